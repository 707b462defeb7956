use crate::Real;

/// Coefficients of a polynomial, lowest power first: `N` of them for `f64`, `M` for `f32`.
///
/// Evaluate it with [`Real::polynomial`].
///
/// ```
/// use terrella::{Real, math::Polynomial};
/// // eˣ − 1 − x, as far as each precision sees it near 0.01
/// let p = Polynomial { f64: [0.0, 0.0, 0.5, 1.0 / 6.0, 1.0 / 24.0], f32: [0.0, 0.0, 0.5] };
/// assert!((0.01_f64.polynomial(&p) - (0.01_f64.exp_m1() - 0.01)).abs() < 1e-12);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Polynomial<const N: usize, const M: usize> {
    /// For `f64`.
    pub f64: [f64; N],
    /// For `f32`.
    pub f32: [f32; M],
}

impl<const N: usize> Polynomial<N, N> {
    /// The same coefficients for both precisions, rounded to `f32` for that one.
    #[must_use]
    pub const fn rounded(coefficients: [f64; N]) -> Self {
        let mut rounded = [0.0; N];
        let mut i = 0;
        #[allow(clippy::indexing_slicing)] // a constant function has no iterators; i < N
        while i < N {
            rounded[i] = coefficients[i] as f32;
            i += 1;
        }
        Self {
            f64: coefficients,
            f32: rounded,
        }
    }
}

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

/// An odd function f with f(1) = 1, from the polynomial p in f(x) = x − x(1 − x²)p(x²): exact at −1, 0 and 1 whatever the
/// coefficients' rounding, so that a face's edge stays its edge.
#[inline(always)]
pub(crate) fn odd_unit<T: Real, const N: usize, const M: usize>(x: T, p: &Polynomial<N, M>) -> T {
    let z = x * x;
    // A zero keeps its sign: it may be what tells longitude −180 from 180.
    (x - x * (T::ONE - z) * z.polynomial(p)).signed_like(x)
}
