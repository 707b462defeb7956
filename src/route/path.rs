//! Polylines and rings, on any surface.

use super::{Legs, OnPath};
use crate::{LatLon, Real};

/// Whether a leg leads from the last place to the first.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Path {
    Open,
    Closed,
}

/// The closest point of all legs.
pub(super) fn nearest<T: Real, S: Legs<T> + ?Sized>(
    surface: &S,
    place: LatLon<T>,
    places: impl IntoIterator<Item = LatLon<T>>,
    path: Path,
) -> Option<OnPath<T>> {
    let mut places = places.into_iter();
    let first = places.next()?;
    let mut last = first;
    let mut leg = 0;
    let mut best = None;
    for next in places {
        best = nearer(surface, place, [last, next], leg, best);
        last = next;
        leg += 1;
    }
    if path == Path::Closed || leg == 0 {
        best = nearer(surface, place, [last, first], leg, best);
    }
    best
}

/// The best so far, or this leg's point if it is closer.
fn nearer<T: Real, S: Legs<T> + ?Sized>(
    surface: &S,
    place: LatLon<T>,
    [start, end]: [LatLon<T>; 2],
    leg: usize,
    best: Option<OnPath<T>>,
) -> Option<OnPath<T>> {
    let farther = |before: OnPath<T>| surface.at_least(place, start, end) >= before.closest.distance;
    if best.is_some_and(farther) {
        return best;
    }
    let closest = surface.closest(place, start, end);
    match best {
        Some(before) if before.closest.distance <= closest.distance => best,
        _ => Some(OnPath { leg, closest }),
    }
}
