//! Optional conversions to and from the types of other crates. They change no result of this crate.

#[cfg(feature = "geo-types")]
mod geo_types;
#[cfg(feature = "glam")]
mod glam;
#[cfg(feature = "mint")]
mod mint;
#[cfg(feature = "nalgebra")]
mod nalgebra;
#[cfg(feature = "num-traits")]
mod num_traits;
#[cfg(feature = "serde")]
mod serde;
