//! The room `grid`.
#![allow(
    missing_docs, clippy::unwrap_used, clippy::expect_used, clippy::panic, clippy::indexing_slicing
)] // tests

mod geohash;
mod plus_code;
mod web_mercator;
