use super::exp_m1::ln_2;
use super::minimax::ATANH;
use super::{atan2, either, exp_m1, max, select};
use crate::Real;

/// The Gudermannian gd ψ = atan sinh ψ, in radians.
#[inline(always)]
pub(crate) fn gudermannian<T: Real>(psi: T) -> T {
    // With q = e^−|ψ|: tan χ = (1 − q²)/2q, and 1 − q is known better than q.
    let less = -exp_m1(-psi.abs());
    let q = T::ONE - less;
    atan2(less * (T::ONE + q), q + q).copysign(psi)
}

/// Its inverse from sine and cosine, ln((1 + sin χ)/cos χ) = atanh sin χ; ∞ where the cosine is not positive.
///
/// With (1 + sin χ)/(2ᵏ cos χ) = r, √½ ≤ r ≤ √2, it is k ln 2 + 2 atanh((r − 1)/(r + 1)).
#[inline(always)]
pub(crate) fn inverse_gudermannian<T: Real>((sin, cos): (T, T)) -> T {
    let s = sin.abs();
    let c = max(cos, T::ZERO);
    let more = T::ONE + s;
    let exponent = c.exponent();
    let scaled = c * (-exponent).power_of_two();
    let beyond = more > scaled * T::of(core::f64::consts::SQRT_2);
    let k = either(beyond, T::ONE) - exponent;
    let scaled = scaled + either(beyond, scaled);
    // For k = 0 the fraction is tan χ/2, without a difference.
    let near = k == T::ZERO;
    let tangent = select(near, s, more - scaled) / select(near, T::ONE + c, more + scaled);
    let main = tangent + tangent;
    let z = tangent * tangent;
    let (head, tail) = ln_2::<T>();
    let base = k * head;
    let high = base + main;
    let lost = (base - high) + main;
    let value = high + (lost + (k * tail + main * (z * z.polynomial(&ATANH))));
    select(c > T::ZERO, value, s * T::of(f64::INFINITY)).copysign(sin)
}
