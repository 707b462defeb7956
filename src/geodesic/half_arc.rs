use core::f64::consts::FRAC_PI_2;

use crate::Real;
use crate::math::{doubled_arc, min, shrunk_root, shrunk_square};

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
