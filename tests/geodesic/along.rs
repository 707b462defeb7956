//! Errors of a method by distance and latitude, against GeographicLib.

use geographiclib_rs::{DirectGeodesic, Geodesic as Reference, InverseGeodesic};
use terrella::Ellipsoid;
use terrella::geodesic::{Geodesic, GeodesicError, Method, Surface};
use testkit::{maximum, minimum};

use crate::sample::{place, signed};
use testkit::truth::Scalar;

/// The largest errors in metres of distance, of the azimuths × reduced length, and of the position of the direct problem.
#[derive(Clone, Copy, Debug, Default)]
pub struct Errors {
    pub distance: f64,
    pub azimuth: f64,
    pub position: f64,
}

/// Lines of a length that are measured.
const LINES: usize = 5_000;

/// Lines of this length from latitudes in this range on WGS 84, from inputs that are exact in the scalar.
pub fn measure<T: Scalar>(method: &impl Geodesic<T>, distance: f64, (low, high): (f64, f64)) -> Errors {
    let round = |x: f64| T::of(x);
    let reference = Reference::new(6_378_137.0, Ellipsoid::<f64>::WGS84.f());
    let mut rng = fastrand::Rng::with_seed(distance as u64 ^ low as u64);
    let mut worst = Errors::default();
    let mut answers = 0;
    for _ in 0..LINES {
        let lat = (low + (high - low) * rng.f64()).copysign(signed(&mut rng));
        let [lat, lon, azimuth, s] = [lat, 180.0 * signed(&mut rng), 180.0 * signed(&mut rng), distance].map(round);
        let from = place(lat, lon);
        let (lat1, lon1): (f64, f64) = (lat.into(), lon.into());
        let (lat2, lon2): (f64, f64) = reference.direct(lat1, lon1, azimuth.into(), s.into());
        let end = method.direct(from, azimuth, s).unwrap().position;
        let miss: f64 = reference.inverse(end.lat().into(), end.lon().into(), lat2, lon2);
        let to = place(round(lat2), round(lon2));
        let (true_s, azimuth1, azimuth2, reduced, _): (f64, f64, f64, f64, f64) =
            reference.inverse(lat1, lon1, to.lat().into(), to.lon().into());
        worst.position = maximum(worst.position, miss);
        let line = match method.inverse(from, to) {
            Ok(line) => line,
            // Vincenty's, next to the antipode.
            Err(GeodesicError::NotConverged(..)) => continue,
            Err(refused) => panic!("{refused}"),
        };
        answers += 1;
        let turn = maximum(turned(line.azimuth1, azimuth1), turned(line.azimuth2, azimuth2));
        worst.distance = maximum(worst.distance, (line.distance.into() - true_s).abs());
        worst.azimuth = maximum(worst.azimuth, turn * reduced.abs());
    }
    assert!(
        answers == LINES || distance.abs() > 1.9e7 && answers > 0,
        "{answers} answers"
    );
    worst
}

/// The angle between two azimuths, in radians.
pub fn turned<T: Scalar>(computed: T, truth: f64) -> f64 {
    let degrees = (computed.into() - truth).abs();
    minimum(degrees, (360.0 - degrees).abs()).to_radians()
}

/// Measures a method in both scalars where it claims anything, and asserts that it keeps the claims.
fn hold(method: Method) {
    let (double, single) = (
        method.on(Ellipsoid::<f64>::WGS84).unwrap(),
        method.on(Ellipsoid::<f32>::WGS84).unwrap(),
    );
    let profile = method.profile();
    let mut bands: Vec<_> = profile.errors.iter().map(|row| row.latitudes).collect();
    bands.dedup();
    for [low, high] in bands {
        for distance in DISTANCES {
            let Some(row) = profile.worst_errors(high, distance) else {
                continue;
            };
            let claimed = row.double.map(|error| error.at(distance));
            let added = row.single.map(|error| error.at(distance));
            let [double, single] = [
                measure(&double, distance, (low, high)),
                measure(&single, distance, (low, high)),
            ]
            .map(|e| [e.distance, e.azimuth, e.position]);
            println!("{method}, {distance:e} m, {low} to {high}°: {double:?} of {claimed:?}");
            println!("    f32 {single:?}, adds {added:?}");
            // And what the reference is off.
            let theirs = if distance < 1e6 { 0.0 } else { 1.5e-8 };
            for i in 0..3 {
                assert!(double[i] <= claimed[i] + theirs, "{method}, {distance:e} m");
                assert!(single[i] <= claimed[i] + added[i], "{method}, {distance:e} m, f32");
            }
        }
    }
}

/// In metres, up to what rounds to half way round.
const DISTANCES: [f64; 15] = [
    1.0, 10.0, 1e3, 1e4, 1e5, 1.5e5, 1e6, 3e6, 5e6, 1e7, 1.5e7, 1.8e7, 1.9e7, 1.99e7, 2e7,
];

/// What the methods for the Earth say of themselves. Those of the sphere are measured on spheres.
#[test]
fn methods_hold_what_they_claim() {
    for &method in Method::ALL {
        if method.profile().surface != Surface::Sphere && !method.needs_place() {
            hold(method);
        }
    }
}
