//! The properties of `tests/properties`, for the fuzz targets.

// The one file that two crates compile: under `cargo test` each property becomes a test of the library, here it does not.
#[path = "../../tests/properties/main.rs"]
mod properties;

pub use properties::{batch, edges, geodesic, position, projection, validation};
pub use testkit::property;
