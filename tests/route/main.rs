//! The room `route`.
#![allow(
    missing_docs, clippy::unwrap_used, clippy::expect_used, clippy::panic, clippy::indexing_slicing
)] // tests

mod heading;
mod rhumb;
mod closest;
mod paths;
mod arc;
mod corridor;
mod fence;
