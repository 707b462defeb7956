//! [`Real`], the scalar everything is generic over.

use core::fmt::{Debug, Display};
use core::ops::{Add, AddAssign, Div, Mul, MulAssign, Neg, Sub, SubAssign};

use crate::math::{Polynomial, complex_polynomial, remainder, repeat};

pub(crate) mod sealed {
    use crate::literal::{Constant, Literal};

    pub trait Sealed: Sized {
        /// A literal as a constant of the scalar: see `literal!`.
        type Literal<const BITS: u64>: Constant<Self>;
    }
    impl Sealed for f32 {
        type Literal<const BITS: u64> = Literal<BITS>;
    }
    impl Sealed for f64 {
        type Literal<const BITS: u64> = Literal<BITS>;
    }
}

/// A scalar: `f32`, `f64`, or a [`Dual`](crate::Dual) number over one of them. Sealed.
///
/// Only what depends on the precision lives here: constants, the length of a polynomial, how a word is split. All else is
/// written once, generically, from `+ − × ÷ √`; the `f32` instantiation does no `f64` arithmetic.
///
/// ```
/// use terrella::Real;
/// fn cube<T: Real>(x: T) -> T {
///     x * x * x
/// }
/// assert_eq!(cube(2.0_f32), 8.0);
/// ```
pub trait Real:
    sealed::Sealed
    + Copy
    + Default
    + Debug
    + Display
    + PartialEq
    + PartialOrd
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
    + AddAssign
    + SubAssign
    + MulAssign
    + Send
    + Sync
    + 'static
{
    /// The scalar without derivatives: itself, if it has none.
    type Plain: Real;

    /// 0.
    const ZERO: Self;
    /// 1.
    const ONE: Self;
    /// The distance from 1 to the next larger number: 2⁻²³ or 2⁻⁵².
    const EPSILON: Self;
    /// Binary digits of a number: 24 or 53.
    const DIGITS: u32;

    /// The scalar nearest to a literal. Of a constant it is a constant: no conversion is left at run time.
    #[must_use]
    fn of(literal: f64) -> Self;

    /// The value without derivatives.
    #[must_use]
    fn plain(self) -> Self::Plain;

    /// A value without derivatives.
    #[must_use]
    fn from_plain(value: Self::Plain) -> Self;

    /// The scalar nearest to a whole number.
    #[must_use]
    fn whole(number: u64) -> Self;

    /// The scalar equal to a byte, by setting bits, which vectorises on every machine.
    #[must_use]
    fn from_byte(byte: u8) -> Self;

    /// The byte equal to a whole number in 0 to 255: the inverse of [`from_byte`](Self::from_byte).
    #[must_use]
    fn to_byte(self) -> u8;

    /// One of two constants, by precision.
    #[must_use]
    fn pick(for_f64: f64, for_f32: f32) -> Self;

    /// The polynomial `c₀ + c₁x + c₂x² + …`, with the coefficients of this precision, by Horner's rule; of more
    /// than 12 terms in x³ for every third one: three short chains in place of a long one, for which a processor would wait.
    #[must_use]
    fn polynomial<const N: usize, const M: usize>(self, coefficients: &Polynomial<N, M>) -> Self;

    /// The same polynomial of the complex number x + iy, of at most 42 terms: real and imaginary part.
    #[must_use]
    #[inline(always)]
    fn complex_polynomial<const N: usize, const M: usize>(
        number: [Self; 2],
        coefficients: &Polynomial<N, M>,
    ) -> [Self; 2] {
        complex_polynomial(number, Self::terms(N, M), |i| Self::coefficient(coefficients, i))
    }

    /// One coefficient for this precision, 0 past the end.
    #[must_use]
    fn coefficient<const N: usize, const M: usize>(coefficients: &Polynomial<N, M>, index: usize) -> Self;

    /// All coefficients for this precision, where there are as many for both.
    #[must_use]
    fn all<const N: usize>(coefficients: &Polynomial<N, N>) -> [Self; N];

    /// How many terms of a sum this precision needs.
    #[must_use]
    fn terms(for_f64: usize, for_f32: usize) -> usize;

    /// How many steps of an iteration that at least doubles its digits this precision needs; one more for a derivative, which follows
    /// the value a step behind.
    #[must_use]
    fn steps(for_f64: usize, for_f32: usize) -> usize;

    /// The correctly rounded square root.
    #[must_use]
    fn sqrt(self) -> Self;

    /// The absolute value.
    #[must_use]
    fn abs(self) -> Self;

    /// The magnitude of `self` with the sign of `sign`, signed zeros included.
    #[must_use]
    fn copysign(self, sign: Self) -> Self;

    /// The same number, but a zero takes the sign of `sign`, which any other number has already.
    #[must_use]
    fn signed_like(self, sign: Self) -> Self;

    /// 0 in place of a value; what a [`Dual`](crate::Dual) carries beside it stays.
    #[must_use]
    fn vanish(self) -> Self;

    /// Whether the value is neither infinite nor NaN.
    #[must_use]
    fn is_finite(self) -> bool;

    /// The nearest integer, ties to even, for |x| ≤ 2⁵¹ (`f64`) or 2²² (`f32`).
    ///
    /// By adding and subtracting 1.5·2⁵² (1.5·2²³): two additions on every machine, where `rint` may be a call.
    #[must_use]
    fn round(self) -> Self;

    /// Sine and cosine turned by a whole number of quarter circles, `self`, for as large ones as [`round`](Self::round) takes. By the number's
    /// bits: no machine takes a branch for it.
    #[must_use]
    fn quarters(self, turned: (Self, Self)) -> (Self, Self);

    /// The largest whole number that is not larger, for |x| < 2³¹.
    #[must_use]
    fn floor(self) -> i32;

    /// `(h, l)` with `h + l = x` exactly and `h` short enough for `h·h'` to be exact with any other such `h'`
    /// (Veltkamp's splitting). For |x| below the square root of the largest number.
    #[must_use]
    fn split(self) -> (Self, Self) {
        let scaled = self * Self::pick(134_217_729.0, 4097.0);
        let high = scaled - (scaled - self);
        (high, self - high)
    }

    /// A first guess at the cube root of a positive normal number, within 4 % (the exponent divided by three).
    #[must_use]
    fn cbrt_guess(self) -> Self;

    /// The whole number k with √½ ≤ x/2ᵏ < √2, of a positive normal number x (from its bits).
    #[must_use]
    fn exponent(self) -> Self;

    /// 2ⁿ of a whole number n, −1022 ≤ n ≤ 1023 (`f64`) or −126 ≤ n ≤ 127 (`f32`) (by its bits).
    #[must_use]
    fn power_of_two(self) -> Self;

    /// The remainder of `self / divisor` with the sign of `self`; exact.
    #[must_use]
    fn remainder(self, divisor: Self) -> Self;
}

macro_rules! real {
    ($float:ident, $bits:ident, $table:ident, $magic:expr, $cbrt:expr, $sqrt:path) => {
        impl Real for $float {
            type Plain = Self;

            const ZERO: Self = 0.0;
            const ONE: Self = 1.0;
            const EPSILON: Self = $float::EPSILON;
            const DIGITS: u32 = $float::MANTISSA_DIGITS;

            #[inline(always)]
            fn of(literal: f64) -> Self {
                literal as $float
            }

            #[inline(always)]
            fn plain(self) -> Self {
                self
            }

            #[inline(always)]
            fn from_plain(value: Self) -> Self {
                value
            }

            #[inline(always)]
            fn whole(number: u64) -> Self {
                number as $float
            }

            #[inline(always)]
            fn from_byte(byte: u8) -> Self {
                $float::from_bits(<$float>::to_bits($magic) | $bits::from(byte)) - $magic
            }

            #[inline(always)]
            fn to_byte(self) -> u8 {
                (self + $magic).to_bits() as u8
            }

            #[inline(always)]
            fn pick(_for_f64: f64, _for_f32: f32) -> Self {
                real!(@pick $float, _for_f64, _for_f32)
            }

            #[inline(always)]
            fn polynomial<const N: usize, const M: usize>(self, coefficients: &Polynomial<N, M>) -> Self {
                let table = &coefficients.$table;
                if table.len() <= 8 {
                    let mut terms = table.iter().rev();
                    let mut sum = terms.next().copied().unwrap_or(0.0);
                    // Not a loop, for size either: coefficients as constants, without the other precision's.
                    repeat!(table.len() - 1, {
                        sum = sum * self + terms.next().copied().unwrap_or(0.0);
                    });
                    return sum;
                }
                let square = self * self;
                let (groups, rest) = table.as_chunks::<3>();
                let cube = square * self;
                // Of the last terms there may be fewer than three: the other sums begin with the group before.
                let mut groups = groups.iter().rev();
                let mut sums = groups.next().copied().unwrap_or([0.0; 3]);
                for (sum, &c) in sums.iter_mut().zip(rest) {
                    *sum += c * cube;
                }
                for group in groups {
                    for (sum, c) in sums.iter_mut().zip(group) {
                        *sum = *sum * cube + c;
                    }
                }
                let [a, b, c] = sums;
                (a + self * b) + square * c
            }

            #[inline(always)]
            fn coefficient<const N: usize, const M: usize>(coefficients: &Polynomial<N, M>, index: usize) -> Self {
                coefficients.$table.get(index).copied().unwrap_or(0.0)
            }

            #[inline(always)]
            fn all<const N: usize>(coefficients: &Polynomial<N, N>) -> [Self; N] {
                coefficients.$table
            }

            #[inline(always)]
            fn terms(_for_f64: usize, _for_f32: usize) -> usize {
                real!(@pick $float, _for_f64, _for_f32)
            }

            #[inline(always)]
            fn steps(_for_f64: usize, _for_f32: usize) -> usize {
                real!(@pick $float, _for_f64, _for_f32)
            }

            #[inline(always)]
            fn sqrt(self) -> Self {
                #[cfg(feature = "std")]
                return $float::sqrt(self);
                #[cfg(not(feature = "std"))]
                return $sqrt(self);
            }

            #[inline(always)]
            fn abs(self) -> Self {
                $float::abs(self)
            }

            #[inline(always)]
            fn copysign(self, sign: Self) -> Self {
                $float::copysign(self, sign)
            }

            #[inline(always)]
            fn signed_like(self, sign: Self) -> Self {
                $float::copysign(self, sign)
            }

            #[inline(always)]
            fn vanish(self) -> Self {
                0.0
            }

            #[inline(always)]
            fn is_finite(self) -> bool {
                $float::is_finite(self)
            }

            #[inline(always)]
            fn round(self) -> Self {
                (self + $magic) - $magic
            }

            #[inline(always)]
            fn quarters(self, (sin, cos): (Self, Self)) -> (Self, Self) {
                let quarters = (self + $magic).to_bits();
                let (sin, cos) = (sin.to_bits(), cos.to_bits());
                let swap = (sin ^ cos) & (quarters & 1).wrapping_neg();
                let sign = |quarters: $bits| (quarters & 2) << ($bits::BITS - 2);
                (
                    $float::from_bits(sin ^ swap ^ sign(quarters)),
                    $float::from_bits(cos ^ swap ^ sign(quarters.wrapping_add(1))),
                )
            }

            #[inline(always)]
            fn floor(self) -> i32 {
                let toward_zero = self as i32;
                toward_zero.saturating_sub((self < toward_zero as $float).into())
            }

            #[inline(always)]
            fn cbrt_guess(self) -> Self {
                $float::from_bits(self.to_bits() / 3 + $cbrt)
            }

            #[inline(always)]
            fn exponent(self) -> Self {
                // The bits of √½ to those of 1, and the exponent to where 2⁵² (2²³) has its units.
                const ROOT: $float = core::$float::consts::FRAC_1_SQRT_2;
                const UNITS: $float = 1.0 / $float::EPSILON;
                const BITS: u32 = $float::MANTISSA_DIGITS - 1;
                let exponent = self.to_bits().wrapping_add((1.0 as $float).to_bits() - ROOT.to_bits()) >> BITS;
                $float::from_bits(UNITS.to_bits() | exponent) - (UNITS + ($float::MAX_EXP - 1) as $float)
            }

            #[inline(always)]
            fn power_of_two(self) -> Self {
                const BITS: u32 = $float::MANTISSA_DIGITS - 1;
                $float::from_bits((self + ($magic + ($float::MAX_EXP - 1) as $float)).to_bits() << BITS)
            }

            #[inline]
            fn remainder(self, divisor: Self) -> Self {
                remainder(self, divisor)
            }
        }
    };
    (@pick f64, $a:expr, $b:expr) => { $a };
    (@pick f32, $a:expr, $b:expr) => { $b };
}

// The cube root's offsets are two thirds of the exponent bias, less what halves the worst error (Kahan; FreeBSD's cbrt).
real!(
    f64,
    u64,
    f64,
    6_755_399_441_055_744.0,
    0x2A9F_7893_0000_0000,
    libm::sqrt
);
real!(f32, u32, f32, 12_582_912.0, 0x2A51_2CE3, crate::math::sqrt_f32);
