//! The elements of a batch, checked as their constructors check them.

use super::{InvalidBatch, same_length};
use crate::Real;
use crate::simd::{BLOCK, CHUNK, Pass, Source, dispatch, element};

/// What the elements of a batch are, and the constructor that lets them in.
pub(crate) trait Constructor<T, const I: usize> {
    /// What the constructor refuses with.
    type Error;

    /// Whether the constructor keeps the numbers as they are; `#[inline(always)]`, without a branch.
    fn keeps(&self, input: [T; I]) -> bool;

    /// The numbers as the constructor keeps them.
    fn admit(&self, input: [T; I]) -> Result<[T; I], Self::Error>;
}

/// Whether a constructor keeps all numbers as they are.
struct Check<'s, D, T, const I: usize> {
    constructor: &'s D,
    columns: [&'s [T]; I],
}

impl<T: Real, D: Constructor<T, I>, const I: usize> Pass for Check<'_, D, T, I> {
    type Output = bool;

    #[inline(always)]
    fn run(mut self) -> bool {
        let [first, ..] = self.columns.as_slice() else {
            return true;
        };
        let blocks = first.len() / BLOCK;
        let mut spare = [[T::ZERO; BLOCK]; I];
        let mut all = true;
        for _ in 0..blocks {
            let block = self.columns.next(&mut spare);
            let mut these = true;
            for i in 0..BLOCK {
                these &= self.constructor.keeps(element(block, i));
            }
            all &= these;
        }
        let rest = self.columns.iter().fold(BLOCK, |n, column| n.min(column.len()));
        for i in 0..rest {
            let element = self.columns.map(|column| column.get(i).copied().unwrap_or_default());
            all &= self.constructor.keeps(element);
        }
        all
    }
}

/// Lets the columns in by the constructor, then does the work on them as the constructor keeps them: all at once if it changes nothing,
/// else in parts of the length given.
///
/// # Errors
/// [`InvalidBatch`], before any work, for unequal lengths (`others` are those of the results) and for what the constructor refuses.
pub(crate) fn admit<T: Real, D: Constructor<T, I>, const I: usize>(
    constructor: &D,
    columns: [&[T]; I],
    others: &[usize],
    mut work: impl FnMut(usize, [&[T]; I]),
) -> Result<(), InvalidBatch<D::Error>> {
    let length = columns.first().map_or(0, |column| column.len());
    same_length(length, &columns.map(<[T]>::len))?;
    same_length(length, others)?;
    if dispatch(Check { constructor, columns }) {
        work(length, columns);
        return Ok(());
    }
    let element = |index: usize| columns.map(|column| column.get(index).copied().unwrap_or_default());
    for index in 0..length {
        constructor
            .admit(element(index))
            .map_err(|why| InvalidBatch::Element { index, why })?;
    }
    let mut mended = [[T::ZERO; CHUNK]; I];
    let mut index = 0;
    while index < length {
        let here = CHUNK.min(length - index);
        for slot in 0..here {
            let numbers = constructor.admit(element(index + slot)).unwrap_or([T::ZERO; I]);
            for (column, value) in mended.iter_mut().zip(numbers) {
                if let Some(place) = column.get_mut(slot) {
                    *place = value;
                }
            }
        }
        work(
            here,
            mended.each_ref().map(|column| column.get(..here).unwrap_or_default()),
        );
        index += here;
    }
    Ok(())
}
