use core::fmt;

use super::LatLon;
use crate::Real;

/// A geodetic latitude and longitude in degrees, and a height above the ellipsoid in metres.
///
/// The height is along the ellipsoid's normal: positive outside, negative inside.
///
/// ```
/// use terrella::{Geodetic, LatLon};
/// let chimborazo = Geodetic::new(LatLon::new(-1.469, -78.817)?, 6268.0)?;
/// assert_eq!(chimborazo.height(), 6268.0);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Geodetic<T> {
    lat_lon: LatLon<T>,
    height: T,
}

impl<T: Real> Geodetic<T> {
    /// From a geodetic latitude and longitude, and a height in metres.
    ///
    /// # Errors
    /// [`InvalidHeight`] if the height is infinite or NaN.
    #[inline]
    pub fn new(lat_lon: LatLon<T>, height: T) -> Result<Self, InvalidHeight<T>> {
        if !height.is_finite() {
            return Err(InvalidHeight { height });
        }
        Ok(Self { lat_lon, height })
    }

    /// For a height known to be finite.
    #[inline(always)]
    pub(crate) const fn within(lat_lon: LatLon<T>, height: T) -> Self {
        Self { lat_lon, height }
    }

    /// Latitude and longitude.
    #[must_use]
    #[inline(always)]
    pub fn lat_lon(self) -> LatLon<T> {
        self.lat_lon
    }

    /// Geodetic latitude in degrees, in [−90, 90].
    #[must_use]
    #[inline(always)]
    pub fn lat(self) -> T {
        self.lat_lon.lat()
    }

    /// Longitude in degrees, in [−180, 180].
    #[must_use]
    #[inline(always)]
    pub fn lon(self) -> T {
        self.lat_lon.lon()
    }

    /// Height above the ellipsoid in metres.
    #[must_use]
    #[inline(always)]
    pub fn height(self) -> T {
        self.height
    }
}

impl<T: Real> From<LatLon<T>> for Geodetic<T> {
    /// The point of the ellipsoid itself, at height 0.
    #[inline]
    fn from(lat_lon: LatLon<T>) -> Self {
        Self::within(lat_lon, T::ZERO)
    }
}

/// A height that is infinite or not a number.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct InvalidHeight<T> {
    /// The height.
    pub height: T,
}

impl<T: fmt::Debug> fmt::Display for InvalidHeight<T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "height {:?} is not finite", self.height)
    }
}

impl<T: fmt::Debug> core::error::Error for InvalidHeight<T> {}
