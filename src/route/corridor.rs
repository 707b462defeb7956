use super::arc::{InvalidArc, chords, reached};
use crate::geodesic::{Karney, wrapped};
use crate::math::{max, min, sin_cos_degrees};
use crate::{LatLon, Real};

/// What is within a distance of a line of geodesics: a corridor with round ends, as polygons.
///
/// [`Corridor::leg`] gives the corners about one leg, [`Corridor::outline`] those about the whole line; both
/// run counter-clockwise, and nothing is allocated. Edges between the corners are geodesics: they are within
/// the tolerance of the true boundary, along arcs on its inner side, beside legs on its outer side. Long legs
/// have more corners beside them, as a line at the same distance from a geodesic is no geodesic.
///
/// An outline has round joins on the outer side of a turn, and one corner on the inner side. **It overlaps
/// itself** where the corridor does: where the line comes back to itself, and where a leg is too short for
/// the inner corner of a turn by θ: shorter than w tan(θ/2), w the half width. There it runs round some
/// places twice, which a [`Fence`](super::Fence) has outside. The corridors of single legs never overlap
/// themselves: a place is within the corridor if it is inside that of one leg.
///
/// The inner corner of a turn is found as in the plane: it is wrong by about w³/R², for a half width of 10 km
/// by 3 cm.
///
/// ```
/// use terrella::geodesic::Karney;
/// use terrella::route::{Corridor, Fence, Side};
/// use terrella::{Ellipsoid, LatLon};
/// let earth = Karney::new(Ellipsoid::WGS84)?;
/// let line = [LatLon::new(60.0_f64, 24.0)?, LatLon::new(60.2, 25.0)?, LatLon::new(59.9, 25.5)?];
/// let corridor = Corridor::new(&earth, &line, 2_000.0, 10.0)?;
/// let outline: Vec<_> = corridor.outline().collect();
/// let rings = [outline.as_slice()];
/// let fence = Fence::new(&earth, &rings);
/// assert_eq!(fence.side(LatLon::new(60.11, 24.5)?), Side::Inside);
/// assert_eq!(fence.side(LatLon::new(60.13, 24.5)?), Side::Outside);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[doc(alias = "buffer")]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Corridor<'a, T> {
    karney: &'a Karney<T>,
    line: &'a [LatLon<T>],
    half_width: T,
    tolerance: T,
}

/// The corners of a [`Corridor`] in order.
#[derive(Clone, Copy, Debug)]
pub struct Outline<'a, T> {
    corridor: Corridor<'a, T>,
    /// There and back: each leg twice.
    legs: usize,
    /// The number of the leg that is gone along.
    number: usize,
    leg: Option<Leg<T>>,
    stage: Stage<T>,
}

/// A leg in one direction, with the corridor's boundary on its right.
#[derive(Clone, Copy, Debug)]
struct Leg<T> {
    from: LatLon<T>,
    to: LatLon<T>,
    azimuth1: T,
    azimuth2: T,
    length: T,
}

#[derive(Clone, Copy, Debug)]
enum Stage<T> {
    /// At one of the corners beside a leg: from one distance to another in so many parts.
    Beside {
        start: T,
        end: T,
        corner: usize,
        parts: usize,
    },
    /// At one of the corners round a place: by a turn to the left, in so many parts.
    Round {
        turn: T,
        corner: usize,
        parts: usize,
    },
    Done,
}

impl<'a, T: Real> Corridor<'a, T> {
    /// Makes the corridor of a line of geodesics: all places within half a width in metres of it.
    ///
    /// # Errors
    /// [`InvalidArc::Radius`] unless 0 < half width ≤ b/10 (635 km); [`InvalidArc::Tolerance`] unless it is
    /// positive and finite, and a million corners are enough for a circle.
    pub fn new(
        karney: &'a Karney<T>,
        line: &'a [LatLon<T>],
        half_width: T,
        tolerance: T,
    ) -> Result<Self, InvalidArc<T>> {
        let within = half_width > T::ZERO && half_width <= T::of(0.1) * karney.ellipsoid().b();
        if !within {
            return Err(InvalidArc::Radius(half_width));
        }
        chords(half_width, T::of(360.0), tolerance)?;
        Ok(Self {
            karney,
            line,
            half_width,
            tolerance,
        })
    }

    /// Returns the corners of the corridor about the whole line; none if it has no place, a circle if all its
    /// places are the same.
    #[must_use]
    pub fn outline(&self) -> Outline<'a, T> {
        Outline::new(*self)
    }

    /// Returns the corners of the corridor about one leg of the line, from 0; none if there is no such leg.
    #[must_use]
    pub fn leg(&self, index: usize) -> Outline<'a, T> {
        let line = self
            .line
            .get(index..)
            .and_then(|rest| rest.get(..2))
            .unwrap_or_default();
        Outline::new(Self { line, ..*self })
    }

    /// The leg with a number: there, and then back. None if it has no length.
    fn directed(&self, number: usize) -> Option<Leg<T>> {
        let last = self.line.len().checked_sub(1)?;
        let place = |index: usize| self.line.get(index).copied();
        let (from, to) = if number < last {
            (place(number)?, place(number + 1)?)
        } else {
            let back = (2 * last).checked_sub(number)?;
            (place(back)?, place(back.checked_sub(1)?)?)
        };
        let way = self.karney.way(from, to);
        (way.distance > T::ZERO).then_some(Leg {
            from,
            to,
            azimuth1: way.azimuth1,
            azimuth2: way.azimuth2,
            length: way.distance,
        })
    }

    fn parts(&self, turn: T) -> usize {
        chords(self.half_width, turn, self.tolerance).unwrap_or(1)
    }

    /// A line beside a geodesic has the curvature w/R², so a part of length s is s² w/(8R²) beside its chord.
    fn parts_beside(&self, length: T) -> usize {
        let parts = length / self.karney.ellipsoid().b() * (self.half_width / (T::of(7.8) * self.tolerance)).sqrt();
        usize::try_from(min(parts, T::of(1e6)).floor()).unwrap_or(0) + 1
    }

    /// To the right of an azimuth at a place.
    fn right(&self, place: LatLon<T>, azimuth: T) -> LatLon<T> {
        reached(self.karney, place, azimuth + T::of(90.0), self.half_width).position
    }

    /// w tan(θ/2): how far from a turn to the right its inner corner is.
    fn cut(&self, turn: T) -> T {
        let (sin, cos) = sin_cos_degrees(max(turn, T::ZERO));
        self.half_width * sin / max(T::ONE + cos, T::EPSILON)
    }
}

impl<'a, T: Real> Outline<'a, T> {
    fn new(corridor: Corridor<'a, T>) -> Self {
        let legs = 2 * corridor.line.len().saturating_sub(1);
        let mut outline = Self {
            corridor,
            legs,
            number: 0,
            leg: None,
            stage: Stage::Done,
        };
        let first = (0..legs).find_map(|number| corridor.directed(number).map(|leg| (number, leg)));
        if let Some((number, leg)) = first {
            outline.go_along(number, leg, T::ZERO, 0);
        } else if !corridor.line.is_empty() {
            let turn = T::of(-360.0);
            let parts = corridor.parts(turn).max(3);
            outline.stage = Stage::Round { turn, corner: 0, parts };
        }
        outline
    }

    /// The next leg that has a length.
    fn following(&self, number: usize) -> Option<(usize, Leg<T>)> {
        (number + 1..self.legs).find_map(|next| self.corridor.directed(next).map(|leg| (next, leg)))
    }

    /// The turn from a leg to the next, and that leg: to the left round the ends.
    fn turn(&self, number: usize, leg: &Leg<T>) -> (T, Option<(usize, Leg<T>)>) {
        let next = self.following(number);
        let middle = self.legs / 2;
        let turn = match next {
            Some((next, onward)) if (number < middle) == (next < middle) => wrapped(onward.azimuth1 - leg.azimuth2),
            _ => T::of(-180.0),
        };
        // Back the same way is a turn to the left.
        let turn = if turn == T::of(180.0) { -turn } else { turn };
        (turn, next)
    }

    /// Starts along a leg, some metres from its start, at its first corner or the next.
    fn go_along(&mut self, number: usize, leg: Leg<T>, start: T, corner: usize) {
        let (turn, _) = self.turn(number, &leg);
        let half = leg.length * T::of(0.5);
        let (start, end) = (min(start, half), leg.length - min(self.corridor.cut(turn), half));
        let parts = self.corridor.parts_beside(leg.length);
        self.number = number;
        self.leg = Some(leg);
        self.stage = Stage::Beside {
            start,
            end,
            corner,
            parts,
        };
    }

    /// What comes after the last corner beside a leg.
    fn go_round(&mut self, leg: &Leg<T>) {
        let (turn, _) = self.turn(self.number, leg);
        if turn < T::ZERO {
            let parts = self.corridor.parts(turn);
            self.stage = Stage::Round { turn, corner: 1, parts };
        } else {
            self.go_on(leg);
        }
    }

    /// What comes after a turn.
    fn go_on(&mut self, leg: &Leg<T>) {
        let (turn, next) = self.turn(self.number, leg);
        let Some((number, next)) = next else {
            self.stage = Stage::Done;
            return;
        };
        let cut = self.corridor.cut(turn);
        let half = T::of(0.5);
        // Both legs have the same inner corner, unless one is too short for it.
        let shared = turn > T::ZERO && cut <= half * leg.length && cut <= half * next.length;
        self.go_along(number, next, cut, usize::from(shared));
    }
}

impl<T: Real> Iterator for Outline<'_, T> {
    type Item = LatLon<T>;

    fn next(&mut self) -> Option<LatLon<T>> {
        let corridor = self.corridor;
        // A turn to the left in one part has no corner of its own.
        loop {
            match (self.stage, self.leg) {
                (Stage::Done, _) | (Stage::Beside { .. }, None) => return None,
                (
                    Stage::Beside {
                        start,
                        end,
                        corner,
                        parts,
                    },
                    Some(leg),
                ) => {
                    let part = T::whole(corner as u64) / T::whole(parts as u64);
                    let along = start + (end - start) * part;
                    let here = if along == leg.length {
                        corridor.right(leg.to, leg.azimuth2)
                    } else {
                        let place = reached(corridor.karney, leg.from, leg.azimuth1, along);
                        corridor.right(place.position, place.azimuth)
                    };
                    if corner < parts {
                        self.stage = Stage::Beside {
                            start,
                            end,
                            corner: corner + 1,
                            parts,
                        };
                    } else {
                        self.go_round(&leg);
                    }
                    return Some(here);
                }
                (Stage::Round { corner, parts, .. }, Some(leg)) if corner >= parts => self.go_on(&leg),
                (Stage::Round { corner, parts, .. }, None) if corner >= parts => return None,
                (Stage::Round { turn, corner, parts }, leg) => {
                    self.stage = Stage::Round {
                        turn,
                        corner: corner + 1,
                        parts,
                    };
                    let part = turn * (T::whole(corner as u64) / T::whole(parts as u64));
                    let about = match leg {
                        Some(leg) => (leg.to, leg.azimuth2),
                        None => (corridor.line.first().copied()?, T::ZERO),
                    };
                    return Some(corridor.right(about.0, wrapped(about.1 + part)));
                }
            }
        }
    }
}

impl<T: Real> core::iter::FusedIterator for Outline<'_, T> {}
