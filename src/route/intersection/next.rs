use super::{Intersections, Overlap, Spot, apart, moved};
use crate::Real;
use crate::geodesic::Line;

impl<T: Real> Intersections<T> {
    /// The intersection closest to the common start of two lines, other than that (the paper's section 5).
    pub(super) fn next_spot(&self, one: &Line<T>, other: &Line<T>) -> Spot<T> {
        let origin = [T::ZERO; 2];
        let reach = self.next_reach;
        let mut closest: Option<Spot<T>> = None;
        let mut keep = |spot: Spot<T>| {
            if closest.is_none_or(|closest| apart(spot.at, origin) < apart(closest.at, origin)) {
                closest = Some(spot);
            }
        };
        // The squares about these points cover the places where the next intersection can be.
        let (zero, twice) = (T::ZERO, reach + reach);
        let corners = [[-reach, -reach], [-reach, reach], [reach, -reach], [reach, reach]];
        let sides = [[-twice, zero], [zero, twice], [twice, zero], [zero, -twice]];
        let [a, b, c, d] = corners.map(Some);
        let [e, f, g, h] = sides.map(Some);
        let mut left = [a, b, c, d, e, f, g, h];
        let clear = self.apart + self.apart - reach - self.margin;
        for index in 0..left.len() {
            let Some(start) = left.get_mut(index).and_then(Option::take) else {
                continue;
            };
            let spot = self.near(one, other, start).settled(origin);
            let at_start = apart(spot.at, origin) <= self.margin;
            let mut drop = |at: [T; 2]| {
                for start in &mut left {
                    *start = start.filter(|&start| apart(at, start) >= clear);
                }
            };
            let Some(overlap) = spot.overlap else {
                if !at_start {
                    keep(spot);
                    drop(spot.at);
                }
                continue;
            };
            if at_start {
                keep(self.conjugate(one, overlap, T::ONE));
                keep(self.conjugate(one, overlap, -T::ONE));
            } else {
                keep(spot);
                drop(spot.at);
            }
            // Along the stretch.
            for side in [reach, -reach] {
                drop(moved(spot.at, [side, overlap.sign::<T>() * side]));
            }
        }
        closest.unwrap_or(Spot {
            at: origin,
            overlap: None,
            angle: (T::ZERO, T::ONE),
        })
    }

    /// Where neighbouring lines from the start meet again: Newton's method for m₁₂ = 0, with dm₁₂/ds = M₂₁.
    fn conjugate(&self, line: &Line<T>, overlap: Overlap, side: T) -> Spot<T> {
        let mut distance = side * self.apart;
        for _ in 0..T::steps(6, 4) {
            let point = line.near(distance);
            distance -= point.reduced_length / point.scale21;
        }
        Spot {
            at: [distance, overlap.sign::<T>() * distance],
            overlap: Some(overlap),
            angle: (T::ZERO, T::ONE),
        }
    }
}
