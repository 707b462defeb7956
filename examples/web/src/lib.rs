//! The quadrilateralized cube both ways and distances on WGS84, for JavaScript: `terrella.mjs` wraps them. Distances are by
//! `AndoyerSecond`, in a third of the bytes, or with feature `karney` by `Karney`, exact to the antipode.
//!
//! Numbers come as arguments; results of several are left in [`results`].

use core::sync::atomic::{AtomicU64, Ordering::Relaxed};

use terrella::cube::{CubeProjection, Face, FacePoint, Quadrilateralized};
#[cfg(not(feature = "karney"))]
use terrella::geodesic::AndoyerSecond as Method;
use terrella::geodesic::Geodesic;
#[cfg(feature = "karney")]
use terrella::geodesic::Karney as Method;
use terrella::{Direction, Ellipsoid, LatLon};

static RESULTS: [AtomicU64; 3] = [const { AtomicU64::new(0) }; 3];

fn leave<const N: usize>(numbers: [f64; N]) {
    for (slot, number) in RESULTS.iter().zip(numbers) {
        slot.store(number.to_bits(), Relaxed);
    }
}

/// Where results are left, as three numbers of 64 bits.
#[unsafe(no_mangle)]
pub extern "C" fn results() -> *const AtomicU64 {
    RESULTS.as_ptr()
}

/// The face of a vector in Earth axes; leaves x and y on it. −1 for what has no direction.
#[unsafe(no_mangle)]
pub extern "C" fn project(x: f64, y: f64, z: f64) -> i32 {
    match Direction::new(x, y, z) {
        Ok(direction) => {
            let point = Quadrilateralized.project(direction);
            leave([point.x(), point.y()]);
            point.face().index().into()
        }
        Err(_) => -1,
    }
}

/// Leaves the unit vector of a point of a face; whether there is one.
#[unsafe(no_mangle)]
pub extern "C" fn unproject(face: u8, x: f64, y: f64) -> bool {
    let point = Face::from_index(face)
        .ok()
        .and_then(|face| FacePoint::new(face, x, y).ok());
    if let Some(point) = point {
        leave(Quadrilateralized.unproject(point).to_array());
    }
    point.is_some()
}

/// The distance in metres of two places in degrees; leaves the azimuths at both. NaN for what is no place.
#[unsafe(no_mangle)]
pub extern "C" fn inverse(lat1: f64, lon1: f64, lat2: f64, lon2: f64) -> f64 {
    let line = || {
        let (from, to) = (LatLon::new(lat1, lon1).ok()?, LatLon::new(lat2, lon2).ok()?);
        Method::new(Ellipsoid::WGS84).ok()?.inverse(from, to).ok()
    };
    line().map_or(f64::NAN, |line| {
        leave([line.azimuth1, line.azimuth2]);
        line.distance
    })
}
