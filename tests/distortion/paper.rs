//! Table 5.1 of Dimitrijević, Lambers & Rančić (2016), cell by cell, and other figures of the papers.

use terrella::cube::{Face, Projection};
use terrella::distortion::{Statistic, Survey};
use terrella::{Ellipsoid, Shift};
use testkit::{Worst, maximum, minimum};

use crate::sphere::{at, on, unit_sphere};

/// A row of the table: min, max, ratio and RMSD of δ_aspect and of δ_area, from formulas and an independent program.
struct Row {
    name: &'static str,
    projection: Projection,
    face: Face,
    n: u32,
    aspect: [f64; 4],
    area: [f64; 4],
    /// What the paper prints otherwise, and why.
    printed: &'static str,
}

#[rustfmt::skip]
#[allow(clippy::approx_constant)] // six digits, as printed
const TABLE: &[Row] = &[
    Row { name: "TSC", projection: Projection::Tangential, face: Face::Front, n: 3999,
        aspect: [0.707107, 1.414214, 2.000000, 0.154686], area: [0.222222, 1.0, 4.499999, 0.505758], printed: "" },
    Row { name: "ASC", projection: Projection::Adjusted, face: Face::Front, n: 3999,
        aspect: [0.707107, 1.414214, 2.000000, 0.145723], area: [0.707107, 1.0, 1.414213, 0.152933], printed: "" },
    Row { name: "OSC", projection: Projection::Outerra, face: Face::Front, n: 3999,
        aspect: [0.993625, 1.006416, 1.012873, 0.000947], area: [0.323802, 1.0, 3.088312, 0.279641], printed: "" },
    Row { name: "CSC", projection: Projection::Cobe, face: Face::Front, n: 3999,
        aspect: [0.650183, 1.538028, 2.365530, 0.217978], area: [0.939916, 1.325261, 1.409978, 0.019428], printed: "" },
    Row { name: "QSC", projection: Projection::Quadrilateralized, face: Face::Front, n: 7999,
        aspect: [0.649638, 1.539320, 2.369505, 0.271455], area: [0.893839, 0.930928, 1.041494, 0.099412],
        printed: "area ratio 1.042: the limit 1.0419 beside the diagonals, which the grid straddles" },
    Row { name: "KSC", projection: Projection::Cartesian, face: Face::Front, n: 3999,
        aspect: [0.577350, 1.732051, 3.000000, 0.227443], area: [1.0, 1.154701, 1.154701, 0.063188], printed: "" },
    Row { name: "HEALPix, equatorial", projection: Projection::Healpix, face: Face::Front, n: 3999,
        aspect: [0.654498, 1.178097, 1.800000, 0.156148], area: [1.0, 1.0, 1.0, 0.0], printed: "" },
    Row { name: "HEALPix, polar", projection: Projection::Healpix, face: Face::Top, n: 7999,
        aspect: [0.547673, 1.825908, 3.333940, 0.436696], area: [1.0, 1.269556, 1.269556, 0.107568],
        printed: "area ratio 1.272: the limit √(1 + π²/16) = 1.271554 beside the diagonals" },
];

/// The paper's own survey: central differences with a step of 1e-6, at −1 + 2i/n.
fn by_differences(projection: Projection, face: Face, n: u32) -> Survey<f64> {
    let ground = unit_sphere::<f64, _>(projection);
    let along = |i: u32| f64::from(i) * 2.0 / f64::from(n) - 1.0;
    let rows = testkit::parallel::map(0..n, |row| {
        let mut survey = Survey::new(ground.central_texel());
        for column in 0..n {
            let (x, y) = (along(column), along(row));
            survey.include(at(face, x, y), &ground.differences(face, [x, y], 1e-6));
        }
        survey
    });
    let mut all = Survey::new(ground.central_texel());
    rows.iter().for_each(|row| all.merge(row));
    all
}

fn cells(statistic: &Statistic<f64>) -> [f64; 4] {
    [statistic.min(), statistic.max(), statistic.ratio(), statistic.rmsd()]
}

#[test]
#[ignore = "230 million places: run it in release"]
fn table_5_1_to_2e_6() {
    println!("{:20} {:^39} | {:^39} |", "", "aspect: min, max, ratio, RMSD", "area");
    let mut worst = Worst::default();
    for row in TABLE {
        let survey = by_differences(row.projection, row.face, row.n);
        let (aspect, area) = (cells(survey.aspect()), cells(survey.sides()));
        let line = |cells: [f64; 4]| cells.map(|c| format!("{c:9.6}")).join(" ");
        println!("{:20} {} | {} | {}", row.name, line(aspect), line(area), row.printed);
        for (seen, expected) in aspect
            .into_iter()
            .chain(area)
            .zip(row.aspect.into_iter().chain(row.area))
        {
            worst.add((seen - expected).abs());
            assert!(
                (seen - expected).abs() <= 2e-6,
                "{}: {seen} is not {expected}",
                row.name
            );
        }
    }
    println!("largest difference: {:.1e}", worst.value());
    println!("The other projections, by the same survey:");
    for &projection in Projection::ALL
        .iter()
        .filter(|p| TABLE.iter().all(|row| row.projection != **p))
    {
        let survey = by_differences(projection, Face::Front, 1999);
        let line = |cells: [f64; 4]| cells.map(|c| format!("{c:9.6}")).join(" ");
        println!(
            "{:20} {} | {} |",
            projection.name(),
            line(cells(survey.aspect())),
            line(cells(survey.sides()))
        );
    }
}

#[test]
fn a_small_grid_is_near_it() {
    // The same survey over 1/100 of the places and fewer: beside the diagonals the ranges are a little narrower.
    for row in TABLE {
        let survey = by_differences(row.projection, row.face, 199);
        for (seen, expected) in [(survey.aspect(), row.aspect), (survey.sides(), row.area)] {
            let [min, max, ratio, rmsd] = cells(seen);
            assert!(
                (min - expected[0]).abs() < 6e-3 && (max - expected[1]).abs() < 3e-2,
                "{}",
                row.name
            );
            assert!(
                (ratio - expected[2]).abs() < 5e-2 && (rmsd - expected[3]).abs() < 5e-3,
                "{}",
                row.name
            );
        }
    }
}

fn near(a: f64, b: f64, tolerance: f64, what: &str) {
    assert!((a - b).abs() <= tolerance, "{what}: {a} is not {b}");
}

#[test]
fn extremes_have_their_exact_values() {
    let texel = |projection, face, x, y| unit_sphere::<f64, _>(projection).jacobian(at(face, x, y)).unwrap();
    let pi = std::f64::consts::PI;
    let high = (2.0_f64 / 3.0).sqrt();
    let outerra = |x, y| texel(Projection::Outerra, Face::Front, x, y);
    near(
        minimum(outerra(1.0, high).aspect(), outerra(high, 1.0).aspect()),
        0.993_625_129_6,
        1e-10,
        "OSC, least aspect",
    );
    near(
        maximum(outerra(1.0, high).aspect(), outerra(high, 1.0).aspect()),
        1.006_415_77,
        1e-8,
        "OSC, largest aspect",
    );
    let m = (2.0_f64.sqrt() - 1.0) / 2.0;
    let central = unit_sphere::<f64, _>(Projection::Outerra).central_texel();
    near(
        outerra(1.0, 1.0).sides() / central,
        2.0 / 9.0 * (1.0 + m).powi(2),
        1e-9,
        "OSC, least area",
    );
    // One-sided at the corner: the dual numbers take the triangle of x.
    let qsc = texel(Projection::Quadrilateralized, Face::Front, 1.0, 1.0).aspect();
    near(maximum(qsc, 1.0 / qsc), 1.539_435_275, 1e-9, "QSC, corner");
    near(maximum(qsc, 1.0 / qsc).powi(2), 2.369_860_967, 1e-8, "QSC, ratio");
    let cartesian = texel(Projection::Cartesian, Face::Front, 1.0, 0.0).aspect();
    near(
        minimum(cartesian, 1.0 / cartesian),
        1.0 / 3.0_f64.sqrt(),
        1e-14,
        "KSC, aspect",
    );
    let area = |x, y| texel(Projection::Cartesian, Face::Front, x, y).sides();
    near(
        area(1.0, 0.0) / area(0.0, 0.0),
        2.0 / 3.0_f64.sqrt(),
        1e-14,
        "KSC, area",
    );
    let side = |y| texel(Projection::Healpix, Face::Front, 0.5, y).aspect();
    near(side(1.0), 5.0 * pi / 24.0, 1e-14, "HEALPix, edge");
    near(side(0.0), 3.0 * pi / 8.0, 1e-14, "HEALPix, equator");
    let cap = texel(Projection::Healpix, Face::Top, 1.0, 1.0).aspect();
    near(maximum(cap, 1.0 / cap).powi(2), 3.334_440_071, 1e-8, "HEALPix, polar");
    let askew = texel(Projection::Healpix, Face::Top, 1e-9, 1e-9);
    near(
        askew.sides() / askew.area(),
        (1.0 + pi * pi / 16.0).sqrt(),
        1e-14,
        "HEALPix, diagonal",
    );
}

/// A survey of the front and the top by dual numbers.
fn survey(ellipsoid: Ellipsoid<f64>, shift: Shift, projection: Projection, n: u32) -> Survey<f64> {
    let ground = on(ellipsoid, shift, projection);
    let mut survey = Survey::new(ground.central_texel());
    survey.face(&ground, Face::Front, n);
    survey.face(&ground, Face::Top, n);
    survey
}

#[test]
fn the_crates_own_have_the_ratios_they_were_made_for() {
    let of = |projection| survey(Ellipsoid::sphere(1.0).unwrap(), Shift::Geodetic, projection, 301);
    let balanced = of(Projection::Balanced);
    near(balanced.oversize(), 1.4054, 1e-4, "balanced ε");
    near(balanced.aspect().ratio(), 1.4030, 1e-4, "balanced aspect");
    near(balanced.area().ratio(), 1.488, 5e-4, "balanced true area");
    let square = of(Projection::Square);
    near(square.aspect().ratio(), 1.0129, 1e-4, "square aspect");
    near(square.sides().ratio(), 1.8892, 1e-4, "square area");
    let separable = of(Projection::Separable);
    let two_thirds = 2.0_f64.powf(2.0 / 3.0);
    near(separable.aspect().ratio(), two_thirds, 1e-4, "separable aspect");
    near(separable.sides().ratio(), two_thirds, 1e-4, "separable area");
    for &projection in Projection::ALL {
        let survey = of(projection);
        // Proved for every map with these symmetries from the lengths of midline and edge; HEALPix and the conformal cube keep neither premise.
        let bound = (std::f64::consts::FRAC_PI_2 / (1.0_f64 / 3.0).acos()).powi(2);
        let product = survey.aspect().ratio() * survey.sides().ratio();
        assert!(product > bound - 1e-3, "{projection}: {product}");
    }
}

#[test]
fn the_ellipsoid_changes_the_largest_aspect_of_qsc_little() {
    let projection = Projection::Quadrilateralized;
    let sphere = unit_sphere::<f64, _>(projection)
        .jacobian(at(Face::Front, 1.0, 1.0))
        .unwrap()
        .aspect();
    let sphere = maximum(sphere, 1.0 / sphere);
    for &shift in Shift::ALL {
        for face in [Face::Front, Face::Top] {
            let ground = on(Ellipsoid::<f64>::WGS84, shift, projection);
            let mut survey = Survey::new(ground.central_texel());
            survey.face(&ground, face, 201);
            let largest = survey.aspect().max();
            println!(
                "{shift}, {face:?}: {largest:.6}, {:+.2e} of the sphere's {sphere:.6}",
                largest - sphere
            );
        }
    }
}
