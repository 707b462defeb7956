use core::f64::consts::{FRAC_1_SQRT_2, FRAC_PI_4};

use super::minimax::{ARC, ASIN};
use super::{descent, halves, max, min, shrunk_root, shrunk_square};
use crate::Real;

/// The arc with this sine, at least 0, and this cosine: a multiple of 45° as a count, and the rest in radians.
///
/// The sine or the cosine alone gives it, by the arc sine of at most π/8 from a multiple of 45°: without the
/// quotient that an arc tangent needs. So their squares must add to 1 but for their rounding.
#[cfg_attr(not(small), inline(always))]
pub(crate) fn arc<T: Real>(sin: T, cos: T) -> (T, T) {
    let (one, two) = (T::ONE, T::of(2.0));
    let width = cos.abs();
    let (low, high) = (min(sin, width), max(width, sin));
    let (side, flat) = (one.copysign(cos), descent(sin, width));
    // sin(π/8).
    let eighth = (one - descent(low, T::of(0.382_683_432_365_089_8))) * T::of(0.5);
    let s = (low - eighth * high) * (one - eighth * T::of(1.0 - FRAC_1_SQRT_2));
    let z = s * s;
    let curve = halves(z, T::terms(ASIN.f64.len(), ASIN.f32.len()), |i| {
        T::coefficient(&ASIN, i)
    });
    let rest = s + s * z * curve;
    let eighths = two * (one - side) + side * ((one - flat) + flat * eighth);
    (eighths, side * flat * rest)
}

/// The same arc in radians, as a sum of two numbers.
#[inline(always)]
pub(crate) fn arc_radians<T: Real>(sin: T, cos: T) -> (T, T) {
    let (eighths, rest) = arc(sin, cos);
    // π/4 in two parts, the first so short that four times it is exact.
    let high = eighths * T::pick(FRAC_PI_4, 1_647_099.0 / 2_097_152.0);
    (
        high,
        eighths * T::pick(3.061_616_997_868_383e-17, 1.569_582_4e-7) + rest,
    )
}

/// Twice the arc sine of the root of at most ½, which is given as the square of a number
/// [`grown`](super::grown).
#[inline(always)]
pub(crate) fn doubled_arc<T: Real>(square: T) -> T {
    let (chord, h) = (shrunk_root(square) * T::of(2.0), shrunk_square(square));
    chord + chord * h * halves(h, T::terms(ARC.f64.len(), ARC.f32.len()), |i| T::coefficient(&ARC, i))
}
