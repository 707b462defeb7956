//! Equal areas, counted: places spread evenly over the ground fall evenly into the cells of the cube.

use terrella::cube::{CubeMap, Kept, Projection};
use terrella::{Ellipsoid, LatLon, Shift};
use testkit::Worst;

/// Cells along an edge, and places for a cell on average.
const CELLS: usize = 8;
const PLACES: usize = 4000;

/// A sine of a latitude of places spread evenly over an ellipsoid: dA is in proportion to d(sin φ)/(1 − e² sin² φ)².
fn sine(rng: &mut fastrand::Rng, e2: f64) -> f64 {
    loop {
        let sin = 2.0 * rng.f64() - 1.0;
        let density = ((1.0 - e2) / (1.0 - e2 * sin * sin)).powi(2);
        if rng.f64() <= density {
            return sin;
        }
    }
}

/// How many standard deviations the cells' counts are off altogether (χ²), and the worst of them by itself.
fn deviations(projection: Projection, ellipsoid: Ellipsoid<f64>, shift: Shift) -> [f64; 2] {
    let map = CubeMap::new(ellipsoid, shift, projection).unwrap();
    let mut rng = fastrand::Rng::with_seed(6);
    let cells = 6 * CELLS * CELLS;
    let mut counts = vec![0_u32; cells];
    for _ in 0..cells * PLACES {
        let lat = sine(&mut rng, ellipsoid.e2()).asin().to_degrees();
        let point = map.project(LatLon::new(lat, 360.0 * rng.f64() - 180.0).unwrap());
        let cell = |v: f64| (((v + 1.0) * 0.5 * CELLS as f64) as usize).min(CELLS - 1);
        let face = usize::from(point.face().index());
        counts[(face * CELLS + cell(point.x())) * CELLS + cell(point.y())] += 1;
    }
    // A count is binomial: of variance N·p(1 − p), p = 1/cells.
    let expected = PLACES as f64;
    let sigma = (expected * (1.0 - 1.0 / cells as f64)).sqrt();
    let off = counts.iter().map(|&count| (f64::from(count) - expected).abs());
    let squares: f64 = off.clone().map(|off| off * off / expected).sum();
    // χ² of so many degrees of freedom has that mean and twice that variance.
    let freedom = (cells - 1) as f64;
    [
        (squares - freedom).abs() / (2.0 * freedom).sqrt(),
        Worst::of(off) / sigma,
    ]
}

/// Of 384 cells the worst is off by 5σ once in 4500 times, χ² by 5σ less than once in 10⁵ times; the seed is fixed.
#[test]
fn equal_area_cubes_are() {
    let keeps_areas = |p: &&Projection| p.profile().keeps == Some(Kept::Areas);
    for &projection in Projection::ALL.iter().filter(keeps_areas) {
        for (ellipsoid, shift) in [
            (Ellipsoid::MOON, Shift::Geodetic),
            (Ellipsoid::WGS84, Shift::Authalic),
            (Ellipsoid::new(1.0, 0.1).unwrap(), Shift::Authalic),
        ] {
            let [all, worst] = deviations(projection, ellipsoid, shift);
            println!(
                "{projection} {shift} f = {:.4}: χ² {all:.1}σ, worst cell {worst:.1}σ",
                ellipsoid.f()
            );
            assert!(all < 5.0 && worst < 5.0, "{projection} {shift}: {all} {worst}");
        }
    }
}

/// What is not equal-area is told, if its cells differ by a percent (root of the mean square).
#[test]
fn others_are_not() {
    for (projection, ellipsoid, shift) in [
        (Projection::Cartesian, Ellipsoid::MOON, Shift::Geodetic),
        (Projection::Adjusted, Ellipsoid::MOON, Shift::Geodetic),
        (Projection::Vertex, Ellipsoid::new(1.0, 0.1).unwrap(), Shift::Geocentric),
    ] {
        let [all, worst] = deviations(projection, ellipsoid, shift);
        println!("{projection} {shift}: χ² {all:.1}σ, worst cell {worst:.1}σ");
        assert!(all > 5.0, "{projection} {shift}: {all}");
    }
}
