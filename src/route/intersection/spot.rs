use super::Overlap;
use crate::Real;
use crate::math::{max, min};

/// A point of the plane of displacements.
#[derive(Clone, Copy)]
pub(super) struct Spot<T> {
    pub at: [T; 2],
    pub overlap: Option<Overlap>,
    /// Sine and cosine of the angle from the first line to the second, if known to cross.
    pub angle: (T, T),
}

/// |Δx| + |Δy|.
#[inline]
pub(super) fn apart<T: Real>([x1, y1]: [T; 2], [x2, y2]: [T; 2]) -> T {
    (x2 - x1).abs() + (y2 - y1).abs()
}

#[inline]
pub(super) fn moved<T: Real>([x, y]: [T; 2], [dx, dy]: [T; 2]) -> [T; 2] {
    [x + dx, y + dy]
}

impl Overlap {
    /// By how much the second displacement grows with the first.
    pub(super) fn sign<T: Real>(self) -> T {
        match self {
            Self::Parallel => T::ONE,
            Self::Antiparallel => -T::ONE,
        }
    }
}

impl<T: Real> Spot<T> {
    /// Where lines coincide, the point of the stretch that is closest to another: as far in x as in y.
    pub fn settled(self, [x0, y0]: [T; 2]) -> Self {
        let Some(overlap) = self.overlap else {
            return self;
        };
        let [x, y] = self.at;
        let sign = overlap.sign();
        let along = ((x0 - x) + sign * (y0 - y)) * T::of(0.5);
        self.along(sign, along)
    }

    /// Where lines coincide, the middle of what two segments have in common, or of the gap between them.
    pub fn settled_between(self, [length1, length2]: [T; 2]) -> Self {
        let Some(overlap) = self.overlap else {
            return self;
        };
        let [x, y] = self.at;
        let sign: T = overlap.sign();
        // x + along in [0, length1], y ± along in [0, length2].
        let (low1, high1) = (-x, length1 - x);
        let (low2, high2) = match overlap {
            Overlap::Parallel => (-y, length2 - y),
            Overlap::Antiparallel => (y - length2, y),
        };
        let low = max(low1, low2);
        let high = min(high1, high2);
        self.along(sign, (low + high) * T::of(0.5))
    }

    fn along(self, sign: T, metres: T) -> Self {
        let at = moved(self.at, [metres, sign * metres]);
        Self { at, ..self }
    }
}
