//! Angles: by sine and cosine, as differences of latitudes and longitudes with what the rounding of the
//! difference lost, and azimuths as users give them.

use super::{GeodesicError, Inverse};
use crate::math::{DoubleWord, atan2, atan2_degrees, either, hypot, max, select, sin_cos, sin_cos_degrees};
use crate::{LatLon, Real};

/// An angle by its sine and cosine.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Angle<T> {
    pub sin: T,
    pub cos: T,
}

impl<T> From<(T, T)> for Angle<T> {
    #[inline(always)]
    fn from((sin, cos): (T, T)) -> Self {
        Self { sin, cos }
    }
}

impl<T: Real> Angle<T> {
    /// The angle of the point (cos, sin), of any length; 0 of the origin, where places are so near that
    /// products underflow.
    #[inline]
    pub fn of(sin: T, cos: T) -> Self {
        let length = hypot(sin, cos);
        let origin = length == T::ZERO;
        let divisor = select(origin, T::ONE, length);
        Self {
            sin: sin / divisor,
            cos: select(origin, T::ONE, cos / divisor),
        }
    }

    #[cfg_attr(not(small), inline(always))]
    pub fn degrees(degrees: T) -> Self {
        sin_cos_degrees(degrees).into()
    }

    #[cfg_attr(not(small), inline(always))]
    pub fn radians(radians: T) -> Self {
        sin_cos(radians).into()
    }

    #[cfg_attr(not(small), inline(always))]
    pub fn to_radians(self) -> T {
        atan2(self.sin, self.cos)
    }

    #[cfg_attr(not(small), inline(always))]
    pub fn to_degrees(self) -> T {
        atan2_degrees(self.sin, self.cos)
    }

    /// The sum of two angles.
    #[cfg_attr(not(small), inline(always))]
    pub fn plus(self, other: Self) -> Self {
        Self {
            sin: self.sin * other.cos + self.cos * other.sin,
            cos: self.cos * other.cos - self.sin * other.sin,
        }
    }

    /// The difference of two angles.
    #[cfg_attr(not(small), inline(always))]
    pub fn minus(self, other: Self) -> Self {
        self.plus(other.opposite())
    }

    /// The angle of opposite sign.
    #[cfg_attr(not(small), inline(always))]
    pub fn opposite(self) -> Self {
        Self {
            sin: -self.sin,
            cos: self.cos,
        }
    }

    /// The sum of this angle and one of less than 0.03 radians, by Taylor series.
    #[inline(always)]
    pub fn plus_small(self, radians: T) -> Self {
        let of = T::of;
        let square = radians * radians;
        let (sin, versine) = if T::terms(3, 2) == 3 {
            (
                radians - radians * square * (of(1.0 / 6.0) - of(1.0 / 120.0) * square),
                square * (of(0.5) - square * (of(1.0 / 24.0) - of(1.0 / 720.0) * square)),
            )
        } else {
            (radians - radians * square * of(1.0 / 6.0), square * of(0.5))
        };
        Self {
            sin: self.sin + (self.cos * sin - self.sin * versine),
            cos: self.cos - (self.sin * sin + self.cos * versine),
        }
    }
}

impl<T: Real> DoubleWord<T> {
    /// Sine and cosine of this number of degrees.
    #[inline(always)]
    pub(crate) fn sin_cos_degrees(self) -> (T, T) {
        let small = self.low * T::of(core::f64::consts::PI / 180.0);
        let (sin, cos) = sin_cos_degrees(self.high);
        (sin + cos * small, cos - sin * small)
    }
}

/// The second latitude less the first, in degrees.
#[cfg_attr(not(small), inline(always))]
pub fn latitude_difference<T: Real>(from: LatLon<T>, to: LatLon<T>) -> DoubleWord<T> {
    DoubleWord::sum(to.lat(), -from.lat())
}

/// The second longitude less the first, in degrees, as [`longitude_difference`] but in fewer steps: a
/// difference of more than 90 may lose its last place, and that of 180 and less than its rounding is 180.
#[cfg_attr(not(small), inline(always))]
pub fn longitude_step<T: Real>(from: LatLon<T>, to: LatLon<T>) -> DoubleWord<T> {
    let half_circle = T::of(180.0);
    let whole = to.lon() - from.lon();
    let over = either(whole.abs() > half_circle, half_circle.copysign(whole));
    DoubleWord::sum(to.lon() - over, -(from.lon() + over))
}

/// The second longitude less the first, in degrees, in [−180, 180].
#[cfg_attr(not(small), inline(always))]
pub fn longitude_difference<T: Real>(from: LatLon<T>, to: LatLon<T>) -> DoubleWord<T> {
    let half_circle = T::of(180.0);
    let whole = DoubleWord::sum(to.lon(), -from.lon());
    let over = either(whole.high.abs() > half_circle, half_circle.copysign(whole.high));
    let turned = DoubleWord::sum((whole.high - over) - over, whole.low);
    // A half circle and a little more is a half circle less that little, the other way round.
    let beyond = (turned.high.abs() == half_circle) & (turned.high * turned.low > T::ZERO);
    let high = select(beyond, -turned.high, turned.high);
    DoubleWord { high, ..turned }
}

/// An angle in [−540, 540] degrees brought to [−180, 180].
#[inline(always)]
pub fn wrapped<T: Real>(angle: T) -> T {
    let half_circle = T::of(180.0);
    let circle = T::of(360.0);
    angle - select(angle > half_circle, circle, T::ZERO) + select(angle < -half_circle, circle, T::ZERO)
}

/// Whether an azimuth in degrees is what it is without its whole turns.
#[inline(always)]
pub fn turns_once<T: Real>(azimuth: T) -> bool {
    azimuth.abs() <= T::of(360.0)
}

/// Sine and cosine of an azimuth in degrees, if it and the distance that belongs to it are finite.
#[cfg_attr(not(small), inline(always))]
pub fn heading<T: Real>(azimuth: T, distance: T) -> Result<(T, T), GeodesicError<T>> {
    if !azimuth.is_finite() {
        return Err(GeodesicError::Azimuth(azimuth));
    }
    if !distance.is_finite() {
        return Err(GeodesicError::Distance(distance));
    }
    let circle = T::of(360.0);
    let turned = if azimuth.abs() > circle {
        azimuth.remainder(circle)
    } else {
        azimuth
    };
    Ok(sin_cos_degrees(turned))
}

/// The cosine of a latitude, never 0: the azimuth at a pole is then the limit along the meridian.
#[inline(always)]
pub fn off_pole<T: Real>(cos: T) -> T {
    // 2^−511 and 2^−60: their squares are normal numbers still.
    max(cos, T::pick(1.491_668_146_240_041_3e-154, 8.673_617_4e-19))
}

/// Whether both places are poles.
#[inline(always)]
pub fn between_poles<T: Real>(from: LatLon<T>, to: LatLon<T>) -> bool {
    let right = T::of(90.0);
    (from.lat().abs() == right) & (to.lat().abs() == right)
}

/// The line itself; from pole to pole, where any meridian is a shortest line, the one that starts to the
/// north ([`Geodesic`](super::Geodesic)).
#[inline(always)]
pub fn northward_between_poles<T: Real>(from: LatLon<T>, to: LatLon<T>, line: Inverse<T>) -> Inverse<T> {
    if between_poles(from, to) {
        return Inverse {
            distance: select(from.lat() == to.lat(), T::ZERO, line.distance),
            azimuth1: T::ZERO,
            azimuth2: azimuth_at_pole(from, to),
        };
    }
    line
}

/// The azimuth at a pole of the line that leaves another pole, or the same one, to the north. Not inlined: a
/// caller who takes the distance alone does not link it.
#[cold]
#[inline(never)]
fn azimuth_at_pole<T: Real>(from: LatLon<T>, to: LatLon<T>) -> T {
    longitude_difference(from, to).value() * T::ONE.copysign(to.lat()) + T::ZERO
}
