//! Optional conversions to and from other crates: nothing here changes a result.

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
