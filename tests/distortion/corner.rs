//! The rule for corners, and the largest known angular deformations.

use terrella::cube::{Face, Projection};
use testkit::Worst;

use crate::sphere::{at, places, smooth, unit_sphere};

/// 2 asin((√3 − 1)/(√3 + 1)): 90° that must become 120°.
const CORNER: f64 = 31.084_536_446_754_3;

fn near(a: f64, b: f64, tolerance: f64, what: &str) {
    assert!((a - b).abs() <= tolerance, "{what}: {a} is not {b}");
}

#[test]
fn smooth_maps_have_31_degrees_at_the_corner() {
    let root = 3.0_f64.sqrt();
    near(
        CORNER,
        2.0 * ((root - 1.0) / (root + 1.0)).asin().to_degrees(),
        1e-8,
        "the rule",
    );
    let mut seen = 0;
    for projection in smooth() {
        for (x, y) in [(1.0, 1.0), (-1.0, 1.0), (-1.0, -1.0), (1.0, -1.0)] {
            let omega = unit_sphere::<f64, _>(projection)
                .jacobian(at(Face::Top, x, y))
                .unwrap()
                .deformation();
            near(omega, CORNER, 1e-8, projection.name());
        }
        seen += 1;
    }
    assert!(seen >= 12);
}

#[test]
fn the_conformal_cube_deforms_nothing() {
    let ground = unit_sphere::<f64, _>(Projection::Conformal);
    let mut worst = Worst::default();
    for point in places(60_000, 6) {
        let distance = (1.0 - point.x().abs()).hypot(1.0 - point.y().abs());
        let omega = ground.jacobian(point).unwrap().deformation();
        worst.add(omega * distance);
    }
    let worst = worst.value();
    println!("conformal: {worst:.1e}°");
    assert!(worst < 1e-12);
}

#[test]
fn creased_maps_stay_below_their_known_maxima() {
    let at_place = |projection, x, y| {
        unit_sphere::<f64, _>(projection)
            .jacobian(at(Face::Front, x, y))
            .unwrap()
    };
    let qsc = Projection::Quadrilateralized;
    // At the corner, and along the diagonal toward the centre, where the largest is but a limit.
    near(at_place(qsc, 1.0, 1.0).deformation(), 24.9024, 5e-5, "QSC, corner");
    near(at_place(qsc, 1e-9, 1e-9).deformation(), 25.174, 5e-4, "QSC, centre");
    let largest = |projection, face| {
        let ground = unit_sphere::<f64, _>(projection);
        let place = |i: i32| f64::from(i) / 400.0;
        let places = (0..=400).flat_map(|i| (0..=400).map(move |j| (place(i), place(j))));
        let omegas = places.filter_map(|(x, y)| ground.jacobian(at(face, x, y)).ok());
        Worst::of(omegas.map(|j| j.deformation()))
    };
    near(largest(qsc, Face::Front), 25.174, 1e-3, "QSC");
    near(largest(Projection::Vertex, Face::Front), 20.25, 5e-3, "vertex");
    near(largest(Projection::Square, Face::Front), 33.54, 5e-3, "square");
    near(largest(Projection::Balanced, Face::Front), CORNER, 1e-6, "balanced");
    near(largest(Projection::Separable, Face::Front), CORNER, 1e-6, "separable");
}

#[test]
fn areas_are_those_of_lambers_and_kolb() {
    let area = |projection, x, y| {
        unit_sphere::<f64, _>(projection)
            .jacobian(at(Face::Front, x, y))
            .unwrap()
            .area()
    };
    let tangential = area(Projection::Tangential, 0.0, 0.0) / area(Projection::Tangential, 1.0, 1.0);
    near(tangential, 3.0 * 3.0_f64.sqrt(), 1e-14, "TSC: 3√3");
    // Least at the middle of an edge.
    let adjusted = area(Projection::Adjusted, 0.0, 0.0) / area(Projection::Adjusted, 1.0, 0.0);
    near(adjusted, 2.0_f64.sqrt(), 1e-14, "ASC: √2");
}
