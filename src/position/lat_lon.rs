use core::fmt;

use super::Direction;
use crate::Real;
use crate::math::sin_cos_degrees;

/// A latitude in [−90, 90] and a longitude in [−180, 180], both in degrees.
///
/// Which latitude it is (geodetic, geocentric, …) is said by whoever takes or gives it.
///
/// ```
/// use terrella::LatLon;
/// let oslo = LatLon::new(59.91, 10.75)?;
/// assert_eq!(LatLon::new(59.91, 370.75)?.lon(), oslo.lon());
/// # Ok::<(), terrella::InvalidLatLon<f64>>(())
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct LatLon<T> {
    lat: T,
    lon: T,
}

impl<T: Real> LatLon<T> {
    /// From a latitude and a longitude in degrees.
    ///
    /// A longitude in [−180, 180] is kept as it is, −180 and 180 both; any other is wrapped, exactly.
    ///
    /// # Errors
    /// [`InvalidLatLon::Latitude`] if |lat| > 90 or NaN, [`InvalidLatLon::Longitude`] if lon is infinite or NaN.
    #[inline]
    pub fn new(lat: T, lon: T) -> Result<Self, InvalidLatLon<T>> {
        let between_poles = lat.abs() <= T::of(90.0); // false for NaN
        if !between_poles {
            return Err(InvalidLatLon::Latitude(lat));
        }
        if lon.abs() <= T::of(180.0) {
            return Ok(Self { lat, lon });
        }
        if !lon.is_finite() {
            return Err(InvalidLatLon::Longitude(lon));
        }
        let circle = T::of(360.0);
        let turned = lon.remainder(circle);
        let lon = if turned > T::of(180.0) {
            turned - circle
        } else if turned < T::of(-180.0) {
            turned + circle
        } else {
            turned
        };
        Ok(Self { lat, lon })
    }

    /// For a latitude and longitude known to be in range.
    #[inline(always)]
    pub(crate) const fn within(lat: T, lon: T) -> Self {
        Self { lat, lon }
    }

    /// Latitude in degrees, in [−90, 90].
    #[must_use]
    #[inline(always)]
    pub fn lat(self) -> T {
        self.lat
    }

    /// Longitude in degrees, in [−180, 180].
    #[must_use]
    #[inline(always)]
    pub fn lon(self) -> T {
        self.lon
    }

    /// The point of the unit sphere at this latitude and longitude.
    ///
    /// Worst error 2.2e-16 rad (`f64`), 1.2e-7 rad (`f32`); exact on the axes, and nothing is lost near them.
    ///
    /// ```
    /// # use terrella::LatLon;
    /// let east = LatLon::new(0.0, 90.0)?.to_direction();
    /// assert_eq!(east.to_array(), [0.0, 1.0, 0.0]);
    /// # Ok::<(), terrella::InvalidLatLon<f64>>(())
    /// ```
    #[must_use]
    #[inline]
    pub fn to_direction(self) -> Direction<T> {
        let [latitude, longitude] = self.sin_cos();
        Direction::from_angles(latitude, longitude)
    }

    /// Sine and cosine of latitude and longitude; not inlined, so that both are computed side by side whatever a caller does between.
    #[inline(never)]
    pub(crate) fn sin_cos(self) -> [(T, T); 2] {
        [sin_cos_degrees(self.lat), sin_cos_degrees(self.lon)]
    }
}

/// Why [`LatLon::new`] refused.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum InvalidLatLon<T> {
    /// The latitude is not in [−90, 90] degrees.
    Latitude(T),
    /// The longitude is infinite or not a number.
    Longitude(T),
}

impl<T: fmt::Debug> fmt::Display for InvalidLatLon<T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Latitude(lat) => write!(f, "latitude {lat:?} is not in [-90, 90] degrees"),
            Self::Longitude(lon) => write!(f, "longitude {lon:?} is not finite"),
        }
    }
}

impl<T: fmt::Debug> core::error::Error for InvalidLatLon<T> {}
