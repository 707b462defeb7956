//! Runs a function over columns: lengths are compared, and what is refused is counted.

use super::InvalidBatch;
use crate::simd::{Element, FEW, Sink, Source, Tally, lanes};

/// Computes all elements: few of them, and all on a machine without vectors, by `one`, else by `in_lanes`.
///
/// # Errors
/// [`InvalidBatch`] if lengths are unequal; nothing is written then. Also if elements are refused: all others
/// are written.
pub(super) fn solve_by<S: Source, D: Sink, E>(
    source: S,
    sink: D,
    one: impl Fn(S::Row) -> Result<D::Row, E>,
    in_lanes: impl FnOnce(S, D, &mut Tally<E>),
) -> Result<(), InvalidBatch<E>> {
    let length = source.len();
    if let Some(other) = source.other_length(length).or_else(|| sink.other_length(length)) {
        return Err(InvalidBatch::Lengths { first: length, other });
    }
    let mut tally = Tally::new();
    if cfg!(lanes) && length >= FEW {
        in_lanes(source, sink, &mut tally);
    } else {
        each(source, sink, &mut tally, one);
    }
    match tally.refused() {
        Some((count, first, why)) => Err(InvalidBatch::Elements { count, first, why }),
        None => Ok(()),
    }
}

/// Computes all elements one by one: of functions that branch on their data.
///
/// # Errors
/// Those of [`solve_by`].
pub(super) fn solve_each<S: Source, D: Sink, E>(
    source: S,
    sink: D,
    one: impl Fn(S::Row) -> Result<D::Row, E>,
) -> Result<(), InvalidBatch<E>> {
    solve_by(source, sink, &one, |source, sink, tally| {
        each(source, sink, tally, &one)
    })
}

fn each<S: Source, D: Sink, E>(
    source: S,
    mut sink: D,
    tally: &mut Tally<E>,
    one: impl Fn(S::Row) -> Result<D::Row, E>,
) {
    for index in 0..source.len() {
        sink.push(tally.note(index, one(source.at(index)), D::nothing()));
    }
}

/// Refuses all elements, for one reason.
///
/// # Errors
/// [`InvalidBatch`], unless there are no elements.
pub(super) fn refuse_all<S: Source, D: Sink, E>(source: S, mut sink: D, why: E) -> Result<(), InvalidBatch<E>> {
    let length = source.len();
    if let Some(other) = source.other_length(length).or_else(|| sink.other_length(length)) {
        return Err(InvalidBatch::Lengths { first: length, other });
    }
    for _ in 0..length {
        sink.push(D::nothing());
    }
    match length {
        0 => Ok(()),
        count => Err(InvalidBatch::Elements { count, first: 0, why }),
    }
}

/// [`solve_by`] an element's own functions.
pub(super) fn solve<S: Source, D: Sink, K: Element<S::Row, Output = D::Row>>(
    element: K,
    source: S,
    sink: D,
) -> Result<(), InvalidBatch<K::Error>> {
    solve_by(
        source,
        sink,
        |row| element.one(row),
        |source, sink, tally| lanes(element, source, sink, tally),
    )
}
