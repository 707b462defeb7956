//! Worst errors against the truth in `tests/truth`: the figures of `table.rs`, held one by one.
#![allow(
    missing_docs, clippy::unwrap_used, clippy::expect_used, clippy::panic, clippy::indexing_slicing
)] // tests

mod cube;
mod kernels;
mod latitude;
mod position;
mod round_trip;
