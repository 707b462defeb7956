use core::fmt;

use super::Zone;

/// Why UTM or UPS has no such position.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum OutsideGrid<T> {
    /// The latitude is beyond UTM's 80° S to 84° N, or farther than 20° from the poles of UPS.
    Latitude(T),
    /// The longitude is more than 60° from the zone's central meridian.
    Longitude(T),
    /// The easting is outside the limits.
    Easting(T),
    /// The northing is outside the limits.
    Northing(T),
    /// The zone is UPS's and not UTM's, or the other way round.
    Zone(Zone),
}

impl<T: fmt::Debug> fmt::Display for OutsideGrid<T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Latitude(lat) => write!(f, "latitude {lat:?} is outside the grid"),
            Self::Longitude(lon) => write!(f, "longitude {lon:?} is more than 60 degrees from the zone's meridian"),
            Self::Easting(easting) => write!(f, "easting {easting:?} is outside the grid"),
            Self::Northing(northing) => write!(f, "northing {northing:?} is outside the grid"),
            Self::Zone(zone) => write!(f, "zone {zone} is not of this grid"),
        }
    }
}

impl<T: fmt::Debug> core::error::Error for OutsideGrid<T> {}
