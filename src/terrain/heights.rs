use core::fmt;

use crate::Real;

/// The heights of a piece of terrain above the ellipsoid: the lowest and the highest, in metres.
///
/// ```
/// use terrella::terrain::{Heights, InvalidHeights};
/// let earth = Heights::new(-10_935.0, 8_849.0)?;
/// assert_eq!((earth.low(), earth.high()), (-10_935.0, 8_849.0));
/// assert_eq!(Heights::new(2.0, 1.0), Err(InvalidHeights { low: 2.0, high: 1.0 }));
/// # Ok::<(), InvalidHeights<f64>>(())
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Heights<T> {
    low: T,
    high: T,
}

impl<T: Real> Heights<T> {
    /// From the lowest and the highest, in metres.
    ///
    /// # Errors
    /// [`InvalidHeights`] if one is infinite or NaN, or the lowest above the highest.
    #[inline]
    pub fn new(low: T, high: T) -> Result<Self, InvalidHeights<T>> {
        if low.is_finite() && high.is_finite() && low <= high {
            Ok(Self { low, high })
        } else {
            Err(InvalidHeights { low, high })
        }
    }

    /// The lowest, in metres.
    #[must_use]
    #[inline(always)]
    pub fn low(self) -> T {
        self.low
    }

    /// The highest, in metres.
    #[must_use]
    #[inline(always)]
    pub fn high(self) -> T {
        self.high
    }
}

/// Heights that are no range.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct InvalidHeights<T> {
    /// What was given for the lowest.
    pub low: T,
    /// What was given for the highest.
    pub high: T,
}

impl<T: fmt::Debug> fmt::Display for InvalidHeights<T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "heights from {:?} to {:?} metres are no range", self.low, self.high)
    }
}

impl<T: fmt::Debug> core::error::Error for InvalidHeights<T> {}
