//! The loop over slices. It works block by block, so that short and odd lengths run the same code.

use core::mem::take;

use super::dispatch::{Pass, dispatch};
use crate::Real;

/// The number of elements that are processed together: enough to fill the widest vector several times, and
/// few enough for a small stack.
pub(crate) const BLOCK: usize = 64;

/// The number of elements that pass through buffers together.
pub(crate) const CHUNK: usize = 4 * BLOCK;

/// A function of one element: straight-line code from `I` numbers to `O` numbers. [`apply`](Self::apply) must
/// be `#[inline(always)]`.
pub(crate) trait Kernel<T, const I: usize, const O: usize> {
    /// Computes the function.
    fn apply(&self, input: [T; I]) -> [T; O];
}

/// The input of a kernel: columns of numbers.
pub(crate) trait Source<'s, T: 's, const I: usize> {
    /// Returns whether no elements are left.
    fn is_empty(&self) -> bool;

    /// Returns the next block and moves past it. The result is the input itself if that is contiguous, else
    /// `spare`. Elements after the last one are arbitrary.
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

/// Returns the first block of a slice and moves the slice past it. If less than a block is left, it is copied
/// to `spare`.
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

/// Copies the last elements. Out of line, since it runs once for each slice.
#[cold]
#[inline(never)]
fn pad<T: Copy>(column: &[T], spare: &mut [T; BLOCK]) {
    for (slot, value) in spare.iter_mut().zip(column) {
        *slot = *value;
    }
}

/// The output of a kernel.
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

/// Copies a block to the front of a slice and moves the slice past it.
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

/// A kernel that runs over all of a source.
pub(crate) struct Sweep<K, S, D, T, const I: usize, const O: usize> {
    kernel: K,
    source: S,
    sink: D,
    scalar: core::marker::PhantomData<T>,
}

/// Element i of each column of a block. There is no iterator over several arrays side by side; i is below
/// [`BLOCK`], but the compiler does not see that when it optimises for size, hence `get`.
#[inline(always)]
pub(crate) fn element<T: Real, const I: usize>(block: [&[T; BLOCK]; I], i: usize) -> [T; I] {
    block.map(|column| column.get(i).copied().unwrap_or_default())
}

/// Runs a kernel over all of a source. It is not inlined, so that a program has the loop once and not once
/// for each caller.
#[inline(never)]
pub(crate) fn sweep<'s, T, K, S, D, const I: usize, const O: usize>(kernel: K, source: S, sink: D)
where
    T: Real,
    K: Kernel<T, I, O>,
    S: Source<'s, T, I>,
    D: Sink<T, O>,
{
    dispatch(Sweep::<K, S, D, T, I, O> {
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

/// Returns the first elements of each slice and moves the slices past them.
pub(crate) fn front<'a, V, const O: usize>(slices: &mut [&'a mut [V]; O], count: usize) -> [&'a mut [V]; O] {
    slices.each_mut().map(|slice| {
        let (head, rest) = take(slice).split_at_mut_checked(count).unwrap_or_default();
        *slice = rest;
        head
    })
}
