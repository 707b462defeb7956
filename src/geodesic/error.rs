use core::fmt;

use crate::math::min;
use crate::{LatLon, Real};

/// Why a method gave no answer. Each variant carries the value that was refused.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum GeodesicError<T> {
    /// The azimuth is infinite or NaN.
    Azimuth(T),
    /// The distance is infinite or NaN.
    Distance(T),
    /// The distance is finite, and longer than the method can go.
    TooFar {
        /// The distance in metres.
        distance: T,
        /// The longest distance in metres that the method accepts from this place at this azimuth.
        limit: T,
    },
    /// The fraction of a line is infinite or NaN, or its product with the length is.
    Fraction(T),
    /// The iteration of [`Vincenty`](super::Vincenty) did not converge between these places, which are nearly
    /// antipodal.
    NotConverged(LatLon<T>, LatLon<T>),
}

impl<T: Real> GeodesicError<T> {
    /// The error for a distance that is not accepted, and the longest one that is.
    pub(crate) fn refused(distance: T, limit: T) -> Self {
        if distance.is_finite() {
            Self::TooFar { distance, limit }
        } else {
            Self::Distance(distance)
        }
    }

    /// The error for a finite distance whose quotient by so many metres is not finite.
    pub(crate) fn quotient(distance: T, metres: T) -> Self {
        Self::refused(distance, min(metres, T::ONE) * T::pick(f64::MAX, f32::MAX))
    }
}

impl<T: fmt::Debug + fmt::Display> fmt::Display for GeodesicError<T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Azimuth(azimuth) => write!(f, "azimuth {azimuth:?} is not finite"),
            Self::Distance(distance) => write!(f, "distance {distance:?} is not finite"),
            Self::TooFar { distance, limit } => write!(f, "distance {distance:?} is longer than {limit:?} metres"),
            Self::Fraction(fraction) => write!(f, "fraction {fraction:?} makes no finite distance"),
            Self::NotConverged(from, to) => write!(f, "no convergence from {from} to {to}"),
        }
    }
}

impl<T: fmt::Debug + fmt::Display> core::error::Error for GeodesicError<T> {}
