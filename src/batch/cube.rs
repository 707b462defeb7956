//! Directions to points of the cube's faces and back, by any [`CubeProjection`].

use super::block::{BLOCK, Door, Kernel, Sink, Source, admit, front, store, sweep};
use super::InvalidBatch;
use crate::cube::{CubeProjection, Face, FacePoint, InvalidFacePoint};
use crate::math::select;
use crate::{Direction, InvalidDirection, Real};

/// Vectors, of unit length or not.
pub(super) struct Vectors;

impl<T: Real> Door<T, 3> for Vectors {
    type Error = InvalidDirection<T>;

    #[inline(always)]
    fn keeps([x, y, z]: [T; 3]) -> bool {
        Direction::is_unit(x, y, z)
    }

    fn admit([x, y, z]: [T; 3]) -> Result<[T; 3], Self::Error> {
        Direction::new(x, y, z).map(Direction::to_array)
    }
}

/// Coordinates on a face.
pub(super) struct Points;

impl<T: Real> Door<T, 2> for Points {
    type Error = InvalidFacePoint<T>;

    #[inline(always)]
    fn keeps([x, y]: [T; 2]) -> bool {
        (x.abs() <= T::ONE) & (y.abs() <= T::ONE)
    }

    fn admit([x, y]: [T; 2]) -> Result<[T; 2], Self::Error> {
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
        [numbers, super::block::block(px, x), super::block::block(py, y)]
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

/// Directions to their places on the cube.
pub fn project<T: Real, P: CubeProjection>(
    projection: P,
    directions: [&[T]; 3],
    faces: &mut [Face],
    points: [&mut [T]; 2],
) -> Result<(), InvalidBatch<InvalidDirection<T>>> {
    let [x, y] = points;
    let lengths = [faces.len(), x.len(), y.len()];
    let (mut faces, mut points) = ([faces], [x, y]);
    admit::<T, Vectors, 3>(directions, &lengths, |directions| {
        let length = directions.map(<[T]>::len)[0];
        let [faces] = front(&mut faces, length);
        let points = front(&mut points, length);
        sweep(Project(projection), directions, Faces { faces, points });
    })
}

/// Places on the cube to their directions.
pub fn unproject<T: Real, P: CubeProjection>(
    projection: P,
    faces: &[Face],
    points: [&[T]; 2],
    directions: [&mut [T]; 3],
) -> Result<(), InvalidBatch<InvalidFacePoint<T>>> {
    let [x, y, z] = directions;
    let lengths = [faces.len(), x.len(), y.len(), z.len()];
    let mut directions = Some([x, y, z]);
    admit::<T, Points, 2>(points, &lengths, |points| {
        if let Some(directions) = directions.take() {
            sweep(Unproject(projection), Faces { faces, points }, directions);
        }
    })
}
