//! The functions of the other rooms over slices.

mod widest;

pub(crate) use widest::{Pass, widest};
