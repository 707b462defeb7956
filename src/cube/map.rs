use super::{CubeProjection, FacePoint};
use crate::latitude::UnsupportedFlattening;
use crate::{Ellipsoid, LatLon, Real, Shift, Shifted};

/// Geodetic latitude and longitude on an ellipsoid to a point of the cube and back.
///
/// Round trip on WGS84 within 5 nm (`f64`), 3 m (`f32`), for every projection and shift.
///
/// ```
/// use terrella::{Ellipsoid, LatLon, Shift};
/// use terrella::cube::{CubeMap, Face, Quadrilateralized};
///
/// let map = CubeMap::new(Ellipsoid::<f64>::wgs84(), Shift::Authalic, Quadrilateralized)?;
/// let oslo = LatLon::new(59.91, 10.75).unwrap();
/// let p = map.project(oslo);
/// assert_eq!(p.face(), Face::Top);
/// assert!((map.unproject(p).lat() - oslo.lat()).abs() < 1e-13);
/// # Ok::<(), terrella::latitude::UnsupportedFlattening<f64>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct CubeMap<T, P> {
    shifted: Shifted<T>,
    projection: P,
}

impl<T: Real, P: CubeProjection> CubeMap<T, P> {
    /// From an ellipsoid, the shift that lays it on the sphere, and the sphere's projection.
    ///
    /// # Errors
    /// [`UnsupportedFlattening`] if the latitude's formula does not hold for this ellipsoid.
    pub fn new(ellipsoid: Ellipsoid<T>, shift: Shift, projection: P) -> Result<Self, UnsupportedFlattening<T>> {
        Ok(Self {
            shifted: Shifted::new(ellipsoid, shift)?,
            projection,
        })
    }

    /// The step from the ellipsoid to the sphere.
    #[must_use]
    pub fn shifted(&self) -> Shifted<T> {
        self.shifted
    }

    /// The projection of the sphere.
    #[must_use]
    pub fn projection(&self) -> P {
        self.projection
    }

    /// From the ellipsoid to the cube.
    #[must_use]
    #[inline]
    pub fn project(&self, position: LatLon<T>) -> FacePoint<T> {
        self.projection.project(self.shifted.to_direction(position))
    }

    /// From the cube to the ellipsoid.
    #[must_use]
    #[inline]
    pub fn unproject(&self, point: FacePoint<T>) -> LatLon<T> {
        self.shifted.to_lat_lon(self.projection.unproject(point))
    }
}
