use super::select;
use crate::Real;

/// The smaller of two numbers: `a` if `a < b`, else `b`.
///
/// So the result is `b` if one of them is NaN, where `f64::min` returns the one that is not. It is `b` of two zeros.
///
/// ```
/// use terrella::math::min;
/// assert_eq!(min(1.0_f64, 2.0), 1.0);
/// assert!(min(1.0_f64, f64::NAN).is_nan());
/// ```
#[doc(alias = "fmin")]
#[must_use]
#[inline(always)]
pub fn min<T: Real>(a: T, b: T) -> T {
    select(a < b, a, b)
}

/// The larger of two numbers: `a` if `a > b`, else `b`.
///
/// So the result is `b` if one of them is NaN, where `f64::max` returns the one that is not. It is `b` of two zeros.
///
/// ```
/// use terrella::math::max;
/// assert_eq!(max(1.0_f32, 2.0), 2.0);
/// assert!(max(1.0_f32, f32::NAN).is_nan());
/// ```
#[doc(alias = "fmax")]
#[must_use]
#[inline(always)]
pub fn max<T: Real>(a: T, b: T) -> T {
    select(a > b, a, b)
}
