//! The one table of worst errors: the tests hold each figure, and the README shows it.

use terrella::cube::Projection;

/// What is claimed, its unit, and the largest error in `f64` and in `f32`.
#[rustfmt::skip]
const FUNCTIONS: &[(&str, &str, [f64; 2])] = &[
    ("math::sin_cos", "ulp", [0.8, 0.81]),
    ("math::sin_cos_degrees", "ulp", [0.8, 0.8]),
    ("math::tan", "ulp", [1.2, 1.2]),
    ("math::atan", "ulp", [0.85, 0.85]),
    ("math::atan2", "ulp", [0.85, 0.85]),
    ("math::atan2_degrees", "ulp", [0.85, 0.85]),
    ("math::cbrt", "ulp", [1.0, 1.0]),
    ("math::exp_m1", "ulp", [0.75, 0.75]),
    ("math::log2", "ulp", [0.85, 0.85]),
    ("LatLon to Direction", "rad", [2.2e-16, 1.2e-7]),
    ("Direction to LatLon", "ulp", [2.3, 2.3]),
    ("LatLon to FacePoint and back, any projection and shift", "m", [5e-9, 2.6]),
    ("latitude of a geodetic one", "rad", [1.6e-16, 8.2e-8]),
    ("geodetic latitude of another", "rad", [3.3e-16, 8.5e-8]),
    ("geodetic latitude of an isometric one", "rad", [6.2e-16, 3.1e-7]),
    ("isometric latitude, relative to 1 or more", "", [5e-16, 2.6e-7]),
    ("latitudes below 0.1, relative", "ulp", [2.6, 2.6]),
    ("Karney inverse, distance", "m", [7e-9, 4.0]),
    ("Karney inverse to 150 km, relative to 1 m or more", "", [2e-9, 1e-6]),
    ("Karney inverse, azimuth times length", "m", [5e-9, 3.0]),
    ("Karney inverse, reduced length", "m", [8e-9, 3.0]),
    ("Karney direct, position", "m", [1e-8, 5.5]),
    ("Karney direct, position after several circuits", "m", [2.6e-8, 12.0]),
    ("Karney area under a line", "m²", [0.1, 6e7]),
    ("Karney area under a line of less than 1000 km", "m²", [0.02, 2e5]),
    ("GreatCircle distance, relative", "", [8e-16, 4.2e-7]),
    ("Vincenty inverse, distance", "m", [1e-4, 7.0]),
    ("Ellipsoid::to_ecef below 100 km", "m", [9.5e-10, 0.5]),
    ("Ellipsoid::to_ecef to 50 000 km", "m", [6e-9, 3.2]),
    ("Ellipsoid::to_geodetic below 100 km, down to the centre", "m", [2.2e-9, 1.2]),
    ("Ellipsoid::to_geodetic to 50 000 km", "m", [1.6e-8, 8.5]),
    ("LocalFrame::geodetic_to_enu, relative to the distance", "", [6e-16, 1e-7]),
    ("LocalFrame::enu_to_offset, relative to the distance", "", [6e-16, 1.7e-7]),
    ("healpix::Pixel::place and healpix::from_plane", "rad", [4.3e-16, 2.3e-7]),
    ("healpix::OnEllipsoid::place and from_plane", "rad", [4.7e-16, 2.5e-7]),
    ("Ground::jacobian, slopes relative to the longest", "", [2.2e-15, 5e-7]),
    ("Ground::jacobian, area, relative", "", [3e-15, 8e-7]),
    ("Karney on Mars and the Moon", "m", [4e-9, 3.0]),
    ("Karney for f = 1/10 and −1/150", "m", [1.2e-8, 4.0]),
    ("Karney for f = 1/10 and −1/150, several circuits", "m", [1.9e-8, 12.0]),
];

/// The largest errors that are claimed under this name.
pub fn claim(what: &str) -> [f64; 2] {
    let (.., claimed) = FUNCTIONS
        .iter()
        .find(|(name, ..)| *name == what)
        .unwrap_or_else(|| panic!("no claim about {what}"));
    *claimed
}

/// The largest errors that are claimed of a projection, forward and inverse: more than a search found
/// (`tests/properties/projection.rs`; forward, and for two of them back, in `f32` alone: `f64` in proportion),
/// and than any row of the truth.
pub fn claims_of(projection: Projection) -> ([f64; 2], [f64; 2]) {
    let profile = projection.profile();
    (profile.forward.worst_error, profile.inverse.worst_error)
}

/// Asserts that a measured pair of errors keeps the claim of this name.
pub fn hold(what: &str, measured: [f64; 2]) {
    compare(what, measured, claim(what));
}

/// Asserts that the measured errors of a projection, forward and inverse, keep its claim.
pub fn hold_projection(projection: Projection, forward: [f64; 2], inverse: [f64; 2]) {
    let (forward_claim, inverse_claim) = claims_of(projection);
    compare(&format!("{projection} forward"), forward, forward_claim);
    compare(&format!("{projection} inverse"), inverse, inverse_claim);
    // What was asked on the truth: a few units of the last place of 1.
    let asked = [4.5e-16, 2.4e-7];
    compare(&format!("{projection} forward, asked"), forward, asked);
    compare(&format!("{projection} inverse, asked"), inverse, asked);
}

fn compare(what: &str, measured: [f64; 2], claimed: [f64; 2]) {
    println!(
        "{what}: {:.2e} of {:.2e} (f64), {:.2e} of {:.2e} (f32)",
        measured[0], claimed[0], measured[1], claimed[1]
    );
    for (measured, claimed) in measured.into_iter().zip(claimed) {
        assert!(
            measured <= claimed,
            "{what}: {measured:e} is over the claimed {claimed:e}"
        );
    }
}

/// The table as the README shows it.
pub fn markdown() -> String {
    let mut table = String::from("| | unit | `f64` | `f32` |\n|---|---|---|---|\n");
    let number = |value: f64| {
        if value < 1e3 {
            format!("{value:?}")
        } else {
            format!("{value:e}")
        }
    };
    for (what, unit, claimed) in FUNCTIONS {
        let [double, single] = claimed.map(number);
        table += &format!("| {what} | {unit} | {double} | {single} |\n");
    }
    table += "\n| projection | x, y: `f64` | `f32` | direction, rad: `f64` | `f32` |\n|---|---|---|---|---|\n";
    for &projection in Projection::ALL {
        let ([fd, fs], [id, is]) = claims_of(projection);
        table += &format!("| {projection} | {fd:?} | {fs:?} | {id:?} | {is:?} |\n");
    }
    table
}
