use super::{GridPosition, Hemisphere, OutsideGrid, PointScale, PolarStereographic, Zone};
use crate::latitude::{UnsupportedFlattening, supported};
use crate::{Ellipsoid, LatLon, Real, Shift};

/// Universal Polar Stereographic: the grid of the polar regions, from 84° N and from 80° S to the poles.
///
/// The scale at the poles is 0.994, their easting and northing are 2 000 000 m.
///
/// Limits, which are those of GeographicLib's `UTMUPS`: eastings and northings 1 200 000 to 2 800 000 m in the
/// north, 700 000 to 3 300 000 m in the south; latitudes from 70°. [`Mgrs`](super::Mgrs) has narrower ones.
///
/// Worst error on the Earth: 2 nm (`f32`: 0.6 m).
///
/// ```
/// use terrella::grid::Ups;
/// use terrella::{Ellipsoid, LatLon};
/// let ups = Ups::new(Ellipsoid::WGS84)?;
/// let here = ups.forward(LatLon::new(84.287_23_f64, -132.247_998)?)?;
/// assert_eq!(format!("{here:.0}"), "0n 1530126 2426774");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Ups<T> {
    map: PolarStereographic<T>,
}

/// Metres at the pole.
const POLE: f64 = 2e6;

impl<T: Real> Ups<T> {
    /// Makes the grid of an ellipsoid.
    ///
    /// # Errors
    /// [`UnsupportedFlattening`] if the third flattening is outside of ±1/19.
    pub fn new(ellipsoid: Ellipsoid<T>) -> Result<Self, UnsupportedFlattening<T>> {
        let ellipsoid = supported(ellipsoid, Shift::Conformal)?;
        let map = PolarStereographic::within(ellipsoid, T::of(0.994));
        Ok(Self { map })
    }

    /// Returns the ellipsoid.
    #[must_use]
    pub fn ellipsoid(&self) -> Ellipsoid<T> {
        self.map.ellipsoid()
    }

    /// Returns the position of a place, in the hemisphere of its latitude's sign.
    ///
    /// # Errors
    /// [`OutsideGrid::Latitude`] if it is farther than 20° from the pole.
    pub fn forward(&self, place: LatLon<T>) -> Result<GridPosition<T>, OutsideGrid<T>> {
        let hemisphere = reached(place)?;
        let [x, y] = self.map.forward(hemisphere, place);
        let [easting, northing] = [x + T::of(POLE), y + T::of(POLE)];
        check(hemisphere, [easting, northing])?;
        Ok(GridPosition::new(Zone::POLAR, hemisphere, easting, northing))
    }

    /// Returns the place of a position.
    ///
    /// # Errors
    /// [`OutsideGrid`] if easting or northing is outside the limits, or the zone is not [`Zone::POLAR`].
    pub fn inverse(&self, position: GridPosition<T>) -> Result<LatLon<T>, OutsideGrid<T>> {
        let GridPosition {
            zone,
            hemisphere,
            easting,
            northing,
        } = position;
        if zone != Zone::POLAR {
            return Err(OutsideGrid::Zone(zone));
        }
        check(hemisphere, [easting, northing])?;
        self.map
            .inverse(hemisphere, [easting - T::of(POLE), northing - T::of(POLE)])
            .map_err(|_| OutsideGrid::Northing(northing))
    }

    /// Returns the convergence of meridians and the scale at a place: those of
    /// [`PolarStereographic::point_scale`].
    ///
    /// # Errors
    /// [`OutsideGrid::Latitude`] if it is farther than 20° from the pole.
    pub fn point_scale(&self, place: LatLon<T>) -> Result<PointScale<T>, OutsideGrid<T>> {
        Ok(self.map.point_scale(reached(place)?, place))
    }
}

/// The hemisphere of a place that is not too far from the pole.
fn reached<T: Real>(place: LatLon<T>) -> Result<Hemisphere, OutsideGrid<T>> {
    if place.lat().abs() < T::of(70.0) {
        Err(OutsideGrid::Latitude(place.lat()))
    } else {
        Ok(Hemisphere::of(place.lat()))
    }
}

/// Refuses what is outside the limits.
fn check<T: Real>(hemisphere: Hemisphere, [easting, northing]: [T; 2]) -> Result<(), OutsideGrid<T>> {
    let range = match hemisphere {
        Hemisphere::North => T::of(1.2e6)..=T::of(2.8e6),
        Hemisphere::South => T::of(7e5)..=T::of(3.3e6),
    };
    if !range.contains(&easting) {
        return Err(OutsideGrid::Easting(easting));
    }
    if !range.contains(&northing) {
        return Err(OutsideGrid::Northing(northing));
    }
    Ok(())
}
