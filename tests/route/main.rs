//! The room `route`.
#![allow(
    missing_docs, clippy::unwrap_used, clippy::expect_used, clippy::panic, clippy::indexing_slicing
)] // tests

mod intersection;
mod passage;
