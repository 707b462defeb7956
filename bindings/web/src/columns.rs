//! Arrays on their way in and out: at most [`POINTS`] numbers of each at a time, in columns of the module's memory that
//! JavaScript reads and writes. So memory does not grow with the arrays, and nothing is allocated for a call.

use core::cell::UnsafeCell;

/// How many numbers a column holds.
pub const POINTS: usize = 1024;

/// How many columns there are: the most that a function takes and gives.
pub const COLUMNS: usize = 8;

#[repr(align(64))]
struct Memory(UnsafeCell<[[f64; POINTS]; COLUMNS]>);

// SAFETY: a module without threads has one.
unsafe impl Sync for Memory {}

static MEMORY: Memory = Memory(UnsafeCell::new([[0.0; POINTS]; COLUMNS]));

/// Where the columns are: [`COLUMNS`] of [`POINTS`] numbers of 8 bytes.
#[unsafe(no_mangle)]
extern "C" fn columns() -> *mut f64 {
    MEMORY.0.get().cast()
}

/// How many columns there are.
#[unsafe(no_mangle)]
extern "C" fn columns_count() -> usize {
    COLUMNS
}

/// How many numbers a column holds.
#[unsafe(no_mangle)]
extern "C" fn points() -> usize {
    POINTS
}

/// Numbers that a column holds as they are.
pub trait Number: 'static {}

impl Number for f64 {}
impl Number for u32 {}
impl Number for u64 {}
impl Number for u8 {}

/// The first `count` numbers of a column.
///
/// # Safety
/// Nothing else of the column may be lent at the same time.
pub unsafe fn column<T: Number>(index: usize, count: usize) -> &'static mut [T] {
    assert!(index < COLUMNS && count <= POINTS);
    let start = columns().wrapping_add(index * POINTS).cast::<T>();
    // SAFETY: a column holds 8 bytes a number, and T has no more; columns do not overlap.
    unsafe { core::slice::from_raw_parts_mut(start, count) }
}

/// Calls `body` with the first I columns, of which JavaScript has written `count` numbers each, and the O after them, of
/// which it will read as many.
pub fn through<T: Number, U: Number, const I: usize, const O: usize, R>(
    count: usize,
    body: impl FnOnce([&[T]; I], [&mut [U]; O]) -> R,
) -> R {
    let inputs = core::array::from_fn(|i| {
        // SAFETY: each column is lent once, and nobody calls this within a body.
        let column: &[T] = unsafe { column(i, count) };
        column
    });
    // SAFETY: the same.
    body(inputs, core::array::from_fn(|i| unsafe { column(I + i, count) }))
}

/// Leaves a few numbers, one in each of the first columns.
pub fn leave<const N: usize>(numbers: [f64; N]) {
    for (index, number) in numbers.into_iter().enumerate() {
        // SAFETY: nothing is lent: this is called where a function ends.
        unsafe { column(index, 1) }.fill(number);
    }
}
