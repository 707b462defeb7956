use core::fmt;

use super::Face;
use crate::Real;

/// A point of a face: x to the right and y up, both in [−1, 1].
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
pub struct FacePoint<T> {
    face: Face,
    x: T,
    y: T,
}

impl<T: Real> FacePoint<T> {
    /// From a face and coordinates.
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

    /// For coordinates known to be in range.
    #[inline(always)]
    pub(crate) const fn within(face: Face, x: T, y: T) -> Self {
        Self { face, x, y }
    }

    /// The face.
    #[must_use]
    #[inline(always)]
    pub fn face(self) -> Face {
        self.face
    }

    /// The coordinate to the right, in [−1, 1].
    #[must_use]
    #[inline(always)]
    pub fn x(self) -> T {
        self.x
    }

    /// The coordinate upward, in [−1, 1].
    #[must_use]
    #[inline(always)]
    pub fn y(self) -> T {
        self.y
    }
}

/// A coordinate that is not on the face.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct InvalidFacePoint<T> {
    /// The coordinate to the right.
    pub x: T,
    /// The coordinate upward.
    pub y: T,
}

impl<T: fmt::Debug> fmt::Display for InvalidFacePoint<T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "({:?}, {:?}) is not in [-1, 1]²", self.x, self.y)
    }
}

impl<T: fmt::Debug> core::error::Error for InvalidFacePoint<T> {}
