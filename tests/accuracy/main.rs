//! Accuracy
#![allow(
    missing_docs,
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::panic,
    clippy::indexing_slicing
)]

mod cube;
mod kernels;
mod latitude;
mod round_trip;
mod table;
mod truth;
