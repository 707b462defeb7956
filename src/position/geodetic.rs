use core::fmt;

use super::LatLon;
use crate::Real;

/// A geodetic latitude and longitude in degrees, and a height above the ellipsoid in metres.
///
/// The height is measured along the ellipsoid's normal: positive outside, negative inside.
///
/// ```
/// use terrella::{Geodetic, LatLon};
/// let chimborazo = Geodetic::new(LatLon::new(-1.469, -78.817)?, 6268.0)?;
/// assert_eq!(chimborazo.height(), 6268.0);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[doc(alias("LLA", "geodetic position"))]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Geodetic<T = f64> {
    lat_lon: LatLon<T>,
    height: T,
}

impl<T: Real> Geodetic<T> {
    /// Creates the position of a geodetic latitude and longitude, and a height above the ellipsoid in metres.
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

    /// Creates a position with a height known to be finite.
    #[inline(always)]
    pub(crate) const fn within(lat_lon: LatLon<T>, height: T) -> Self {
        Self { lat_lon, height }
    }

    /// Returns the latitude and longitude.
    #[must_use]
    #[inline(always)]
    pub const fn lat_lon(self) -> LatLon<T> {
        self.lat_lon
    }

    /// Returns the geodetic latitude in degrees, in [−90, 90].
    #[must_use]
    #[inline(always)]
    pub const fn lat(self) -> T {
        self.lat_lon.lat()
    }

    /// Returns the longitude in degrees, in [−180, 180].
    #[must_use]
    #[inline(always)]
    pub const fn lon(self) -> T {
        self.lat_lon.lon()
    }

    /// Returns the height above the ellipsoid in metres.
    #[must_use]
    #[inline(always)]
    pub const fn height(self) -> T {
        self.height
    }
}

impl<T: Real> From<LatLon<T>> for Geodetic<T> {
    /// Creates the position on the ellipsoid itself, at height 0.
    #[inline]
    fn from(lat_lon: LatLon<T>) -> Self {
        Self::within(lat_lon, T::ZERO)
    }
}

impl<T: fmt::Display> fmt::Display for Geodetic<T> {
    /// Writes latitude, longitude and height, each with the formatter's options: `-1.469, -78.817, 6268 m`.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.lat_lon.fmt(f)?;
        f.write_str(", ")?;
        self.height.fmt(f)?;
        f.write_str(" m")
    }
}

/// The error for a height that is infinite or NaN.
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
