use super::minimax::TAN;
use crate::Real;

/// Tangent of an angle in radians, |x| ≤ π/4.
///
/// Within 1.2 ulp there; the polynomial means nothing beyond.
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
