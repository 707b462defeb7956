use super::zone::band;
use super::{GridPosition, Hemisphere, OutsideGrid, PointScale, TransverseMercator, Zone};
use crate::geodesic::nearly_round;
use crate::latitude::UnsupportedFlattening;
use crate::{Ellipsoid, LatLon, Real};

/// Universal Transverse Mercator: sixty zones of six degrees of longitude, from 80° S to 84° N.
///
/// The scale on central meridians is 0.9996. Eastings there are 500 000 m; northings on the equator are 0 in
/// the north and 10 000 000 m in the south.
///
/// Limits, which are those of GeographicLib's `UTMUPS`: eastings 0 to 1 000 000 m, northings −9 100 000 to
/// 9 600 000 m (north) or 900 000 to 19 600 000 m (south), longitudes within 60° of the central meridian.
/// [`Mgrs`](super::Mgrs) has narrower ones.
///
/// Worst error on the Earth: easting, northing and place 5 nm. In `f32` the easting 0.2 m, the northing and the
/// place 2.2 m: the northing is rounded to 0.5 m.
///
/// ```
/// use terrella::grid::{Hemisphere, Utm, Zone};
/// use terrella::{Ellipsoid, LatLon};
/// let utm = Utm::new(Ellipsoid::WGS84)?;
/// let oslo = LatLon::new(59.91_f64, 10.75)?;
/// let here = utm.forward(oslo)?;
/// assert_eq!(format!("{here:.3}"), "32n 597868.381 6642681.510");
/// // The neighbouring zone, asked for:
/// assert_eq!(format!("{:.3}", utm.in_zone(Zone::new(33)?, oslo)?), "33n 262409.732 6649017.749");
/// assert!((utm.inverse(here)?.lat() - 59.91).abs() < 1e-13);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Utm<T> {
    map: TransverseMercator<T>,
}

/// Metres on the central meridian of a zone.
pub(crate) const FALSE_EASTING: f64 = 5e5;
/// Metres on the equator, in the south.
pub(crate) const FALSE_NORTHING: f64 = 1e7;

impl<T: Real> Utm<T> {
    /// Makes the grid of an ellipsoid.
    ///
    /// # Errors
    /// [`UnsupportedFlattening`] if |f| > 1/60.
    pub fn new(ellipsoid: Ellipsoid<T>) -> Result<Self, UnsupportedFlattening<T>> {
        let map = TransverseMercator::within(nearly_round(ellipsoid)?, T::of(0.9996), T::ZERO);
        Ok(Self { map })
    }

    /// Returns the ellipsoid.
    #[must_use]
    pub fn ellipsoid(&self) -> Ellipsoid<T> {
        self.map.ellipsoid()
    }

    /// Returns a zone's projection, without false origins; none for [`Zone::POLAR`].
    #[must_use]
    pub fn zone(&self, zone: Zone) -> Option<TransverseMercator<T>> {
        zone.meridian().map(|meridian| self.map.about(meridian))
    }

    /// Returns the position of a place in its own zone, which [`Zone::of`] tells.
    ///
    /// # Errors
    /// [`OutsideGrid::Latitude`] from 84° north and south of 80° south.
    pub fn forward(&self, place: LatLon<T>) -> Result<GridPosition<T>, OutsideGrid<T>> {
        self.in_zone(Zone::of(place), place)
    }

    /// Returns the position of a place in a zone that need not be its own. The hemisphere is that of the
    /// latitude's sign: −0 is in the south.
    ///
    /// # Errors
    /// [`OutsideGrid`] if the place is too far from the zone, or the zone is [`Zone::POLAR`].
    pub fn in_zone(&self, zone: Zone, place: LatLon<T>) -> Result<GridPosition<T>, OutsideGrid<T>> {
        let map = self.map_of(zone, place)?;
        let hemisphere = Hemisphere::of(place.lat());
        let [x, y] = map.forward(place);
        let [easting, northing] = shifted(hemisphere, [x, y]);
        check(hemisphere, [easting, northing])?;
        Ok(GridPosition::new(zone, hemisphere, easting, northing))
    }

    /// Returns the place of a position.
    ///
    /// # Errors
    /// [`OutsideGrid`] if easting or northing is outside the limits, or the zone is [`Zone::POLAR`].
    pub fn inverse(&self, position: GridPosition<T>) -> Result<LatLon<T>, OutsideGrid<T>> {
        let GridPosition {
            zone,
            hemisphere,
            easting,
            northing,
        } = position;
        let map = self.zone(zone).ok_or(OutsideGrid::Zone(zone))?;
        check(hemisphere, [easting, northing])?;
        map.inverse(unshifted(hemisphere, [easting, northing]))
            .map_err(|_| OutsideGrid::Northing(northing))
    }

    /// Returns the convergence of meridians and the scale of a zone at a place: those of
    /// [`TransverseMercator::point_scale`].
    ///
    /// # Errors
    /// [`OutsideGrid`] if the place is more than 60° from the central meridian, or the zone is [`Zone::POLAR`].
    pub fn point_scale(&self, zone: Zone, place: LatLon<T>) -> Result<PointScale<T>, OutsideGrid<T>> {
        Ok(self.map_of(zone, place)?.point_scale(place))
    }

    /// The projection of a zone that a place is not too far from.
    fn map_of(&self, zone: Zone, place: LatLon<T>) -> Result<TransverseMercator<T>, OutsideGrid<T>> {
        let Some(map) = self.zone(zone) else {
            let own = zone == Zone::of(place);
            return Err(if own {
                OutsideGrid::Latitude(place.lat())
            } else {
                OutsideGrid::Zone(zone)
            });
        };
        let step = (place.lon() - map.meridian()).abs();
        if step > T::of(60.0) && step < T::of(300.0) {
            return Err(OutsideGrid::Longitude(place.lon()));
        }
        Ok(map)
    }
}

/// With false origins.
#[inline(always)]
pub(crate) fn shifted<T: Real>(hemisphere: Hemisphere, [x, y]: [T; 2]) -> [T; 2] {
    [x + T::of(FALSE_EASTING), y + false_northing(hemisphere)]
}

/// Without false origins.
#[inline(always)]
pub(crate) fn unshifted<T: Real>(hemisphere: Hemisphere, [easting, northing]: [T; 2]) -> [T; 2] {
    [easting - T::of(FALSE_EASTING), northing - false_northing(hemisphere)]
}

#[inline(always)]
fn false_northing<T: Real>(hemisphere: Hemisphere) -> T {
    match hemisphere {
        Hemisphere::North => T::ZERO,
        Hemisphere::South => T::of(FALSE_NORTHING),
    }
}

/// Refuses what is outside the limits.
fn check<T: Real>(hemisphere: Hemisphere, [easting, northing]: [T; 2]) -> Result<(), OutsideGrid<T>> {
    if !(T::ZERO..=T::of(1e6)).contains(&easting) {
        return Err(OutsideGrid::Easting(easting));
    }
    let north = match hemisphere {
        Hemisphere::North => T::of(-9.1e6)..=T::of(9.6e6),
        Hemisphere::South => T::of(9e5)..=T::of(1.96e7),
    };
    if north.contains(&northing) {
        Ok(())
    } else {
        Err(OutsideGrid::Northing(northing))
    }
}

/// The letters' band of a latitude in a hemisphere: next to the equator the northing decides.
pub(super) fn band_in<T: Real>(hemisphere: Hemisphere, lat: T) -> i8 {
    let band = band(lat);
    match hemisphere {
        Hemisphere::North => band.max(0),
        Hemisphere::South => band.min(-1),
    }
}
