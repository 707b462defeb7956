//! The room `route`.
#![allow(
    missing_docs, clippy::unwrap_used, clippy::expect_used, clippy::panic, clippy::indexing_slicing
)] // tests

mod arc;
mod closest;
mod corridor;
mod fence;
mod heading;
mod intersection;
mod passage;
mod paths;
mod rhumb;
