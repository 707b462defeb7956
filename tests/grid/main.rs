//! Grids against truth of 25 digits, against the values of other programs, and against each other.
#![allow(
    missing_docs, clippy::unwrap_used, clippy::expect_used, clippy::panic, clippy::indexing_slicing
)] // tests

mod azimuthal;
mod conformal;
mod geohash;
mod mgrs;
mod plus_code;
mod utm;
mod web_mercator;

use terrella::LatLon;
use testkit::truth::{Row, Scalar};

/// How far a place is from the truth, in metres on a sphere.
pub fn displacement<T: Scalar>(row: Row<'_>, place: LatLon<T>) -> f64 {
    let turn = row.deviation("lon", place.lon());
    let turn = (turn + 540.0).rem_euclid(360.0) - 180.0;
    // Without the rounding of the line above, next to 0.
    let turn = if turn.abs() < 1.0 && row.error("lon", place.lon()) < 1.0 {
        row.deviation("lon", place.lon())
    } else {
        turn
    };
    row.error("lat", place.lat())
        .hypot(turn * row.value("lat").to_radians().cos())
        * 111_320.0
}

/// How far a point is from the truth, in metres.
pub fn distance<T: Scalar>(row: Row<'_>, [x, y]: [T; 2]) -> f64 {
    row.error("x", x).hypot(row.error("y", y))
}
