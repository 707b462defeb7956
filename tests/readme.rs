//! The README's table of projections, measured afresh.
#![allow(missing_docs, clippy::indexing_slicing, clippy::type_complexity)] // tests

use terrella::cube::Projection;

use testkit::{measure, table};

/// Projection, what it keeps, true-area ratio, aspect ratio, ε, ω in degrees, and how it is computed to the cube and back.
#[rustfmt::skip]
const PROPERTIES: &[(Projection, &str, f64, f64, f64, f64, &str, &str)] = &[
    (Projection::Tangential,        "great circles straight", 5.196, 2.000, 4.500, 31.1, "÷",          "÷ √"),
    (Projection::Adjusted,          "",                       1.414, 2.000, 2.000, 31.1, "atan",       "tan"),
    (Projection::Outerra,           "",                       3.566, 1.013, 3.088, 31.1, "iteration",  "÷ √"),
    (Projection::Cobe,              "COBE data",              1.221, 2.366, 2.366, 31.1, "polynomial", "polynomial, misses by 2.9e-4"),
    (Projection::CobeExact,         "COBE data",              1.230, 2.383, 2.383, 31.1, "polynomial", "iteration"),
    (Projection::Quadrilateralized, "areas",                  1.000, 2.370, 2.370, 25.2, "polynomial", "polynomial"),
    (Projection::Cartesian,         "",                       1.333, 3.000, 3.000, 31.1, "÷ √",        "√"),
    (Projection::Healpix,           "areas",                  1.000, 3.334, 3.334, 49.3, "atan",       "tan"),
    (Projection::S2Quadratic,       "",                       2.097, 2.081, 2.105, 31.1, "÷ √",        "÷ √"),
    (Projection::EquiEdge,          "",                       2.309, 1.125, 2.000, 31.1, "atan",       "tan"),
    (Projection::Algebraic,         "",                       1.268, 2.712, 2.712, 31.1, "÷ √",        "÷ √"),
    (Projection::Vertex,            "areas",                  1.000, 2.035, 2.035, 20.3, "polynomial", "polynomial"),
    (Projection::Conformal,         "angles",                 f64::INFINITY, 1.000, f64::INFINITY, 0.0, "series", "series"),
    (Projection::Balanced,          "",                       1.488, 1.403, 1.405, 31.1, "iteration",  "÷ √"),
    (Projection::Square,            "",                       2.229, 1.013, 1.889, 33.5, "iteration",  "÷ √"),
    (Projection::Separable,         "",                       1.637, 1.587, 1.587, 31.1, "atan",       "tan"),
];

fn number(value: f64, digits: usize) -> String {
    if value.is_finite() {
        format!("{value:.digits$}")
    } else {
        "∞".into()
    }
}

#[test]
fn errors_are_as_claimed() {
    let (readme, table) = (include_str!("../README.md"), table::markdown());
    assert!(readme.contains(&table), "the README lacks this table:\n{table}");
}

#[test]
fn properties_are_as_measured_and_shown() {
    let mut table = String::from(
        "| projection | keeps | area ratio | aspect ratio | ε | ω | to the cube | back |\n|---|---|---|---|---|---|---|---|\n",
    );
    assert_eq!(PROPERTIES.len(), Projection::ALL.len());
    for &(projection, keeps, area, aspect, oversize, deformation, forward, inverse) in PROPERTIES {
        let m = measure::Measures::of(projection);
        let measured = [
            m.sphere.area_ratio(),
            m.sphere.worst.aspect().ratio(),
            m.sphere.oversize(),
            m.sphere.worst.deformation().max(),
        ];
        // Half of the last digit that is shown.
        let tolerances = [5e-4, 5e-4, 5e-4, 5e-2];
        for ((claimed, measured), tolerance) in [area, aspect, oversize, deformation]
            .into_iter()
            .zip(measured)
            .zip(tolerances)
        {
            assert!(
                claimed == measured || (claimed - measured).abs() < tolerance,
                "{projection}: {claimed} {measured}"
            );
        }
        assert_eq!(m.is_equal_area(), keeps == "areas", "{projection}");
        assert_eq!(m.has_two_kinds(), projection == Projection::Healpix, "{projection}");
        assert_eq!(m.sphere.is_conformal(), keeps == "angles", "{projection}");
        table += &format!(
            "| {projection} | {keeps} | {} | {} | {} | {:.1}° | {forward} | {inverse} |\n",
            number(area, 3),
            number(aspect, 3),
            number(oversize, 3),
            deformation
        );
    }
    let readme = include_str!("../README.md");
    assert!(readme.contains(&table), "the README lacks this table:\n{table}");
}

#[test]
fn creases_are_where_they_should_be() {
    let [balanced, vertex, quadrilateralized] =
        [Projection::Balanced, Projection::Vertex, Projection::Quadrilateralized].map(measure::Measures::of);
    assert!(balanced.inner_bend < 0.1, "balanced is smooth inside a face");
    assert!(
        vertex.inner_bend < 5.0 && vertex.edge_bend < 0.1,
        "vertex is nearly smooth everywhere"
    );
    assert!(
        quadrilateralized.inner_bend > 20.0,
        "quadrilateralized is creased along the diagonals"
    );
}

#[test]
fn texels_of_equal_area_cubes_are_askew() {
    let [quadrilateralized, healpix] = [Projection::Quadrilateralized, Projection::Healpix].map(measure::Measures::of);
    let near = |measured: f64, exact: f64| assert!((measured - exact).abs() < 1e-6, "{measured} {exact}");
    near(quadrilateralized.sphere.sides_ratio(), 1.041_903);
    let [side, polar] = healpix.kinds.map(|surveys| surveys.sides_ratio());
    near(side, 1.0);
    near(polar, (1.0 + std::f64::consts::PI.powi(2) / 16.0).sqrt());
}
