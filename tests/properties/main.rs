//! Laws that hold for any input, each defined once: here proptest looks for what breaks them, in `fuzz/` libFuzzer does.
#![allow(
    missing_docs, clippy::unwrap_used, clippy::expect_used, clippy::panic, clippy::indexing_slicing
)] // tests

#[cfg(test)]
mod areas;
pub mod batch;
pub mod edges;
pub mod geodesic;
#[cfg(test)]
mod harness;
pub mod position;
pub mod projection;
pub mod reference;
#[cfg(test)]
mod slices;
pub mod validation;
