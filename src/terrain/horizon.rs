use super::vector::{along, difference, dot};
use super::{Camera, OrientedBox};
use crate::math::{max, min, select};
use crate::{Ecef, Ellipsoid, Real};

/// What the planet itself hides from an eye.
///
/// Cozzi & Ring, *3D engine design for virtual globes* (2011), §12.3, with Stoner's test in scaled space, as Cesium has it: divided by the
/// ellipsoid's axes the planet is a unit sphere; with V the eye, T the point and d = (T − V)·(−V), the point is beyond the plane of the horizon for
/// d > V² − 1 and hidden if d²/(T − V)² > V² − 1 too. No trigonometry; one root for each eye, none for a point.
///
/// Where terrain goes down to `lowest` below the ellipsoid, the planet is taken for the ellipsoid times 1 + lowest/b, b being the smaller axis. That is
/// nowhere above the depth: at any normal it is lower by |lowest|·H/b, where H is the ellipsoid's support, and H ≥ b. For `lowest` above, b is the
/// larger axis.
///
/// Parallel lines of sight ([`of`](Self::of)) are those of an eye that is infinitely far away: with D toward
/// it, of length 1 in scaled space, T is beyond the plane of the horizon for T·D < 0 and hidden if T² −
/// (T·D)² < 1 too.
///
/// What is hidden is a convex set, and with a point all that is behind it. A point inside the planet is hidden if it is beyond the plane of the
/// horizon; on the near side it counts as seen, like the ground above it. From inside nothing is hidden. Rounding is
/// allowed for: it hides nothing that is seen, as if the eye were higher by up to 4 ulps of the planet's radius.
///
/// ```
/// use terrella::terrain::Horizon;
/// use terrella::{Ellipsoid, Geodetic, LatLon};
///
/// let earth = Ellipsoid::<f64>::WGS84;
/// let at = |lat, lon, height| Ok::<_, Box<dyn std::error::Error>>(earth.to_ecef(Geodetic::new(LatLon::new(lat, lon)?, height)?));
/// // From 1000 m the horizon is 113 km away.
/// let horizon = Horizon::new(earth, 0.0, at(45.0, 7.0, 1000.0)?);
/// assert!(!horizon.hides(at(46.0, 7.0, 0.0)?));
/// assert!(horizon.hides(at(47.0, 7.0, 0.0)?));
/// assert!(!horizon.hides(at(47.0, 7.0, 4000.0)?));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Horizon<T> {
    /// The eye; the planet's centre if the eye is infinitely far away.
    eye: [T; 3],
    /// One over the axes.
    scale: [T; 3],
    /// V, or D.
    scaled: [T; 3],
    /// d at the plane of the horizon.
    plane: T,
    /// d²/(T − V)² on the line of sight to it.
    cone: T,
    /// The square of the shadow's radius where that is the same everywhere, or 0.
    cylinder: T,
}

impl<T: Real> Horizon<T> {
    /// Of an ellipsoid with terrain nowhere lower than `lowest`, in metres above it, from an eye.
    #[must_use]
    pub fn new(ellipsoid: Ellipsoid<T>, lowest: T, eye: Ecef<T>) -> Self {
        let (scale, solid) = scales(ellipsoid, lowest);
        let eye = eye.to_array();
        let scaled = product(eye, scale);
        let square = dot(scaled, scaled);
        // What rounding may do to d, in units of |T − V|, is taken off it.
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

    /// The same for a camera: from its centre of projection, which may be infinitely far away, wherever the
    /// eye is.
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
        // Homogeneous: the eye times the weight, and the way from there.
        let far = along(way, weight, eye);
        let length = dot(far, far).sqrt();
        let near = weight.abs() > length * T::EPSILON.sqrt();
        if let Some(point) = camera.point().filter(|_| near) {
            return Self::new(ellipsoid, lowest, point);
        }
        // From farther away less is hidden: what is as good as infinitely far away may be taken for it.
        let toward = far.map(|v| v / length);
        let height = dot(toward, eye);
        let rest = T::of(8.0) * T::EPSILON;
        // Lines of sight along the ground may come from either side.
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

    /// Whether a point is hidden.
    #[must_use]
    #[inline]
    pub fn hides(&self, point: Ecef<T>) -> bool {
        // The difference first: the digits of a near point are in it.
        let way = product(difference(point.to_array(), self.eye), self.scale);
        let down = -dot(way, self.scaled);
        (down > self.plane) & (down * down + self.cylinder > self.cone * dot(way, way))
    }

    /// Whether all of a box is hidden: all of its corners are.
    #[must_use]
    #[inline]
    pub fn hides_box(&self, bounds: &OrientedBox<T>) -> bool {
        bounds.corners().into_iter().all(|corner| self.hides(corner))
    }
}

/// One over the axes of the planet in the ground that is nowhere lower, and whether there is any.
#[inline(always)]
fn scales<T: Real>(ellipsoid: Ellipsoid<T>, lowest: T) -> ([T; 3], bool) {
    let (a, b) = (ellipsoid.a(), ellipsoid.b());
    let axis = select(lowest < T::ZERO, min(a, b), max(a, b));
    let size = T::ONE + lowest / axis;
    let solid = size > T::ZERO;
    let size = select(solid, size, T::ONE);
    ([a, a, b].map(|axis| T::ONE / (axis * size)), solid)
}

#[inline(always)]
fn product<T: Real>([ax, ay, az]: [T; 3], [bx, by, bz]: [T; 3]) -> [T; 3] {
    [ax * bx, ay * by, az * bz]
}
