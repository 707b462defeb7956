//! Routes and fences, for many places.

mod intersection;

pub use intersection::of_segments;
