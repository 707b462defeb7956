//! Routes and fields: legs, closest points, intersections, rhumb lines, rings and fences.
//!
//! Latitudes, longitudes and azimuths are in degrees, lengths in metres.

mod densified;
mod intersection;
mod segment;
mod waypoints;

pub use densified::Densified;
pub use intersection::{Intersection, Intersections, IntersectionsWithin, Overlap};
pub use segment::Segment;
pub use waypoints::{InvalidStep, Waypoints};
