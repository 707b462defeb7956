//! The trait of all projections.

use super::{Faces, on_face};
use crate::cube::{Face, FacePoint};
use crate::math::sin_cos_degrees;
use crate::{Direction, Real};

/// A projection of the sphere onto the six faces of a cube, and back.
///
/// To make one of your own, implement [`forward`](Self::forward) and [`inverse`](Self::inverse). Everything
/// else in this crate then works with it, in `f64` and `f32`, with derivatives and over slices.
///
/// ```
/// use terrella::cube::{CubeProjection, Face};
/// use terrella::{Direction, Real};
///
/// #[derive(Clone, Copy)]
/// struct Gnomonic;
///
/// impl CubeProjection for Gnomonic {
///     fn forward<T: Real>(&self, _: Face, [right, up, outward]: [T; 3]) -> [T; 2] {
///         [right / outward, up / outward]
///     }
///     fn inverse<T: Real>(&self, _: Face, [x, y]: [T; 2]) -> [T; 3] {
///         let length = (x * x + y * y + T::ONE).sqrt();
///         [x / length, y / length, T::ONE / length]
///     }
/// }
///
/// let point = Gnomonic.project(Direction::new(2.0, 1.0, 0.0)?);
/// assert_eq!((point.face(), point.x(), point.y()), (Face::Front, 0.5, 0.0));
/// # Ok::<(), terrella::InvalidDirection<f64>>(())
/// ```
pub trait CubeProjection: Copy {
    /// Returns (x, y) in [−1, 1]² on a face, from a unit vector in the face's frame (right, up, outward).
    ///
    /// The vector's length is 1 apart from rounding; the result must depend on its direction only. Rounding
    /// may carry a result past ±1: [`project`](Self::project) brings it back.
    #[must_use]
    fn forward<T: Real>(&self, face: Face, local: [T; 3]) -> [T; 2];

    /// Returns the unit vector in the face's frame (right, up, outward), from (x, y) in [−1, 1]².
    #[must_use]
    fn inverse<T: Real>(&self, face: Face, point: [T; 2]) -> [T; 3];

    /// Returns which symmetries the faces have, and whether they agree along the edges of the cube. The
    /// default is that all are alike, with the symmetries of the square.
    #[must_use]
    #[inline(always)]
    fn faces(&self) -> Faces {
        Faces::Alike
    }

    /// Whether symmetries of the ellipsoid map a quarter of the front or of the top face to each quarter of a
    /// face. Then [`Patches::flatness`](crate::terrain::Patches::flatness) looks at these two quarters alone,
    /// else at all.
    const SYMMETRIC: bool = true;

    /// Whether cells of equal size in x and y have equal areas on the sphere. Then
    /// [`Tile::area`](crate::terrain::Tile::area) needs no integral where the shift keeps areas.
    #[doc(hidden)]
    const KEEPS_AREAS: bool = false;

    /// How many times as much as on a plain cube the edges of tiles may bend: a bound for the boxes of
    /// [`Enclosure`](crate::terrain::Enclosure). It is 1, unless the cube is
    /// [`Stretched`](crate::cube::Stretched).
    #[doc(hidden)]
    #[must_use]
    #[inline(always)]
    fn bend<T: Real>(&self) -> T {
        T::ONE
    }

    /// Returns the unit vector along the cube's axes, on which the faces are defined, from a unit vector along
    /// Earth axes. The default is a cube whose axes are those of the Earth;
    /// [`Turned`](crate::cube::Turned) and [`Stretched`](crate::cube::Stretched) give other ones.
    #[must_use]
    #[inline(always)]
    fn to_cube<T: Real>(&self, vector: [T; 3]) -> [T; 3] {
        vector
    }

    /// Returns the unit vector along Earth axes, from a unit vector along the cube's axes: the inverse of
    /// [`to_cube`](Self::to_cube).
    #[must_use]
    #[inline(always)]
    fn to_earth<T: Real>(&self, vector: [T; 3]) -> [T; 3] {
        vector
    }

    /// Returns whether a direction along the cube's axes lies on the top or the bottom face. The default is
    /// the cube's own faces: where |z| is the largest component.
    #[must_use]
    #[inline(always)]
    fn is_polar<T: Real>(&self, direction: Direction<T>) -> bool {
        let [x, y, z] = direction.to_array();
        (z.abs() > y.abs()) & (z.abs() >= x.abs())
    }

    /// Returns the face of a direction: top or bottom, or the side face of its longitude. Where |x| = |y|,
    /// the side face is that of the axis y.
    #[must_use]
    #[inline(always)]
    fn face<T: Real>(&self, direction: Direction<T>) -> Face {
        let [x, y, z] = self.to_cube(direction.to_array());
        let on_cube = Direction::within(x, y, z);
        Face::of(self.is_polar(on_cube), on_cube)
    }

    /// Projects a direction to a point of the cube.
    #[must_use]
    #[inline(always)]
    fn project<T: Real>(&self, direction: Direction<T>) -> FacePoint<T> {
        let [x, y, z] = self.to_cube(direction.to_array());
        let on_cube = Direction::within(x, y, z);
        let face = Face::of(self.is_polar(on_cube), on_cube);
        let [x, y] = on_face(self.forward(face, face.to_local([x, y, z])));
        FacePoint::within(face, x, y)
    }

    /// Returns the direction of a point of the cube: the inverse of [`project`](Self::project).
    #[must_use]
    #[inline(always)]
    fn unproject<T: Real>(&self, point: FacePoint<T>) -> Direction<T> {
        let [x, y, z] = self.vector(point.face(), [point.x(), point.y()]);
        Direction::within(x, y, z)
    }

    /// Returns the unit vector along Earth axes, from (x, y) on a face: [`unproject`](Self::unproject) for
    /// numbers with derivatives, or next to a face, where the formula goes on.
    #[must_use]
    #[inline(always)]
    fn vector<T: Real>(&self, face: Face, point: [T; 2]) -> [T; 3] {
        self.to_earth(face.to_earth(self.inverse(face, point)))
    }

    /// Whether the projection is computed from latitude and longitude alone. If so, a
    /// [`CubeMap`](crate::cube::CubeMap) calls [`project_place`](Self::project_place) and
    /// [`unproject_place`](Self::unproject_place), and computes no unit vector.
    #[doc(hidden)]
    const TAKES_PLACES: bool = false;

    /// Returns the number of the face, x and y, from the sine and cosine of a latitude on the sphere and a
    /// longitude in [−180, 180] degrees.
    ///
    /// ```
    /// use terrella::cube::{CubeProjection, Face, Healpix};
    /// let (sin, cos) = (0.6, 0.8);
    /// let [number, x, y] = Healpix.project_place((sin, cos), 99.0);
    /// assert_eq!((number, x, y), (f64::from(Face::Right.index()), 0.2, 1.5 * sin));
    /// ```
    #[doc(hidden)]
    #[must_use]
    #[inline(always)]
    fn project_place<T: Real>(&self, latitude: (T, T), lon: T) -> [T; 3] {
        let point = self.project(Direction::from_angles(latitude, sin_cos_degrees(lon)));
        [T::from_byte(point.face().index()), point.x(), point.y()]
    }

    /// Returns the sine and cosine of the latitude on the sphere, and the longitude in [−180, 180] degrees,
    /// from the number of a face, x and y.
    ///
    /// ```
    /// use terrella::cube::{CubeProjection, Healpix};
    /// assert_eq!(Healpix.unproject_place([1.0, 0.2, 0.0]), ((0.0, 1.0), 99.0));
    /// ```
    #[doc(hidden)]
    #[must_use]
    #[inline(always)]
    fn unproject_place<T: Real>(&self, [number, x, y]: [T; 3]) -> ((T, T), T) {
        let direction = self.unproject(FacePoint::within(Face::of_number(number), x, y));
        ((direction.z(), direction.cos_lat()), direction.lon())
    }

    /// Runs a task with the projection's own type. A [`Projection`](super::Projection) runs it with the type
    /// that it stands for, so that a loop over points chooses the projection once.
    #[doc(hidden)]
    #[inline(always)]
    fn with<W: ProjectionTask>(self, task: W) -> W::Output {
        task.run(self)
    }
}

/// A task for a projection whose type is not known yet: see [`CubeProjection::with`].
///
/// ```
/// use terrella::cube::{CubeProjection, Projection, ProjectionTask};
///
/// struct Size;
///
/// impl ProjectionTask for Size {
///     type Output = usize;
///     fn run<P: CubeProjection>(self, _: P) -> usize {
///         size_of::<P>()
///     }
/// }
///
/// assert_eq!(Projection::Vertex.with(Size), 0);
/// ```
#[doc(hidden)]
pub trait ProjectionTask {
    /// The task's result.
    type Output;

    /// Runs the task.
    fn run<P: CubeProjection>(self, projection: P) -> Self::Output;
}
