//! [`LatLon`] to and from geo-types' points, whose x is the longitude and y the latitude.

use geo_types::{Coord, CoordNum, Point};

use crate::{InvalidLatLon, LatLon, Real};

impl<T: Real + CoordNum> From<LatLon<T>> for Coord<T> {
    /// x is the longitude, y the latitude.
    fn from(place: LatLon<T>) -> Self {
        Self {
            x: place.lon(),
            y: place.lat(),
        }
    }
}

impl<T: Real + CoordNum> TryFrom<Coord<T>> for LatLon<T> {
    type Error = InvalidLatLon<T>;

    /// x is the longitude, y the latitude.
    fn try_from(coord: Coord<T>) -> Result<Self, Self::Error> {
        Self::new(coord.y, coord.x)
    }
}

impl<T: Real + CoordNum> From<LatLon<T>> for Point<T> {
    /// x is the longitude, y the latitude.
    fn from(place: LatLon<T>) -> Self {
        Self(place.into())
    }
}

impl<T: Real + CoordNum> TryFrom<Point<T>> for LatLon<T> {
    type Error = InvalidLatLon<T>;

    /// x is the longitude, y the latitude.
    fn try_from(point: Point<T>) -> Result<Self, Self::Error> {
        point.0.try_into()
    }
}
