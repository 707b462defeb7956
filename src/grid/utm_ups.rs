use super::{GridPosition, OutsideGrid, PointScale, Ups, Utm, Zone};
use crate::latitude::UnsupportedFlattening;
use crate::{Ellipsoid, LatLon, Real};

/// UTM and UPS together: every place has a position.
///
/// Limits and errors are those of [`Utm`] and [`Ups`].
///
/// ```
/// use terrella::grid::{UtmUps, Zone};
/// use terrella::{Ellipsoid, LatLon};
/// let grid = UtmUps::new(Ellipsoid::<f64>::WGS84)?;
/// let pole = grid.forward(LatLon::new(-90.0, 0.0)?)?;
/// assert_eq!((pole.zone, format!("{pole}")), (Zone::POLAR, "0s 2000000 2000000".into()));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct UtmUps<T> {
    utm: Utm<T>,
    ups: Ups<T>,
}

impl<T: Real> UtmUps<T> {
    /// Makes the grids of an ellipsoid.
    ///
    /// # Errors
    /// [`UnsupportedFlattening`] if |f| > 1/60.
    pub fn new(ellipsoid: Ellipsoid<T>) -> Result<Self, UnsupportedFlattening<T>> {
        Ok(Self {
            utm: Utm::new(ellipsoid)?,
            ups: Ups::new(ellipsoid)?,
        })
    }

    /// Returns the ellipsoid.
    #[must_use]
    pub fn ellipsoid(&self) -> Ellipsoid<T> {
        self.utm.ellipsoid()
    }

    /// Returns the position of a place in its own zone, which [`Zone::of`] tells.
    ///
    /// # Errors
    /// None on ellipsoids like the Earth's. On much larger ones [`OutsideGrid`], as limits are in metres.
    pub fn forward(&self, place: LatLon<T>) -> Result<GridPosition<T>, OutsideGrid<T>> {
        self.in_zone(Zone::of(place), place)
    }

    /// Returns the position of a place in a zone that need not be its own.
    ///
    /// # Errors
    /// Those of [`Utm::in_zone`], or of [`Ups::forward`] for [`Zone::POLAR`].
    pub fn in_zone(&self, zone: Zone, place: LatLon<T>) -> Result<GridPosition<T>, OutsideGrid<T>> {
        if zone == Zone::POLAR {
            self.ups.forward(place)
        } else {
            self.utm.in_zone(zone, place)
        }
    }

    /// Returns the place of a position.
    ///
    /// # Errors
    /// [`OutsideGrid`] if easting or northing is outside the limits.
    pub fn inverse(&self, position: GridPosition<T>) -> Result<LatLon<T>, OutsideGrid<T>> {
        if position.zone == Zone::POLAR {
            self.ups.inverse(position)
        } else {
            self.utm.inverse(position)
        }
    }

    /// Returns the convergence of meridians and the scale of a zone at a place.
    ///
    /// # Errors
    /// Those of [`Utm::point_scale`], or of [`Ups::point_scale`] for [`Zone::POLAR`].
    pub fn point_scale(&self, zone: Zone, place: LatLon<T>) -> Result<PointScale<T>, OutsideGrid<T>> {
        if zone == Zone::POLAR {
            self.ups.point_scale(place)
        } else {
            self.utm.point_scale(zone, place)
        }
    }
}
