use super::correction::{Correction, Turn, supported};
use super::{Shift, UnsupportedFlattening};
use crate::math::{atan2_degrees, max, sin_cos_degrees};
use crate::{Direction, Ellipsoid, LatLon, Real};

/// Converts geodetic latitude and longitude on an ellipsoid to a direction on the sphere, and back.
///
/// The auxiliary latitude of the [`Shift`] becomes the latitude of the sphere; the longitude stays the same.
///
/// ```
/// use terrella::{Ellipsoid, LatLon, Shift, Shifted};
/// let earth = Shifted::new(Ellipsoid::WGS84, Shift::Geocentric).unwrap();
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
    /// Creates the step from an ellipsoid to the sphere. `shift` is the auxiliary latitude that becomes the
    /// sphere's latitude.
    ///
    /// # Errors
    /// [`UnsupportedFlattening`] if the flattening of the ellipsoid is out of the range of that latitude.
    pub fn new(ellipsoid: Ellipsoid<T>, shift: Shift) -> Result<Self, UnsupportedFlattening<T>> {
        supported(ellipsoid, shift).map(|ellipsoid| Self::within(ellipsoid, shift))
    }

    /// For an ellipsoid known to be [`supported`].
    pub(crate) fn within(ellipsoid: Ellipsoid<T>, shift: Shift) -> Self {
        Self {
            ellipsoid,
            shift,
            forward: Correction::to_shifted(ellipsoid, shift),
            inverse: Correction::to_geodetic(ellipsoid, shift),
        }
    }

    /// Returns the ellipsoid.
    #[must_use]
    pub fn ellipsoid(&self) -> Ellipsoid<T> {
        self.ellipsoid
    }

    /// Returns the shift.
    #[must_use]
    pub fn shift(&self) -> Shift {
        self.shift
    }

    /// The corrections from the geodetic latitude to the sphere's, and back.
    pub(crate) fn corrections(&self) -> [Correction<T>; 2] {
        [self.forward, self.inverse]
    }

    /// Returns the direction on the sphere of a geodetic latitude and longitude.
    #[must_use]
    #[inline]
    pub fn to_direction(&self, position: LatLon<T>) -> Direction<T> {
        let [latitude, longitude] = position.sin_cos();
        Direction::from_angles(self.forward.turn(latitude), longitude)
    }

    /// Returns the geodetic latitude and longitude of a direction on the sphere: the inverse of
    /// [`to_direction`](Self::to_direction).
    #[must_use]
    #[inline]
    pub fn to_lat_lon(&self, direction: Direction<T>) -> LatLon<T> {
        let (sin, cos) = self.inverse.turn((direction.z(), direction.cos_lat()));
        LatLon::within(atan2_degrees(sin, cos), direction.lon())
    }

    /// The sine and cosine of the sphere's latitude, from a geodetic latitude in degrees.
    #[inline]
    pub(crate) fn latitude(&self, lat: T) -> (T, T) {
        self.forward.turn(sin_cos_degrees(lat))
    }

    /// The geodetic latitude in degrees, from the sine and cosine of the sphere's latitude.
    #[inline]
    pub(crate) fn geodetic(&self, latitude: (T, T)) -> T {
        let (sin, cos) = self.inverse.turn(latitude);
        atan2_degrees(sin, cos)
    }

    /// The outward normal of the ellipsoid at the place that belongs to a direction on the sphere.
    #[must_use]
    #[inline(always)]
    pub(crate) fn normal(&self, direction: Direction<T>) -> Direction<T> {
        normal(&self.inverse, direction)
    }

    /// The same step for another scalar.
    #[must_use]
    pub(crate) fn map<U: Real>(&self, scalar: impl Fn(T) -> U) -> Shifted<U> {
        Shifted {
            ellipsoid: self.ellipsoid.map(&scalar),
            shift: self.shift,
            forward: self.forward.map(&scalar),
            inverse: self.inverse.map(&scalar),
        }
    }
}

/// The outward normal of the ellipsoid at the place that belongs to a direction on the sphere, by the
/// correction to the geodetic latitude. No angle is computed.
#[must_use]
#[inline(always)]
pub(crate) fn normal<T: Real>(correction: &impl Turn<T>, direction: Direction<T>) -> Direction<T> {
    let [x, y, z] = direction.to_array();
    // cos φ divided by the distance from the axis is smooth across the pole, if that distance is kept above
    // 0.
    let axial = max(T::pick(1e-300, 1e-36), x * x + y * y).sqrt();
    let (sin, cos) = correction.turn((z, axial));
    let scale = cos / axial;
    Direction::within(x * scale, y * scale, sin)
}
