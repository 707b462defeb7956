use super::{CubeProjection, Face, FacePoint, ProjectionTask};
use crate::latitude::UnsupportedFlattening;
use crate::{Ellipsoid, LatLon, Real, Shift, Shifted};

/// Converts geodetic latitude and longitude on an ellipsoid to a point of the cube, and back.
///
/// A map consists of three parts: an ellipsoid, the [`Shift`] that leads from the ellipsoid to the sphere,
/// and a [`CubeProjection`] of the sphere. With the authalic shift, an equal-area projection of the sphere is
/// an equal-area map of the ellipsoid.
///
/// A round trip on WGS 84 is off by at most 5 nm (`f64`) or 3 m (`f32`), for every projection except
/// [`Cobe`](super::Cobe) and for every shift. [`batch::map`](crate::batch::map) converts whole slices.
///
/// ```
/// use terrella::{Ellipsoid, LatLon, Shift};
/// use terrella::cube::{CubeMap, Face, Quadrilateralized};
///
/// let map = CubeMap::new(Ellipsoid::<f64>::WGS84, Shift::Authalic, Quadrilateralized)?;
/// let oslo = LatLon::new(59.91, 10.75).unwrap();
/// let p = map.project(oslo);
/// assert_eq!(p.face(), Face::Top);
/// assert!((map.unproject(p).lat() - oslo.lat()).abs() < 1e-13);
/// # Ok::<(), terrella::latitude::UnsupportedFlattening<f64>>(())
/// ```
#[doc(alias("cube map", "cubemap", "cubesphere", "cubed sphere"))]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct CubeMap<T, P> {
    shifted: Shifted<T>,
    projection: P,
}

impl<T: Real, P: CubeProjection> CubeMap<T, P> {
    /// Creates the map of an ellipsoid, from the shift to the sphere and the projection of the sphere.
    ///
    /// # Errors
    /// [`UnsupportedFlattening`] if the flattening of the ellipsoid is out of the range of the shift.
    pub fn new(ellipsoid: Ellipsoid<T>, shift: Shift, projection: P) -> Result<Self, UnsupportedFlattening<T>> {
        Ok(Self {
            shifted: Shifted::new(ellipsoid, shift)?,
            projection,
        })
    }

    /// The map of another projection, or of the type that a projection stands for.
    pub(crate) fn with_projection<Q: CubeProjection>(&self, projection: Q) -> CubeMap<T, Q> {
        CubeMap {
            shifted: self.shifted,
            projection,
        }
    }

    /// Returns the step from the ellipsoid to the sphere.
    #[must_use]
    pub fn shifted(&self) -> Shifted<T> {
        self.shifted
    }

    /// Returns the projection of the sphere.
    #[must_use]
    pub fn projection(&self) -> P {
        self.projection
    }

    /// Projects a geodetic latitude and longitude to a point of the cube.
    #[must_use]
    #[inline]
    pub fn project(&self, position: LatLon<T>) -> FacePoint<T> {
        self.projection.with(Project(&self.shifted, position))
    }

    /// Returns the geodetic latitude and longitude of a point of the cube: the inverse of
    /// [`project`](Self::project).
    #[must_use]
    #[inline]
    pub fn unproject(&self, point: FacePoint<T>) -> LatLon<T> {
        self.projection.with(Unproject(&self.shifted, point))
    }
}

struct Project<'a, T>(&'a Shifted<T>, LatLon<T>);

impl<T: Real> ProjectionTask for Project<'_, T> {
    type Output = FacePoint<T>;

    #[inline(always)]
    fn run<P: CubeProjection>(self, projection: P) -> FacePoint<T> {
        let Self(shifted, position) = self;
        if P::TAKES_PLACES {
            let [number, x, y] = projection.project_place(shifted.latitude(position.lat()), position.lon());
            FacePoint::within(Face::of_number(number), x, y)
        } else {
            projection.project(shifted.to_direction(position))
        }
    }
}

struct Unproject<'a, T>(&'a Shifted<T>, FacePoint<T>);

impl<T: Real> ProjectionTask for Unproject<'_, T> {
    type Output = LatLon<T>;

    #[inline(always)]
    fn run<P: CubeProjection>(self, projection: P) -> LatLon<T> {
        let Self(shifted, point) = self;
        if P::TAKES_PLACES {
            let (latitude, lon) =
                projection.unproject_place([T::from_byte(point.face().index()), point.x(), point.y()]);
            LatLon::within(shifted.geodetic(latitude), lon)
        } else {
            shifted.to_lat_lon(projection.unproject(point))
        }
    }
}
