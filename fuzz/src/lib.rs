//! The laws of `tests/laws`, for the fuzz targets.

#[path = "../../tests/laws/batch.rs"]
pub mod batch;
#[path = "../../tests/laws/bytes.rs"]
pub mod bytes;
#[path = "../../tests/laws/doors.rs"]
pub mod doors;
#[path = "../../tests/laws/double.rs"]
pub mod double;
#[path = "../../tests/laws/edges.rs"]
pub mod edges;
#[path = "../../tests/laws/geodesic.rs"]
pub mod geodesic;
#[path = "../../tests/laws/law.rs"]
pub mod law;
#[path = "../../tests/laws/nearest.rs"]
mod nearest;
#[path = "../../tests/laws/position.rs"]
pub mod position;
#[path = "../../tests/laws/projection.rs"]
pub mod projection;
#[path = "../../tests/laws/reference.rs"]
pub mod reference;
#[path = "../../tests/laws/scalar.rs"]
pub mod scalar;
#[allow(dead_code)]
#[path = "../../tests/accuracy/table.rs"]
mod table;
#[allow(dead_code)]
#[path = "../../tests/cube/unfolded.rs"]
mod unfolded;
#[path = "../../tests/laws/vector.rs"]
pub mod vector;
