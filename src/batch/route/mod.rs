//! Rhumb lines over slices.

mod rhumb;

pub use rhumb::{rhumb_area, rhumb_direct, rhumb_inverse};
