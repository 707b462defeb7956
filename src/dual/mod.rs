//! [`Dual`], the scalar that carries derivatives.

use core::cmp::Ordering;
use core::fmt;

use crate::Real;

mod kernel;
mod operators;

/// A number together with its derivatives by `N` variables. It is a scalar: a function of this crate that is
/// called with it returns its derivatives with its result (forward automatic differentiation).
///
/// A derivative has the function's rounding errors and no other: there is no step size. Where a function has
/// a crease, as the quadrilateralized cube has on the diagonals of a face, the derivative is that of one
/// side. Comparisons compare the values alone. A `Dual` of a `Dual` has second derivatives.
///
/// ```
/// use terrella::{Dual, math::atan2};
///
/// let [y, x] = Dual::variables([3.0_f64, 4.0]);
/// let angle = atan2(y, x);
/// assert_eq!(angle.value(), 3.0_f64.atan2(4.0));
/// let [by_y, by_x] = angle.slopes();
/// assert!((by_y - 4.0 / 25.0).abs() < 1e-16);
/// assert!((by_x + 3.0 / 25.0).abs() < 1e-16);
/// ```
///
/// With the feature `num-traits` it is a `num_traits::Float`, `FloatConst` and `NumAssign` if `T` is, as
/// `f32` and `f64` are. So code that is generic over these traits is differentiated too:
///
#[cfg_attr(feature = "num-traits", doc = "```")]
#[cfg_attr(not(feature = "num-traits"), doc = "```ignore")]
/// use num_traits::Float;
/// use terrella::Dual;
///
/// fn logistic<F: Float>(x: F) -> F {
///     ((-x).exp() + F::one()).recip()
/// }
/// let [x] = Dual::variables([0.0_f64]);
/// assert_eq!(logistic(x).slopes(), [0.25]);
/// ```
///
/// The value is the one that the function of `T` returns: with num-traits' feature `std` that of the
/// platform's mathematical library. A derivative is NaN where the function has no value, and 0 by a variable
/// that the argument does not depend on. Steps (`floor`, `round`, `signum`) have derivative 0. `max` and
/// `min` return the chosen number with its derivatives. At an infinite argument, and at the zero of `hypot`
/// and `atan2`, a derivative may be NaN.
///
/// The largest error of a derivative of these functions is 2.1 ε (`f64`) and 1.7 ε (`f32`) of the derivative,
/// with glibc's functions, against derivatives of 25 digits at 395 places.
#[doc(alias = "autodiff")]
#[doc(alias = "derivative")]
#[doc(alias = "gradient")]
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Dual<T, const N: usize> {
    value: T,
    slopes: [T; N],
}

impl<T: Real, const N: usize> Dual<T, N> {
    /// Makes a number that depends on no variable: all derivatives are 0.
    #[must_use]
    #[inline(always)]
    pub const fn constant(value: T) -> Self {
        Self {
            value,
            slopes: [T::ZERO; N],
        }
    }

    /// Makes the `N` variables, with the given values: the derivative of each by itself is 1.
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

    /// Makes a number from its value and its derivatives by each of the variables.
    #[must_use]
    #[inline(always)]
    pub const fn new(value: T, slopes: [T; N]) -> Self {
        Self { value, slopes }
    }

    /// Returns the value.
    #[must_use]
    #[inline(always)]
    pub const fn value(self) -> T {
        self.value
    }

    /// Returns the derivatives by each of the variables.
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
    pub(crate) fn slopes_with(self, other: Self, combine: impl Fn(T, T) -> T) -> [T; N] {
        let mut slopes = self.slopes;
        for (a, b) in slopes.iter_mut().zip(other.slopes) {
            *a = combine(*a, b);
        }
        slopes
    }
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

/// Returns the value without its derivatives.
impl<T: Real, const N: usize> From<Dual<T, N>> for f64 {
    #[inline(always)]
    fn from(number: Dual<T, N>) -> Self {
        number.value.into()
    }
}
