//! Grids and their text: transverse Mercator, UTM, UPS and MGRS, azimuthal maps, Web Mercator's tiles, geohashes
//! and plus codes.
//!
//! Latitudes, longitudes and convergences are in degrees, eastings and northings in metres.
//!
//! | type | what it is | worst error on the Earth, `f64` | `f32` |
//! |---|---|---|---|
//! | [`TransverseMercator`] | conformal about a meridian | 5 nm to 6000 km from it | 2.2 m |
//! | [`PolarStereographic`] | conformal about a pole | 2 nm to 2000 km | 0.6 m |
//! | [`Utm`], [`Ups`], [`UtmUps`] | their zones with false origins | 5 nm | 2.2 m |
//! | [`Mgrs`] | UTM and UPS as text | digits are cut | to 0.5 m |
//! | [`LambertAzimuthal`] | equal areas, about a place | 6·10⁻¹⁶ of the distance from it | 4·10⁻⁷ |
//! | [`AzimuthalEquidistant`] | true distances and azimuths from a place | 15 nm | 7 m |
//! | [`Gnomonic`] | geodesics nearly straight | 15 nm on the ground | 7 m |
//!
//! The first three and the equal-area map have no branch that depends on the place:
//! [`batch::grid`](crate::batch::grid) projects whole slices.

mod azimuthal_equidistant;
mod geohash;
mod gnomonic;
mod halves;
mod hemisphere;
mod invalid_map;
mod kruger;
mod lambert_azimuthal;
mod mgrs;
mod mgrs_parse;
mod mgrs_text;
mod outside;
mod outside_grid;
mod outside_mgrs;
mod plus_code;
mod point_scale;
mod polar_stereographic;
mod transverse_mercator;
mod ups;
mod utm;
mod utm_ups;
pub mod web_mercator;
mod zone;

pub use azimuthal_equidistant::AzimuthalEquidistant;
pub use geohash::{Geohash, InvalidGeohash};
pub use gnomonic::Gnomonic;
pub use hemisphere::Hemisphere;
pub use invalid_map::InvalidMap;
pub use lambert_azimuthal::LambertAzimuthal;
pub use mgrs::Mgrs;
pub use mgrs_parse::ParseMgrsError;
pub use mgrs_text::MgrsText;
pub use outside::{NotOnMap, OutsideMap};
pub use outside_grid::OutsideGrid;
pub use outside_mgrs::OutsideMgrs;
pub use plus_code::{InvalidPlusCode, PlusCode, ShortPlusCode};
pub use point_scale::PointScale;
pub use polar_stereographic::PolarStereographic;
pub use transverse_mercator::TransverseMercator;
pub use ups::Ups;
pub use utm::Utm;
pub(crate) use utm::{shifted, unshifted};
pub use utm_ups::UtmUps;
pub use zone::{GridPosition, InvalidZone, Zone};
