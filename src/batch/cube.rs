//! Converts directions to points of the cube's faces, and back, by any [`CubeProjection`].

use super::InvalidBatch;
use super::admit::{Constructor, admit};
use super::face_mask::FaceMask;
use super::position::Vectors;
use crate::cube::{CubeProjection, Face, FacePoint, InvalidFacePoint, ProjectionTask, on_face};
use crate::simd::{BLOCK, Kernel, Sink, Source, block, front, store, sweep};
use crate::{Direction, InvalidDirection, Real};

/// Coordinates on a face.
pub(super) struct Points;

impl<T: Real> Constructor<T, 2> for Points {
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
        let facing = FaceMask::toward(self.0.is_polar(Direction::within(x, y, z)), [x, y, z]);
        let number = facing.number();
        let [x, y] = on_face(self.0.forward(Face::of_number(number), facing.to_local([x, y, z])));
        [number, x, y]
    }
}

struct Unproject<P>(P);

impl<T: Real, P: CubeProjection> Kernel<T, 3, 3> for Unproject<P> {
    #[inline(always)]
    fn apply(&self, [number, x, y]: [T; 3]) -> [T; 3] {
        FaceMask::of(number).to_earth(self.0.inverse(Face::of_number(number), [x, y]))
    }
}

/// Points of faces as a source and a sink. The face becomes a column of numbers.
pub(super) struct Faces<F, C> {
    pub(super) faces: F,
    pub(super) points: C,
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
        let mut spare = [Face::Front; BLOCK];
        let here = block(&mut self.faces, &mut spare);
        for (slot, &face) in numbers.iter_mut().zip(here) {
            *slot = T::from_byte(face.index());
        }
        let [px, py] = &mut self.points;
        [numbers, block(px, x), block(py, y)]
    }
}

impl<T: Real> Sink<T, 3> for Faces<&mut [Face], [&mut [T]; 2]> {
    #[inline(always)]
    fn store(&mut self, [numbers, x, y]: &[[T; BLOCK]; 3]) {
        store(&mut self.faces, &numbers.map(Face::of_number));
        let [px, py] = &mut self.points;
        store(px, x);
        store(py, y);
    }
}

/// Projects directions into faces and points.
struct ProjectAll<'a, T>([&'a [T]; 3], Faces<&'a mut [Face], [&'a mut [T]; 2]>);

impl<T: Real> ProjectionTask for ProjectAll<'_, T> {
    type Output = ();

    fn run<P: CubeProjection>(self, projection: P) {
        sweep(Project(projection), self.0, self.1);
    }
}

/// Unprojects faces and points into directions.
struct UnprojectAll<'a, T>(Faces<&'a [Face], [&'a [T]; 2]>, [&'a mut [T]; 3]);

impl<T: Real> ProjectionTask for UnprojectAll<'_, T> {
    type Output = ();

    fn run<P: CubeProjection>(self, projection: P) {
        sweep(Unproject(projection), self.0, self.1);
    }
}

/// [`project`] for directions that have passed [`Vectors`].
pub(super) fn project_units<T: Real, P: CubeProjection>(
    projection: P,
    directions: [&[T]; 3],
    faces: &mut [Face],
    points: [&mut [T]; 2],
) {
    projection.with(ProjectAll(directions, Faces { faces, points }));
}

/// [`unproject`] for points that have passed [`Points`].
pub(super) fn unproject_points<T: Real, P: CubeProjection>(
    projection: P,
    faces: &[Face],
    points: [&[T]; 2],
    directions: [&mut [T]; 3],
) {
    projection.with(UnprojectAll(Faces { faces, points }, directions));
}

/// Projects vectors of any length to faces and their coordinates x and y in [−1, 1], with the bits of
/// [`CubeProjection::project`].
///
/// # Errors
/// [`InvalidBatch`] if slices have unequal lengths, or [`Direction::new`] refuses an element. Nothing is
/// written then.
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

/// Converts faces and their coordinates x and y in [−1, 1] to unit vectors, with the bits of
/// [`CubeProjection::unproject`].
///
/// # Errors
/// [`InvalidBatch`] if slices have unequal lengths, or [`FacePoint::new`] refuses an element. Nothing is
/// written then.
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
    // A point is accepted without a change or refused: `work` is called once, with all of them.
    admit(&Points, points, &[faces.len(), x, y, z], |length, points| {
        unproject_points(projection, faces, points, front(&mut directions, length));
    })
}
