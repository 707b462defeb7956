use super::minimax::TAN;
use crate::Real;

/// Returns the tangent of an angle `x` in radians, |x| ≤ π/4.
///
/// The error is below 1.2 ulp in this domain. Beyond it the result is not the tangent: divide the results of
/// [`sin_cos`](super::sin_cos) there.
///
/// ```
/// assert_eq!(terrella::math::tan(core::f32::consts::FRAC_PI_4), 1.0);
/// ```
#[must_use]
#[inline(always)]
pub fn tan<T: Real>(x: T) -> T {
    let z = x * x;
    x + x * z * z.polynomial(&TAN)
}
