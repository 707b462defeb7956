//! Laws that hold for any input, each defined once: here random bytes try them, in `fuzz/` libFuzzer looks for what breaks them.
#![allow(
    missing_docs, clippy::unwrap_used, clippy::expect_used, clippy::panic, clippy::indexing_slicing
)] // tests

#[cfg(test)]
mod areas;
pub mod edges;
pub mod fences;
pub mod geodesic;
pub mod grid;
pub mod healpix;
pub mod intersections;
pub mod legs;
pub mod position;
pub mod projection;
pub mod reference;
pub mod rhumb;
pub mod text;
pub mod validation;
