use super::minimax::ATANH;
use super::select;
use crate::Real;

/// Returns the logarithm of `x` to base 2.
///
/// The error is below 0.85 ulp for every `x`, subnormal numbers included; powers of two are exact. The
/// logarithm of 0 is −∞, of ∞ it is ∞. It is NaN below 0.
///
/// ```
/// assert_eq!(terrella::math::log2(0.125_f32), -3.0);
/// ```
#[must_use]
#[inline(always)]
pub fn log2<T: Real>(x: T) -> T {
    // By a power of two, 2⁵⁴ (2²⁴) or ¼, to where the number is normal and so is 2⁻ᵏ.
    let small = x < T::ONE;
    let scaled = x * select(small, T::pick(18_014_398_509_481_984.0, 16_777_216.0), T::of(0.25));
    let k = scaled.exponent();
    let f = scaled * (-k).power_of_two() - T::ONE;
    let k = k - select(small, T::pick(54.0, 24.0), T::of(-2.0));
    let (main, rest) = ln(f);
    // 1/ln 2 is split so that its head times the logarithm's is exact.
    let k1 = T::pick(1.442_695_051_431_655_9, 1.442_382_8);
    let k2 = T::pick(-1.054_269_247_642_913_8e-8, 3.122_283_9e-4);
    let (head, tail) = main.split();
    let product = head * k1;
    let high = k + product;
    let lost = (k - high) + product;
    let value = high + (lost + (tail * k1 + (main * k2 + rest * (k1 + k2))));
    let infinity = T::of(f64::INFINITY);
    let edge = select(x == T::ZERO, -infinity, select(x < T::ZERO, T::of(f64::NAN), x));
    select((x > T::ZERO) & (x < infinity), value, edge)
}

/// ln(1 + f) as a sum of two numbers, √½ ≤ 1 + f ≤ √2: 2 atanh(f/(2 + f)), as fdlibm writes it.
#[inline(always)]
fn ln<T: Real>(f: T) -> (T, T) {
    let s = f / (T::of(2.0) + f);
    let z = s * s;
    let half = T::of(0.5) * (f * f);
    let main = f - half;
    (main, ((f - main) - half) + s * (half + (z + z) * z.polynomial(&ATANH)))
}
