//! Angles in degrees for the methods: differences with what their rounding lost, and what is done at every method's door.

use super::{GeodesicError, Inverse};
use crate::math::{either, max, select, sin_cos_degrees};
use crate::{LatLon, Real};

/// An angle as the sum of a number and a small rest.
#[derive(Clone, Copy)]
pub(super) struct Split<T> {
    pub angle: T,
    pub rest: T,
}

impl<T: Real> Split<T> {
    /// The sum, exactly (Knuth). Never −0, unless both are.
    #[inline(always)]
    pub fn sum(a: T, b: T) -> Self {
        let angle = a + b;
        let part = angle - a;
        let rest = (a - (angle - part)) + (b - part);
        Self { angle, rest }
    }

    /// Half of it.
    #[inline(always)]
    pub fn half(self) -> Self {
        let half = T::of(0.5);
        Self {
            angle: self.angle * half,
            rest: self.rest * half,
        }
    }

    /// Sine and cosine, of degrees.
    #[inline(always)]
    pub fn sin_cos(self) -> (T, T) {
        let small = self.rest * T::of(core::f64::consts::PI / 180.0);
        let (sin, cos) = sin_cos_degrees(self.angle);
        (sin + cos * small, cos - sin * small)
    }
}

/// The second latitude less the first.
#[cfg_attr(not(small), inline(always))]
pub(super) fn latitude_difference<T: Real>(from: LatLon<T>, to: LatLon<T>) -> Split<T> {
    Split::sum(to.lat(), -from.lat())
}

/// The second longitude less the first, in [−180, 180].
#[cfg_attr(not(small), inline(always))]
pub(super) fn longitude_difference<T: Real>(from: LatLon<T>, to: LatLon<T>) -> Split<T> {
    let half_circle = T::of(180.0);
    let whole = Split::sum(to.lon(), -from.lon());
    let over = either(whole.angle.abs() > half_circle, half_circle.copysign(whole.angle));
    let turned = Split::sum((whole.angle - over) - over, whole.rest);
    // A half circle and a little more is a half circle less that little, the other way round.
    let beyond = (turned.angle.abs() == half_circle) & (turned.angle * turned.rest > T::ZERO);
    let angle = select(beyond, -turned.angle, turned.angle);
    Split { angle, ..turned }
}

/// An angle in [−540, 540] brought to [−180, 180].
#[inline(always)]
pub(super) fn wrapped<T: Real>(angle: T) -> T {
    let half_circle = T::of(180.0);
    let circle = T::of(360.0);
    angle - select(angle > half_circle, circle, T::ZERO) + select(angle < -half_circle, circle, T::ZERO)
}

/// Refuses an azimuth or a distance that is not finite; sine and cosine of the azimuth.
#[cfg_attr(not(small), inline(always))]
pub(super) fn heading<T: Real>(azimuth: T, distance: T) -> Result<(T, T), GeodesicError<T>> {
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

/// √(x² + y²), of the smallest numbers too.
#[cfg_attr(not(small), inline(always))]
#[cfg_attr(small, inline(never))]
pub(super) fn hypot<T: Real>(x: T, y: T) -> T {
    let small = max(x.abs(), y.abs()) < T::pick(3.054_936_363_499_605e-151, 8.673_617_4e-19);
    // 2^±600 and 2^±100.
    let grow = select(small, T::pick(4.149_515_568_880_993e180, 1.267_650_6e30), T::ONE);
    let shrink = select(small, T::pick(2.409_919_865_102_884e-181, 7.888_609e-31), T::ONE);
    let (x, y) = (x * grow, y * grow);
    (x * x + y * y).sqrt() * shrink
}

/// The cosine of a latitude, never 0: the azimuth at a pole is then the limit along the meridian.
#[inline(always)]
pub(super) fn off_pole<T: Real>(cos: T) -> T {
    // 2^−511 and 2^−60: their squares are normal numbers still.
    max(cos, T::pick(1.491_668_146_240_041_3e-154, 8.673_617_4e-19))
}

/// A line as it is; between poles, where it may be any meridian, the one that starts to the north
/// ([`Geodesic`](super::Geodesic)).
#[inline(always)]
pub(super) fn northward_between_poles<T: Real>(from: LatLon<T>, to: LatLon<T>, line: Inverse<T>) -> Inverse<T> {
    let right = T::of(90.0);
    if (from.lat().abs() == right) & (to.lat().abs() == right) {
        return Inverse {
            distance: select(from.lat() == to.lat(), T::ZERO, line.distance),
            azimuth1: T::ZERO,
            azimuth2: azimuth_at_pole(from, to),
        };
    }
    line
}

/// Of the line that leaves another pole, or the same, to the north. By itself: a caller who takes the
/// distance alone does not link it.
#[cold]
#[inline(never)]
fn azimuth_at_pole<T: Real>(from: LatLon<T>, to: LatLon<T>) -> T {
    let Split { angle, rest } = longitude_difference(from, to);
    (angle + rest) * T::ONE.copysign(to.lat()) + T::ZERO
}
