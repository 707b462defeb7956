//! [`Dual`] as a number of the num-traits crate, so that code generic over its traits is differentiated.
//!
//! `f32` and `f64` are such numbers already. The value of a dual is what its scalar's own function gives.

use num_traits::{Bounded, Float, Num, One, Signed, Zero};

use crate::{Dual, Real};

mod cast;
mod constants;
mod float;

impl<T: Real, const N: usize> Zero for Dual<T, N> {
    #[inline]
    fn zero() -> Self {
        Self::ZERO
    }

    /// Whether the value is 0. Derivatives do not count, as in a comparison.
    #[inline]
    fn is_zero(&self) -> bool {
        *self == Self::ZERO
    }
}

impl<T: Real, const N: usize> One for Dual<T, N> {
    #[inline]
    fn one() -> Self {
        Self::ONE
    }
}

impl<T: Real + Num, const N: usize> Num for Dual<T, N> {
    type FromStrRadixErr = T::FromStrRadixErr;

    fn from_str_radix(text: &str, radix: u32) -> Result<Self, Self::FromStrRadixErr> {
        T::from_str_radix(text, radix).map(Self::constant)
    }
}

impl<T: Real + Float, const N: usize> Bounded for Dual<T, N> {
    #[inline]
    fn min_value() -> Self {
        <Self as Float>::min_value()
    }

    #[inline]
    fn max_value() -> Self {
        <Self as Float>::max_value()
    }
}

impl<T: Real + Float, const N: usize> Signed for Dual<T, N> {
    #[inline]
    fn abs(&self) -> Self {
        Float::abs(*self)
    }

    #[inline]
    fn abs_sub(&self, other: &Self) -> Self {
        Float::abs_sub(*self, *other)
    }

    #[inline]
    fn signum(&self) -> Self {
        Float::signum(*self)
    }

    #[inline]
    fn is_positive(&self) -> bool {
        Float::is_sign_positive(*self)
    }

    #[inline]
    fn is_negative(&self) -> bool {
        Float::is_sign_negative(*self)
    }
}
