//! Closest points of legs to places, on any surface that has [`Legs`](crate::route::Legs), your own included.

mod closest;

pub use closest::{closest, leg_closest, leg_tracks, tracks};
