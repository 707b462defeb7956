//! Routes and fields: legs, closest points, intersections, rhumb lines, rings and fences.
//!
//! Latitudes, longitudes and azimuths are in degrees, lengths in metres.

pub mod heading;
mod rhumb;

pub use rhumb::{Rhumb, RhumbEnd, RhumbInverse, RhumbLine};
