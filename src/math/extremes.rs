use super::select;
use crate::Real;

/// Returns the smaller of two numbers: `a` if `a < b`, otherwise `b`.
///
/// If one of them is NaN, the result is `b`. (`f64::min` returns the other one.) Of two zeros it is `b` too.
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

/// Returns the larger of two numbers: `a` if `a > b`, otherwise `b`.
///
/// If one of them is NaN, the result is `b`. (`f64::max` returns the other one.) Of two zeros it is `b` too.
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
