//! What the programs share: how they are asked and answer, what their pages look like, and how pictures and charts are drawn.

pub mod data;
pub mod ellipsoid;
#[cfg(feature = "pictures")]
pub mod imagery;
pub mod labels;
pub mod outcome;
pub mod page;
pub mod parallel;
#[cfg(feature = "pictures")]
pub mod picture;
#[cfg(feature = "charts")]
pub mod raster;
#[cfg(feature = "charts")]
pub mod svg;
pub mod units;
