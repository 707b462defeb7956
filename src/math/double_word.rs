//! Double-word arithmetic: a number is kept as the sum of two, the second one far smaller than the first
//! (Dekker, Numer. Math. 18, 1971; Knuth, The Art of Computer Programming 2, 4.2.2).

use super::rest;
use crate::Real;

/// The number `high` + `low`; |`low`| is at most a rounding of `high`.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub(crate) struct DoubleWord<T> {
    pub high: T,
    pub low: T,
}

impl<T: Real> DoubleWord<T> {
    /// a + b, exactly. Never −0, unless both are.
    #[inline(always)]
    pub fn sum(a: T, b: T) -> Self {
        let (high, low) = rest::sum(a, b);
        Self { high, low }
    }

    /// a·b, exactly, for numbers far from the largest and the smallest.
    #[inline(always)]
    pub fn product(a: T, b: T) -> Self {
        let (high, low) = rest::product(a, b);
        Self { high, low }
    }

    /// Half of this number, exactly.
    #[inline(always)]
    pub fn half(self) -> Self {
        let half = T::of(0.5);
        Self {
            high: self.high * half,
            low: self.low * half,
        }
    }

    /// This number with the other sign.
    #[inline(always)]
    pub fn negated(self) -> Self {
        Self {
            high: -self.high,
            low: -self.low,
        }
    }

    /// The nearest single number.
    #[inline(always)]
    pub fn value(self) -> T {
        self.high + self.low
    }

    /// Adds a number and keeps what the rounding loses.
    pub fn add(&mut self, value: T) {
        let Self { high, low } = Self::sum(self.high, value);
        self.high = high;
        self.low += low;
    }

    /// Adds a double word and keeps what the rounding of the larger parts loses.
    pub fn add_double(&mut self, value: Self) {
        self.add(value.high);
        self.low += value.low;
    }
}
