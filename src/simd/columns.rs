//! What a loop reads and writes: columns side by side. A row is one element of each.

use core::mem::take;

use crate::Real;

/// The number of rows that are processed together: enough to fill the widest vector several times, and few
/// enough for a small stack.
pub(crate) const BLOCK: usize = 64;

/// The number of values in the widest vector, if they are numbers; else any.
const fn width<V>() -> usize {
    if size_of::<V>() == 8 { 8 } else { 16 }
}

/// Columns to read: arrays of slices, pairs of columns.
pub(crate) trait Source: Copy {
    /// The number of rows that fill the widest vector: at most [`BLOCK`], a power of two.
    const WIDTH: usize = 16;

    /// One element of each column.
    type Row: Copy;
    /// A block of rows, as columns.
    type Spare;
    /// A block of rows that lie in the columns themselves, or in a spare.
    type Block<'a>: Copy
    where
        Self: 'a;

    /// A spare with any rows in it.
    fn spare() -> Self::Spare;

    /// The length of the first column.
    fn len(&self) -> usize;

    /// The first length that is another one.
    fn other_length(&self, length: usize) -> Option<usize>;

    /// The row at an index below the length.
    fn at(&self, index: usize) -> Self::Row;

    /// Returns the next block and moves past it. If less than a block is left, it is copied to `spare`, and
    /// its last row fills the rest.
    fn next<'a>(&mut self, spare: &'a mut Self::Spare) -> Self::Block<'a>
    where
        Self: 'a;

    /// The block in a spare.
    fn block<'a>(spare: &'a Self::Spare) -> Self::Block<'a>
    where
        Self: 'a;

    /// Row i of a block. There is no iterator over several arrays side by side; i is below [`BLOCK`], but the
    /// compiler does not see that when it optimises for size, hence `get`.
    fn row<'a>(block: Self::Block<'a>, i: usize) -> Self::Row
    where
        Self: 'a;

    /// Writes row i of a spare.
    fn put(spare: &mut Self::Spare, i: usize, row: Self::Row);
}

/// Columns to write.
pub(crate) trait Sink {
    /// One element of each column.
    type Row: Copy;
    /// A block of rows, as columns.
    type Block;

    /// A block with any rows in it.
    fn block() -> Self::Block;

    /// The row for an element that was refused.
    fn nothing() -> Self::Row;

    /// The first length that is another one.
    fn other_length(&self, length: usize) -> Option<usize>;

    /// Writes row i of a block.
    fn put(block: &mut Self::Block, i: usize, row: Self::Row);

    /// Row i of a block.
    fn get(block: &Self::Block, i: usize) -> Self::Row;

    /// Stores the next block, or as much of it as there is room for, and moves past it.
    fn store(&mut self, block: &Self::Block);

    /// Stores the next row and moves past it.
    fn push(&mut self, row: Self::Row);
}

/// An element of a column of results.
pub(crate) trait Cell: Copy {
    /// What is written for an element that was refused.
    fn nothing() -> Self;
}

impl<T: Real> Cell for T {
    #[inline(always)]
    fn nothing() -> Self {
        T::of(f64::NAN)
    }
}

macro_rules! whole_numbers {
    ($($integer:ty)*) => {$(
        impl Cell for $integer {
            #[inline(always)]
            fn nothing() -> Self {
                0
            }
        }
    )*};
}

whole_numbers! { u8 u32 u64 }

impl<V: Copy + Default, const N: usize> Source for [&[V]; N] {
    const WIDTH: usize = width::<V>();
    type Row = [V; N];
    type Spare = [[V; BLOCK]; N];
    type Block<'a>
        = [&'a [V; BLOCK]; N]
    where
        Self: 'a;

    #[inline(always)]
    fn spare() -> Self::Spare {
        [[V::default(); BLOCK]; N]
    }

    #[inline(always)]
    fn len(&self) -> usize {
        self.first().map_or(0, |column| column.len())
    }

    fn other_length(&self, length: usize) -> Option<usize> {
        self.map(<[V]>::len).into_iter().find(|&other| other != length)
    }

    #[inline(always)]
    fn at(&self, index: usize) -> Self::Row {
        self.map(|column| column.get(index).copied().unwrap_or_default())
    }

    #[inline(always)]
    fn next<'a>(&mut self, spare: &'a mut Self::Spare) -> Self::Block<'a>
    where
        Self: 'a,
    {
        let mut columns = self.iter_mut();
        spare.each_mut().map(|spare| match columns.next() {
            Some(column) => block(column, spare),
            None => spare,
        })
    }

    #[inline(always)]
    fn block<'a>(spare: &'a Self::Spare) -> Self::Block<'a>
    where
        Self: 'a,
    {
        spare.each_ref()
    }

    #[inline(always)]
    fn row<'a>(block: Self::Block<'a>, i: usize) -> Self::Row
    where
        Self: 'a,
    {
        block.map(|column| column.get(i).copied().unwrap_or_default())
    }

    #[inline(always)]
    fn put(spare: &mut Self::Spare, i: usize, row: Self::Row) {
        put(spare, i, row);
    }
}

impl<V: Cell, const N: usize> Sink for [&mut [V]; N] {
    type Row = [V; N];
    type Block = [[V; BLOCK]; N];

    #[inline(always)]
    fn block() -> Self::Block {
        [[V::nothing(); BLOCK]; N]
    }

    #[inline(always)]
    fn nothing() -> Self::Row {
        [V::nothing(); N]
    }

    fn other_length(&self, length: usize) -> Option<usize> {
        self.iter().map(|column| column.len()).find(|&other| other != length)
    }

    #[inline(always)]
    fn put(block: &mut Self::Block, i: usize, row: Self::Row) {
        put(block, i, row);
    }

    fn get(block: &Self::Block, i: usize) -> Self::Row {
        let mut columns = block.iter();
        [(); N].map(|()| {
            columns
                .next()
                .and_then(|column| column.get(i).copied())
                .unwrap_or(V::nothing())
        })
    }

    #[inline(always)]
    fn store(&mut self, block: &Self::Block) {
        for (column, block) in self.iter_mut().zip(block) {
            store(column, block);
        }
    }

    #[inline(always)]
    fn push(&mut self, row: Self::Row) {
        for (column, value) in self.iter_mut().zip(row) {
            push(column, value);
        }
    }
}

/// The same row again and again.
#[derive(Clone, Copy)]
pub(crate) struct Same<R> {
    row: R,
    length: usize,
}

impl<R> Same<R> {
    pub(crate) const fn new(row: R, length: usize) -> Self {
        Self { row, length }
    }
}

impl<V: Copy + Default, const N: usize> Source for Same<[V; N]> {
    const WIDTH: usize = width::<V>();
    type Row = [V; N];
    type Spare = [V; N];
    type Block<'a>
        = [V; N]
    where
        Self: 'a;

    #[inline(always)]
    fn spare() -> Self::Spare {
        [V::default(); N]
    }

    #[inline(always)]
    fn len(&self) -> usize {
        self.length
    }

    fn other_length(&self, length: usize) -> Option<usize> {
        (self.length != length).then_some(self.length)
    }

    #[inline(always)]
    fn at(&self, _: usize) -> Self::Row {
        self.row
    }

    #[inline(always)]
    fn next<'a>(&mut self, _: &'a mut Self::Spare) -> Self::Block<'a>
    where
        Self: 'a,
    {
        self.length = self.length.saturating_sub(BLOCK);
        self.row
    }

    #[inline(always)]
    fn block<'a>(spare: &'a Self::Spare) -> Self::Block<'a>
    where
        Self: 'a,
    {
        *spare
    }

    #[inline(always)]
    fn row<'a>(block: Self::Block<'a>, _: usize) -> Self::Row
    where
        Self: 'a,
    {
        block
    }

    #[inline(always)]
    fn put(spare: &mut Self::Spare, _: usize, row: Self::Row) {
        *spare = row;
    }
}

impl<A: Source, B: Source> Source for (A, B) {
    const WIDTH: usize = if A::WIDTH < B::WIDTH { A::WIDTH } else { B::WIDTH };
    type Row = (A::Row, B::Row);
    type Spare = (A::Spare, B::Spare);
    type Block<'a>
        = (A::Block<'a>, B::Block<'a>)
    where
        Self: 'a;

    #[inline(always)]
    fn spare() -> Self::Spare {
        (A::spare(), B::spare())
    }

    #[inline(always)]
    fn len(&self) -> usize {
        self.0.len()
    }

    fn other_length(&self, length: usize) -> Option<usize> {
        self.0.other_length(length).or_else(|| self.1.other_length(length))
    }

    #[inline(always)]
    fn at(&self, index: usize) -> Self::Row {
        (self.0.at(index), self.1.at(index))
    }

    #[inline(always)]
    fn next<'a>(&mut self, spare: &'a mut Self::Spare) -> Self::Block<'a>
    where
        Self: 'a,
    {
        (self.0.next(&mut spare.0), self.1.next(&mut spare.1))
    }

    #[inline(always)]
    fn block<'a>(spare: &'a Self::Spare) -> Self::Block<'a>
    where
        Self: 'a,
    {
        (A::block(&spare.0), B::block(&spare.1))
    }

    #[inline(always)]
    fn row<'a>(block: Self::Block<'a>, i: usize) -> Self::Row
    where
        Self: 'a,
    {
        (A::row(block.0, i), B::row(block.1, i))
    }

    #[inline(always)]
    fn put(spare: &mut Self::Spare, i: usize, row: Self::Row) {
        A::put(&mut spare.0, i, row.0);
        B::put(&mut spare.1, i, row.1);
    }
}

impl<A: Sink, B: Sink> Sink for (A, B) {
    type Row = (A::Row, B::Row);
    type Block = (A::Block, B::Block);

    #[inline(always)]
    fn block() -> Self::Block {
        (A::block(), B::block())
    }

    #[inline(always)]
    fn nothing() -> Self::Row {
        (A::nothing(), B::nothing())
    }

    fn other_length(&self, length: usize) -> Option<usize> {
        self.0.other_length(length).or_else(|| self.1.other_length(length))
    }

    #[inline(always)]
    fn put(block: &mut Self::Block, i: usize, row: Self::Row) {
        A::put(&mut block.0, i, row.0);
        B::put(&mut block.1, i, row.1);
    }

    fn get(block: &Self::Block, i: usize) -> Self::Row {
        (A::get(&block.0, i), B::get(&block.1, i))
    }

    #[inline(always)]
    fn store(&mut self, block: &Self::Block) {
        self.0.store(&block.0);
        self.1.store(&block.1);
    }

    #[inline(always)]
    fn push(&mut self, row: Self::Row) {
        self.0.push(row.0);
        self.1.push(row.1);
    }
}

/// Returns the first block of a slice and moves the slice past it. If less than a block is left, it is copied
/// to `spare`.
#[inline(always)]
pub(crate) fn block<'a, 's: 'a, V: Copy>(column: &mut &'s [V], spare: &'a mut [V; BLOCK]) -> &'a [V; BLOCK] {
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

/// Copies the last elements, and the very last one to the rest. Out of line, since it runs once for each
/// slice.
#[cold]
#[inline(never)]
fn pad<V: Copy>(column: &[V], spare: &mut [V; BLOCK]) {
    if let Some(&last) = column.last() {
        *spare = [last; BLOCK];
    }
    for (slot, value) in spare.iter_mut().zip(column) {
        *slot = *value;
    }
}

#[inline(always)]
fn put<V: Copy, const N: usize>(block: &mut [[V; BLOCK]; N], i: usize, row: [V; N]) {
    for (column, value) in block.iter_mut().zip(row) {
        if let Some(slot) = column.get_mut(i) {
            *slot = value;
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

/// Stores a value at the front of a slice and moves the slice past it.
#[inline(always)]
pub(crate) fn push<V>(column: &mut &mut [V], value: V) {
    if let Some((slot, rest)) = take(column).split_first_mut() {
        *slot = value;
        *column = rest;
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

/// As [`front`], of slices that are read.
pub(crate) fn head<'a, V, const I: usize>(slices: &mut [&'a [V]; I], count: usize) -> [&'a [V]; I] {
    slices.each_mut().map(|slice| {
        let (head, rest) = slice.split_at_checked(count).unwrap_or_default();
        *slice = rest;
        head
    })
}
