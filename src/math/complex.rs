use core::ops::{Add, Mul};

use super::{Polynomial, repeat};
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

/// A polynomial of x + iy with `terms` real coefficients, at most 42: real and imaginary part. What is past the last coefficient is 0.
///
/// Divided by the quadratic that a number and its conjugate are the roots of: two products a coefficient (Knuth, The Art of Computer
/// Programming 2, 4.6.4, eq. 3). Even and odd powers apart, as polynomials of the square: two chains at a time.
#[inline(always)]
pub(crate) fn complex_polynomial<T: Real>([x, y]: [T; 2], terms: usize, coefficient: impl Fn(usize) -> T) -> [T; 2] {
    let number = Complex { re: x, im: y };
    let square = number * number;
    let (twice, norm) = (square.re + square.re, square.norm());
    let (mut even, mut odd) = ((T::ZERO, T::ZERO), (T::ZERO, T::ZERO));
    let mut i = terms.div_ceil(2);
    repeat!(i.div_ceil(5), {
        repeat!((i - 1).min(5), {
            i -= 1;
            let next = |(a, b): (T, T), i| (coefficient(i) + (twice * a - norm * b), a);
            (even, odd) = (next(even, 2 * i), next(odd, 2 * i + 1));
        });
    });
    let last = |(a, b): (T, T), i| Complex {
        re: coefficient(i) + (square.re * a - norm * b),
        im: square.im * a,
    };
    (last(even, 0) + number * last(odd, 1)).parts()
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
