use super::minimax::EXP;
use super::{halves, max, select};
use crate::Real;

/// Returns eˣ − 1, without the cancellation of `exp(x) - 1` for a small `x`.
///
/// The error is below 0.75 ulp for every `x`, subnormal numbers included. The result for −∞ is −1; it is ∞
/// where eˣ is larger than the largest number. A zero keeps its sign.
///
/// ```
/// use terrella::math::exp_m1;
/// assert_eq!(exp_m1(-1e-20_f64), -1e-20);
/// assert_eq!(exp_m1(f32::NEG_INFINITY), -1.0);
/// ```
#[must_use]
#[inline(always)]
pub fn exp_m1<T: Real>(x: T) -> T {
    // eˣ = 2ⁿeʳ, |r| ≤ ½ ln 2; the polynomial is of `minimax.py`.
    let half = T::of(0.5);
    // Further down there is nothing but −1, and 2ⁿ would be out of range.
    let bounded = max(T::pick(-708.0, -86.0), x);
    let n = (bounded * T::of(core::f64::consts::LOG2_E)).round_ties_even();
    let (head, tail) = ln_2::<T>();
    let near = bounded - n * head;
    let less = n * tail;
    let r = near - less;
    let lost = (near - r) - less;
    let z = r * r;
    let curve = halves(r, T::terms(EXP.f64.len(), EXP.f32.len()), |i| T::coefficient(&EXP, i));
    let main = r + z * half;
    let rest = ((r - main) + z * half) + (z * r * curve + (lost + lost * r));
    // Half of the result, for 2¹⁰²⁴ (2¹²⁸) is no number and the result may be one.
    let scale = (n - T::ONE).power_of_two();
    let from = scale - half;
    let scaled = scale * main;
    let high = from + scaled;
    let lost = ((scale - from) - half) + ((from - high) + scaled);
    let value = T::of(2.0) * (high + (lost + scale * rest));
    let value = select(x < T::pick(710.0, 89.0), value, x * T::of(f64::INFINITY));
    // Half of a subnormal number may not be one.
    select(x.abs() < T::EPSILON * T::of(0.25), x, value)
}

/// ln 2 in parts of 42 and 53 bits (17, 24): an exponent times the first is exact.
#[inline(always)]
pub(super) fn ln_2<T: Real>() -> (T, T) {
    (
        T::pick(0.693_147_180_559_890_3, 0.693_145_75),
        T::pick(5.497_923_018_708_371e-14, 1.428_606_8e-6),
    )
}
