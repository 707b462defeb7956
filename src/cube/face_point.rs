use core::fmt;

use super::Face;
use crate::Real;

/// A point on a face of the cube: x to the right and y upward, both in [−1, 1].
///
/// ```
/// use terrella::cube::{Face, FacePoint};
/// let p = FacePoint::new(Face::Front, 0.25, -1.0)?;
/// assert_eq!((p.face(), p.x(), p.y()), (Face::Front, 0.25, -1.0));
/// # Ok::<(), terrella::cube::InvalidFacePoint<f64>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct FacePoint<T = f64> {
    face: Face,
    x: T,
    y: T,
}

impl<T: Real> FacePoint<T> {
    /// Creates the point of a face with coordinates in [−1, 1].
    ///
    /// # Errors
    /// [`InvalidFacePoint`] if a coordinate is outside [−1, 1] or NaN.
    #[inline]
    pub fn new(face: Face, x: T, y: T) -> Result<Self, InvalidFacePoint<T>> {
        if x.abs() <= T::ONE && y.abs() <= T::ONE {
            Ok(Self { face, x, y })
        } else {
            Err(InvalidFacePoint { x, y })
        }
    }

    /// Creates a point with coordinates known to be in range.
    #[inline(always)]
    pub(crate) const fn within(face: Face, x: T, y: T) -> Self {
        Self { face, x, y }
    }

    /// Returns the face.
    #[must_use]
    #[inline(always)]
    pub const fn face(self) -> Face {
        self.face
    }

    /// Returns the coordinate to the right, in [−1, 1].
    #[must_use]
    #[inline(always)]
    pub const fn x(self) -> T {
        self.x
    }

    /// Returns the coordinate upward, in [−1, 1].
    #[must_use]
    #[inline(always)]
    pub const fn y(self) -> T {
        self.y
    }
}

/// The error for coordinates of which at least one is outside [−1, 1] or NaN.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct InvalidFacePoint<T> {
    /// The coordinate to the right.
    pub x: T,
    /// The coordinate upward.
    pub y: T,
}

impl<T: fmt::Display> fmt::Display for FacePoint<T> {
    /// Writes the face and the coordinates, each with the formatter's options: `front (0.25, -1)`.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.face.name())?;
        f.write_str(" (")?;
        self.x.fmt(f)?;
        f.write_str(", ")?;
        self.y.fmt(f)?;
        f.write_str(")")
    }
}

impl From<FacePoint<f32>> for FacePoint {
    /// The same face and coordinates: every `f32` is an `f64`.
    fn from(point: FacePoint<f32>) -> Self {
        Self::within(point.face, point.x.into(), point.y.into())
    }
}

impl FacePoint {
    /// Returns the point with coordinates rounded to the nearest `f32`.
    #[must_use]
    pub const fn to_f32(self) -> FacePoint<f32> {
        FacePoint::within(self.face, self.x as f32, self.y as f32)
    }
}

impl<T: fmt::Debug> fmt::Display for InvalidFacePoint<T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "({:?}, {:?}) is not in [-1, 1]²", self.x, self.y)
    }
}

impl<T: fmt::Debug> core::error::Error for InvalidFacePoint<T> {}
