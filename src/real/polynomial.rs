use super::{Real, repeat};

/// The coefficients of a polynomial, lowest power first: `N` of them for `f64`, `M` for `f32`.
///
/// Fewer terms are enough in single precision. [`at`](Self::at) evaluates the polynomial.
///
/// ```
/// use terrella::math::Polynomial;
/// // eˣ − 1 − x, for |x| ≤ 0.01
/// const P: Polynomial<5, 3> = Polynomial {
///     f64: [0.0, 0.0, 0.5, 1.0 / 6.0, 1.0 / 24.0],
///     f32: [0.0, 0.0, 0.5],
/// };
/// assert!((P.at(0.01_f64) - (0.01_f64.exp_m1() - 0.01)).abs() < 1e-12);
/// assert!((P.at(0.01_f32) - (0.01_f32.exp_m1() - 0.01)).abs() < 1e-6);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Polynomial<const N: usize, const M: usize> {
    /// For `f64`.
    pub f64: [f64; N],
    /// For `f32`.
    pub f32: [f32; M],
}

impl<const N: usize, const M: usize> Polynomial<N, M> {
    /// Returns c₀ + c₁x + c₂x² + … with the coefficients of the scalar's precision.
    ///
    /// The derivatives of a [`Dual`](crate::Dual) come from the derivative of the polynomial.
    ///
    /// ```
    /// use terrella::math::Polynomial;
    /// assert_eq!(Polynomial::rounded([1.0, 0.0, 3.0]).at(2.0_f32), 13.0);
    /// ```
    #[doc(alias = "horner")]
    #[must_use]
    #[inline(always)]
    pub fn at<T: Real>(&self, x: T) -> T {
        x.polynomial(self)
    }
}

impl<const N: usize> Polynomial<N, N> {
    /// Takes the same coefficients for both precisions, and rounds them for `f32`.
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

/// A polynomial of x + iy with `terms` real coefficients, at most 42: real and imaginary part. What is past
/// the last coefficient is 0.
///
/// Divided by the quadratic that a number and its conjugate are the roots of: two products a coefficient
/// (Knuth, The Art of Computer Programming 2, 4.6.4, eq. 3). Even and odd powers apart, as polynomials of the
/// square: two chains at a time.
#[inline(always)]
pub(crate) fn complex_polynomial<T: Real>([x, y]: [T; 2], terms: usize, coefficient: impl Fn(usize) -> T) -> [T; 2] {
    let times = |[a, b]: [T; 2], [c, d]: [T; 2]| [a * c - b * d, a * d + b * c];
    let square = times([x, y], [x, y]);
    let [re, im] = square;
    let (twice, norm) = (re + re, re * re + im * im);
    let (mut even, mut odd) = ((T::ZERO, T::ZERO), (T::ZERO, T::ZERO));
    let mut i = terms.div_ceil(2);
    repeat!(i.div_ceil(5), {
        repeat!((i - 1).min(5), {
            i -= 1;
            let next = |(a, b): (T, T), i| (coefficient(i) + (twice * a - norm * b), a);
            (even, odd) = (next(even, 2 * i), next(odd, 2 * i + 1));
        });
    });
    let last = |(a, b): (T, T), i| [coefficient(i) + (re * a - norm * b), im * a];
    let ([a, b], [c, d]) = (last(even, 0), times([x, y], last(odd, 1)));
    [a + c, b + d]
}
