//! Arithmetic of headings in degrees: turns taken off, differences, means.
//!
//! A heading is any finite number of degrees; whole turns do not count. Of an infinite one and of NaN the
//! result is NaN, where it is not an error.
//!
//! ```
//! use terrella::route::heading;
//! assert_eq!(heading::to_circle(-90.0_f32), 270.0);
//! assert_eq!(heading::to_half_circles(270.0), -90.0);
//! assert_eq!(heading::difference(350.0, 10.0), 20.0);
//! assert_eq!(heading::mean(&[350.0, 10.0, 30.0]).map(f64::round), Ok(10.0));
//! ```

use core::fmt;

use crate::Real;
use crate::math::{DoubleWord, atan2_degrees, hypot, sin_cos_degrees, sum};

/// Returns the heading in [0, 360): the number nearest to it, and 0 where that is 360.
///
/// Only a negative heading is rounded.
///
/// ```
/// use terrella::route::heading::to_circle;
/// assert_eq!([725.5, 360.0, -0.0, -1e-20].map(to_circle::<f64>), [5.5, 0.0, 0.0, 0.0]);
/// ```
#[must_use]
#[doc(alias("wrap", "normalise", "wrap_360"))]
pub fn to_circle<T: Real>(heading: T) -> T {
    let circle = T::of(360.0);
    let rest = heading.remainder(circle);
    let turned = if rest < T::ZERO { rest + circle } else { rest + T::ZERO };
    if turned == circle { T::ZERO } else { turned }
}

/// Returns the heading in [−180, 180), exactly.
///
/// ```
/// use terrella::route::heading::to_half_circles;
/// assert_eq!([180.0, -180.0, 540.25, 359.0].map(to_half_circles::<f64>), [-180.0, -180.0, -179.75, -1.0]);
/// ```
#[must_use]
#[doc(alias("wrap", "normalise", "wrap_180", "wrap_pi"))]
pub fn to_half_circles<T: Real>(heading: T) -> T {
    let (half, circle) = (T::of(180.0), T::of(360.0));
    let rest = heading.remainder(circle);
    // Both numbers of a sum are within a factor of two.
    if rest >= half {
        rest - circle
    } else if rest < -half {
        rest + circle
    } else {
        rest + T::ZERO
    }
}

/// Returns the turn from one heading to another, in [−180, 180]: positive to the right. It is the number
/// nearest to the true one.
///
/// A turn of exactly half a circle is −180; 180 is one that is less by less than a rounding.
///
/// ```
/// use terrella::route::heading::difference;
/// assert_eq!((difference(10.0_f64, 350.0), difference(90.0, 270.0)), (-20.0, -180.0));
/// assert_eq!(difference(-1e-20_f64, 1e-20), 2e-20);
/// ```
#[must_use]
#[doc(alias = "turn")]
pub fn difference<T: Real>(from: T, to: T) -> T {
    let (half, circle) = (T::of(180.0), T::of(360.0));
    let (high, low) = sum(to_half_circles(to), -to_half_circles(from));
    // The turn is high + low, |high| ≤ 360.
    let over = high > half || (high == half && low >= T::ZERO);
    let under = high < -half || (high == -half && low < T::ZERO);
    let turned = if over {
        high - circle
    } else if under {
        high + circle
    } else {
        high
    };
    turned + low
}

/// Returns the mean of headings in [0, 360): the direction of the sum of their unit vectors.
///
/// It is within 2 ulp of 360, for headings whose unit vectors do not nearly cancel.
///
/// ```
/// use terrella::route::heading::{UndefinedMean, mean};
/// assert_eq!(mean(&[359.0_f64, 1.0]), Ok(0.0));
/// assert_eq!(mean(&[90.0_f32, 270.0]), Err(UndefinedMean::Balanced));
/// ```
///
/// # Errors
/// [`UndefinedMean`] if there is none.
#[doc(alias = "circular mean")]
pub fn mean<T: Real>(headings: &[T]) -> Result<T, UndefinedMean<T>> {
    if headings.is_empty() {
        return Err(UndefinedMean::Empty);
    }
    let (mut east, mut north) = (DoubleWord::default(), DoubleWord::default());
    for (index, &heading) in headings.iter().enumerate() {
        if !heading.is_finite() {
            return Err(UndefinedMean::Heading { index, heading });
        }
        let (sin, cos) = sin_cos_degrees(to_half_circles(heading));
        east.add(sin);
        north.add(cos);
    }
    let (east, north) = (east.value(), north.value());
    // What roundings of so many sines make of nothing.
    if hypot(east, north) <= T::whole(headings.len() as u64) * T::EPSILON {
        return Err(UndefinedMean::Balanced);
    }
    Ok(to_circle(atan2_degrees(east, north)))
}

/// Why headings have no mean.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum UndefinedMean<T> {
    /// There are no headings.
    Empty,
    /// A heading is infinite or NaN.
    Heading {
        /// Its index.
        index: usize,
        /// The heading.
        heading: T,
    },
    /// The headings point away from each other, so that their unit vectors cancel up to rounding.
    Balanced,
}

impl<T: fmt::Debug> fmt::Display for UndefinedMean<T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Empty => f.write_str("no headings have no mean"),
            Self::Heading { index, heading } => write!(f, "heading {heading:?} at index {index} is not finite"),
            Self::Balanced => f.write_str("opposite headings have no mean"),
        }
    }
}

impl<T: fmt::Debug> core::error::Error for UndefinedMean<T> {}
