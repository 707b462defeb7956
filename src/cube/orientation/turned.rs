use super::Rotation;
use crate::cube::{CubeProjection, Face, Faces, ProjectionTask};
use crate::{Direction, Real};

/// A projection onto a cube that is turned: its faces are centred on other places.
///
/// Tiles, terrain, distortion and batches work with it as with the projection itself. Each point costs nine
/// multiplications more, and the result is within 3 ulps of the cube's size of that of exact arithmetic
/// (4·10⁻¹⁶ rad in `f64`, 2·10⁻⁷ rad in `f32`), next to the error of the projection. Distortion on the sphere
/// stays the same.
///
/// ```
/// use terrella::cube::{Balanced, CubeMap, CubeProjection, Face, Rotation, Turned};
/// use terrella::{Direction, Ellipsoid, LatLon, Shift};
/// // The cube of GEOS and FV3, 10° to the west of this crate's: its corners are in the sea.
/// let west = Turned::new(Balanced, Rotation::about_axis(-10.0)?);
/// let map = CubeMap::new(Ellipsoid::<f64>::WGS84, Shift::Authalic, west)?;
/// let point = map.project(LatLon::new(0.0, -10.0)?);
/// assert_eq!(point.face(), Face::Front);
/// assert!(point.x().abs() < 1e-15 && point.y() == 0.0);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// PROJ's `rhealpix` is [`Healpix`](crate::cube::Healpix) with the authalic shift, turned by 45° more than its
/// `lon_0`. Its sheet has the side faces in a row, in the order back, left, front, right, and with its default
/// options the polar faces above and below the first, turned by half; the unit is ¼π of the authalic radius:
///
/// ```
/// use terrella::cube::{CubeMap, Face, Healpix, Rotation, Turned};
/// use terrella::{Ellipsoid, LatLon, Shift};
/// let rhealpix = Turned::new(Healpix, Rotation::about_axis(45.0)?);
/// let map = CubeMap::new(Ellipsoid::WGS84, Shift::Authalic, rhealpix)?;
/// let unit = 6_371_007.180_918_474 * std::f64::consts::FRAC_PI_4;
/// let point = map.project(LatLon::new(30.0, 10.0)?);
/// let [x, y] = match point.face() {
///     Face::Back => [point.x() - 3.0, point.y()],
///     Face::Left => [point.x() - 1.0, point.y()],
///     Face::Front => [point.x() + 1.0, point.y()],
///     Face::Right => [point.x() + 3.0, point.y()],
///     Face::Top => [-3.0 - point.x(), 2.0 - point.y()],
///     Face::Bottom => [-3.0 - point.x(), -2.0 - point.y()],
/// };
/// // `echo 10 30 | proj +proj=rhealpix +ellps=WGS84`
/// assert!((x * unit - 1_111_950.519_752).abs() < 1e-6 && (y * unit - 3_740_232.893_366).abs() < 1e-6);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[doc(alias = "rHEALPix")]
#[doc(alias = "oblique")]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Turned<P> {
    projection: P,
    rotation: Rotation,
}

impl<P: CubeProjection> Turned<P> {
    /// Turns the cube of a projection.
    #[must_use]
    pub const fn new(projection: P, rotation: Rotation) -> Self {
        Self { projection, rotation }
    }

    /// Returns the projection onto the cube that is not turned.
    #[must_use]
    pub const fn projection(&self) -> P {
        self.projection
    }

    /// Returns the rotation.
    #[must_use]
    pub const fn rotation(&self) -> Rotation {
        self.rotation
    }
}

impl<P: CubeProjection> CubeProjection for Turned<P> {
    const SYMMETRIC: bool = false;
    const KEEPS_AREAS: bool = P::KEEPS_AREAS;

    #[inline(always)]
    fn faces(&self) -> Faces {
        self.projection.faces()
    }

    #[inline(always)]
    fn forward<T: Real>(&self, face: Face, local: [T; 3]) -> [T; 2] {
        self.projection.forward(face, local)
    }

    #[inline(always)]
    fn inverse<T: Real>(&self, face: Face, point: [T; 2]) -> [T; 3] {
        self.projection.inverse(face, point)
    }

    #[inline(always)]
    fn is_polar<T: Real>(&self, direction: Direction<T>) -> bool {
        self.projection.is_polar(direction)
    }

    #[inline(always)]
    fn bend<T: Real>(&self) -> T {
        self.projection.bend()
    }

    #[inline(always)]
    fn to_cube<T: Real>(&self, vector: [T; 3]) -> [T; 3] {
        self.projection.to_cube(self.rotation.to_cube(vector))
    }

    #[inline(always)]
    fn to_earth<T: Real>(&self, vector: [T; 3]) -> [T; 3] {
        self.rotation.to_earth(self.projection.to_earth(vector))
    }

    #[inline(always)]
    fn with<W: ProjectionTask>(self, task: W) -> W::Output {
        self.projection.with(OnTurned {
            rotation: self.rotation,
            task,
        })
    }
}

/// Runs a task with a projection that is turned.
struct OnTurned<W> {
    rotation: Rotation,
    task: W,
}

impl<W: ProjectionTask> ProjectionTask for OnTurned<W> {
    type Output = W::Output;

    #[inline(always)]
    fn run<P: CubeProjection>(self, projection: P) -> W::Output {
        self.task.run(Turned::new(projection, self.rotation))
    }
}
