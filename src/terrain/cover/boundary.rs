//! Where the edges of a tile run: inside a region, outside it, or both; and how far a function goes along
//! them.
//!
//! An edge is divided at halves, and each part has five places at equal steps of x or y. Between two of them
//! a function is taken to stay within δ of the straight line through its values there, where δ is the largest
//! of the three second differences of the five values. This was found by a search, not by formulas: over
//! 60 000 parts of each projection, three levels of them coarse, the distances from parallels, meridians and
//! squared distances from places stayed within 0.7 δ (`cobe-exact`, with 0.5 δ in all others); a parabola
//! stays within δ/8. Only the square of a distance from a place near the antipode may rise by more, up to
//! 1.3 δ. `tests/terrain/cover.rs` repeats it.

use super::{Relation, Tile};
use crate::cube::{CubeMap, CubeProjection};
use crate::math::{max, min};
use crate::{Direction, LatLon, Real};

/// A region as a function that is 0 or more inside it, made of N smooth ones.
pub(super) trait Margin<T: Real, const N: usize> {
    /// The smooth functions at a place on the sphere.
    fn numbers(&self, place: Direction<T>) -> [T; N];

    /// The function made of them.
    fn depth(&self, numbers: [T; N]) -> T;

    /// Whether there may be a place inside between two, where each function is within its `bend` of a straight
    /// line, plus the rounding.
    fn may_enter(&self, ends: [[T; N]; 2], bends: [T; N]) -> bool;

    /// The same of a place outside.
    fn may_leave(&self, ends: [[T; N]; 2], bends: [T; N]) -> bool;

    /// How far outside a place still counts as inside, for the rounding of the numbers.
    fn rounding(&self) -> T;
}

/// Whether straight lines from one number to another are 0 or more at one common place.
pub(super) fn are_common<T: Real>(lines: impl IntoIterator<Item = [T; 2]>) -> bool {
    let (mut first, mut last) = (T::ZERO, T::ONE);
    for [from, to] in lines {
        let zero = from / (from - to);
        if from < T::ZERO {
            if to < T::ZERO {
                return false;
            }
            first = max(zero, first);
        } else if to < T::ZERO {
            last = min(zero, last);
        }
    }
    let apart = first > last;
    !apart
}

/// How many parts of a tile's edges are looked at before the answer is given up. Only edges that run along
/// the edge of a region, between once and some thousand times its rounding away, need more than some dozens.
const MOST: u32 = 1000;
/// Edges are divided at least into parts as long as the tiles of this level.
const COARSEST: u8 = 3;

/// A part of one of the four edges of a tile: of 2^depth parts, the one with this index.
#[derive(Clone, Copy)]
struct Part {
    edge: u32,
    depth: u8,
    index: u32,
}

impl Part {
    /// The part at the start of an edge.
    fn first(edge: u32, tile: Tile) -> Self {
        Self {
            edge,
            depth: COARSEST.saturating_sub(tile.level()),
            index: 0,
        }
    }

    /// Whether it can be halved: beyond, coordinates are no different numbers.
    fn is_divisible(self, tile: Tile) -> bool {
        self.depth + tile.level() < 40 && self.depth < 28
    }

    fn first_half(self) -> Self {
        Self {
            depth: self.depth + 1,
            index: 2 * self.index,
            ..self
        }
    }

    /// The part after this one, on this edge or the next.
    fn next(self, tile: Tile) -> Option<Self> {
        let first = Self::first(self.edge, tile);
        let mut next = Self {
            index: self.index + 1,
            ..self
        };
        while next.depth > first.depth && next.index % 2 == 0 {
            next.depth -= 1;
            next.index /= 2;
        }
        if next.depth > first.depth || next.index >> first.depth == 0 {
            return Some(next);
        }
        (self.edge < 3).then(|| Self::first(self.edge + 1, tile))
    }

    /// The directions of its five places.
    #[inline(always)]
    fn places<T: Real, P: CubeProjection>(self, tile: Tile, projection: P) -> [Direction<T>; 5] {
        let count = 4_u32 << self.depth;
        [0, 1, 2, 3, 4].map(|m| {
            let along = 4 * self.index + m;
            let node = match self.edge {
                0 => [along, 0],
                1 => [count, along],
                2 => [along, count],
                _ => [0, along],
            };
            projection.unproject(tile.node(node, count))
        })
    }
}

/// δ of five values.
#[inline(always)]
fn bend<T: Real>([a, b, c, d, e]: [T; 5]) -> T {
    let second = |a: T, b: T, c: T| ((c - b) - (b - a)).abs();
    max(second(a, b, c), max(second(b, c, d), second(c, d, e)))
}

/// What is found on the edges of a tile.
#[derive(Clone, Copy)]
struct Found {
    /// A place in the region.
    inside: bool,
    /// A place outside it.
    outside: bool,
}

impl Found {
    /// NaN is inside and outside.
    fn place<T: Real>(&mut self, depth: T, rounding: T) {
        let (outside, inside) = (depth < -rounding, depth >= -rounding);
        self.inside |= !outside;
        self.outside |= !inside;
    }

    fn is_both(self) -> bool {
        self.inside & self.outside
    }
}

/// What is found on the edges of a tile, exact but for twice the rounding.
fn search<T: Real, P: CubeProjection, const N: usize>(projection: P, tile: Tile, margin: &impl Margin<T, N>) -> Found {
    let rounding = margin.rounding();
    let mut found = Found {
        inside: false,
        outside: false,
    };
    for corner in tile.corners() {
        found.place(margin.depth(margin.numbers(projection.unproject(corner))), rounding);
    }
    let mut part = Some(Part::first(0, tile));
    for _ in 0..MOST {
        let Some(this) = part else {
            return found;
        };
        if found.is_both() {
            return found;
        }
        let numbers = this.places(tile, projection).map(|place| margin.numbers(place));
        for numbers in numbers {
            found.place(margin.depth(numbers), rounding);
        }
        let [a, b, c, d, e] = numbers;
        // Of each function: the bend, from its five values.
        let mut bends = [T::ZERO; N];
        for (bend, ((((a, b), c), d), e)) in bends.iter_mut().zip(a.iter().zip(b).zip(c).zip(d).zip(e)) {
            *bend = self::bend([*a, b, c, d, e]);
        }
        let sharpest = bends.into_iter().fold(T::ZERO, max);
        let mut open = false;
        let mut possible = false;
        for ends in [[a, b], [b, c], [c, d], [d, e]] {
            possible |= margin.may_enter(ends, bends);
            open |= margin.may_leave(ends, bends);
        }
        let undecided = (possible & !found.inside) | (open & !found.outside);
        part = if undecided && sharpest > rounding && this.is_divisible(tile) {
            Some(this.first_half())
        } else {
            found.inside |= possible;
            found.outside |= open;
            this.next(tile)
        };
    }
    Found {
        inside: true,
        outside: true,
    }
}

/// How a tile lies to a region, from its edges; and where they do not tell, from a place in each part of the
/// region and a place in each part of what is outside.
pub(super) fn relation<T: Real, P: CubeProjection, const N: usize>(
    map: &CubeMap<T, P>,
    tile: Tile,
    margin: &impl Margin<T, N>,
    [inside, outside]: [&[LatLon<T>]; 2],
) -> Relation {
    let found = search(map.projection(), tile, margin);
    let holds = |place: LatLon<T>| Tile::containing(map.project(place), tile.level()) == Ok(tile);
    let is_outside = |place: LatLon<T>| {
        let numbers = margin.numbers(map.shifted().to_direction(place));
        let inside = margin.depth(numbers) >= -margin.rounding();
        !inside
    };
    match found {
        Found {
            inside: true,
            outside: true,
        } => Relation::Meets,
        Found { inside: true, .. } => {
            if outside.iter().any(|&place| holds(place) && is_outside(place)) {
                Relation::Meets
            } else {
                Relation::Inside
            }
        }
        Found { .. } => {
            if inside.iter().any(|&place| holds(place)) {
                Relation::Meets
            } else {
                Relation::Apart
            }
        }
    }
}

/// The least and the greatest value of a function along the edges of a tile; NaN stands for a place where it
/// has no value, such as the longitude of a pole. They are at most `rounding` inside the true ones.
pub(super) fn range<T: Real, P: CubeProjection>(
    projection: P,
    tile: Tile,
    function: impl Fn(Direction<T>) -> T,
    rounding: T,
) -> Option<[T; 2]> {
    let values = |part: Part| {
        let [a, b, c, d, e] = part.places(tile, projection).map(&function);
        let known = |value: T, other: T| if value.is_finite() { value } else { other };
        let (b, d) = (known(b, a), known(d, e));
        let c = known(c, b);
        [known(a, b), known(b, c), c, known(d, c), known(e, d)]
    };
    let (mut low, mut high) = (T::of(f64::INFINITY), T::of(f64::NEG_INFINITY));
    let mut part = Some(Part::first(0, tile));
    while let Some(this) = part {
        for value in values(this) {
            (low, high) = (min(value, low), max(value, high));
        }
        part = if this.index + 1 < 1 << this.depth {
            Some(Part {
                index: this.index + 1,
                ..this
            })
        } else {
            (this.edge < 3).then(|| Part::first(this.edge + 1, tile))
        };
    }
    part = Some(Part::first(0, tile));
    for _ in 0..MOST {
        let Some(this) = part else {
            return Some([low, high]);
        };
        let values = values(this);
        let bend = bend(values);
        let (mut least, mut most) = (T::of(f64::INFINITY), T::of(f64::NEG_INFINITY));
        for value in values {
            (least, most) = (min(value, least), max(value, most));
        }
        (low, high) = (min(least, low), max(most, high));
        let beyond = (least - bend < low - rounding) | (most + bend > high + rounding);
        part = if beyond && this.is_divisible(tile) {
            Some(this.first_half())
        } else {
            this.next(tile)
        };
    }
    None
}
