//! Routes and fences over slices: closest points of legs on any surface that has [`Legs`](crate::route::Legs), your
//! own included; sides of fences; intersections; rhumb lines.

mod closest;
mod fence;
mod intersection;
mod rhumb;

pub use closest::{closest, leg_closest, leg_tracks, tracks};
pub use fence::{distances, sides};
pub use intersection::of_segments;
pub use rhumb::{rhumb_area, rhumb_direct, rhumb_inverse};
