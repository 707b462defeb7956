//! Equal-area projections keep areas, on the sphere and on the ellipsoid.

use terrella::cube::{Kept, Projection};
use terrella::{Ellipsoid, Shift};
use testkit::{maximum, minimum};

use crate::sphere::{on, places, unit_sphere};

fn equal_area() -> impl Iterator<Item = Projection> {
    let keeps_areas = |p: &Projection| p.profile().keeps == Some(Kept::Areas);
    Projection::ALL.iter().copied().filter(keeps_areas)
}

/// Smallest and largest areal scale over many places, less 1.
fn areal(ellipsoid: Ellipsoid<f64>, shift: Shift, projection: Projection) -> [f64; 2] {
    let ground = on(ellipsoid, shift, projection);
    let mut range = [f64::INFINITY, f64::NEG_INFINITY];
    for point in places(60_000, 5) {
        let error = ground.tissot(point).unwrap().areal - 1.0;
        range = [minimum(range[0], error), maximum(range[1], error)];
    }
    range
}

#[test]
fn on_the_sphere_and_by_the_authalic_latitude_to_1e_13() {
    for projection in equal_area() {
        for (what, ellipsoid) in [
            ("sphere", Ellipsoid::sphere(6_371_000.0).unwrap()),
            ("WGS84", Ellipsoid::WGS84),
            ("f = 1/10", Ellipsoid::new(1.0, 0.1).unwrap()),
            ("f = -1/150", Ellipsoid::new(1.0, -1.0 / 150.0).unwrap()),
        ] {
            let [least, most] = areal(ellipsoid, Shift::Authalic, projection);
            println!("{projection}, {what}: {least:.1e} to {most:.1e}");
            assert!(
                -least < 1e-13 && most < 1e-13,
                "{projection}, {what}: {least:e} to {most:e}"
            );
        }
    }
}

#[test]
fn by_the_geocentric_latitude_within_half_a_percent() {
    for projection in equal_area() {
        // What a cell of the face covers on the ground: the inverse of the areal scale.
        let [smallest, largest] = areal(Ellipsoid::WGS84, Shift::Geocentric, projection);
        let [least, most] = [largest, smallest].map(|scale| 1.0 / (1.0 + scale) - 1.0);
        println!("{projection}: {:+.3} % to {:+.3} %", least * 100.0, most * 100.0);
        assert!(
            (least + 0.0045).abs() < 5e-5 && (most - 0.0022).abs() < 5e-5,
            "{projection}: {least} {most}"
        );
    }
}

#[test]
fn a_face_is_a_sixth_of_the_sphere() {
    for &projection in Projection::ALL {
        let ground = unit_sphere::<f64, _>(projection);
        // The mean of a unit of area over a whole face, by the midpoint rule.
        let n = 200;
        let along = |i: i32| (2.0 * f64::from(i) + 1.0) / f64::from(n) - 1.0;
        for face in [terrella::cube::Face::Front, terrella::cube::Face::Top] {
            let area: f64 = (0..n * n)
                .map(|i| {
                    ground
                        .jacobian(crate::sphere::at(face, along(i / n), along(i % n)))
                        .unwrap()
                        .area()
                })
                .sum::<f64>()
                * (2.0 / f64::from(n)).powi(2);
            let sixth = 4.0 * std::f64::consts::PI / 6.0;
            assert!(
                (area / sixth - 1.0).abs() < 2e-4,
                "{projection}, {face:?}: {}",
                area / sixth
            );
        }
    }
}
