//! Optional conversions to and from other crates: nothing here changes a result.

#[cfg(feature = "glam")]
mod glam;
#[cfg(feature = "serde")]
mod serde;
