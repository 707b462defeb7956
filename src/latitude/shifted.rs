use super::correction::{Correction, Turn};
use super::{Shift, UnsupportedFlattening};
use crate::math::atan2_degrees;
use crate::math::sin_cos_degrees;
use crate::{Direction, Ellipsoid, LatLon, Real};

/// An ellipsoid laid on the sphere: geodetic latitude and longitude to direction and back.
///
/// ```
/// use terrella::{Ellipsoid, LatLon, Shift, Shifted};
/// let earth = Shifted::new(Ellipsoid::wgs84(), Shift::Geocentric).unwrap();
/// let d = earth.to_direction(LatLon::new(45.0, 0.0).unwrap());
/// assert!((d.to_lat_lon().lat() - 44.807_576_8_f64).abs() < 1e-7);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Shifted<T> {
    ellipsoid: Ellipsoid<T>,
    shift: Shift,
    forward: Correction<T>,
    inverse: Correction<T>,
}

impl<T: Real> Shifted<T> {
    /// From an ellipsoid and the latitude that is taken for the sphere's.
    ///
    /// # Errors
    /// [`UnsupportedFlattening`] if the latitude's formula does not hold for this ellipsoid.
    pub fn new(ellipsoid: Ellipsoid<T>, shift: Shift) -> Result<Self, UnsupportedFlattening<T>> {
        Ok(Self {
            ellipsoid,
            shift,
            forward: Correction::to_shifted(ellipsoid, shift)?,
            inverse: Correction::to_geodetic(ellipsoid, shift)?,
        })
    }

    /// The ellipsoid.
    #[must_use]
    pub fn ellipsoid(&self) -> Ellipsoid<T> {
        self.ellipsoid
    }

    /// The shift.
    #[must_use]
    pub fn shift(&self) -> Shift {
        self.shift
    }

    /// From the geodetic latitude to the sphere's, and back.
    pub(crate) fn corrections(&self) -> [Correction<T>; 2] {
        [self.forward, self.inverse]
    }

    /// The direction of a geodetic latitude and longitude.
    #[must_use]
    #[inline]
    pub fn to_direction(&self, position: LatLon<T>) -> Direction<T> {
        Direction::from_latitude(self.forward.turn(sin_cos_degrees(position.lat())), position.lon())
    }

    /// The geodetic latitude and longitude of a direction.
    #[must_use]
    #[inline]
    pub fn to_lat_lon(&self, direction: Direction<T>) -> LatLon<T> {
        let (sin, cos) = self.inverse.turn((direction.z(), direction.cos_lat()));
        LatLon::within(atan2_degrees(sin, cos), direction.lon())
    }
}
