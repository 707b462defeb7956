//! Slices in parts, one a thread, without Python's lock.

use std::fmt::Display;
use std::thread;

use pyo3::prelude::*;
use terrella::batch::InvalidBatch;

use crate::geodesic::refusal;

/// Columns that can be cut in two.
pub trait Columns: Sized + Send {
    /// How many rows there are.
    fn rows(&self) -> usize;

    /// The first rows, and the others.
    fn cut(self, rows: usize) -> (Self, Self);
}

impl<T: Sync> Columns for &[T] {
    fn rows(&self) -> usize {
        self.len()
    }

    fn cut(self, rows: usize) -> (Self, Self) {
        self.split_at(rows)
    }
}

impl<T: Send> Columns for &mut [T] {
    fn rows(&self) -> usize {
        self.len()
    }

    fn cut(self, rows: usize) -> (Self, Self) {
        self.split_at_mut(rows)
    }
}

impl<C: Columns, const N: usize> Columns for [C; N] {
    fn rows(&self) -> usize {
        self.first().map_or(0, Columns::rows)
    }

    fn cut(self, rows: usize) -> (Self, Self) {
        let mut others = Vec::with_capacity(N);
        let first = self.map(|column| {
            let (first, other) = column.cut(rows);
            others.push(other);
            first
        });
        let mut others = others.into_iter();
        (first, std::array::from_fn(|_| others.next().expect("one for each")))
    }
}

impl<A: Columns, B: Columns> Columns for (A, B) {
    fn rows(&self) -> usize {
        self.0.rows()
    }

    fn cut(self, rows: usize) -> (Self, Self) {
        let ((a, b), (c, d)) = (self.0.cut(rows), self.1.cut(rows));
        ((a, c), (b, d))
    }
}

/// What was refused: how many rows, the first of them, and why. Nothing if nothing was.
pub type Refused = Option<(usize, usize, String)>;

/// Runs a batch over rows, in as many parts as there are threads. Each row has the bits that it has alone, so the parts do not
/// show.
pub fn run<G: Columns, M: Columns, E: Display>(
    py: Python<'_>,
    threads: usize,
    given: G,
    made: M,
    body: impl Fn(G, M) -> Result<(), InvalidBatch<E>> + Sync,
) -> PyResult<Refused> {
    let rows = given.rows();
    let part = |start, given, made| match body(given, made) {
        Ok(()) => Ok(None),
        Err(InvalidBatch::Elements { count, first, why }) => Ok(Some((count, start + first, why.to_string()))),
        Err(lengths) => Err(refusal(lengths)),
    };
    py.detach(|| {
        let threads = threads.clamp(1, rows.max(1));
        if threads == 1 {
            return part(0, given, made);
        }
        thread::scope(|scope| {
            let (mut given, mut made, mut start) = (given, made, 0);
            let mut workers = Vec::new();
            for left in (1..=threads).rev() {
                let here = (rows - start) / left;
                let (of_given, other_given) = given.cut(here);
                let (of_made, other_made) = made.cut(here);
                (given, made) = (other_given, other_made);
                let part = &part;
                workers.push(scope.spawn(move || part(start, of_given, of_made)));
                start += here;
            }
            let mut all: Refused = None;
            for worker in workers {
                let part = worker.join().expect("nothing panics")?;
                all = match (all, part) {
                    (Some((count, first, why)), Some((more, _, _))) => Some((count + more, first, why)),
                    (all, part) => all.or(part),
                };
            }
            Ok(all)
        })
    })
}
