//! Optional conversions to and from other crates: nothing here changes a result.

#[cfg(feature = "glam")]
mod glam;
#[cfg(feature = "num-traits")]
mod num_traits;
#[cfg(feature = "serde")]
mod serde;
