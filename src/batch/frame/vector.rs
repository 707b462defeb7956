//! Vectors that have no place, such as velocities.

use core::convert::Infallible;

use super::Axes;
use crate::batch::InvalidBatch;
use crate::batch::engine::solve_by;
use crate::simd::{Kernel, sweep};
use crate::{Enu, LocalFrame, Real};

/// Vectors from Earth axes to those of a frame.
#[derive(Clone, Copy)]
struct VectorSeen<'a, T>(&'a LocalFrame<T>);

impl<T: Real> Kernel<[T; 3]> for VectorSeen<'_, T> {
    type Output = [T; 3];

    #[inline(always)]
    fn apply(&self, vector: [T; 3]) -> [T; 3] {
        self.0.vector_to_enu(vector).row()
    }
}

/// Vectors from the axes of a frame to Earth axes.
#[derive(Clone, Copy)]
struct ToVector<'a, T>(&'a LocalFrame<T>);

impl<T: Real> Kernel<[T; 3]> for ToVector<'_, T> {
    type Output = [T; 3];

    #[inline(always)]
    fn apply(&self, row: [T; 3]) -> [T; 3] {
        self.0.vector_from_enu(Enu::of(row))
    }
}

/// Rotates vectors, such as velocities, from Earth axes to those of the frame, with the bits of
/// [`LocalFrame::vector_to_enu`].
///
/// # Errors
/// [`InvalidBatch::Lengths`] if slices have unequal lengths. No element is refused.
///
/// ```
/// use terrella::{Ellipsoid, LatLon, LocalFrame, batch::frame};
/// let about = LocalFrame::new(Ellipsoid::WGS84, LatLon::new(0.0, 90.0)?.into());
/// let (mut east, mut north, mut up) = ([0.0], [0.0], [0.0]);
/// frame::vector_to_enu(&about, [&[-1.0], &[3.0], &[2.0]], [&mut east, &mut north, &mut up])?;
/// assert_eq!((east, north, up), ([1.0], [2.0], [3.0]));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn vector_to_enu<T: Real>(
    frame: &LocalFrame<T>,
    vectors: [&[T]; 3],
    enu: [&mut [T]; 3],
) -> Result<(), InvalidBatch<Infallible>> {
    solve_by(
        vectors,
        enu,
        |row| Ok(VectorSeen(frame).apply(row)),
        |vectors, enu, _| sweep(VectorSeen(frame), vectors, enu),
    )
}

/// Rotates vectors from the axes of the frame to Earth axes, with the bits of
/// [`LocalFrame::vector_from_enu`]: the inverse of [`vector_to_enu`].
///
/// # Errors
/// [`InvalidBatch::Lengths`] if slices have unequal lengths. No element is refused.
pub fn vector_from_enu<T: Real>(
    frame: &LocalFrame<T>,
    enu: [&[T]; 3],
    vectors: [&mut [T]; 3],
) -> Result<(), InvalidBatch<Infallible>> {
    solve_by(
        enu,
        vectors,
        |row| Ok(ToVector(frame).apply(row)),
        |enu, vectors, _| sweep(ToVector(frame), enu, vectors),
    )
}
