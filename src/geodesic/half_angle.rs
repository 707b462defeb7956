use core::f64::consts::PI;

use crate::Real;
use crate::math::{DoubleWord, choose, grown, grown_square, min, sin_cos_eighth};

/// Half of an angle, at most 90° in size, by the sine of what lies between it and the nearest of 0°, 90°.
///
/// The squares of sine and cosine take that sine alone, and their errors are those of squares of both.
#[derive(Clone, Copy)]
pub(super) struct HalfAngle<T> {
    sign: T,
    /// Negative beyond 45° of the half.
    side: T,
    sin: T,
    cos: T,
    /// What sine and cosine are turned by, in radians.
    rest: T,
}

impl<T: Real> HalfAngle<T> {
    /// Half of a difference in degrees, at most 180 in size. Its squares leave out what the difference lost: a
    /// rounding of an arc that is not small.
    #[inline(always)]
    pub fn of_difference(degrees: DoubleWord<T>) -> Self {
        let rest = degrees.low * T::of(PI / 360.0);
        Self {
            rest,
            ..Self::of(degrees.high, T::ZERO)
        }
    }

    /// Half of a sum in degrees, at most 180 in size: near a pole what it lost counts.
    #[inline(always)]
    pub fn of_sum(degrees: DoubleWord<T>) -> Self {
        Self::of(degrees.high, degrees.low)
    }

    #[inline(always)]
    fn of(degrees: T, lost: T) -> Self {
        let (x, sign) = (degrees.abs(), T::ONE.copysign(degrees + T::ZERO));
        let turned = min(x, (T::of(180.0) - x) - sign * lost);
        let (sin, cos) = sin_cos_eighth(turned * T::of(PI / 360.0));
        let (side, rest) = (T::of(90.0) - x, T::ZERO);
        Self {
            sign,
            side,
            sin,
            cos,
            rest,
        }
    }

    #[inline(always)]
    pub fn sin_cos(self) -> (T, T) {
        let steep = self.side < T::ZERO;
        let sin = choose(steep, self.cos, self.sin) * self.sign;
        let cos = choose(steep, self.sin, self.cos);
        (sin + cos * self.rest, cos - sin * self.rest)
    }

    /// The squares of sine and cosine.
    #[inline(always)]
    pub fn squares(self) -> (T, T) {
        self.sorted(self.sin * self.sin, T::of(0.5))
    }

    /// The same, as those of numbers [`grown`].
    #[inline(always)]
    pub fn grown_squares(self) -> (T, T) {
        let sin = grown(self.sin);
        self.sorted(sin * sin, grown_square(T::of(0.5)))
    }

    /// A square and what it lacks of another, `half` of which is given, in the order of sine and cosine: by
    /// signs, which no compiler turns into a branch.
    #[inline(always)]
    fn sorted(self, square: T, half: T) -> (T, T) {
        let (square, turn) = (square.copysign(self.side), half.copysign(self.side));
        ((half - turn) + square, (half + turn) - square)
    }
}
