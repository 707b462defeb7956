use super::vector::{along, difference, dot};
use super::{Camera, OrientedBox};
use crate::math::{max, min, select};
use crate::{Ecef, Ellipsoid, Real};

/// Horizon culling: tells which points the planet itself hides from an eye.
///
/// The test is that of Cozzi & Ring, *3D engine design for virtual globes* (2011), §12.3, with Stoner's test
/// in scaled space, as Cesium uses it. Divided by the ellipsoid's axes, the planet is a unit sphere. Let V be
/// the eye, T the point and d = (T − V)·(−V). The point is beyond the plane of the horizon if d > V² − 1, and
/// it is hidden if also d²/(T − V)² > V² − 1. The test needs no trigonometry, one square root for each eye,
/// and none for a point.
///
/// If the terrain goes down to `lowest` below the ellipsoid, the ellipsoid times 1 + lowest/b stands for the
/// planet, where b is the smaller axis. It is nowhere above that depth: along any normal it is lower by
/// |lowest|·H/b, where H is the ellipsoid's support function, and H ≥ b. For a `lowest` above the ellipsoid,
/// b is the larger axis.
///
/// A parallel projection ([`of`](Self::of)) has its eye infinitely far away. Let D be the direction toward
/// it, of length 1 in scaled space. T is beyond the plane of the horizon if T·D < 0, and it is hidden if also
/// T² − (T·D)² < 1.
///
/// The hidden points form a convex set, and everything behind a hidden point is hidden. A point inside the
/// planet is hidden if it is beyond the plane of the horizon; on the near side it counts as visible, like the
/// ground above it. An eye inside the planet sees everything. The test allows for rounding, as if the eye
/// were higher by up to 4 ulps of the planet's radius, so it never hides a visible point.
///
/// ```
/// use terrella::terrain::Horizon;
/// use terrella::{Ellipsoid, Geodetic, LatLon};
///
/// let earth = Ellipsoid::<f64>::WGS84;
/// let at = |lat, lon, height| -> Result<_, Box<dyn std::error::Error>> {
///     Ok(earth.to_ecef(Geodetic::new(LatLon::new(lat, lon)?, height)?))
/// };
/// // From 1000 m the horizon is 113 km away.
/// let horizon = Horizon::new(earth, 0.0, at(45.0, 7.0, 1000.0)?);
/// assert!(!horizon.hides(at(46.0, 7.0, 0.0)?));
/// assert!(horizon.hides(at(47.0, 7.0, 0.0)?));
/// assert!(!horizon.hides(at(47.0, 7.0, 4000.0)?));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[doc(alias = "horizon culling")]
#[doc(alias = "occlusion culling")]
#[doc(alias = "EllipsoidalOccluder")]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Horizon<T> {
    /// The eye, or the planet's centre if the eye is infinitely far away.
    eye: [T; 3],
    /// The reciprocals of the ellipsoid's axes.
    scale: [T; 3],
    /// V, or D for a parallel projection.
    scaled: [T; 3],
    /// The value of d at the plane of the horizon.
    plane: T,
    /// The value of d²/(T − V)² on a line of sight to the horizon.
    cone: T,
    /// For a parallel projection the square of the radius of the shadow, which is a cylinder; else 0.
    cylinder: T,
}

impl<T: Real> Horizon<T> {
    /// Creates the horizon of an eye. No terrain is lower than `lowest`, in metres above the ellipsoid
    /// (negative below it).
    #[must_use]
    pub fn new(ellipsoid: Ellipsoid<T>, lowest: T, eye: Ecef<T>) -> Self {
        let (scale, solid) = scales(ellipsoid, lowest);
        let eye = eye.to_array();
        let scaled = product(eye, scale);
        let square = dot(scaled, scaled);
        // Subtracted from d: the largest rounding error of d, in units of |T − V|.
        let rest = T::of(4.0) * T::EPSILON;
        let outside = square - T::ONE + rest * square;
        let sight = max(outside, T::ZERO).sqrt();
        let wider = sight + rest * square.sqrt();
        let hides = solid & (outside > T::ZERO);
        Self {
            eye,
            scale,
            scaled,
            plane: select(hides, sight * wider, T::of(f64::INFINITY)),
            cone: wider * wider,
            cylinder: T::ZERO,
        }
    }

    /// Creates the horizon of a camera. It is seen from the camera's centre of projection, wherever the eye
    /// is; for a parallel projection that is infinitely far away.
    ///
    /// ```
    /// use terrella::terrain::{Camera, Horizon};
    /// use terrella::{Ecef, Ellipsoid};
    ///
    /// // A parallel projection from 10 km above 0° N 0° E straight down shows half of the planet.
    /// let eye = Ecef::new(6_388_137.0_f64, 0.0, 0.0)?;
    /// let matrix = [[0.0, 1e-7, 0.0, 0.0], [0.0, 0.0, 1e-7, 0.0], [0.0; 4], [0.0, 0.0, 0.0, 1.0]];
    /// let camera = Camera::new(eye, matrix, [1024.0, 1024.0])?;
    /// let horizon = Horizon::of(Ellipsoid::WGS84, 0.0, &camera);
    /// assert!(!horizon.hides(Ecef::new(100_000.0, 6_377_500.0, 0.0)?));
    /// assert!(horizon.hides(Ecef::new(-100_000.0, 6_377_000.0, 0.0)?));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[must_use]
    pub fn of(ellipsoid: Ellipsoid<T>, lowest: T, camera: &Camera<T>) -> Self {
        let (scale, solid) = scales(ellipsoid, lowest);
        let (way, weight) = camera.centre();
        let eye = product(camera.eye().to_array(), scale);
        let way = product(way, scale);
        // Homogeneous coordinates: the eye times the weight, plus the way from there.
        let far = along(way, weight, eye);
        let length = dot(far, far).sqrt();
        let near = weight.abs() > length * T::EPSILON.sqrt();
        if let Some(point) = camera.point().filter(|_| near) {
            return Self::new(ellipsoid, lowest, point);
        }
        // A centre of projection that is far enough away may be treated as infinitely far: from farther away,
        // less is hidden.
        let toward = far.map(|v| v / length);
        let height = dot(toward, eye);
        let rest = T::of(8.0) * T::EPSILON;
        // Lines of sight parallel to the ground may come from either side, so nothing is hidden then.
        let hides = solid & (height.abs() > T::ZERO);
        Self {
            eye: [T::ZERO; 3],
            scale,
            scaled: toward.map(|v| select(height > T::ZERO, v, -v)),
            plane: select(hides, rest, T::of(f64::INFINITY)),
            cone: T::ONE + rest,
            cylinder: T::ONE - rest,
        }
    }

    /// Returns whether the planet hides a point.
    #[must_use]
    #[inline]
    pub fn hides(&self, point: Ecef<T>) -> bool {
        // The difference comes first: it keeps the digits of a near point.
        let way = product(difference(point.to_array(), self.eye), self.scale);
        let down = -dot(way, self.scaled);
        (down > self.plane) & (down * down + self.cylinder > self.cone * dot(way, way))
    }

    /// Returns whether the planet hides all of a box: all of its corners.
    #[must_use]
    #[inline]
    pub fn hides_box(&self, bounds: &OrientedBox<T>) -> bool {
        bounds.corners().into_iter().all(|corner| self.hides(corner))
    }
}

/// The reciprocals of the axes of the ellipsoid that stands for the planet, and whether it has a positive
/// size.
#[inline(always)]
fn scales<T: Real>(ellipsoid: Ellipsoid<T>, lowest: T) -> ([T; 3], bool) {
    let (a, b) = (ellipsoid.a(), ellipsoid.b());
    let axis = select(lowest < T::ZERO, min(a, b), max(a, b));
    let size = T::ONE + lowest / axis;
    let solid = size > T::ZERO;
    let size = select(solid, size, T::ONE);
    ([a, a, b].map(|axis| T::ONE / (axis * size)), solid)
}

/// The product of two vectors, component by component.
#[inline(always)]
fn product<T: Real>([ax, ay, az]: [T; 3], [bx, by, bz]: [T; 3]) -> [T; 3] {
    [ax * bx, ay * by, az * bz]
}
