//! The properties of `tests/properties`, for the fuzz targets.

#[path = "../../tests/properties/batch.rs"]
pub mod batch;
#[path = "../../tests/properties/bytes.rs"]
pub mod bytes;
#[path = "../../tests/properties/double.rs"]
pub mod double;
#[path = "../../tests/properties/edges.rs"]
pub mod edges;
#[path = "../../tests/properties/geodesic.rs"]
pub mod geodesic;
#[path = "../../tests/properties/nearest.rs"]
mod nearest;
#[path = "../../tests/properties/position.rs"]
pub mod position;
#[path = "../../tests/properties/projection.rs"]
pub mod projection;
#[path = "../../tests/properties/property.rs"]
pub mod property;
#[path = "../../tests/properties/reference.rs"]
pub mod reference;
#[path = "../../tests/properties/scalar.rs"]
pub mod scalar;
#[allow(dead_code)]
#[path = "../../tests/accuracy/table.rs"]
mod table;
#[allow(dead_code)]
#[path = "../../tests/cube/unfolded.rs"]
mod unfolded;
#[path = "../../tests/properties/validation.rs"]
pub mod validation;
#[path = "../../tests/properties/vector.rs"]
pub mod vector;
