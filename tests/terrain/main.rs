//! Terrain: tiles and their addresses.
#![allow(
    missing_docs, clippy::unwrap_used, clippy::expect_used, clippy::panic, clippy::indexing_slicing
)] // a test may fail loudly

mod bounds;
mod cover;
mod edges;
mod heights;
mod horizon;
mod keys;
mod neighbours;
mod oblique;
mod patch;
mod relative;
mod reports;
mod s2;
mod sample;
mod scene;
mod selection;
mod sight;
mod solid_angle;
mod tile;
mod vector;
mod visible;
