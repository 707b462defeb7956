use core::fmt;

use crate::LatLon;

/// The error for a point that no place is projected to, or that is so far out that the projection has lost
/// its digits.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct OutsideMap<T> {
    /// Metres to the east.
    pub x: T,
    /// Metres to the north.
    pub y: T,
}

impl<T: fmt::Debug> fmt::Display for OutsideMap<T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "point ({:?}, {:?}) is outside the map", self.x, self.y)
    }
}

impl<T: fmt::Debug> core::error::Error for OutsideMap<T> {}

/// The error for a place that a projection does not have.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct NotOnMap<T>(pub LatLon<T>);

impl<T: fmt::Display> fmt::Display for NotOnMap<T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "the map does not reach {}", self.0)
    }
}

impl<T: fmt::Debug + fmt::Display> core::error::Error for NotOnMap<T> {}
