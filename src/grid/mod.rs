//! Grids and their text: transverse Mercator, UTM, UPS and MGRS, azimuthal maps, Web Mercator's tiles, geohashes
//! and plus codes.
//!
//! Latitudes, longitudes and convergences are in degrees, eastings and northings in metres.

mod azimuthal_equidistant;
mod gnomonic;
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
mod point_scale;
mod polar_stereographic;
mod transverse_mercator;
mod ups;
mod utm;
mod utm_ups;
mod zone;

pub use azimuthal_equidistant::AzimuthalEquidistant;
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
pub use point_scale::PointScale;
pub use polar_stereographic::PolarStereographic;
pub use transverse_mercator::TransverseMercator;
pub use ups::Ups;
pub use utm::Utm;
pub(crate) use utm::{shifted, unshifted};
pub use utm_ups::UtmUps;
pub use zone::{GridPosition, InvalidZone, Zone};
