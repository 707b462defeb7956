//! Where something is: [`LatLon`] in degrees, [`Direction`] as a unit vector, and the way between them; [`Geodetic`], with a
//! height, and [`Ecef`] in metres.

mod direction;
mod ecef;
mod geodetic;
mod lat_lon;

pub use direction::{Direction, InvalidDirection};
pub use ecef::{Ecef, InvalidEcef};
pub use geodetic::{Geodetic, InvalidHeight};
pub use lat_lon::{InvalidLatLon, LatLon};

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
