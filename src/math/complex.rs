use core::ops::{Add, Div, Mul, Sub};

use super::Polynomial;
use crate::Real;

/// A complex number: what the conformal map is written in.
#[derive(Clone, Copy)]
pub(crate) struct Complex<T> {
    pub re: T,
    pub im: T,
}

impl<T: Real> Complex<T> {
    /// The principal square root of a number with re ≥ 0.
    #[inline(always)]
    pub fn sqrt(self) -> Self {
        let modulus = (self.re * self.re + self.im * self.im).sqrt();
        let re = ((modulus + self.re) * T::of(0.5)).sqrt();
        let twice = re + re;
        Self {
            re,
            im: self.im / super::select(twice == T::ZERO, T::ONE, twice),
        }
    }

    /// A polynomial with real coefficients, by Horner's rule.
    #[inline(always)]
    pub fn polynomial<const N: usize, const M: usize>(self, coefficients: &Polynomial<N, M>) -> Self {
        let mut sum = Self { re: T::ZERO, im: T::ZERO };
        for i in (0..T::terms(N, M)).rev() {
            sum = sum * self;
            sum.re += T::coefficient(coefficients, i);
        }
        sum
    }
}

impl<T: Real> Add for Complex<T> {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        Self { re: self.re + other.re, im: self.im + other.im }
    }
}

impl<T: Real> Sub for Complex<T> {
    type Output = Self;
    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        Self { re: self.re - other.re, im: self.im - other.im }
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
        Self { re: self.re * factor, im: self.im * factor }
    }
}

impl<T: Real> Div for Complex<T> {
    type Output = Self;
    #[inline(always)]
    fn div(self, other: Self) -> Self {
        let square = other.re * other.re + other.im * other.im;
        Self {
            re: (self.re * other.re + self.im * other.im) / square,
            im: (self.im * other.re - self.re * other.im) / square,
        }
    }
}
