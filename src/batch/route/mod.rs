//! Rhumb lines over slices.

mod rhumb;

pub use rhumb::{rhumb_area, rhumb_direct, rhumb_inverse};
//! Closest points of legs to places, on any surface that has [`Legs`](crate::route::Legs), your own included.

mod closest;

pub use closest::{closest, leg_closest, leg_tracks, tracks};
//! Routes and fences, for many places.

mod fence;

pub use fence::{distances, sides};
