use core::ops::{Add, Mul};

use super::Polynomial;
use crate::Real;

/// A complex number, as far as the conformal map needs one.
#[derive(Clone, Copy)]
pub(crate) struct Complex<T> {
    pub re: T,
    pub im: T,
}

impl<T: Real> Complex<T> {
    /// i times the number.
    #[inline(always)]
    pub fn times_i(self) -> Self {
        Self {
            re: -self.im,
            im: self.re,
        }
    }

    /// The square of the modulus.
    #[inline(always)]
    pub fn norm(self) -> T {
        self.re * self.re + self.im * self.im
    }

    /// Real and imaginary part.
    #[inline(always)]
    pub fn parts(self) -> [T; 2] {
        [self.re, self.im]
    }

    /// A polynomial with real coefficients.
    #[inline(always)]
    pub fn polynomial<const N: usize, const M: usize>(self, coefficients: &Polynomial<N, M>) -> Self {
        let [re, im] = T::complex_polynomial([self.re, self.im], coefficients);
        Self { re, im }
    }
}

impl<T: Real> Add for Complex<T> {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        Self {
            re: self.re + other.re,
            im: self.im + other.im,
        }
    }
}

impl<T: Real> Mul for Complex<T> {
    type Output = Self;
    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        Self {
            re: self.re * other.re - self.im * other.im,
            im: self.re * other.im + self.im * other.re,
        }
    }
}

impl<T: Real> Mul<T> for Complex<T> {
    type Output = Self;
    #[inline(always)]
    fn mul(self, factor: T) -> Self {
        Self {
            re: self.re * factor,
            im: self.im * factor,
        }
    }
}
