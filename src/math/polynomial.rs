use super::Polynomial;
use crate::Real;

/// c₀ + c₁x + … of at least two terms, even and odd powers apart: half as long a chain as Horner's rule.
#[inline(always)]
pub(crate) fn halves<T: Real>(x: T, terms: usize, c: impl Fn(usize) -> T) -> T {
    let square = x * x;
    let (mut one, mut other) = (c(terms - 1), c(terms - 2));
    for i in (0..terms - 2).rev() {
        (one, other) = (other, one * square + c(i));
    }
    other + x * one
}

/// An odd function f with f(1) = 1, from the polynomial p in f(x) = x − x(1 − x²)p(x²): exact at −1, 0 and 1
/// whatever the coefficients' rounding, so that a face's edge stays its edge.
#[inline(always)]
pub(crate) fn odd_unit<T: Real, const N: usize, const M: usize>(x: T, p: &Polynomial<N, M>) -> T {
    let z = x * x;
    // A zero keeps its sign: it may be what tells longitude −180 from 180.
    (x - x * (T::ONE - z) * z.polynomial(p)).signed_like(x)
}
