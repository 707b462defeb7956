use crate::LatLon;

/// Where a place is along a leg: which part of the leg its closest point is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Reach {
    /// The closest point is the start, and the place is behind it.
    BeforeStart,
    /// The closest point is a point of the leg at which the way to the place leaves the leg at a right angle,
    /// or the place is on the leg.
    Within,
    /// The closest point is the end, and the place is past it.
    PastEnd,
}

/// The point of a leg that is closest to a place.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[doc(alias("foot", "interception", "projection"))]
pub struct Closest<T> {
    /// The distance in metres from the place to the leg, not negative.
    pub distance: T,
    /// The closest point.
    pub position: LatLon<T>,
    /// The distance in metres from the start along the leg to that point, from 0 to the leg's length.
    pub along: T,
    /// Whether that point is an end of the leg.
    pub reach: Reach,
}

/// Where a place is beside the whole line of a leg, which goes on behind the start and past the end.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[doc(alias("cross track", "along track"))]
pub struct Track<T> {
    /// The distance in metres from the line: positive to the right of the way from start to end, negative to
    /// the left.
    pub across: T,
    /// The distance in metres from the start along the line to its closest point, negative behind the start.
    pub along: T,
}

/// The point of a polyline or a ring that is closest to a place.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct OnPath<T> {
    /// The number of the leg, from 0. The leg that closes a ring is the last one.
    pub leg: usize,
    /// The closest point of that leg.
    pub closest: Closest<T>,
}
