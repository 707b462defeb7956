use super::{Ground, Jacobian, Singular};
use crate::Real;
use crate::cube::{CubeProjection, FacePoint};
use crate::math::{atan2_degrees, select};

/// Tissot's indicatrix at a point: the ellipse to which the projection maps a small circle on the ground.
///
/// A scale is a length on the face divided by the length on the ground. The faces are drawn so large that six
/// of them have the area of the planet: an equal-area projection has [`areal`](Self::areal) scale 1
/// everywhere. All scales are dimensionless.
///
/// Snyder, *Map projections: a working manual* (USGS 1395, 1987), §4.
///
/// ```
/// use terrella::cube::{CubeMap, Face, FacePoint, Vertex};
/// use terrella::distortion::Ground;
/// use terrella::{Ellipsoid, Shift};
///
/// let ground = Ground::new(CubeMap::new(Ellipsoid::<f64>::WGS84, Shift::Authalic, Vertex)?);
/// let tissot = ground.tissot(FacePoint::new(Face::Top, 0.3, -0.6)?)?;
/// assert!((tissot.areal - 1.0).abs() < 1e-13);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[doc(alias = "Tissot indicatrix")]
#[doc(alias = "scale factor")]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Tissot<T> {
    /// h: the scale along the meridian.
    pub meridian: T,
    /// k: the scale along the parallel.
    pub parallel: T,
    /// θ′: the angle on the face between the meridian (northward) and the parallel (eastward), in degrees.
    pub graticule_angle: T,
    /// a: the major semi-axis, which is the largest scale.
    pub major: T,
    /// b: the minor semi-axis, which is the smallest scale.
    pub minor: T,
    /// The azimuth on the ground of the largest scale, in degrees clockwise from north, in [0, 180); 0 if all
    /// scales are equal.
    pub azimuth: T,
    /// s = ab: the areal scale.
    pub areal: T,
    /// ω: the maximum angular deformation, in degrees, in [0, 180].
    pub deformation: T,
}

impl<T: Real> Tissot<T> {
    /// Creates the indicatrix from the derivative of the ground; on the drawn face, `unit` metres are one
    /// unit of x and y.
    #[must_use]
    #[inline]
    pub fn new(jacobian: &Jacobian<T>, unit: T) -> Self {
        let [a, b] = jacobian.by_x;
        let [c, d] = jacobian.by_y;
        let area = jacobian.area();
        let scale = unit / area;
        let [shortest, longest] = jacobian.extremes();
        // The unit circle of the face becomes an ellipse on the ground; the scale is largest along its minor
        // axis.
        let (p, q, r) = (a * a + c * c, a * b + c * d, b * b + d * d);
        let twice = atan2_degrees(T::of(-2.0) * q, p - r);
        let azimuth = T::of(0.5) * twice;
        let half_circle = T::of(180.0);
        let azimuth = select(azimuth < T::ZERO, azimuth + half_circle, azimuth);
        Self {
            meridian: (a * a + c * c).sqrt() * scale,
            parallel: (b * b + d * d).sqrt() * scale,
            graticule_angle: atan2_degrees(area, -q),
            major: unit / shortest,
            minor: unit / longest,
            azimuth: select(azimuth < half_circle, azimuth + T::ZERO, T::ZERO),
            areal: scale * unit,
            deformation: jacobian.deformation(),
        }
    }
}

impl<T: Real, P: CubeProjection> Ground<T, P> {
    /// Returns Tissot's indicatrix at a point of the cube.
    ///
    /// # Errors
    /// [`Singular`] where the map has no derivative, or one that is not invertible: see [`Ground::jacobian`].
    #[doc(alias = "Tissot")]
    pub fn tissot(&self, point: FacePoint<T>) -> Result<Tissot<T>, Singular<T>> {
        Ok(Tissot::new(&self.jacobian(point)?, self.unit()))
    }

    /// Returns the length, in metres, of one unit of x and y on the drawn faces: with it, six faces have the
    /// area of the planet. It is √(π/6) authalic radii.
    #[must_use]
    pub fn unit(&self) -> T {
        T::of(0.723_601_254_558_267_7) * self.ellipsoid().authalic_radius()
    }

    /// Returns the area that each texel has where all have the same, in square metres per unit of x and of y:
    /// a 24th of the planet, the square of [`unit`](Self::unit).
    #[must_use]
    pub fn fair_texel(&self) -> T {
        let unit = self.unit();
        unit * unit
    }
}
