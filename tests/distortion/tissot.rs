//! Tissot's indicatrix: the relations between its parts, and circles drawn on the ground.

use terrella::cube::{Projection, Tangential};
use terrella::distortion::Tissot;
use terrella::{Ellipsoid, Shift};
use testkit::maximum;

use crate::sphere::{at, on, places, unit_sphere};

fn near(a: f64, b: f64, tolerance: f64, what: &str) {
    assert!(
        (a - b).abs() <= tolerance * maximum(b.abs(), 1.0),
        "{what}: {a:e} is not {b:e}"
    );
}

#[test]
fn its_parts_agree() {
    for &projection in Projection::ALL {
        let ground = on(Ellipsoid::<f64>::WGS84, Shift::Authalic, projection);
        for point in places(2000, 3) {
            let t = ground.tissot(point).unwrap();
            let large = maximum(t.major, 1.0).powi(2);
            near(t.major * t.minor, t.areal, 1e-13 * large, "ab = s");
            near(
                t.meridian.powi(2) + t.parallel.powi(2),
                t.major.powi(2) + t.minor.powi(2),
                1e-13,
                "h² + k² = a² + b²",
            );
            let sine = t.graticule_angle.to_radians().sin();
            near(t.meridian * t.parallel * sine, t.areal, 1e-13 * large, "hk sin θ′ = s");
            let half = (t.deformation.to_radians() / 2.0).sin();
            near(half, (t.major - t.minor) / (t.major + t.minor), 1e-14, "sin ω/2");
            assert!(t.minor <= t.major && (0.0..180.0).contains(&t.azimuth));
        }
    }
}

#[test]
fn the_scale_is_largest_along_the_azimuth() {
    for &projection in Projection::ALL {
        let ground = on(Ellipsoid::<f64>::WGS84, Shift::Geocentric, projection);
        for point in places(500, 4) {
            let j = ground.jacobian(point).unwrap();
            let t = ground.tissot(point).unwrap();
            // A step of one metre on the ground at an azimuth, on the face.
            let scale = |azimuth: f64| {
                let (east, north) = azimuth.to_radians().sin_cos();
                let ([a, b], [c, d]) = (j.by_x, j.by_y);
                ((d * east - c * north).hypot(a * north - b * east)) / j.area() * ground.unit()
            };
            near(scale(t.azimuth), t.major, 1e-12 * t.major, "along");
            near(scale(t.azimuth + 90.0), t.minor, 1e-12 * t.major, "across");
            near(scale(0.0), t.meridian, 1e-13 * t.major, "north");
            near(scale(90.0), t.parallel, 1e-13 * t.major, "east");
        }
    }
}

#[test]
fn the_gnomonic_one_is_known() {
    // At the angle c from the centre the scales are sec²c away from it and sec c across.
    let ground = unit_sphere::<f64, _>(Tangential);
    let t = ground.tissot(at(terrella::cube::Face::Front, 0.75, 0.0)).unwrap();
    let secant = 1.25;
    near(t.major, secant * secant * ground.unit(), 1e-15, "radial");
    near(t.minor, secant * ground.unit(), 1e-15, "tangential");
    near(t.azimuth, 90.0, 1e-15, "azimuth");
    near(t.parallel, t.major, 1e-15, "parallel");
    near(t.graticule_angle, 90.0, 1e-15, "graticule");
}

#[test]
fn conformal_has_no_azimuth_to_speak_of() {
    let same = terrella::distortion::Jacobian {
        by_x: [2.0_f64, 0.0],
        by_y: [0.0, 2.0],
    };
    let t = Tissot::new(&same, 2.0);
    assert_eq!(
        (t.major, t.minor, t.azimuth, t.deformation, t.areal),
        (1.0, 1.0, 0.0, 0.0, 1.0)
    );
}
