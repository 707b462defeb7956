use super::{Constant, Polynomial};

/// What the kernels need of a scalar beyond [`Real`](super::Real): functions, bits, and numbers by precision.
///
/// Private, so that users' code can neither name nor call it: its names may then differ in meaning from those
/// of `f64`, and one that users' code has from another trait is never ambiguous.
pub(crate) trait Kernel: Sized + Copy {
    /// A literal as a constant of the scalar: see `literal!`.
    type Literal<const BITS: u64>: Constant<Self>;

    /// One of two constants, by precision.
    fn pick(for_f64: f64, for_f32: f32) -> Self;

    /// The number of terms of a sum that this precision needs.
    fn terms(for_f64: usize, for_f32: usize) -> usize;

    /// The number of steps that this precision needs of an iteration that at least doubles its digits. A
    /// derivative follows the value one step behind, and needs one step more.
    fn steps(for_f64: usize, for_f32: usize) -> usize;

    /// The polynomial c₀ + c₁x + c₂x² + … with the coefficients of this precision. Horner's rule; more than 8
    /// terms are summed as three polynomials in x³, for three short chains have less latency than a long one.
    fn polynomial<const N: usize, const M: usize>(self, coefficients: &Polynomial<N, M>) -> Self;

    /// The same polynomial of the complex number x + iy, of at most 42 terms: real and imaginary part.
    fn complex_polynomial<const N: usize, const M: usize>(
        number: [Self; 2],
        coefficients: &Polynomial<N, M>,
    ) -> [Self; 2];

    /// One coefficient of this precision; 0 past the end.
    fn coefficient<const N: usize, const M: usize>(coefficients: &Polynomial<N, M>, index: usize) -> Self;

    /// All coefficients of this precision, where there are as many for both.
    fn all<const N: usize>(coefficients: &Polynomial<N, N>) -> [Self; N];

    /// `self`, but a zero takes the sign of `sign`. Any other number must have that sign already.
    fn signed_like(self, sign: Self) -> Self;

    /// 0 in place of the value; derivatives stay.
    fn vanish(self) -> Self;

    /// Whether this is 0 and all derivatives are 0.
    #[cfg(feature = "num-traits")]
    fn is_nothing(self) -> bool;

    /// The nearest integer, ties to even, for |x| ≤ 2⁵¹ (`f64`) or 2²² (`f32`).
    ///
    /// It adds and subtracts 1.5·2⁵² (1.5·2²³): two additions on every machine, where `rint` may be a call.
    fn round_ties_even(self) -> Self;

    /// The largest integer that is not larger, for |x| < 2³¹.
    fn floor(self) -> i32;

    /// Sine and cosine turned by `self` quarter circles, an integer in the range of
    /// [`round_ties_even`](Self::round_ties_even). By the number's bits: no machine takes a branch for it.
    fn quarters(self, turned: (Self, Self)) -> (Self, Self);

    /// `(h, l)` with `h + l = x` exactly and `h` short enough for `h·h'` to be exact with any other such `h'`
    /// (Veltkamp's splitting). For |x| below the square root of the largest number.
    fn split(self) -> (Self, Self);

    /// A first guess at the cube root of a positive normal number, within 4 % (the exponent divided by
    /// three).
    fn cbrt_guess(self) -> Self;

    /// The integer k with √½ ≤ x/2ᵏ < √2, of a positive normal number x (from its bits).
    fn exponent(self) -> Self;

    /// 2ⁿ of an integer n, −1022 ≤ n ≤ 1023 (`f64`) or −126 ≤ n ≤ 127 (`f32`) (by its bits).
    fn power_of_two(self) -> Self;

    /// The remainder of `self / divisor` with the sign of `self`; exact.
    fn remainder(self, divisor: Self) -> Self;

    /// The scalar equal to a byte, by setting bits, which vectorises on every machine.
    fn from_byte(byte: u8) -> Self;

    /// The byte equal to an integer in 0 to 255: the inverse of [`from_byte`](Self::from_byte).
    fn to_byte(self) -> u8;
}
