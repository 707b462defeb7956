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

    /// A polynomial with real coefficients, divided by the quadratic that the number and its conjugate are the roots of: two
    /// products a coefficient (Knuth, The Art of Computer Programming 2, 4.6.4, eq. 3).
    #[inline(always)]
    pub fn polynomial<const N: usize, const M: usize>(self, coefficients: &Polynomial<N, M>) -> Self {
        // Even and odd powers apart, as polynomials of the square: two chains at a time.
        let square = self * self;
        let (twice, norm) = (square.re + square.re, square.norm());
        let (mut even, mut odd) = ((T::ZERO, T::ZERO), (T::ZERO, T::ZERO));
        for i in (1..T::terms(N, M).div_ceil(2)).rev() {
            let next = |(a, b): (T, T), i| (T::coefficient(coefficients, i) + (twice * a - norm * b), a);
            (even, odd) = (next(even, 2 * i), next(odd, 2 * i + 1));
        }
        let last = |(a, b): (T, T), i| Self {
            re: T::coefficient(coefficients, i) + (square.re * a - norm * b),
            im: square.im * a,
        };
        last(even, 0) + self * last(odd, 1)
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
