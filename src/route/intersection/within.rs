use core::iter::FusedIterator;

use super::{Intersection, Intersections, Spot, apart, moved};
use crate::Real;
use crate::geodesic::Line;

/// The intersections of two lines within a distance, from [`Intersections::within`].
///
/// The square of the displacements that are near enough is divided into squares so small that each holds one
/// intersection at most, and that from its middle the steps lead to it. They are visited from the inside to
/// the outside, ring by ring: each intersection of a ring is farther than all of the rings before; inside a
/// ring there is no order. [`most`](Self::most) tells how many there can be: about as many as (d/20 000 km)²
/// on the Earth, of a distance d.
///
/// Lines that coincide have a stretch of intersections: of each stretch the iterator gives the point halfway
/// between the starts. For a line and itself, that is both starts, and places where it crosses itself.
///
/// ```
/// use terrella::geodesic::Karney;
/// use terrella::route::Intersections;
/// use terrella::{Ellipsoid, LatLon};
///
/// let earth = Karney::new(Ellipsoid::WGS84)?;
/// let one = earth.line(LatLon::new(50.0_f64, 4.0)?, 147.7)?;
/// let other = earth.line(LatLon::new(0.0, 0.0)?, 90.0)?;
/// let all = Intersections::new(Ellipsoid::WGS84)?.within(&one, &other, 40_000e3)?;
/// assert_eq!(all.most(), 9);
/// let found: Vec<_> = all.map(|met| (met.displacement1 / 1e3).round()).collect();
/// assert_eq!(found, [6058.0, -33942.0, -13942.0, -13942.0]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct IntersectionsWithin<T> {
    method: Intersections<T>,
    lines: [Line<T>; 2],
    distance: T,
    origin: [T; 2],
    /// Half of a square's diagonal.
    half: T,
    /// Rings about the inner square.
    rings: i32,
    /// The next square.
    next: Option<Square>,
}

/// A square by its number in both diagonal directions.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Square {
    i: i32,
    j: i32,
}

impl Square {
    fn ring(self) -> i32 {
        self.i.abs().max(self.j.abs())
    }

    /// The next one of its ring, or the first of the next ring.
    fn after(self) -> Self {
        let Self { i, j } = self;
        let ring = self.ring();
        if j < ring {
            // Inside, only both ends of a row belong to the ring.
            let j = if i.abs() == ring { j + 1 } else { ring };
            Self { i, j }
        } else if i < ring {
            Self { i: i + 1, j: -ring }
        } else {
            Self {
                i: -(ring + 1),
                j: -(ring + 1),
            }
        }
    }

    fn before(self, other: Self) -> bool {
        (self.ring(), self.i, self.j) < (other.ring(), other.i, other.j)
    }
}

impl<T: Real> IntersectionsWithin<T> {
    pub(super) fn new(method: Intersections<T>, lines: [Line<T>; 2], distance: T, origin: [T; 2]) -> Self {
        // Rings of two squares each way, so that one is in the middle.
        let reach = distance + method.margin;
        let exact = reach / method.capture;
        let rings = ((exact + T::ONE) * T::of(0.5)).floor();
        let half = reach / odd(rings);
        Self {
            method,
            lines,
            distance,
            origin,
            half,
            rings,
            next: Some(Square { i: 0, j: 0 }),
        }
    }

    /// Returns the largest number of intersections that there can be.
    #[must_use]
    pub fn most(&self) -> u64 {
        let side = u64::from(self.rings.unsigned_abs()) * 2 + 1;
        side * side
    }

    fn middle(&self, Square { i, j }: Square) -> [T; 2] {
        let by = |k: i32| self.half * whole(k);
        moved(self.origin, [by(i + j), by(i - j)])
    }

    /// The intersection that belongs to a square, and perhaps to a neighbour too: it may be outside by a part
    /// of the margin.
    fn of(&self, square: Square) -> Option<Spot<T>> {
        let [one, other] = &self.lines;
        let middle = self.middle(square);
        let spot = self.method.near(one, other, middle).settled(self.origin);
        let inside = apart(spot.at, middle) <= self.half + self.slack();
        (inside && apart(spot.at, self.origin) <= self.distance).then_some(spot)
    }

    fn slack(&self) -> T {
        self.method.margin * T::of(0.25)
    }

    /// Whether an earlier neighbour has the same.
    fn had(&self, square: Square, spot: Spot<T>) -> bool {
        let sides = [-1, 0, 1];
        sides
            .into_iter()
            .flat_map(|di| sides.map(|dj| (di, dj)))
            .any(|(di, dj)| {
                let neighbour = Square {
                    i: square.i + di,
                    j: square.j + dj,
                };
                let slack = self.slack();
                neighbour.before(square)
                    && apart(spot.at, self.middle(neighbour)) <= self.half + (slack + slack)
                    && self
                        .of(neighbour)
                        .is_some_and(|other| apart(other.at, spot.at) <= self.method.margin)
            })
    }
}

/// A small integer.
fn whole<T: Real>(k: i32) -> T {
    let size = T::whole(k.unsigned_abs().into());
    if k < 0 { -size } else { size }
}

fn odd<T: Real>(rings: i32) -> T {
    let rings: T = whole(rings);
    rings + rings + T::ONE
}

impl<T: Real> Iterator for IntersectionsWithin<T> {
    type Item = Intersection<T>;

    fn next(&mut self) -> Option<Intersection<T>> {
        loop {
            let square = self.next?;
            let after = square.after();
            self.next = (after.ring() <= self.rings).then_some(after);
            if let Some(spot) = self.of(square) {
                if !self.had(square, spot) {
                    let [one, _] = &self.lines;
                    return Some(self.method.answer(one, spot));
                }
            }
        }
    }

    fn size_hint(&self) -> (usize, Option<usize>) {
        let most = if self.next.is_some() { self.most() } else { 0 };
        (0, usize::try_from(most).ok())
    }
}

impl<T: Real> FusedIterator for IntersectionsWithin<T> {}
