//! The cube: frames, neighbours, numberings, and what every projection keeps on faces, edges and corners.
#![allow(
    missing_docs, clippy::unwrap_used, clippy::expect_used, clippy::panic, clippy::indexing_slicing
)] // a test may fail loudly

mod cells;
mod cost;
mod edges;
mod faces;
mod neighbours;
mod numbering;
mod orientation;
mod places;
mod range;
mod sample;
mod symmetry;
