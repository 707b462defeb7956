//! Tiles of places, their keys, and the places of their samples.

mod key;
mod samples;
mod tile;

pub use key::{directions_to_key, from_key, places_to_key, s2_leaf, to_key};
pub use samples::{sample_directions, sample_places};
pub use tile::{InvalidTiled, containing};
