//! Checks the elements of a batch as their constructors do.

use super::{InvalidBatch, same_length};
use crate::Real;
use crate::simd::{BLOCK, CHUNK, Pass, Source, dispatch, element};

/// The constructor of the elements of a batch.
pub(crate) trait Constructor<T, const I: usize> {
    /// The constructor's error.
    type Error;

    /// Whether the constructor accepts the numbers and does not change them; `#[inline(always)]`, without a
    /// branch.
    fn keeps(&self, input: [T; I]) -> bool;

    /// The numbers as the constructor changes them.
    fn admit(&self, input: [T; I]) -> Result<[T; I], Self::Error>;
}

/// The pass that finds out whether a constructor accepts all numbers without a change.
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

/// Passes all elements through the constructor, then calls `work` on what it returns: once with all columns
/// if it changes no element, else on one part after the other. `work` is told the length of its part.
///
/// # Errors
/// [`InvalidBatch`], before `work` is called, if lengths are unequal (`others` are those of the results) or
/// the constructor refuses an element.
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
