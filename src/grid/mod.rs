//! Grids and their text: transverse Mercator, UTM, UPS and MGRS, azimuthal maps, Web Mercator's tiles, geohashes
//! and plus codes.
//!
//! Latitudes, longitudes and convergences are in degrees, eastings and northings in metres.

mod geohash;
mod halves;
mod plus_code;
pub mod web_mercator;

pub use geohash::{Geohash, InvalidGeohash};
pub use plus_code::{InvalidPlusCode, PlusCode, ShortPlusCode};
