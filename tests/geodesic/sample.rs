//! Random and awkward pairs of places.

use terrella::LatLon;

use testkit::truth::Scalar;

/// A place from numbers in range.
pub fn place<T: Scalar>(lat: T, lon: T) -> LatLon<T> {
    LatLon::new(lat, lon).unwrap()
}

/// A number in [−1, 1].
pub fn signed(rng: &mut fastrand::Rng) -> f64 {
    2.0 * rng.f64() - 1.0
}

/// A latitude and a longitude, evenly over the sphere.
pub fn even(rng: &mut fastrand::Rng) -> (f64, f64) {
    (signed(rng).asin().to_degrees(), 180.0 * signed(rng))
}

/// A number in [−1, 1] of any magnitude down to 1e-16.
fn tiny(rng: &mut fastrand::Rng) -> f64 {
    10f64.powf(-16.0 * rng.f64()) * signed(rng)
}

/// A latitude: anywhere, on or near the equator, a pole, or 45°.
fn latitude(rng: &mut fastrand::Rng) -> f64 {
    let near = |to: f64, rng: &mut fastrand::Rng| (to + 10.0 * tiny(rng)).clamp(-90.0, 90.0);
    match rng.u8(0..12) {
        0 => near(0.0, rng),
        1 => near(90.0, rng),
        2 => near(-90.0, rng),
        3 => near(45.0, rng),
        4 => near(-45.0, rng),
        5 => *rng.choice(&[0.0, -0.0, 90.0, -90.0, 45.0, -45.0]).unwrap(),
        _ => signed(rng).asin().to_degrees(),
    }
}

/// A longitude: anywhere, or on or near a multiple of 90°.
fn longitude(rng: &mut fastrand::Rng) -> f64 {
    let quarter = 90.0 * f64::from(rng.i8(-2..=2));
    match rng.u8(0..6) {
        0 => quarter,
        1 => (quarter + 10.0 * tiny(rng)).clamp(-180.0, 180.0),
        _ => 180.0 * signed(rng),
    }
}

/// Two places as `[lat1, lon1, lat2, lon2]`: anywhere, nearly coincident, nearly antipodal, on a meridian or a parallel.
pub fn awkward(rng: &mut fastrand::Rng) -> [f64; 4] {
    let (lat1, lon1) = (latitude(rng), longitude(rng));
    let mut offset = |about: f64| match rng.u8(0..4) {
        0 => about,
        _ => about + 10.0 * tiny(rng),
    };
    let (near_lat, far_lat) = (offset(lat1), offset(-lat1));
    let (near_lon, far_lon) = (offset(lon1), offset(lon1 - 180.0f64.copysign(lon1)));
    let (lat2, lon2) = match rng.u8(0..6) {
        0 => (near_lat, near_lon),
        1 => (far_lat, far_lon),
        2 => (latitude(rng), near_lon),
        3 => (near_lat, far_lon),
        _ => (latitude(rng), longitude(rng)),
    };
    [lat1, lon1, lat2.clamp(-90.0, 90.0), lon2.clamp(-180.0, 180.0)]
}
