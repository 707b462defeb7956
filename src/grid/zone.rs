use core::fmt;

use super::Hemisphere;
use crate::{LatLon, Real};

/// A zone of UTM, 1 to 60, or the polar regions of UPS, whose number is 0.
///
/// ```
/// use terrella::LatLon;
/// use terrella::grid::Zone;
/// let bergen = Zone::of(LatLon::new(60.39, 5.32)?);
/// assert_eq!((bergen.number(), bergen.meridian::<f64>()), (32, Some(9.0)));
/// assert_eq!(Zone::of(LatLon::new(84.0, 5.32)?), Zone::POLAR);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Zone(u8);

impl Zone {
    /// The polar regions.
    pub const POLAR: Self = Self(0);

    /// Creates the zone of a number, 0 for the polar regions.
    ///
    /// # Errors
    /// [`InvalidZone`] if the number is above 60.
    pub const fn new(number: u8) -> Result<Self, InvalidZone> {
        if number <= 60 {
            Ok(Self(number))
        } else {
            Err(InvalidZone(number))
        }
    }

    /// For a number known to be at most 60.
    pub(super) const fn within(number: u8) -> Self {
        Self(number)
    }

    /// Returns the zone that a place belongs to: [`POLAR`](Self::POLAR) from 84° north and south of 80° south,
    /// else one of six degrees of longitude, with the exceptions of Norway (32 from 3° E, 56° to 64° N) and
    /// Svalbard (31, 33, 35 and 37 from 0° to 42° E, 72° to 84° N).
    ///
    /// A place on a border belongs to the zone to the east, and to the band to the north; 180° is −180°.
    #[must_use]
    #[doc(alias = "StandardZone")]
    pub fn of<T: Real>(place: LatLon<T>) -> Self {
        let lat = place.lat();
        let utm = lat < T::of(84.0) && lat >= T::of(-80.0);
        if !utm {
            return Self::POLAR;
        }
        let floor = place.lon().floor();
        let lon = if floor == 180 { -180 } else { floor };
        let zone = match (band(lat), lon) {
            (7, 3..6) => 32,
            (9, 0..42) => 2 * ((lon + 183) / 12) + 1,
            _ => (lon + 186) / 6,
        };
        Self(zone as u8)
    }

    /// Returns the number, 0 to 60.
    #[must_use]
    pub const fn number(self) -> u8 {
        self.0
    }

    /// Returns the longitude of the central meridian in degrees, unless this is [`POLAR`](Self::POLAR).
    #[must_use]
    pub fn meridian<T: Real>(self) -> Option<T> {
        let (east, west) = (T::whole(6 * u64::from(self.0)), T::of(183.0));
        (self != Self::POLAR).then_some(east - west)
    }
}

/// The band of eight degrees of latitude that a latitude is in, −10 to 9: the last one goes to the poles.
pub(super) fn band<T: Real>(lat: T) -> i8 {
    (lat.floor().div_euclid(8)).clamp(-10, 9) as i8
}

/// Writes the number.
impl fmt::Display for Zone {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.fmt(f)
    }
}

/// The error for a number that is not 0 to 60.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct InvalidZone(pub u8);

impl fmt::Display for InvalidZone {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "zone {} is not in 0 to 60", self.0)
    }
}

impl core::error::Error for InvalidZone {}

/// A place as a zone of UTM or UPS gives it: easting and northing in metres, with their false origins.
///
/// ```
/// use terrella::grid::{GridPosition, Hemisphere, Zone};
/// let here = GridPosition::new(Zone::new(32)?, Hemisphere::North, 597_978.25, 6_643_156.5);
/// assert_eq!(format!("{here}, {here:.0}"), "32n 597978.25 6643156.5, 32n 597978 6643156");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct GridPosition<T> {
    /// The zone.
    pub zone: Zone,
    /// The hemisphere that the northing is counted in. In UTM either will do: across the equator, northings run
    /// on.
    pub hemisphere: Hemisphere,
    /// Metres to the east, 500 000 on the central meridian of a zone, 2 000 000 at a pole.
    pub easting: T,
    /// Metres to the north, on the equator 0 (north) or 10 000 000 (south), 2 000 000 at a pole.
    pub northing: T,
}

impl<T> GridPosition<T> {
    /// Makes a position of its parts. Whether there is such a place, the projection says.
    #[must_use]
    pub const fn new(zone: Zone, hemisphere: Hemisphere, easting: T, northing: T) -> Self {
        Self {
            zone,
            hemisphere,
            easting,
            northing,
        }
    }
}

/// Writes zone, hemisphere, easting and northing, with the formatter's options: `32n 597978.25 6643156.5`.
impl<T: fmt::Display> fmt::Display for GridPosition<T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}{} ", self.zone, self.hemisphere)?;
        self.easting.fmt(f)?;
        f.write_str(" ")?;
        self.northing.fmt(f)
    }
}
