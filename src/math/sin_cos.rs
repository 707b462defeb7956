use super::minimax::{COS, SIN};
use super::{choose, halves, mirrored, select};
use crate::Real;

/// Returns the sine and the cosine of an angle `x` in radians.
///
/// The error is below 0.8 ulp for |x| ≤ 10⁵ (`f64`) and 0.81 ulp for |x| ≤ 100 (`f32`), next to the multiples
/// of π/2 too. Both are NaN beyond.
///
/// ```
/// let (sin, cos) = terrella::math::sin_cos(core::f64::consts::FRAC_PI_2);
/// assert_eq!((sin, cos), (1.0, 6.123233995736766e-17));
/// ```
#[must_use]
#[cfg_attr(not(small), inline(always))]
pub fn sin_cos<T: Real>(x: T) -> (T, T) {
    // Reduction by three parts of π/2 (Cody and Waite), then the polynomials of `minimax.py`.
    let q = (x * T::of(core::f64::consts::FRAC_2_PI)).round_ties_even();
    // π/2 in parts of 33, 33 and 53 bits (17, 17, 24): q times each of the first two is exact.
    let a = x - q * T::pick(1.570_796_326_734_125_6, 1.570_785_5);
    let b = q * T::pick(6.077_100_506_303_966e-11, 1.080_427_3e-5);
    let c = q * T::pick(2.022_266_248_795_950_6e-21, 6.077_100_6e-11);
    let high = a - b;
    let low = ((a - high) - b) - c;
    // The part that the third subtraction shifts into `high` matters where a − b cancels.
    let r = high + low;
    let low = (high - r) + low;
    let limit = T::pick(1e5, 100.0);
    let r = select(x.abs() <= limit, r, T::of(f64::NAN));
    let [result, _] = reduced(r, low, T::ZERO);
    q.quarters(result)
}

/// Returns the sine and the cosine of an angle `x` in degrees.
///
/// The error is below 0.8 ulp for |x| ≤ 10⁹ (`f64`) and |x| ≤ 10⁶ (`f32`). Both are NaN beyond. Results of 0,
/// ±½ and ±1 are exact; a sine of 0 has the sign of `x`. For |x| below 10⁻³⁰⁷ (10⁻³⁷) the error of a sine is
/// below 1.5 ulp.
///
/// ```
/// let (sin, cos) = terrella::math::sin_cos_degrees(-240.0_f32);
/// assert_eq!(cos, -0.5);
/// assert_eq!(terrella::math::sin_cos_degrees(180.0_f64), (0.0, -1.0));
/// ```
#[must_use]
#[cfg_attr(not(small), inline(always))]
pub fn sin_cos_degrees<T: Real>(x: T) -> (T, T) {
    let (q, (high, low)) = quarter_and_rest(x);
    let [result, _] = reduced(high, low, T::ZERO);
    zero_of_sign(q.quarters(result), x)
}

/// Sine and cosine of degrees, each as a sum of two numbers within 0.2 ulp. The first number is that of
/// [`sin_cos_degrees`], except for its last rounding.
#[cfg_attr(not(small), inline(always))]
pub(crate) fn sin_cos_degrees_with_rest<T: Real>(x: T) -> [(T, T); 2] {
    let (q, (high, low)) = quarter_and_rest(x);
    let (head, tail) = high.split();
    let square_lost = ((head * head - high * high) + (head + head) * tail) + tail * tail;
    let [result, rest] = reduced(high, low, square_lost * T::of(0.5));
    [zero_of_sign(q.quarters(result), x), q.quarters(rest)]
}

/// The nearest multiple of 90°, and the rest in radians as a sum of two numbers.
#[inline(always)]
fn quarter_and_rest<T: Real>(x: T) -> (T, (T, T)) {
    let q = (x * T::of(1.0 / 90.0)).round_ties_even();
    let rest = select(x.abs() <= T::pick(1e9, 1e6), x - q * T::of(90.0), T::of(f64::NAN));
    (q, radians(rest))
}

/// A sine of zero has the sign of the angle, so that −180 and 180 stay apart; a cosine's is positive.
#[inline(always)]
fn zero_of_sign<T: Real>((sin, cos): (T, T), x: T) -> (T, T) {
    (select(sin == T::ZERO, sin.signed_like(x), sin), cos + T::ZERO)
}

/// Degrees to radians, as a sum of two numbers: π/180 is split so that its head times the argument's head is
/// exact.
#[inline(always)]
fn radians<T: Real>(degrees: T) -> (T, T) {
    let (head, tail) = degrees.split();
    let k1 = T::pick(0.017_453_292_384_743_69, 0.017_448_425);
    let k2 = T::pick(1.351_996_052_785_142_5e-10, 4.867_227e-6);
    let product = head * k1;
    let rest = tail * k1 + degrees * k2;
    let high = product + rest;
    (high, rest - (high - product))
}

/// Sine and cosine of `x + low`, |x| ≤ π/4, `low` below half an ulp of `x`, and what their last rounding
/// lost; `lost` is what that of half of x² lost.
#[inline(always)]
fn reduced<T: Real>(x: T, low: T, lost: T) -> [(T, T); 2] {
    let z = x * x;
    let half = z * T::of(0.5);
    // sin(x + l) = x + (l·cos x + x³p); cos x ≈ 1 − z/2 is enough for l.
    let small_sin = low * (T::ONE - half) + x * z * z.polynomial(&SIN);
    let sin = x + small_sin;
    // 1 − z/2 is rounded once; what that lost goes into the small terms (as in fdlibm's k_cos).
    let w = T::ONE - half;
    let small_cos = ((T::ONE - w) - half) + ((z * z * z.polynomial(&COS) - x * low) - lost);
    let cos = w + small_cos;
    [(sin, cos), (small_sin - (sin - x), small_cos - (cos - w))]
}

/// Sine and cosine of 0 ≤ x ≤ 90 degrees, within 1.5 ulp.
#[cfg_attr(not(small), inline(always))]
#[cfg_attr(small, inline(never))]
pub(crate) fn sin_cos_quarter<T: Real>(x: T) -> (T, T) {
    let upper = x > T::of(45.0);
    let turned = mirrored(upper, T::of(90.0), x);
    let (sin, cos) = sin_cos_eighth(turned * T::of(core::f64::consts::PI / 180.0));
    (choose(upper, cos, sin), choose(upper, sin, cos))
}

/// Sine and cosine of |x| ≤ π/4, within 1 ulp, by a shorter chain than [`sin_cos_small`].
#[cfg_attr(not(small), inline(always))]
pub(crate) fn sin_cos_eighth<T: Real>(x: T) -> (T, T) {
    let z = x * x;
    let sin = x + x * z * halves(z, T::terms(6, 4), |i| T::coefficient(&SIN, i));
    let cos = T::ONE - (T::of(0.5) * z - z * z * halves(z, T::terms(6, 3), |i| T::coefficient(&COS, i)));
    (sin, cos)
}

/// Sine and cosine of |x| ≤ π/4, without a reduction.
#[cfg_attr(not(small), inline(always))]
pub(crate) fn sin_cos_small<T: Real>(x: T) -> (T, T) {
    let [result, _] = reduced(x, T::ZERO, T::ZERO);
    result
}
