//! [`Dual`], the scalar that carries derivatives.

use core::cmp::Ordering;
use core::fmt;

use crate::Real;

mod kernel;
mod operators;

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

/// The value; what its derivatives are is lost.
impl<T: Real, const N: usize> From<Dual<T, N>> for f64 {
    #[inline(always)]
    fn from(number: Dual<T, N>) -> Self {
        number.value.into()
    }
}
