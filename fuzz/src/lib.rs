//! The properties of `tests/properties` and `crates/slices`, for the fuzz targets.

// The files that two crates compile: under `cargo test` each property becomes a test of the library, here it does not.
#[path = "../../crates/slices/tests/slices/batch/mod.rs"]
pub mod batch;
#[path = "../../tests/properties/main.rs"]
mod properties;

pub use properties::{
    edges, fences, geodesic, grid, healpix, intersections, legs, position, projection, rhumb, text, validation,
};
pub use testkit::property;
