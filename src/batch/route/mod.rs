//! Routes and fences, for many places.

mod fence;

pub use fence::{distances, sides};
