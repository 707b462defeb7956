//! Errors of a method by distance and latitude, against GeographicLib.

use geographiclib_rs::{DirectGeodesic, Geodesic as Reference, InverseGeodesic};
use terrella::Ellipsoid;
use terrella::geodesic::Geodesic;
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

/// Lines of this length from latitudes in this range on WGS 84, from inputs that are exact in the scalar.
pub fn measure<T: Scalar>(method: &impl Geodesic<T>, distance: f64, (low, high): (f64, f64)) -> Errors {
    let round = |x: f64| T::of(x);
    let reference = Reference::new(6_378_137.0, Ellipsoid::<f64>::WGS84.f());
    let mut rng = fastrand::Rng::with_seed(distance as u64 ^ low as u64);
    let mut worst = Errors::default();
    for _ in 0..5_000 {
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
        let line = method.inverse(from, to).unwrap();
        let turn = maximum(turned(line.azimuth1, azimuth1), turned(line.azimuth2, azimuth2));
        let errors = [(line.distance.into() - true_s).abs(), turn * reduced.abs(), miss];
        for (worst, error) in [&mut worst.distance, &mut worst.azimuth, &mut worst.position]
            .into_iter()
            .zip(errors)
        {
            *worst = maximum(*worst, error);
        }
    }
    worst
}

/// The angle between two azimuths, in radians.
pub fn turned<T: Scalar>(computed: T, truth: f64) -> f64 {
    let degrees = (computed.into() - truth).abs();
    minimum(degrees, (360.0 - degrees).abs()).to_radians()
}

/// What single precision adds: to a length or an angle times it, and to a position, where the distance's own rounding counts too.
const SINGLE: [f64; 2] = [7e-7, 2.0];

/// Asserts both scalars' errors to be within what a row of a method's table claims.
pub fn hold(
    double: &impl Geodesic<f64>,
    single: &impl Geodesic<f32>,
    distance: f64,
    latitudes: (f64, f64),
    claimed: Errors,
) {
    let measured = measure(double, distance, latitudes);
    println!("{distance:e} m, {latitudes:?}: {measured:?} of {claimed:?}");
    let within = |measured: Errors, [length, position]: [f64; 2]| {
        measured.distance <= claimed.distance + length
            && measured.azimuth <= claimed.azimuth + length
            && measured.position <= claimed.position + length + position
    };
    assert!(within(measured, [0.0; 2]));
    let measured = measure(single, distance, latitudes);
    println!("    f32 {measured:?}");
    assert!(within(measured, [SINGLE[0] * distance, SINGLE[1]]));
}
