use core::fmt;

use super::{Mgrs, OutsideGrid};

/// Why MGRS has no square for a position.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum OutsideMgrs<T> {
    /// UTM or UPS has no such position.
    Grid(OutsideGrid<T>),
    /// The easting is outside the limits.
    Easting(T),
    /// The northing is outside the limits.
    Northing(T),
    /// The latitude's band is not that of the northing.
    Latitude(T),
    /// The precision is above 11.
    Precision(u8),
}

impl<T: fmt::Debug> fmt::Display for OutsideMgrs<T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Grid(why) => why.fmt(f),
            Self::Easting(easting) => write!(f, "easting {easting:?} is outside of MGRS"),
            Self::Northing(northing) => write!(f, "northing {northing:?} is outside of MGRS"),
            Self::Latitude(lat) => write!(f, "latitude {lat:?} is not that of the northing"),
            Self::Precision(precision) => write!(f, "precision {precision} is above {}", Mgrs::MAX_PRECISION),
        }
    }
}

impl<T: fmt::Debug> core::error::Error for OutsideMgrs<T> {}
