use super::{Intersections, Segment, Spot, apart};
use crate::Real;
use crate::math::{max, min};

impl<T: Real> Intersections<T> {
    /// Where two segments intersect: the intersection closest to both middles, or the one from a corner of
    /// the rectangle of displacements, if the former leaves room for another (the paper's section 6).
    pub(super) fn segment_spot(&self, one: &Segment<T>, other: &Segment<T>) -> Option<Spot<T>> {
        let lengths = [one.length(), other.length()];
        let half = T::of(0.5);
        let middle = lengths.map(|length| length * half);
        let spot = self
            .closest_spot(one.line(), other.line(), middle)
            .settled_between(lengths);
        if let Some(met) = self.on_both(spot, lengths) {
            return Some(met);
        }
        let [x, y] = lengths;
        if apart(middle, [T::ZERO; 2]) < apart(middle, spot.at) {
            return None;
        }
        let corners = [[T::ZERO, T::ZERO], [T::ZERO, y], [x, T::ZERO], [x, y]];
        let far = corners
            .into_iter()
            .filter(|&corner| apart(spot.at, corner) >= self.apart + self.apart);
        far.map(|corner| self.near(one.line(), other.line(), corner).settled(corner))
            .find_map(|spot| self.on_both(spot, lengths))
    }

    /// The point on both segments, if it is: an end that lies on the other segment but for rounding is on it.
    fn on_both(&self, spot: Spot<T>, lengths: [T; 2]) -> Option<Spot<T>> {
        let [x, y] = spot.at;
        let [length1, length2] = lengths;
        let slack = T::EPSILON * T::of(4.0) * (self.radius + length1 + length2);
        let clamped = |x: T, length: T| min(max(x, T::ZERO), length);
        let (sin, cos) = spot.angle;
        let on = |x: T, length: T, y: T, other: T| {
            let end = clamped(x, length);
            // The foot of that end on the other segment.
            let foot = y + (end - x) * cos;
            let near = (end - x).abs() * sin.abs() <= slack && foot >= -slack && foot <= other + slack;
            near.then(|| (end, clamped(foot, other)))
        };
        let at = on(x, length1, y, length2)
            .map(|(x, y)| [x, y])
            .or_else(|| on(y, length2, x, length1).map(|(y, x)| [x, y]))?;
        Some(Spot { at, ..spot })
    }
}
