//! [`Real`] for `f32` and `f64`: what depends on the precision. All else is written once, generically.

use super::remainder::remainder;
use super::{Kernel, Literal, Polynomial, Real, complex_polynomial, repeat};

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
            fn whole(integer: u64) -> Self {
                integer as $float
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
            fn is_finite(self) -> bool {
                $float::is_finite(self)
            }
        }

        impl Kernel for $float {
            type Literal<const BITS: u64> = Literal<BITS>;

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
                let (mut groups, rest) = table.split_at(table.len() - table.len() % 3);
                let cube = square * self;
                // Of the last terms there may be fewer than three: the other sums begin with the group
                // before.
                let mut sums = [0.0; 3];
                if let Some((before, last)) = groups.split_last_chunk() {
                    (groups, sums) = (before, *last);
                }
                for (sum, &c) in sums.iter_mut().zip(rest) {
                    *sum += c * cube;
                }
                while let Some((before, group)) = groups.split_last_chunk::<3>() {
                    for (sum, c) in sums.iter_mut().zip(group) {
                        *sum = *sum * cube + c;
                    }
                    groups = before;
                }
                let [a, b, c] = sums;
                (a + self * b) + square * c
            }

            #[inline(always)]
            fn complex_polynomial<const N: usize, const M: usize>(
                number: [Self; 2],
                coefficients: &Polynomial<N, M>,
            ) -> [Self; 2] {
                complex_polynomial(number, Self::terms(N, M), |i| Self::coefficient(coefficients, i))
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
            fn signed_like(self, sign: Self) -> Self {
                $float::copysign(self, sign)
            }

            #[inline(always)]
            fn vanish(self) -> Self {
                0.0
            }

            #[cfg(feature = "num-traits")]
            #[inline(always)]
            fn is_nothing(self) -> bool {
                self == 0.0
            }

            #[inline(always)]
            fn round_ties_even(self) -> Self {
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
            fn split(self) -> (Self, Self) {
                let scaled = self * Self::pick(134_217_729.0, 4097.0);
                let high = scaled - (scaled - self);
                (high, self - high)
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

// The cube root's offsets are two thirds of the exponent bias, less what halves the worst error (Kahan;
// FreeBSD's cbrt).
real!(
    f64,
    u64,
    f64,
    6_755_399_441_055_744.0,
    0x2A9F_7893_0000_0000,
    libm::sqrt
);
real!(f32, u32, f32, 12_582_912.0, 0x2A51_2CE3, super::sqrt::sqrt_f32);
