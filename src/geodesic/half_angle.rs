use core::f64::consts::{FRAC_PI_2, PI};

use crate::Real;
use crate::math::{
    DoubleWord, choose, doubled_arc, grown, grown_square, min, shrunk_root, shrunk_square, sin_cos_eighth,
};

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

/// An arc of at most a half circle, by the smaller of the squares of its half's sine and cosine: of a number
/// [`grown`], and negative if it is that of the cosine.
#[derive(Clone, Copy)]
pub(super) struct HalfArc<T>(pub T);

impl<T: Real> HalfArc<T> {
    /// From both squares, of numbers [`grown`].
    #[inline(always)]
    pub fn new(sine: T, cosine: T) -> Self {
        Self(min(sine, cosine).copysign(cosine - sine))
    }

    /// Sine and cosine of the arc.
    #[inline(always)]
    pub fn sin_cos(self) -> (T, T) {
        let (one, two) = (T::ONE, T::of(2.0));
        let square = self.0.abs();
        let small = shrunk_square(square);
        let sin = two * shrunk_root(square * (one - small));
        (sin, (one - two * small).copysign(self.0))
    }

    /// The arc, in radians: twice the arc sine of the root, or what that lacks of π.
    #[inline(always)]
    pub fn angle(self) -> T {
        let small = doubled_arc(self.0.abs());
        // Nothing, or π in two parts.
        let whole = |half: T| half - half.copysign(self.0);
        let high = whole(T::pick(FRAC_PI_2, 1.570_796_25));
        let low = whole(T::pick(6.123_233_995_736_766e-17, 7.549_79e-8));
        high + (small.copysign(self.0) + low)
    }
}
