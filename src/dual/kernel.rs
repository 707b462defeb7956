//! [`Dual`] as a scalar: each function with its derivative.

use super::Dual;
use crate::Real;
use crate::real::{Constant, Kernel, Literal, Polynomial, complex_polynomial};

impl<T: Real, const N: usize> Real for Dual<T, N> {
    type Plain = T::Plain;

    const ZERO: Self = Self::constant(T::ZERO);
    const ONE: Self = Self::constant(T::ONE);
    const EPSILON: Self = Self::constant(T::EPSILON);
    const DIGITS: u32 = T::DIGITS;

    #[inline(always)]
    fn of(literal: f64) -> Self {
        Self::constant(T::of(literal))
    }

    #[inline(always)]
    fn whole(integer: u64) -> Self {
        Self::constant(T::whole(integer))
    }

    #[inline(always)]
    fn plain(self) -> T::Plain {
        self.value.plain()
    }

    #[inline(always)]
    fn from_plain(value: T::Plain) -> Self {
        Self::constant(T::from_plain(value))
    }

    #[inline(always)]
    fn sqrt(self) -> Self {
        let root = self.value.sqrt();
        self.chain(root, T::of(0.5) / root)
    }

    #[inline(always)]
    fn abs(self) -> Self {
        self.chain(self.value.abs(), T::ONE.copysign(self.value))
    }

    #[inline(always)]
    fn copysign(self, sign: Self) -> Self {
        let turn = T::ONE.copysign(self.value) * T::ONE.copysign(sign.value);
        self.chain(self.value.copysign(sign.value), turn)
    }

    #[inline(always)]
    fn is_finite(self) -> bool {
        self.value.is_finite()
    }
}

impl<T: Real, const N: usize> Kernel for Dual<T, N> {
    type Literal<const BITS: u64> = Literal<BITS>;

    #[inline(always)]
    fn from_byte(byte: u8) -> Self {
        Self::constant(T::from_byte(byte))
    }

    #[inline(always)]
    fn to_byte(self) -> u8 {
        self.value.to_byte()
    }

    #[inline(always)]
    fn pick(for_f64: f64, for_f32: f32) -> Self {
        Self::constant(T::pick(for_f64, for_f32))
    }

    #[inline(always)]
    fn polynomial<const A: usize, const B: usize>(self, coefficients: &Polynomial<A, B>) -> Self {
        let mut slope = T::ZERO;
        for i in (1..T::terms(A, B)).rev() {
            slope = slope * self.value + T::coefficient(coefficients, i) * T::whole(i as u64);
        }
        self.chain(self.value.polynomial(coefficients), slope)
    }

    #[inline(always)]
    fn complex_polynomial<const A: usize, const B: usize>(
        [x, y]: [Self; 2],
        coefficients: &Polynomial<A, B>,
    ) -> [Self; 2] {
        let number = [x.value, y.value];
        let [u, v] = T::complex_polynomial(number, coefficients);
        // The derivative of an analytic function is one complex number.
        let [s, t] = complex_polynomial(number, T::terms(A, B) - 1, |i| {
            T::coefficient(coefficients, i + 1) * T::whole(i as u64 + 1)
        });
        [
            Self::new(u, x.slopes_with(y, |dx, dy| s * dx - t * dy)),
            Self::new(v, x.slopes_with(y, |dx, dy| t * dx + s * dy)),
        ]
    }

    #[inline(always)]
    fn coefficient<const A: usize, const B: usize>(coefficients: &Polynomial<A, B>, index: usize) -> Self {
        Self::constant(T::coefficient(coefficients, index))
    }

    #[inline(always)]
    fn all<const A: usize>(coefficients: &Polynomial<A, A>) -> [Self; A] {
        T::all(coefficients).map(Self::constant)
    }

    #[inline(always)]
    fn terms(for_f64: usize, for_f32: usize) -> usize {
        T::terms(for_f64, for_f32)
    }

    #[inline(always)]
    fn steps(for_f64: usize, for_f32: usize) -> usize {
        T::steps(for_f64, for_f32) + 1
    }

    #[inline(always)]
    fn signed_like(self, sign: Self) -> Self {
        self.chain(self.value.signed_like(sign.value), T::ONE)
    }

    #[inline(always)]
    fn vanish(self) -> Self {
        self.chain(self.value.vanish(), T::ONE)
    }

    #[cfg(feature = "num-traits")]
    #[inline(always)]
    fn is_nothing(self) -> bool {
        self.value.is_nothing() && self.slopes.iter().all(|slope| slope.is_nothing())
    }

    #[inline(always)]
    fn round_ties_even(self) -> Self {
        Self::constant(self.value.round_ties_even())
    }

    #[inline(always)]
    fn quarters(self, (sin, cos): (Self, Self)) -> (Self, Self) {
        let (mut sin, mut cos) = (sin, cos);
        (sin.value, cos.value) = self.value.quarters((sin.value, cos.value));
        for (s, c) in sin.slopes.iter_mut().zip(&mut cos.slopes) {
            (*s, *c) = self.value.quarters((*s, *c));
        }
        (sin, cos)
    }

    #[inline(always)]
    fn floor(self) -> i32 {
        self.value.floor()
    }

    #[inline(always)]
    fn split(self) -> (Self, Self) {
        let (high, low) = self.value.split();
        (self.chain(high, T::ONE), Self::constant(low))
    }

    #[inline(always)]
    fn cbrt_guess(self) -> Self {
        Self::constant(self.value.cbrt_guess())
    }

    #[inline(always)]
    fn exponent(self) -> Self {
        Self::constant(self.value.exponent())
    }

    #[inline(always)]
    fn power_of_two(self) -> Self {
        Self::constant(self.value.power_of_two())
    }

    #[inline]
    fn remainder(self, divisor: Self) -> Self {
        let value = self.value.remainder(divisor.value);
        let turns = (self.value - value) / divisor.value;
        Self {
            value,
            slopes: self.slopes_with(divisor, |a, b| a - turns * b),
        }
    }
}

impl<T: Real, const N: usize, const BITS: u64> Constant<Dual<T, N>> for Literal<BITS> {
    const VALUE: Dual<T, N> = Dual::constant(<T::Literal<BITS> as Constant<T>>::VALUE);
}
