//! Every function of `Float` with its derivative.

use core::num::FpCategory;

use num_traits::Float;

use crate::{Dual, Real};

/// f(x) from f and f′ at the value of x: NaN where f has no value.
fn chain<T: Real + Float, const N: usize>(x: Dual<T, N>, value: T, slope: T) -> Dual<T, N> {
    let slope = slope_of(value, slope);
    Dual::new(value, x.slopes().map(|s| times(s, slope)))
}

/// f(x, y) from f and its two partial derivatives.
fn chain_both<T: Real + Float, const N: usize>([x, y]: [Dual<T, N>; 2], value: T, [by_x, by_y]: [T; 2]) -> Dual<T, N> {
    let (by_x, by_y) = (slope_of(value, by_x), slope_of(value, by_y));
    Dual::new(value, x.slopes_with(y, |a, b| times(a, by_x) + times(b, by_y)))
}

fn slope_of<T: Real + Float>(value: T, slope: T) -> T {
    if value.is_nan() { T::nan() } else { slope }
}

/// A product that is 0 where the first factor is: what does not depend on a variable has derivative 0 by it,
/// even where f′ is infinite.
fn times<T: Real>(factor: T, slope: T) -> T {
    if factor.is_nothing() { T::ZERO } else { factor * slope }
}

/// What has no derivative.
macro_rules! constants {
    ($($name:ident)*) => {
        $(
            #[inline]
            fn $name() -> Self {
                Self::constant(T::$name())
            }
        )*
    };
}

/// What looks at the value alone.
macro_rules! questions {
    ($($name:ident -> $answer:ty),*) => {
        $(
            #[inline]
            fn $name(self) -> $answer {
                Float::$name(self.value())
            }
        )*
    };
}

/// Functions of one argument: the derivative from the argument and the function's value.
macro_rules! functions {
    ($($name:ident($x:pat, $value:pat) = $slope:expr;)*) => {
        $(
            fn $name(self) -> Self {
                let x = self.value();
                let value = Float::$name(x);
                let ($x, $value) = (x, value);
                chain(self, value, $slope)
            }
        )*
    };
}

impl<T: Real + Float, const N: usize> Float for Dual<T, N> {
    constants! { nan infinity neg_infinity neg_zero min_value min_positive_value max_value epsilon }

    questions! {
        is_nan -> bool, is_infinite -> bool, is_finite -> bool, is_normal -> bool, is_subnormal -> bool,
        classify -> FpCategory, is_sign_positive -> bool, is_sign_negative -> bool,
        integer_decode -> (u64, i16, i8)
    }

    functions! {
        floor(_, _) = T::ZERO;
        ceil(_, _) = T::ZERO;
        round(_, _) = T::ZERO;
        trunc(_, _) = T::ZERO;
        fract(_, _) = T::ONE;
        signum(_, _) = T::ZERO;
        abs(x, _) = Float::signum(x);
        recip(_, inverse) = -(inverse * inverse);
        sqrt(_, root) = T::of(0.5) / root;
        cbrt(_, root) = (T::of(3.0) * root * root).recip();
        exp(_, power) = power;
        exp2(_, power) = power * T::of(core::f64::consts::LN_2);
        exp_m1(x, _) = x.exp();
        ln(x, _) = x.recip();
        ln_1p(x, _) = (T::ONE + x).recip();
        log2(x, _) = T::of(core::f64::consts::LOG2_E) / x;
        log10(x, _) = T::of(core::f64::consts::LOG10_E) / x;
        to_degrees(_, _) = T::ONE.to_degrees();
        to_radians(_, _) = T::ONE.to_radians();
        sin(x, _) = x.cos();
        cos(x, _) = -x.sin();
        tan(_, tangent) = T::ONE + tangent * tangent;
        asin(x, _) = inverse_root((T::ONE - x) * (T::ONE + x));
        acos(x, _) = -inverse_root((T::ONE - x) * (T::ONE + x));
        atan(x, _) = (T::ONE + x * x).recip();
        sinh(x, _) = x.cosh();
        cosh(x, _) = x.sinh();
        tanh(x, _) = square(x.cosh().recip());
        asinh(x, _) = x.hypot(T::ONE).recip();
        // Two roots: the product of their squares may overflow.
        acosh(x, _) = inverse_root(x - T::ONE) * inverse_root(x + T::ONE);
        atanh(x, _) = ((T::ONE - x) * (T::ONE + x)).recip();
    }

    fn sin_cos(self) -> (Self, Self) {
        let (sin, cos) = Float::sin_cos(self.value());
        (chain(self, sin, cos), chain(self, cos, -sin))
    }

    fn powi(self, n: i32) -> Self {
        let x = self.value();
        let value = x.powi(n);
        let less = n.checked_sub(1).map_or_else(|| value / x, |less| x.powi(less));
        let factor = T::whole(n.unsigned_abs().into());
        let factor = if n < 0 { -factor } else { factor };
        chain(self, value, times(factor, less))
    }

    fn powf(self, exponent: Self) -> Self {
        let (x, y) = (self.value(), exponent.value());
        let value = x.powf(y);
        // x^y ln x tends to 0 with x.
        let by_exponent = if x == T::ZERO && y > T::ZERO {
            T::ZERO
        } else {
            value * x.ln()
        };
        let slopes = [times(y, x.powf(y - T::ONE)), by_exponent];
        chain_both([self, exponent], value, slopes)
    }

    fn log(self, base: Self) -> Self {
        let (x, b) = (self.value(), base.value());
        let value = x.log(b);
        let ln = b.ln();
        chain_both([self, base], value, [(x * ln).recip(), -value / (b * ln)])
    }

    fn hypot(self, other: Self) -> Self {
        let (x, y) = (self.value(), other.value());
        let value = x.hypot(y);
        chain_both([self, other], value, [x / value, y / value])
    }

    fn atan2(self, other: Self) -> Self {
        let (y, x) = (self.value(), other.value());
        let radius = y.hypot(x);
        let slopes = [x / radius / radius, -(y / radius / radius)];
        chain_both([self, other], y.atan2(x), slopes)
    }

    fn mul_add(self, a: Self, b: Self) -> Self {
        let value = Float::mul_add(self.value(), a.value(), b.value());
        let product = chain_both([self, a], value, [a.value(), self.value()]);
        Self::new(value, product.slopes_with(b, |product, b| product + b))
    }

    fn copysign(self, sign: Self) -> Self {
        Real::copysign(self, sign)
    }

    fn max(self, other: Self) -> Self {
        if self >= other || other.is_nan() { self } else { other }
    }

    fn min(self, other: Self) -> Self {
        if self <= other || other.is_nan() { self } else { other }
    }

    fn clamp(self, min: Self, max: Self) -> Self {
        if self < min {
            min
        } else if self > max {
            max
        } else {
            self
        }
    }

    fn abs_sub(self, other: Self) -> Self {
        if self <= other { Self::ZERO } else { self - other }
    }
}

fn square<T: Real>(x: T) -> T {
    x * x
}

fn inverse_root<T: Real + Float>(x: T) -> T {
    Float::sqrt(x).recip()
}
