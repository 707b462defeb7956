//! Distances and destinations: one method a file, all behind [`Geodesic`].

use core::fmt;

use crate::math::min;
use crate::{LatLon, Real};

mod andoyer;
mod andoyer_second;
mod auxiliary;
mod bowring;
mod degrees;
mod flat;
mod great_circle;
mod haversine;
mod karney;
mod method;
mod middle;
mod ordinary;
mod planar;
mod plane;
mod sum;
mod vincenty;

pub use andoyer::Andoyer;
pub use andoyer_second::AndoyerSecond;
pub use bowring::Bowring;
pub use flat::Flat;
pub use great_circle::GreatCircle;
pub use haversine::Haversine;
pub use karney::{Area, Karney, Line, LinePoint, PolygonArea, Solution};
pub use method::{AnyMethod, Method, UnknownMethod};
pub use planar::{PlanarArea, PlanarPolygon};
pub use plane::Plane;
pub use vincenty::Vincenty;

/// A method that solves the two problems of geodesy.
///
/// The distance and both azimuths of an [`Inverse`] are those of one line: from the first place along
/// `azimuth1` for `distance` it leads to the second place, and arrives there with `azimuth2`. Of several
/// shortest lines all three numbers are of the same one.
///
/// At a pole an azimuth counts from the meridian of the longitude that is given with the pole. Some pairs of
/// places leave the azimuths open. There every method has the same rule, and the line starts to the north,
/// with `azimuth1` = 0:
///
/// | places | distance | `azimuth2` |
/// |---|---|---|
/// | coincident | 0 | 0 |
/// | the same pole, by two longitudes | 0 | λ₂ − λ₁ at the north pole, λ₁ − λ₂ at the south pole |
/// | from pole to pole | half of a meridian | λ₂ − λ₁ at the north pole, λ₁ − λ₂ at the south pole |
/// | antipodes on a sphere | half of a circle | 180 |
pub trait Geodesic<T: Real> {
    /// From two places to the distance between them and the azimuths at both.
    ///
    /// # Errors
    /// What the method's own documentation says.
    fn inverse(&self, from: LatLon<T>, to: LatLon<T>) -> Result<Inverse<T>, GeodesicError<T>>;

    /// From a place, an azimuth in degrees and a distance in metres to where they lead; a negative distance goes backwards.
    ///
    /// # Errors
    /// [`GeodesicError::Azimuth`] and [`GeodesicError::Distance`] for what is not finite; else what the method's own documentation says.
    /// On ellipsoids of metres or less some methods refuse the largest numbers as [`GeodesicError::TooFar`].
    fn direct(&self, from: LatLon<T>, azimuth: T, distance: T) -> Result<Direct<T>, GeodesicError<T>>;
}

/// A method that solves its ordinary problems in straight lines of arithmetic, so that a loop over them vectorises:
/// [`batch::geodesic`](crate::batch::geodesic) is that loop. Sealed.
pub trait Straight<T: Real>: Geodesic<T> + Send + Sync + sealed::Sealed {
    /// The inverse problem, and whether the answer is that of [`Geodesic::inverse`], bit for bit. For
    /// [`Karney`] not between coincident and nearly antipodal places, nor on ellipsoids with |f| > 1/149; for
    /// [`Vincenty`] not where it evaluates the longitude more than six (`f32`: four) times.
    fn ordinary_inverse(&self, from: LatLon<T>, to: LatLon<T>) -> (Inverse<T>, bool);

    /// The direct problem, and whether the answer is that of [`Geodesic::direct`], bit for bit: not for azimuths beyond ±360°, nor after
    /// very many circuits, nor, for [`Karney`], on ellipsoids with |f| > 1/149.
    fn ordinary_direct(&self, from: LatLon<T>, azimuth: T, distance: T) -> (Direct<T>, bool);

    /// Whether the distance in metres is at most 50 polar radii: no direct problem so long is refused.
    fn reaches(&self, distance: T) -> bool;
}

mod sealed {
    pub trait Sealed {}
    impl<T> Sealed for super::Karney<T> {}
    impl<T> Sealed for super::Vincenty<T> {}
}

/// The solution of the inverse problem.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Inverse<T> {
    /// The distance in metres.
    pub distance: T,
    /// The azimuth at the first place toward the second, in degrees clockwise from north, in [−180, 180].
    pub azimuth1: T,
    /// The azimuth of travel at the second place, in degrees clockwise from north, in [−180, 180].
    pub azimuth2: T,
}

/// The solution of the direct problem.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Direct<T> {
    /// The place reached.
    pub position: LatLon<T>,
    /// The azimuth of travel there, in degrees clockwise from north, in [−180, 180].
    pub azimuth: T,
}

/// Why a method gave no answer.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum GeodesicError<T> {
    /// An azimuth that is infinite or not a number.
    Azimuth(T),
    /// A distance that is infinite or not a number.
    Distance(T),
    /// A distance, forward or back, that is longer than the method can go.
    TooFar {
        /// The distance in metres.
        distance: T,
        /// The longest that this method goes from there at this azimuth, in metres.
        limit: T,
    },
    /// A part of a way that is infinite or not a number, or that makes the distance so.
    Fraction(T),
    /// [`Vincenty`]'s iteration did not converge between these places: they are nearly antipodal.
    NotConverged(LatLon<T>, LatLon<T>),
}

impl<T: Real> GeodesicError<T> {
    /// A distance that is refused, and the longest that is not.
    pub(crate) fn refused(distance: T, limit: T) -> Self {
        if distance.is_finite() {
            Self::TooFar { distance, limit }
        } else {
            Self::Distance(distance)
        }
    }

    /// A finite distance whose quotient by so many metres is none.
    pub(crate) fn quotient(distance: T, metres: T) -> Self {
        Self::refused(distance, min(metres, T::ONE) * T::pick(f64::MAX, f32::MAX))
    }
}

impl<T: fmt::Debug> fmt::Display for GeodesicError<T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Azimuth(azimuth) => write!(f, "azimuth {azimuth:?} is not finite"),
            Self::Distance(distance) => write!(f, "distance {distance:?} is not finite"),
            Self::TooFar { distance, limit } => write!(f, "distance {distance:?} is longer than {limit:?} metres"),
            Self::Fraction(fraction) => write!(f, "fraction {fraction:?} makes no finite distance"),
            Self::NotConverged(from, to) => write!(f, "no convergence from {from:?} to {to:?}"),
        }
    }
}

impl<T: fmt::Debug> core::error::Error for GeodesicError<T> {}
