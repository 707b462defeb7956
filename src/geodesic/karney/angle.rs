use crate::Real;
use crate::geodesic::degrees::hypot;
use crate::math::{atan2, atan2_degrees, select, sin_cos, sin_cos_degrees};

/// An angle by its sine and cosine.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Angle<T> {
    pub sin: T,
    pub cos: T,
}

impl<T: Real> Angle<T> {
    /// The angle of the point (cos, sin), of any length; 0 of the origin, where places are so near that products underflow.
    #[inline]
    pub fn of(sin: T, cos: T) -> Self {
        let length = hypot(sin, cos);
        let origin = length == T::ZERO;
        let divisor = select(origin, T::ONE, length);
        Self {
            sin: sin / divisor,
            cos: select(origin, T::ONE, cos / divisor),
        }
    }

    pub fn degrees(degrees: T) -> Self {
        let (sin, cos) = sin_cos_degrees(degrees);
        Self { sin, cos }
    }

    pub fn radians(radians: T) -> Self {
        let (sin, cos) = sin_cos(radians);
        Self { sin, cos }
    }

    pub fn to_radians(self) -> T {
        atan2(self.sin, self.cos)
    }

    pub fn to_degrees(self) -> T {
        atan2_degrees(self.sin, self.cos)
    }

    /// The sum of two angles.
    pub fn plus(self, other: Self) -> Self {
        Self {
            sin: self.sin * other.cos + self.cos * other.sin,
            cos: self.cos * other.cos - self.sin * other.sin,
        }
    }

    /// The difference of two angles.
    pub fn minus(self, other: Self) -> Self {
        self.plus(other.opposite())
    }

    /// The angle of opposite sign.
    pub fn opposite(self) -> Self {
        Self {
            sin: -self.sin,
            cos: self.cos,
        }
    }
}
