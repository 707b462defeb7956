//! Directions to points of the cube's faces and back, by any [`CubeProjection`].

use super::InvalidBatch;
use super::block::{BLOCK, Door, Kernel, Sink, Source, admit, block, front, store, sweep};
use super::position::Vectors;
use crate::cube::{CubeProjection, Face, FacePoint, InvalidFacePoint, ProjectionTask};
use crate::math::select;
use crate::{Direction, InvalidDirection, Real};

/// Coordinates on a face.
pub(super) struct Points;

impl<T: Real> Door<T, 2> for Points {
    type Error = InvalidFacePoint<T>;

    #[inline(always)]
    fn keeps(&self, [x, y]: [T; 2]) -> bool {
        (x.abs() <= T::ONE) & (y.abs() <= T::ONE)
    }

    fn admit(&self, [x, y]: [T; 2]) -> Result<[T; 2], Self::Error> {
        FacePoint::new(Face::Front, x, y).map(|_| [x, y])
    }
}

struct Project<P>(P);

impl<T: Real, P: CubeProjection> Kernel<T, 3, 3> for Project<P> {
    #[inline(always)]
    fn apply(&self, [x, y, z]: [T; 3]) -> [T; 3] {
        let point = self.0.project(Direction::within(x, y, z));
        [number(point.face()), point.x(), point.y()]
    }
}

struct Unproject<P>(P);

impl<T: Real, P: CubeProjection> Kernel<T, 3, 3> for Unproject<P> {
    #[inline(always)]
    fn apply(&self, [number, x, y]: [T; 3]) -> [T; 3] {
        self.0.unproject(FacePoint::within(face(number), x, y)).to_array()
    }
}

/// A face's number in the width of the coordinates, so that it is chosen with them.
#[inline(always)]
fn number<T: Real>(face: Face) -> T {
    let side = |at: Face, number: f64, other: T| select(face as u8 == at as u8, T::of(number), other);
    let number = side(Face::Bottom, 5.0, T::ZERO);
    let number = side(Face::Top, 4.0, number);
    let number = side(Face::Left, 3.0, number);
    let number = side(Face::Back, 2.0, number);
    side(Face::Right, 1.0, number)
}

/// The face of a number.
#[inline(always)]
fn face<T: Real>(number: T) -> Face {
    let side = |at: Face, value: f64, other: Face| select(number == T::of(value), at, other);
    let face = side(Face::Bottom, 5.0, Face::Front);
    let face = side(Face::Top, 4.0, face);
    let face = side(Face::Left, 3.0, face);
    let face = side(Face::Back, 2.0, face);
    side(Face::Right, 1.0, face)
}

/// Points of faces as a source and a sink: the face is a column of numbers.
struct Faces<F, C> {
    faces: F,
    points: C,
}

impl<'s, T: Real> Source<'s, T, 3> for Faces<&'s [Face], [&'s [T]; 2]> {
    #[inline(always)]
    fn is_empty(&self) -> bool {
        self.faces.is_empty()
    }

    #[inline(always)]
    fn next<'a>(&mut self, [numbers, x, y]: &'a mut [[T; BLOCK]; 3]) -> [&'a [T; BLOCK]; 3]
    where
        's: 'a,
    {
        let (here, rest) = match self.faces.split_at_checked(BLOCK) {
            Some(parts) => parts,
            None => (self.faces, [].as_slice()),
        };
        self.faces = rest;
        for (slot, &face) in numbers.iter_mut().zip(here) {
            *slot = number(face);
        }
        let [px, py] = &mut self.points;
        [numbers, block(px, x), block(py, y)]
    }
}

impl<T: Real> Sink<T, 3> for Faces<&mut [Face], [&mut [T]; 2]> {
    #[inline(always)]
    fn store(&mut self, [numbers, x, y]: &[[T; BLOCK]; 3]) {
        store(&mut self.faces, &numbers.map(face));
        let [px, py] = &mut self.points;
        store(px, x);
        store(py, y);
    }
}

/// Where to project from, and to.
struct ProjectAll<'a, T>([&'a [T]; 3], Faces<&'a mut [Face], [&'a mut [T]; 2]>);

impl<T: Real> ProjectionTask for ProjectAll<'_, T> {
    type Output = ();

    fn run<P: CubeProjection>(self, projection: P) {
        sweep(Project(projection), self.0, self.1);
    }
}

/// Where to go back from, and to.
struct UnprojectAll<'a, T>(Faces<&'a [Face], [&'a [T]; 2]>, [&'a mut [T]; 3]);

impl<T: Real> ProjectionTask for UnprojectAll<'_, T> {
    type Output = ();

    fn run<P: CubeProjection>(self, projection: P) {
        sweep(Unproject(projection), self.0, self.1);
    }
}

/// Of directions as [`Vectors`] keeps them.
pub(super) fn project_units<T: Real, P: CubeProjection>(
    projection: P,
    directions: [&[T]; 3],
    faces: &mut [Face],
    points: [&mut [T]; 2],
) {
    projection.with(ProjectAll(directions, Faces { faces, points }));
}

/// Of points as [`Points`] keeps them.
pub(super) fn unproject_points<T: Real, P: CubeProjection>(
    projection: P,
    faces: &[Face],
    points: [&[T]; 2],
    directions: [&mut [T]; 3],
) {
    projection.with(UnprojectAll(Faces { faces, points }, directions));
}

/// Directions to their places on the cube: [`CubeProjection::project`].
///
/// # Errors
/// [`InvalidBatch`] for unequal lengths, and for what [`Direction::new`] refuses; nothing is written then.
///
/// ```
/// use terrella::batch::cube;
/// use terrella::cube::{Face, S2Quadratic};
/// let (mut face, mut x, mut y) = ([Face::Front; 2], [0.0; 2], [0.0; 2]);
/// cube::project(S2Quadratic, [&[0.0, 1.0], &[2.0, 0.0], &[2.0, 0.5]], &mut face, [&mut x, &mut y])?;
/// assert_eq!((face[0], x[0], y[0]), (Face::Right, 0.0, 1.0));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn project<T: Real, P: CubeProjection>(
    projection: P,
    directions: [&[T]; 3],
    faces: &mut [Face],
    mut points: [&mut [T]; 2],
) -> Result<(), InvalidBatch<InvalidDirection<T>>> {
    let lengths = [faces.len(), points[0].len(), points[1].len()];
    let mut faces = [faces];
    admit(&Vectors, directions, &lengths, |length, directions| {
        let [faces] = front(&mut faces, length);
        project_units(projection, directions, faces, front(&mut points, length));
    })
}

/// Places on the cube to their directions: [`CubeProjection::unproject`].
///
/// # Errors
/// [`InvalidBatch`] for unequal lengths, and for what [`FacePoint::new`] refuses; nothing is written then.
///
/// ```
/// use terrella::batch::cube;
/// use terrella::cube::{Face, Outerra};
/// let (mut x, mut y, mut z) = ([0.0; 2], [0.0; 2], [0.0; 2]);
/// cube::unproject(Outerra, &[Face::Back, Face::Top], [&[0.0, 0.0], &[0.0, 1.0]], [&mut x, &mut y, &mut z])?;
/// assert_eq!((x[0], y[0], z[0]), (-1.0, 0.0, 0.0));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn unproject<T: Real, P: CubeProjection>(
    projection: P,
    faces: &[Face],
    points: [&[T]; 2],
    mut directions: [&mut [T]; 3],
) -> Result<(), InvalidBatch<InvalidFacePoint<T>>> {
    let [x, y, z] = directions.each_ref().map(|column| column.len());
    // A point is kept or refused: all of them come at once.
    admit(&Points, points, &[faces.len(), x, y, z], |length, points| {
        unproject_points(projection, faces, points, front(&mut directions, length));
    })
}
