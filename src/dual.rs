//! [`Dual`], the scalar that carries derivatives.

use core::cmp::Ordering;
use core::fmt;
use core::ops::{Add, AddAssign, Div, Mul, MulAssign, Neg, Sub, SubAssign};

use crate::Real;
use crate::literal::Literal;
use crate::math::{Polynomial, complex_polynomial};
use crate::real::sealed::Sealed;

/// A number with its derivatives by `N` variables: every function of this crate, run on it, is differentiated.
///
/// The derivatives are exact but for rounding: no step size, no formula beside the function's own. Where the function is creased, as
/// the quadrilateralized cube is on its diagonals, they are those of one side. Numbers compare by value alone.
///
/// A dual of a dual has second derivatives.
///
/// ```
/// use terrella::{Dual, Real, math::atan2};
///
/// let [y, x] = Dual::variables([3.0_f64, 4.0]);
/// let angle = atan2(y, x);
/// assert_eq!(angle.value(), 3.0_f64.atan2(4.0));
/// let [by_y, by_x] = angle.slopes();
/// assert!((by_y - 4.0 / 25.0).abs() < 1e-16);
/// assert!((by_x + 3.0 / 25.0).abs() < 1e-16);
/// ```
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Dual<T, const N: usize> {
    value: T,
    slopes: [T; N],
}

impl<T: Real, const N: usize> Dual<T, N> {
    /// A number that depends on no variable.
    #[must_use]
    #[inline(always)]
    pub const fn constant(value: T) -> Self {
        Self {
            value,
            slopes: [T::ZERO; N],
        }
    }

    /// The variables themselves, at the given values.
    #[must_use]
    #[inline(always)]
    pub fn variables(values: [T; N]) -> [Self; N] {
        let mut variable = 0;
        values.map(|value| {
            let mut dual = Self::constant(value);
            if let Some(slope) = dual.slopes.get_mut(variable) {
                *slope = T::ONE;
            }
            variable += 1;
            dual
        })
    }

    /// A number with a value and derivatives.
    #[must_use]
    #[inline(always)]
    pub const fn new(value: T, slopes: [T; N]) -> Self {
        Self { value, slopes }
    }

    /// The value.
    #[must_use]
    #[inline(always)]
    pub const fn value(self) -> T {
        self.value
    }

    /// The derivatives, by each of the variables.
    #[must_use]
    #[inline(always)]
    pub const fn slopes(self) -> [T; N] {
        self.slopes
    }

    /// f(x) from f and f′ at the value: the chain rule.
    #[inline(always)]
    fn chain(self, value: T, slope: T) -> Self {
        Self {
            value,
            slopes: self.slopes.map(|s| s * slope),
        }
    }

    /// Each pair of slopes combined.
    #[inline(always)]
    fn slopes_with(self, other: Self, combine: impl Fn(T, T) -> T) -> [T; N] {
        let mut slopes = self.slopes;
        for (a, b) in slopes.iter_mut().zip(other.slopes) {
            *a = combine(*a, b);
        }
        slopes
    }
}

impl<T: Real, const N: usize> Sealed for Dual<T, N> {
    type Literal<const BITS: u64> = Literal<BITS>;
}

impl<T: Real, const N: usize> Default for Dual<T, N> {
    #[inline(always)]
    fn default() -> Self {
        Self::ZERO
    }
}

impl<T: Real, const N: usize> fmt::Display for Dual<T, N> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(&self.value, f)?;
        f.write_str(" (")?;
        for (i, slope) in self.slopes.iter().enumerate() {
            f.write_str(if i == 0 { "" } else { ", " })?;
            fmt::Display::fmt(slope, f)?;
        }
        f.write_str(")")
    }
}

impl<T: Real, const N: usize> PartialEq for Dual<T, N> {
    #[inline(always)]
    fn eq(&self, other: &Self) -> bool {
        self.value == other.value
    }
}

impl<T: Real, const N: usize> PartialOrd for Dual<T, N> {
    #[inline(always)]
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        self.value.partial_cmp(&other.value)
    }
}

impl<T: Real, const N: usize> Add for Dual<T, N> {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        Self {
            value: self.value + other.value,
            slopes: self.slopes_with(other, |a, b| a + b),
        }
    }
}

impl<T: Real, const N: usize> Sub for Dual<T, N> {
    type Output = Self;
    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        Self {
            value: self.value - other.value,
            slopes: self.slopes_with(other, |a, b| a - b),
        }
    }
}

#[allow(clippy::suspicious_arithmetic_impl)] // the product rule adds
impl<T: Real, const N: usize> Mul for Dual<T, N> {
    type Output = Self;
    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        Self {
            value: self.value * other.value,
            slopes: self.slopes_with(other, |a, b| a * other.value + self.value * b),
        }
    }
}

impl<T: Real, const N: usize> Div for Dual<T, N> {
    type Output = Self;
    #[inline(always)]
    fn div(self, other: Self) -> Self {
        let value = self.value / other.value;
        let inverse = T::ONE / other.value;
        Self {
            value,
            slopes: self.slopes_with(other, |a, b| (a - value * b) * inverse),
        }
    }
}

impl<T: Real, const N: usize> Neg for Dual<T, N> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Self {
            value: -self.value,
            slopes: self.slopes.map(|s| -s),
        }
    }
}

impl<T: Real, const N: usize> AddAssign for Dual<T, N> {
    #[inline(always)]
    fn add_assign(&mut self, other: Self) {
        *self = *self + other;
    }
}

impl<T: Real, const N: usize> SubAssign for Dual<T, N> {
    #[inline(always)]
    fn sub_assign(&mut self, other: Self) {
        *self = *self - other;
    }
}

impl<T: Real, const N: usize> MulAssign for Dual<T, N> {
    #[inline(always)]
    fn mul_assign(&mut self, other: Self) {
        *self = *self * other;
    }
}

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
    fn plain(self) -> T::Plain {
        self.value.plain()
    }

    #[inline(always)]
    fn from_plain(value: T::Plain) -> Self {
        Self::constant(T::from_plain(value))
    }

    #[inline(always)]
    fn from_byte(byte: u8) -> Self {
        Self::constant(T::from_byte(byte))
    }

    #[inline(always)]
    fn to_byte(self) -> u8 {
        self.value.to_byte()
    }

    #[inline(always)]
    fn whole(number: u64) -> Self {
        Self::constant(T::whole(number))
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
    fn signed_like(self, sign: Self) -> Self {
        self.chain(self.value.signed_like(sign.value), T::ONE)
    }

    #[inline(always)]
    fn vanish(self) -> Self {
        self.chain(self.value.vanish(), T::ONE)
    }

    #[inline(always)]
    fn is_finite(self) -> bool {
        self.value.is_finite()
    }

    #[inline(always)]
    fn round(self) -> Self {
        Self::constant(self.value.round())
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
