//! The loop over columns that surveys, patches and batches run, and the choice of the machine's instructions
//! for it.

mod columns;
mod dispatch;
mod lanes;

pub(crate) use columns::{BLOCK, Same, Sink, Source, block, front, head, push, store};
pub(crate) use lanes::{Behind, CHUNK, Door, Element, FEW, Kernel, Tally, lanes, sweep};
