use core::fmt;

use super::boundary::relation;
use super::near::Within;
use super::{Region, Relation, Tile};
use crate::cube::{CubeMap, CubeProjection};
use crate::geodesic::Geodesic;
use crate::{LatLon, Real};

/// The places up to a distance from a centre, along geodesics of a method: on the ellipsoid a geodesic circle
/// with what is in it.
///
/// A tile meets the cap exactly if the nearest place of the tile is not farther than the radius, to within
/// the error of the method and 8 ulp of the radius of the Earth (11 nm in `f64`, 6 m in `f32`). Take
/// [`Karney`](crate::geodesic::Karney) for the ellipsoid, or [`GreatCircle`](crate::geodesic::GreatCircle) for
/// a sphere.
///
/// ```
/// use terrella::cube::{CubeMap, S2Quadratic};
/// use terrella::geodesic::Karney;
/// use terrella::terrain::{Cap, Covering};
/// use terrella::{Ellipsoid, LatLon, Shift};
///
/// let earth = Ellipsoid::<f64>::WGS84;
/// let cap = Cap::new(Karney::new(earth)?, LatLon::new(59.91, 10.75)?, 10_000.0)?;
/// let map = CubeMap::new(earth, Shift::Geodetic, S2Quadratic)?;
/// assert_eq!(Covering::new(map, cap, 12)?.count(), 76);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[doc(alias = "S2Cap")]
#[doc(alias = "circle")]
#[doc(alias = "radius search")]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Cap<T, G> {
    method: G,
    centre: LatLon<T>,
    radius: T,
}

impl<T: Real, G: Geodesic<T>> Cap<T, G> {
    /// Creates the cap about a centre, with a radius in metres.
    ///
    /// # Errors
    /// [`InvalidRadius`] if the radius is negative or NaN. An infinite one holds every place.
    pub fn new(method: G, centre: LatLon<T>, radius: T) -> Result<Self, InvalidRadius<T>> {
        if radius >= T::ZERO {
            Ok(Self { method, centre, radius })
        } else {
            Err(InvalidRadius(radius))
        }
    }

    /// Returns the centre.
    #[must_use]
    pub const fn centre(&self) -> LatLon<T> {
        self.centre
    }

    /// Returns the radius in metres.
    #[must_use]
    pub const fn radius(&self) -> T {
        self.radius
    }
}

impl<T: Real, G: Geodesic<T>> Region<T> for Cap<T, G> {
    fn relation<P: CubeProjection>(&self, map: &CubeMap<T, P>, tile: Tile) -> Relation {
        // A method that refuses a pair of places leaves open whether they are near.
        let distance = |place| self.method.distance(self.centre, place).unwrap_or(T::of(f64::NAN));
        let margin = Within {
            shifted: map.shifted(),
            distance,
            radius: self.radius,
        };
        let (lat, lon) = (self.centre.lat(), self.centre.lon());
        let opposite = LatLon::within(-lat, lon - T::of(180.0).copysign(lon));
        relation(map, tile, &margin, [&[self.centre], &[opposite]])
    }
}

/// The error for a radius that is negative or NaN.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct InvalidRadius<T>(pub T);

impl<T: fmt::Debug> fmt::Display for InvalidRadius<T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "expected a radius of 0 or more, got {:?}", self.0)
    }
}

impl<T: fmt::Debug> core::error::Error for InvalidRadius<T> {}
