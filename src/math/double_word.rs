//! Double-word arithmetic: a number is kept as the sum of two, the second one far smaller than the first
//! (Dekker, Numer. Math. 18, 1971; Knuth, The Art of Computer Programming 2, 4.2.2).

use super::select;
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
        let (high, low) = sum(a, b);
        Self { high, low }
    }

    /// a·b, exactly, for numbers far from the largest and the smallest.
    #[inline(always)]
    pub fn product(a: T, b: T) -> Self {
        let (high, low) = product(a, b);
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

/// a + b as a rounded sum and what the rounding lost.
#[inline(always)]
pub(crate) fn sum<T: Real>(a: T, b: T) -> (T, T) {
    let sum = a + b;
    let part = sum - a;
    let lost = (a - (sum - part)) + (b - part);
    (sum, lost)
}

/// a·b as a rounded product and what the rounding lost, for numbers far from the largest.
#[inline(always)]
pub(crate) fn product<T: Real>(a: T, b: T) -> (T, T) {
    let product = a * b;
    let ((ah, al), (bh, bl)) = (a.split(), b.split());
    (product, ((ah * bh - product) + (ah * bl + al * bh)) + al * bl)
}

/// The same for any numbers; nothing is kept where splitting overflows.
#[inline(always)]
pub(crate) fn product_of_any<T: Real>(a: T, b: T) -> (T, T) {
    let (product, lost) = product(a, b);
    (product, select(lost.is_finite(), lost, T::ZERO))
}

/// √(x² + y²) and what its rounding lost.
#[inline(always)]
pub(crate) fn hypotenuse<T: Real>(x: T, y: T) -> (T, T) {
    let (xx, xx_lost) = product(x, x);
    let (yy, yy_lost) = product(y, y);
    let (square, square_lost) = sum(xx, yy);
    let root = square.sqrt();
    let (back, back_lost) = product(root, root);
    let rest = (square - back) + (square_lost + xx_lost + yy_lost - back_lost);
    (root, select(root > T::ZERO, rest / (root + root), T::ZERO))
}
