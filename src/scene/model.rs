use crate::geodesic::{Andoyer, Direct, Flat, Geodesic, GeodesicError, GreatCircle, Inverse, Karney, Plane};
use crate::{LatLon, Real};

/// A largest error.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Bound {
    /// Of distances, or of positions: metres.
    pub distance: f64,
    /// Of azimuths between places no nearer than the scene's nearest: radians; infinite if that is 0.
    pub azimuth: f64,
}

/// The models of distances and azimuths, from the cheapest to the dearest.
///
/// [`Haversine`](crate::geodesic::Haversine), [`Bowring`](crate::geodesic::Bowring),
/// [`AndoyerSecond`](crate::geodesic::AndoyerSecond) and [`Vincenty`](crate::geodesic::Vincenty) are not
/// among them: each takes more instructions than one that is more exact; and Vincenty's does not answer
/// everywhere.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Model {
    /// [`Plane`] about the middle of the latitudes.
    Plane,
    /// [`Flat`].
    Flat,
    /// [`GreatCircle`] with the radius that suits the latitudes best.
    Sphere,
    /// [`Andoyer`].
    Andoyer,
    /// [`Karney`].
    Karney,
}

impl Model {
    /// All of them.
    pub const ALL: [Self; 5] = [Self::Plane, Self::Flat, Self::Sphere, Self::Andoyer, Self::Karney];

    /// Instructions of an inverse problem in `f64`, distance and azimuths, one by one on x86-64 (SSE2), to two digits: `benches/instructions/run` counts them.
    #[must_use]
    pub const fn instructions(self) -> u32 {
        match self {
            Self::Plane => 330,
            Self::Flat => 450,
            Self::Sphere => 990,
            Self::Andoyer => 1000,
            Self::Karney => 1100,
        }
    }
}

/// The model that a scene chose, on its ellipsoid: [`Distances::method`](super::Distances::method).
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[allow(clippy::large_enum_variant)] // nothing here allocates
pub enum AnyModel<T> {
    /// [`Model::Plane`].
    Plane(Plane<T>),
    /// [`Model::Flat`].
    Flat(Flat<T>),
    /// [`Model::Sphere`].
    Sphere(GreatCircle<T>),
    /// [`Model::Andoyer`].
    Andoyer(Andoyer<T>),
    /// [`Model::Karney`].
    Karney(Karney<T>),
}

impl<T: Real> Geodesic<T> for AnyModel<T> {
    #[inline(always)]
    fn inverse(&self, from: LatLon<T>, to: LatLon<T>) -> Result<Inverse<T>, GeodesicError<T>> {
        match self {
            Self::Plane(method) => method.inverse(from, to),
            Self::Flat(method) => method.inverse(from, to),
            Self::Sphere(method) => method.inverse(from, to),
            Self::Andoyer(method) => method.inverse(from, to),
            Self::Karney(method) => method.inverse(from, to),
        }
    }

    #[inline(always)]
    fn direct(&self, from: LatLon<T>, azimuth: T, distance: T) -> Result<Direct<T>, GeodesicError<T>> {
        match self {
            Self::Plane(method) => method.direct(from, azimuth, distance),
            Self::Flat(method) => method.direct(from, azimuth, distance),
            Self::Sphere(method) => method.direct(from, azimuth, distance),
            Self::Andoyer(method) => method.direct(from, azimuth, distance),
            Self::Karney(method) => method.direct(from, azimuth, distance),
        }
    }
}
