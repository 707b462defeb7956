use super::{repeat, select};
use crate::Real;

/// Returns the cube root of `x`.
///
/// The error is below 1 ulp for normal numbers. Zeros, infinities and NaN are returned as they are. Subnormal
/// numbers have no bound.
///
/// ```
/// assert_eq!(terrella::math::cbrt(27.0_f64), 3.0);
/// ```
#[must_use]
#[cfg_attr(not(small), inline(always))]
pub fn cbrt<T: Real>(x: T) -> T {
    // Halley's iteration from a guess that divides the exponent by three.
    // An eighth of a number next to the largest, for thrice its cube would be none.
    let large = x.abs() > T::pick(1e300, 1e37);
    let magnitude = x.abs() * select(large, T::of(0.125), T::ONE);
    let mut root = magnitude.cbrt_guess();
    repeat!(T::steps(3, 2), {
        let cube = root * root * root;
        root += root * ((magnitude - cube) / (cube + cube + magnitude));
    });
    let root = root * select(large, T::of(2.0), T::ONE);
    select(x.is_finite() & (x != T::ZERO), root.copysign(x), x)
}
