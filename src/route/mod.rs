//! Routes and fields: legs, closest points, intersections, rhumb lines, rings and fences.
//!
//! Latitudes, longitudes and azimuths are in degrees, lengths in metres.

mod arc;
mod corridor;
mod edge;
mod fence;
mod globe;
mod planar;
mod side;

pub use arc::{Arc, InvalidArc, Turn};
pub use corridor::{Corridor, Outline};
pub use edge::{Crossing, EdgeCrossing, EdgeDistance};
pub use fence::Fence;
pub use planar::Planar;
pub use side::Side;
