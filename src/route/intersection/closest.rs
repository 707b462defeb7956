use super::{Intersections, Spot, apart, moved};
use crate::Real;
use crate::geodesic::Line;

impl<T: Real> Intersections<T> {
    /// The closest intersection to a point: from the point, and from four beside it, whose squares cover all
    /// places where it can be (the paper's section 4).
    pub(super) fn closest_spot(&self, one: &Line<T>, other: &Line<T>, origin: [T; 2]) -> Spot<T> {
        let half = self.half_reach;
        let none = T::ZERO;
        let mut closest = self.near(one, other, origin).settled(origin);
        let mut left = [[half, none], [-half, none], [none, half], [none, -half]].map(|by| Some(moved(origin, by)));
        let mut found = closest;
        let mut index = 0;
        loop {
            if apart(found.at, origin) < self.apart {
                return found;
            }
            if apart(found.at, origin) < apart(closest.at, origin) {
                closest = found;
            }
            // Around one that is found there is no other.
            let clear = self.apart + self.apart - half - self.margin;
            for start in &mut left {
                *start = start.filter(|&start| apart(found.at, start) >= clear);
            }
            let start = loop {
                let Some(start) = left.get_mut(index) else {
                    return closest;
                };
                index += 1;
                if let Some(start) = start.take() {
                    break start;
                }
            };
            found = self.near(one, other, start).settled(origin);
        }
    }
}
