//! Positions: [`LatLon`] in degrees, [`Direction`] as a unit vector, [`Geodetic`] with a height, [`Ecef`] in
//! metres; their text, and the way from one scalar to the other.

mod direction;
mod dms;
mod ecef;
mod geodetic;
mod lat_lon;
mod nmea;
mod parse;
mod precision;
mod token;

use core::fmt;

pub use direction::{Direction, InvalidDirection};
pub use dms::{Dms, DmsLatLon};
pub use ecef::{Ecef, InvalidEcef};
pub use geodetic::{Geodetic, InvalidHeight};
pub use lat_lon::{InvalidLatLon, LatLon};
pub use nmea::{NmeaLatLon, ParseNmeaError};
pub use parse::ParseLatLonError;

use crate::Real;
use crate::math::{atan2_degrees, max, select};

/// [`atan2_degrees`] from the smallest numbers to the largest; (0, 0) gives 0, whatever the signs.
#[inline(always)]
pub(crate) fn angle_degrees<T: Real>(y: T, x: T) -> T {
    let largest = max(y.abs(), x.abs());
    let tiny = largest < T::pick(1e-280, 1e-28);
    let huge = largest > T::pick(2e307, 4e37);
    // Powers of two: 2^200 and 2^60, 2^−3.
    let grow = T::pick(1.606_938_044_258_990_3e60, 1.152_921_5e18);
    let scale = select(tiny, grow, select(huge, T::of(0.125), T::ONE));
    let angle = atan2_degrees(y * scale, x * scale);
    select((y == T::ZERO) & (x == T::ZERO), T::ZERO, angle)
}

/// Writes three numbers, each with the formatter's options, and text before, between and after them.
pub(crate) fn write_between<T: fmt::Display>(
    f: &mut fmt::Formatter<'_>,
    [before, then, and, after]: [&str; 4],
    [x, y, z]: [&T; 3],
) -> fmt::Result {
    f.write_str(before)?;
    x.fmt(f)?;
    f.write_str(then)?;
    y.fmt(f)?;
    f.write_str(and)?;
    z.fmt(f)?;
    f.write_str(after)
}
