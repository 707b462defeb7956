//! Routes and fields: legs, closest points, intersections, rhumb lines, rings and fences.
//!
//! Latitudes, longitudes and azimuths are in degrees, lengths in metres.

mod arc;
mod corridor;
mod fence;
mod globe;
mod ground;
mod planar;
mod side;

pub use arc::{Arc, InvalidArc, Turn};
pub use corridor::{Corridor, Outline};
pub use fence::Fence;
pub use ground::{Crossing, EdgeDistance, Ground};
pub use planar::Planar;
pub use side::Side;
