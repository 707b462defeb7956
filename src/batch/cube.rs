//! Converts directions to points of the cube's faces, and back, by any [`CubeProjection`].

use core::fmt;

use super::engine::solve_by;
use super::face_mask::FaceMask;
use super::face_number::Faces;
use super::position::Vectors;
use super::{FaceNumber, InvalidBatch};
use crate::cube::{CubeProjection, Face, FacePoint, InvalidFace, InvalidFacePoint, ProjectionTask, on_face};
use crate::simd::{Behind, Door, Kernel, Tally, lanes};
use crate::{Direction, InvalidDirection, Real};

/// Why a point of the cube was refused.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum InvalidPoint<T> {
    /// [`Face::from_index`] refuses the number of the face.
    Face(InvalidFace),
    /// [`FacePoint::new`] refuses x or y.
    Point(InvalidFacePoint<T>),
}

impl<T: fmt::Debug> fmt::Display for InvalidPoint<T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Face(why) => why.fmt(f),
            Self::Point(why) => why.fmt(f),
        }
    }
}

impl<T: fmt::Debug> core::error::Error for InvalidPoint<T> {}

/// The coordinates and the number of a face.
pub(super) type Point<T> = ([T; 2], T);

/// Coordinates on a face, and its number.
#[derive(Clone, Copy)]
pub(super) struct Points;

impl<T: Real> Door<Point<T>> for Points {
    type Error = InvalidPoint<T>;

    #[inline(always)]
    fn keeps(&self, ([x, y], number): Point<T>) -> bool {
        (x.abs() <= T::ONE) & (y.abs() <= T::ONE) & (number <= T::of(5.0))
    }

    fn admit(&self, point: Point<T>) -> Result<Point<T>, Self::Error> {
        face_point(point).map(|_| point)
    }
}

/// The point, if there is one.
pub(super) fn face_point<T: Real>(([x, y], number): Point<T>) -> Result<FacePoint<T>, InvalidPoint<T>> {
    let face = Face::from_index(number.to_byte()).map_err(InvalidPoint::Face)?;
    FacePoint::new(face, x, y).map_err(InvalidPoint::Point)
}

/// The number of a point's face, and its coordinates.
pub(super) fn numbered<T: Real>(point: FacePoint<T>) -> (T, [T; 2]) {
    (T::from_byte(point.face().index()), [point.x(), point.y()])
}

#[derive(Clone, Copy)]
struct Project<P>(P);

impl<T: Real, P: CubeProjection> Kernel<[T; 3]> for Project<P> {
    type Output = (T, [T; 2]);

    #[inline(always)]
    fn apply(&self, vector: [T; 3]) -> (T, [T; 2]) {
        let [x, y, z] = self.0.to_cube(vector);
        let facing = FaceMask::toward(self.0.is_polar(Direction::within(x, y, z)), [x, y, z]);
        let number = facing.number();
        let local = facing.to_local([x, y, z]);
        (number, on_face(self.0.forward(Face::of_number(number), local)))
    }
}

#[derive(Clone, Copy)]
struct Unproject<P>(P);

impl<T: Real, P: CubeProjection> Kernel<Point<T>> for Unproject<P> {
    type Output = [T; 3];

    #[inline(always)]
    fn apply(&self, (point, number): Point<T>) -> [T; 3] {
        let local = self.0.inverse(Face::of_number(number), point);
        self.0.to_earth(FaceMask::of(number).to_earth(local))
    }
}

/// [`project`] in lanes.
pub(super) struct ProjectInLanes<'a, 't, T, F> {
    pub(super) vectors: Vectors,
    pub(super) directions: [&'a [T]; 3],
    pub(super) points: (Faces<&'a mut [F], T>, [&'a mut [T]; 2]),
    pub(super) tally: &'t mut Tally<InvalidDirection<T>>,
}

impl<T: Real, F: FaceNumber> ProjectionTask for ProjectInLanes<'_, '_, T, F> {
    type Output = ();

    fn run<P: CubeProjection>(self, projection: P) {
        lanes(
            Behind(self.vectors, Project(projection)),
            self.directions,
            self.points,
            self.tally,
        );
    }
}

/// [`unproject`] in lanes.
pub(super) struct UnprojectInLanes<'a, 't, T, F> {
    pub(super) points: ([&'a [T]; 2], Faces<&'a [F], T>),
    pub(super) directions: [&'a mut [T]; 3],
    pub(super) tally: &'t mut Tally<InvalidPoint<T>>,
}

impl<T: Real, F: FaceNumber> ProjectionTask for UnprojectInLanes<'_, '_, T, F> {
    type Output = ();

    fn run<P: CubeProjection>(self, projection: P) {
        lanes(
            Behind(Points, Unproject(projection)),
            self.points,
            self.directions,
            self.tally,
        );
    }
}

/// Projects vectors of any length to faces and their coordinates x and y in [−1, 1], with the bits of
/// [`CubeProjection::project`].
///
/// # Errors
/// [`InvalidBatch`] if slices have unequal lengths, or [`Direction::new`] refuses an element.
///
/// ```
/// use terrella::batch::cube;
/// use terrella::cube::{Face, S2Quadratic};
/// let (mut face, mut x, mut y) = ([Face::Front; 2], [0.0; 2], [0.0; 2]);
/// cube::project(S2Quadratic, [&[0.0, 1.0], &[2.0, 0.0], &[2.0, 0.5]], &mut face, [&mut x, &mut y])?;
/// assert_eq!((face[0], x[0], y[0]), (Face::Right, 0.0, 1.0));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn project<T: Real, P: CubeProjection, F: FaceNumber>(
    projection: P,
    directions: [&[T]; 3],
    faces: &mut [F],
    points: [&mut [T]; 2],
) -> Result<(), InvalidBatch<InvalidDirection<T>>> {
    solve_by(
        directions,
        (Faces::new(faces), points),
        |[x, y, z]| Ok(numbered(projection.project(Direction::new(x, y, z)?))),
        |directions, points, tally| {
            projection.with(ProjectInLanes {
                vectors: Vectors { known: false },
                directions,
                points,
                tally,
            });
        },
    )
}

/// Converts faces and their coordinates x and y in [−1, 1] to unit vectors, with the bits of
/// [`CubeProjection::unproject`].
///
/// # Errors
/// [`InvalidBatch`] if slices have unequal lengths, or [`FacePoint::new`] refuses an element.
///
/// ```
/// use terrella::batch::cube;
/// use terrella::cube::Tangential;
/// let (mut x, mut y, mut z) = ([0.0; 2], [0.0; 2], [0.0; 2]);
/// cube::unproject(Tangential, &[0_u8, 2], [&[0.0, 0.0], &[0.0, 1.0]], [&mut x, &mut y, &mut z])?;
/// assert_eq!((x[0], y[0], z[0]), (1.0, 0.0, 0.0));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn unproject<T: Real, P: CubeProjection, F: FaceNumber>(
    projection: P,
    faces: &[F],
    points: [&[T]; 2],
    directions: [&mut [T]; 3],
) -> Result<(), InvalidBatch<InvalidPoint<T>>> {
    solve_by(
        (points, Faces::new(faces)),
        directions,
        |point| Ok(projection.unproject(face_point(point)?).to_array()),
        |points, directions, tally| {
            projection.with(UnprojectInLanes {
                points,
                directions,
                tally,
            });
        },
    )
}
