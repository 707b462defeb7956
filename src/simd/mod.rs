//! The loop over slices that surveys, patches and batches run, and the choice of the machine's instructions
//! for it.

mod dispatch;
mod sweep;

pub(crate) use dispatch::{Pass, dispatch};
pub(crate) use sweep::{BLOCK, CHUNK, Kernel, Sink, Source, block, element, front, store, sweep};
