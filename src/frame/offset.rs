use super::{Enu, InvalidEnu, LocalFrame};
use crate::{Aer, Geodetic, Ned, Real};

/// How far a geodetic position is from an origin: in latitude and longitude, in degrees, and in height, in metres.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct GeodeticOffset<T> {
    /// Northward, in degrees, in [−180, 180].
    pub lat: T,
    /// Eastward, in degrees, in [−180, 180].
    pub lon: T,
    /// Upward, in metres.
    pub height: T,
}

impl<T: Real> LocalFrame<T> {
    /// TODO
    ///
    /// # Errors
    /// [`InvalidEnu`] if a component is infinite or NaN.
    pub fn enu_to_geodetic(&self, enu: Enu<T>) -> Result<Geodetic<T>, InvalidEnu<T>> {
        let Enu { east, north, up } = enu;
        let ecef = self.from_enu(enu).map_err(|_| InvalidEnu { east, north, up })?;
        Ok(self.ellipsoid.to_geodetic(ecef))
    }

    /// [`Self::enu_to_geodetic`] from north, east, down.
    ///
    /// # Errors
    /// [`InvalidEnu`] if a component is infinite or NaN.
    pub fn ned_to_geodetic(&self, ned: Ned<T>) -> Result<Geodetic<T>, InvalidEnu<T>> {
        self.enu_to_geodetic(ned.into())
    }

    /// [`Self::enu_to_geodetic`] from azimuth, elevation and range.
    ///
    /// # Errors
    /// [`InvalidEnu`] if azimuth, elevation or range is infinite or NaN, with the components that come of them.
    pub fn aer_to_geodetic(&self, aer: Aer<T>) -> Result<Geodetic<T>, InvalidEnu<T>> {
        self.enu_to_geodetic(aer.into())
    }

    /// TODO
    ///
    /// # Errors
    /// [`InvalidEnu`] if a component is infinite or NaN.
    pub fn enu_to_offset(&self, enu: Enu<T>) -> Result<GeodeticOffset<T>, InvalidEnu<T>> {
        let there = self.enu_to_geodetic(enu)?;
        Ok(GeodeticOffset {
            lat: there.lat() - self.origin.lat(),
            lon: super::turn(self.origin.lon(), there.lon()),
            height: there.height() - self.origin.height(),
        })
    }
}
