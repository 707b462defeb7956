//! The loop over columns. It works block by block, and short and odd lengths run the same code.

use core::convert::Infallible;
use core::marker::PhantomData;

use super::columns::{BLOCK, Sink, Source};
use super::dispatch::{Pass, dispatch};

/// The number of rows that pass through buffers together.
pub(crate) const CHUNK: usize = 4 * BLOCK;

/// The last rows of a loop are filled up to a multiple of this: two of the widest vectors of `f64`. So no loop
/// has a second body for what is left.
const LANES: usize = if cfg!(lanes) { 16 } else { 1 };

/// With fewer rows of a block that were not found, [`Element::second`] does not pay.
const PAIR: usize = 2;

/// With fewer elements the lanes do not pay.
pub(crate) const FEW: usize = 4;

/// The constructors of what an element is made of.
///
/// [`keeps`](Self::keeps) and [`mend`](Self::mend) must be `#[inline(always)]`, straight-line code, and hold
/// for any numbers.
pub(crate) trait Door<Input>: Copy {
    /// Why an element is refused.
    type Error;

    /// Whether the constructors accept the numbers and do not change them.
    fn keeps(&self, input: Input) -> bool;

    /// The numbers as the constructors change them, bit for bit, or any that [`keeps`](Self::keeps) denies.
    /// It is called only for blocks in which a row is not kept.
    #[inline(always)]
    fn mend(&self, input: Input) -> Input {
        input
    }

    /// The numbers as the constructors change them.
    fn admit(&self, input: Input) -> Result<Input, Self::Error>;
}

/// A function of one element that cannot be refused. [`apply`](Self::apply) is straight-line code and
/// `#[inline(always)]`.
pub(crate) trait Kernel<Input>: Copy {
    /// The results.
    type Output;

    /// Computes the function.
    fn apply(&self, input: Input) -> Self::Output;
}

/// A function of one element behind a door: the way that nearly all elements take, in lanes, and the function
/// itself, one by one.
///
/// All but [`one`](Self::one) must be `#[inline(always)]`, straight-line code, and hold for any numbers.
pub(crate) trait Element<Input>: Copy {
    /// The results.
    type Output;
    /// Why an element is refused.
    type Error;

    /// As [`Door::keeps`].
    fn keeps(&self, input: Input) -> bool;

    /// As [`Door::mend`].
    #[inline(always)]
    fn mend(&self, input: Input) -> Input {
        input
    }

    /// The results for numbers that are kept, and whether they are those of [`one`](Self::one), bit for bit.
    fn fast(&self, input: Input) -> (Self::Output, bool);

    /// Whether [`finish`](Self::finish) does anything. Where it does not, its loop is not compiled.
    const FINISHES: bool = false;

    /// What is left to do to a result of [`fast`](Self::fast), in a loop of its own: a processor overlaps more
    /// rows of two short loops than of a long one.
    #[inline(always)]
    fn finish(&self, output: Self::Output) -> Self::Output {
        output
    }

    /// Whether [`second`](Self::second) finds any. Where it does not, its loop is not compiled.
    const SECOND: bool = false;

    /// As [`fast`](Self::fast), for what that does not find: the hard cases in lanes of their own.
    #[inline(always)]
    fn second(&self, input: Input) -> (Self::Output, bool) {
        (self.fast(input).0, false)
    }

    /// The results by the constructors and the function that takes one element.
    fn one(&self, input: Input) -> Result<Self::Output, Self::Error>;
}

/// Counts the elements that were refused.
pub(crate) struct Tally<E> {
    /// The number of elements before those that are processed now.
    before: usize,
    count: usize,
    first: Option<(usize, E)>,
}

impl<E> Tally<E> {
    pub(crate) const fn new() -> Self {
        Self {
            before: 0,
            count: 0,
            first: None,
        }
    }

    /// Moves past elements.
    pub(crate) const fn pass(&mut self, count: usize) {
        self.before += count;
    }

    /// The result of one element, or nothing if it was refused.
    pub(crate) fn note<V>(&mut self, index: usize, result: Result<V, E>, nothing: V) -> V {
        result.unwrap_or_else(|why| {
            self.count += 1;
            self.first.get_or_insert((self.before + index, why));
            nothing
        })
    }

    /// The number of elements that were refused, the index of the first, and why it was.
    pub(crate) fn refused(self) -> Option<(usize, usize, E)> {
        self.first.map(|(first, why)| (self.count, first, why))
    }
}

struct Lanes<'t, K, S, D, E> {
    kernel: K,
    source: S,
    sink: D,
    tally: &'t mut Tally<E>,
}

/// Computes all elements in lanes, and those that have no fast way one by one. It is not inlined, so that a
/// program has the loop once and not once for each caller.
#[inline(never)]
pub(crate) fn lanes<K, S, D>(kernel: K, source: S, sink: D, tally: &mut Tally<K::Error>)
where
    S: Source,
    D: Sink,
    K: Element<S::Row, Output = D::Row>,
{
    dispatch(Lanes {
        kernel,
        source,
        sink,
        tally,
    });
}

/// Runs a kernel over all of a source.
pub(crate) fn sweep<K, S, D>(kernel: K, source: S, sink: D)
where
    S: Source,
    D: Sink,
    K: Kernel<S::Row, Output = D::Row>,
{
    lanes(Behind(Open, kernel), source, sink, &mut Tally::new());
}

/// No door: all numbers are kept.
#[derive(Clone, Copy)]
struct Open;

impl<I> Door<I> for Open {
    type Error = Infallible;

    #[inline(always)]
    fn keeps(&self, _: I) -> bool {
        true
    }

    #[inline(always)]
    fn admit(&self, input: I) -> Result<I, Infallible> {
        Ok(input)
    }
}

/// A kernel behind a door.
#[derive(Clone, Copy)]
pub(crate) struct Behind<D, K>(pub(crate) D, pub(crate) K);

impl<I, D: Door<I>, K: Kernel<I>> Element<I> for Behind<D, K> {
    type Output = K::Output;
    type Error = D::Error;

    #[inline(always)]
    fn keeps(&self, input: I) -> bool {
        self.0.keeps(input)
    }

    #[inline(always)]
    fn mend(&self, input: I) -> I {
        self.0.mend(input)
    }

    #[inline(always)]
    fn fast(&self, input: I) -> (K::Output, bool) {
        (self.1.apply(input), true)
    }

    fn one(&self, input: I) -> Result<K::Output, D::Error> {
        Ok(self.1.apply(self.0.admit(input)?))
    }
}

impl<K, S, D> Pass for Lanes<'_, K, S, D, K::Error>
where
    S: Source,
    D: Sink,
    K: Element<S::Row, Output = D::Row>,
{
    type Output = ();

    #[inline(always)]
    fn run(self) {
        let Self {
            kernel,
            mut source,
            mut sink,
            tally,
        } = self;
        let (mut spare, mut mended, mut results) = (S::spare(), S::spare(), D::block());
        let mut found = [true; BLOCK];
        loop {
            let rows = source;
            let here = rows.len().min(BLOCK);
            if here == 0 {
                return;
            }
            let count = here.div_ceil(LANES).min(BLOCK / LANES) * LANES;
            let mut block = source.next(&mut spare);
            let mut kept = true;
            for i in 0..count {
                kept &= kernel.keeps(S::row(block, i));
            }
            if !kept {
                for i in 0..count {
                    S::put(&mut mended, i, kernel.mend(S::row(block, i)));
                }
                block = S::block(&mended);
            }
            let mut all = true;
            for i in 0..count {
                let (row, fast) = kernel.fast(S::row(block, i));
                D::put(&mut results, i, row);
                if let Some(slot) = found.get_mut(i) {
                    *slot = fast;
                }
                all &= fast;
            }
            if K::FINISHES {
                for i in 0..count {
                    let row = kernel.finish(D::get(&results, i));
                    D::put(&mut results, i, row);
                }
            }
            if !kept {
                for i in 0..count {
                    let kept = kernel.keeps(S::row(block, i));
                    if let Some(slot) = found.get_mut(i) {
                        *slot &= kept;
                    }
                    all &= kept;
                }
            }
            if !all {
                complete::<K, S, D>(&kernel, (rows, block), &mut found, &mut results, tally);
            }
            sink.store(&results);
            tally.pass(here);
        }
    }
}

/// Computes the rows of a block that were not found: several of them in lanes, the rest one by one.
#[cold]
#[inline(never)]
fn complete<'a, K, S, D>(
    kernel: &K,
    (rows, block): (S, S::Block<'a>),
    found: &mut [bool; BLOCK],
    results: &mut D::Block,
    tally: &mut Tally<K::Error>,
) where
    S: Source + 'a,
    D: Sink,
    K: Element<S::Row, Output = D::Row>,
{
    let here = rows.len().min(BLOCK);
    if K::SECOND {
        let mut spare = S::spare();
        let mut places = [0_u8; BLOCK];
        let mut count = 0;
        for (i, found) in (0..here).zip(found.iter()) {
            let row = S::row(block, i);
            if !found && kernel.keeps(row) {
                S::put(&mut spare, count, row);
                if let Some(place) = places.get_mut(count) {
                    *place = i as u8;
                }
                count += 1;
            }
        }
        if count >= PAIR {
            let (second, well) = dispatch(Second::<K, S, D> {
                kernel: *kernel,
                spare,
                count,
                sink: PhantomData,
            });
            for (j, (&place, well)) in places.iter().zip(well).enumerate().take(count) {
                if well {
                    let i = usize::from(place);
                    D::put(results, i, D::get(&second, j));
                    if let Some(slot) = found.get_mut(i) {
                        *slot = true;
                    }
                }
            }
        }
    }
    for (i, _) in (0..here).zip(found.iter()).filter(|(_, found)| !**found) {
        let row = tally.note(i, kernel.one(rows.at(i)), D::nothing());
        D::put(results, i, row);
    }
}

/// [`Element::second`] for the first rows of a spare.
struct Second<K, S: Source, D> {
    /// By value: what a pointer in it points to is then known not to change in the loop.
    kernel: K,
    spare: S::Spare,
    count: usize,
    sink: PhantomData<D>,
}

impl<K, S, D> Pass for Second<K, S, D>
where
    S: Source,
    D: Sink,
    K: Element<S::Row, Output = D::Row>,
{
    type Output = (D::Block, [bool; BLOCK]);

    #[inline(always)]
    fn run(self) -> Self::Output {
        let (mut results, mut found, spare) = (D::block(), [false; BLOCK], self.spare);
        // They are few: one vector will do.
        let width = if cfg!(lanes) { S::WIDTH } else { 1 };
        let count = self.count.div_ceil(width).min(BLOCK / width) * width;
        for i in 0..count {
            let (row, fast) = self.kernel.second(S::row(S::block(&spare), i));
            D::put(&mut results, i, row);
            if let Some(slot) = found.get_mut(i) {
                *slot = fast;
            }
        }
        (results, found)
    }
}
