//! The loop that every batch runs: block by block, so that short and odd lengths take the same code.

use core::mem::take;

use super::{InvalidBatch, Pass, same_length, widest};
use crate::Real;

/// Elements that are worked on together: enough to fill the widest vector several times, few enough for a small stack.
pub(crate) const BLOCK: usize = 64;

/// A function of one element, a straight line from `I` numbers to `O` numbers; [`apply`](Self::apply) is `#[inline(always)]`.
pub(crate) trait Kernel<T, const I: usize, const O: usize> {
    /// The function.
    fn apply(&self, input: [T; I]) -> [T; O];
}

/// Where a kernel's numbers come from.
pub(crate) trait Source<'s, T: 's, const I: usize> {
    /// Whether nothing is left.
    fn is_empty(&self) -> bool;

    /// The next block: where it lies, or in `spare` if it has to be put together there. What follows the last element is any number.
    fn next<'a>(&mut self, spare: &'a mut [[T; BLOCK]; I]) -> [&'a [T; BLOCK]; I]
    where
        's: 'a;
}

impl<'s, T: Real, const I: usize> Source<'s, T, I> for [&'s [T]; I] {
    #[inline(always)]
    fn is_empty(&self) -> bool {
        self.iter().any(|column| column.is_empty())
    }

    #[inline(always)]
    fn next<'a>(&mut self, spare: &'a mut [[T; BLOCK]; I]) -> [&'a [T; BLOCK]; I]
    where
        's: 'a,
    {
        let mut columns = self.iter_mut();
        spare.each_mut().map(|spare| match columns.next() {
            Some(column) => block(column, spare),
            None => spare,
        })
    }
}

/// The first block of a slice, which goes past it; what is less than a block is copied to `spare`.
#[inline(always)]
pub(crate) fn block<'a, 's: 'a, T: Copy>(column: &mut &'s [T], spare: &'a mut [T; BLOCK]) -> &'a [T; BLOCK] {
    match column.split_first_chunk() {
        Some((block, rest)) => {
            *column = rest;
            block
        }
        None => {
            pad(take(column), spare);
            spare
        }
    }
}

/// Copies the last elements, out of line.
#[cold]
#[inline(never)]
fn pad<T: Copy>(column: &[T], spare: &mut [T; BLOCK]) {
    for (slot, value) in spare.iter_mut().zip(column) {
        *slot = *value;
    }
}

/// Where a kernel's results go.
pub(crate) trait Sink<T, const O: usize> {
    /// Takes the next block, or as much of it as there is room for.
    fn store(&mut self, block: &[[T; BLOCK]; O]);
}

impl<T: Real, const O: usize> Sink<T, O> for [&mut [T]; O] {
    #[inline(always)]
    fn store(&mut self, block: &[[T; BLOCK]; O]) {
        for (column, block) in self.iter_mut().zip(block) {
            store(column, block);
        }
    }
}

/// Copies a block to the front of a slice, and goes past it.
#[inline(always)]
pub(crate) fn store<V: Copy>(column: &mut &mut [V], block: &[V; BLOCK]) {
    let here = take(column);
    if here.len() < BLOCK {
        for (slot, value) in here.iter_mut().zip(block) {
            *slot = *value;
        }
    } else if let Some((head, rest)) = here.split_first_chunk_mut() {
        *head = *block;
        *column = rest;
    }
}

/// A kernel over all of a source.
pub(crate) struct Sweep<K, S, D, T, const I: usize, const O: usize> {
    kernel: K,
    source: S,
    sink: D,
    scalar: core::marker::PhantomData<T>,
}

/// One of each column of a block. Columns side by side have no iterator; i is below [`BLOCK`], and compiled for size it is not seen that it is.
#[inline(always)]
fn element<T: Real, const I: usize>(block: [&[T; BLOCK]; I], i: usize) -> [T; I] {
    block.map(|column| column.get(i).copied().unwrap_or_default())
}

/// Runs a kernel over all of a source: a function of its own, so that an image has it once and not once for each caller.
#[inline(never)]
pub(crate) fn sweep<'s, T, K, S, D, const I: usize, const O: usize>(kernel: K, source: S, sink: D)
where
    T: Real,
    K: Kernel<T, I, O>,
    S: Source<'s, T, I>,
    D: Sink<T, O>,
{
    widest(Sweep::<K, S, D, T, I, O> {
        kernel,
        source,
        sink,
        scalar: core::marker::PhantomData,
    });
}

impl<'s, T, K, S, D, const I: usize, const O: usize> Pass for Sweep<K, S, D, T, I, O>
where
    T: Real,
    K: Kernel<T, I, O>,
    S: Source<'s, T, I>,
    D: Sink<T, O>,
{
    type Output = ();

    #[inline(always)]
    fn run(mut self) {
        let mut spare = [[T::ZERO; BLOCK]; I];
        let mut results = [[T::ZERO; BLOCK]; O];
        while !self.source.is_empty() {
            let block = self.source.next(&mut spare);
            for i in 0..BLOCK {
                let result = self.kernel.apply(element(block, i));
                for (column, value) in results.iter_mut().zip(result) {
                    if let Some(slot) = column.get_mut(i) {
                        *slot = value;
                    }
                }
            }
            self.sink.store(&results);
        }
    }
}

/// What the elements of a batch are, and the constructor that lets them in.
pub(crate) trait Door<T, const I: usize> {
    /// What the constructor refuses with.
    type Error;

    /// Whether the constructor keeps the numbers as they are; `#[inline(always)]`, without a branch.
    fn keeps(&self, input: [T; I]) -> bool;

    /// The numbers as the constructor keeps them.
    fn admit(&self, input: [T; I]) -> Result<[T; I], Self::Error>;
}

/// Whether a door keeps all numbers as they are.
struct Check<'s, D, T, const I: usize> {
    door: &'s D,
    columns: [&'s [T]; I],
}

impl<T: Real, D: Door<T, I>, const I: usize> Pass for Check<'_, D, T, I> {
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
                these &= self.door.keeps(element(block, i));
            }
            all &= these;
        }
        let rest = self.columns.iter().fold(BLOCK, |n, column| n.min(column.len()));
        for i in 0..rest {
            let element = self.columns.map(|column| column.get(i).copied().unwrap_or_default());
            all &= self.door.keeps(element);
        }
        all
    }
}

/// Elements that go through buffers together.
pub(crate) const CHUNK: usize = 4 * BLOCK;

/// Lets the columns in by the door, then does the work on them as the constructor keeps them: all at once if it changes nothing,
/// else in parts of the length given.
///
/// # Errors
/// [`InvalidBatch`], before any work, for unequal lengths (`others` are those of the results) and for what the door refuses.
pub(crate) fn admit<T: Real, D: Door<T, I>, const I: usize>(
    door: &D,
    columns: [&[T]; I],
    others: &[usize],
    mut work: impl FnMut(usize, [&[T]; I]),
) -> Result<(), InvalidBatch<D::Error>> {
    let length = columns.first().map_or(0, |column| column.len());
    same_length(length, &columns.map(<[T]>::len))?;
    same_length(length, others)?;
    if widest(Check { door, columns }) {
        work(length, columns);
        return Ok(());
    }
    let element = |index: usize| columns.map(|column| column.get(index).copied().unwrap_or_default());
    for index in 0..length {
        door.admit(element(index))
            .map_err(|why| InvalidBatch::Element { index, why })?;
    }
    let mut mended = [[T::ZERO; CHUNK]; I];
    let mut index = 0;
    while index < length {
        let here = CHUNK.min(length - index);
        for slot in 0..here {
            let numbers = door.admit(element(index + slot)).unwrap_or([T::ZERO; I]);
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

/// The first elements of each slice, which goes past them.
pub(crate) fn front<'a, V, const O: usize>(columns: &mut [&'a mut [V]; O], length: usize) -> [&'a mut [V]; O] {
    columns.each_mut().map(|column| {
        let (head, rest) = take(column).split_at_mut_checked(length).unwrap_or_default();
        *column = rest;
        head
    })
}
