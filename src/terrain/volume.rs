use super::vector::{along, difference, dot};
use crate::math::max;
use crate::{Ecef, Real};

/// An oriented bounding box, in metres along Earth axes: from [`Enclosure::of`](super::Enclosure::of).
#[doc(alias = "OBB")]
#[doc(alias = "OrientedBoundingBox")]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct OrientedBox<T> {
    pub(super) centre: [T; 3],
    pub(super) axes: [[T; 3]; 3],
    pub(super) half: [T; 3],
}

impl<T: Real> OrientedBox<T> {
    /// Returns the centre, in metres.
    #[must_use]
    #[inline]
    pub fn centre(&self) -> Ecef<T> {
        let [x, y, z] = self.centre;
        Ecef::within(x, y, z)
    }

    /// Returns the three axes: perpendicular unit vectors, right-handed.
    #[must_use]
    #[inline]
    pub const fn axes(&self) -> [[T; 3]; 3] {
        self.axes
    }

    /// Returns half of the extent along each axis, in metres.
    #[must_use]
    #[inline]
    pub const fn half(&self) -> [T; 3] {
        self.half
    }

    /// Returns the eight corners, in metres.
    #[must_use]
    #[inline]
    pub fn corners(&self) -> [Ecef<T>; 8] {
        let mut corner = 0;
        [self.centre; 8].map(|mut point| {
            for (bit, (axis, half)) in self.axes.into_iter().zip(self.half).enumerate() {
                let way = if corner >> bit & 1 == 0 { -half } else { half };
                point = along(point, way, axis);
            }
            corner += 1;
            let [x, y, z] = point;
            Ecef::within(x, y, z)
        })
    }

    /// Returns the bounding sphere: the sphere through the corners.
    #[must_use]
    #[inline]
    pub fn sphere(&self) -> BoundingSphere<T> {
        BoundingSphere {
            centre: self.centre(),
            radius: dot(self.half, self.half).sqrt(),
        }
    }

    /// Returns the distance from a point to the box, in metres; 0 if the point is inside.
    #[must_use]
    #[inline]
    pub fn distance(&self, point: Ecef<T>) -> T {
        let apart = difference(point.to_array(), self.centre);
        let mut outside = [T::ZERO; 3];
        for ((outside, axis), half) in outside.iter_mut().zip(self.axes).zip(self.half) {
            *outside = max(dot(apart, axis).abs() - half, T::ZERO);
        }
        dot(outside, outside).sqrt()
    }
}

/// A bounding sphere, in metres along Earth axes: from [`OrientedBox::sphere`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct BoundingSphere<T> {
    /// The centre, in metres.
    pub centre: Ecef<T>,
    /// The radius, in metres.
    pub radius: T,
}
