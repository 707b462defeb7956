use core::fmt;

use super::Direction;
use crate::Real;
use crate::math::{product_of_any, select, sin_cos_degrees};

/// A latitude in [−90, 90] and a longitude in [−180, 180], both in degrees.
///
/// The function that takes or returns it says which latitude it is: geodetic, geocentric or another.
///
/// It is written as decimal degrees with as many decimals as asked for, or with as many as it takes to parse
/// the same bits again; in degrees, minutes and seconds by [`to_dms`](Self::to_dms). Text of either form
/// parses: see its implementation of [`FromStr`](core::str::FromStr).
///
/// ```
/// use terrella::LatLon;
/// let oslo = LatLon::new(59.91, 10.75)?;
/// assert_eq!(LatLon::new(59.91, 370.75)?.lon(), oslo.lon());
/// assert_eq!((format!("{oslo}"), format!("{oslo:.3}")), ("59.91, 10.75".into(), "59.910, 10.750".into()));
/// assert_eq!("59.91N 10.75E".parse(), Ok(oslo));
/// # Ok::<(), terrella::InvalidLatLon<f64>>(())
/// ```
#[doc(alias("coordinate", "lonlat", "latlng"))]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct LatLon<T = f64> {
    lat: T,
    lon: T,
}

impl LatLon {
    /// [`LatLon::new`] for constants: the same, in `f64` alone.
    ///
    /// For `f32`, use [`to_f32`](Self::to_f32) on the result.
    ///
    /// ```
    /// use terrella::LatLon;
    /// const OSLO: LatLon = match LatLon::const_new(59.91, 10.75) {
    ///     Ok(place) => place,
    ///     Err(_) => panic!("out of range"),
    /// };
    /// assert_eq!(LatLon::new(59.91, 370.75), Ok(OSLO));
    /// # assert_eq!(LatLon::const_new(59.91, 370.75), Ok(OSLO));
    /// ```
    ///
    /// # Errors
    /// [`InvalidLatLon`] for what [`LatLon::new`] refuses.
    pub const fn const_new(lat: f64, lon: f64) -> Result<Self, InvalidLatLon<f64>> {
        if !(lat >= -90.0 && lat <= 90.0) {
            return Err(InvalidLatLon::Latitude(lat));
        }
        if !lon.is_finite() {
            return Err(InvalidLatLon::Longitude(lon));
        }
        let turned = if lon >= -180.0 && lon <= 180.0 {
            lon
        } else {
            lon % 360.0
        };
        let lon = if turned > 180.0 {
            turned - 360.0
        } else if turned < -180.0 {
            turned + 360.0
        } else {
            turned
        };
        Ok(Self { lat, lon })
    }
}

impl<T: Real> LatLon<T> {
    /// Creates the place of a latitude and a longitude in degrees.
    ///
    /// A longitude in [−180, 180] is kept as it is, −180 and 180 both. Any other is brought into this range
    /// by turns of 360°, without rounding.
    ///
    /// # Errors
    /// [`InvalidLatLon::Latitude`] if the latitude is outside [−90, 90] or NaN; [`InvalidLatLon::Longitude`]
    /// if the longitude is infinite or NaN.
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

    /// Creates the place of a latitude and a longitude in radians.
    ///
    /// Worst error 0.51 ulp of the degrees. So ±π/2 and ±π, rounded to the scalar, become exactly ±90° and
    /// ±180°, although some of the rounded numbers are larger than π/2 or π. A longitude beyond ±π is
    /// converted to degrees first, and then brought into range.
    ///
    /// ```
    /// use core::f32::consts::{FRAC_PI_2, PI};
    /// use terrella::LatLon;
    /// assert_eq!(LatLon::from_radians(FRAC_PI_2, -PI), LatLon::new(90.0, -180.0));
    /// assert!(LatLon::from_radians(FRAC_PI_2.next_up(), 0.0).is_err());
    /// ```
    ///
    /// # Errors
    /// Those of [`new`](Self::new), with the value in degrees.
    #[inline]
    pub fn from_radians(lat: T, lon: T) -> Result<Self, InvalidLatLon<T>> {
        let degrees = |angle: T| {
            scaled(
                angle,
                T::pick(57.295_779_513_082_32, 57.295_78),
                T::pick(-1.987_849_567_057_628_3e-15, -6.688_024_4e-7),
            )
        };
        Self::new(degrees(lat), degrees(lon))
    }

    /// Returns the latitude in [−π/2, π/2] and the longitude in [−π, π], in radians. Worst error 0.51 ulp.
    ///
    /// The bounds are those numbers as rounded to the scalar: π rounded to `f32` is larger than π.
    ///
    /// ```
    /// use terrella::LatLon;
    /// let place = LatLon::new(30.0, -180.0)?;
    /// assert_eq!(place.to_radians(), (std::f64::consts::FRAC_PI_6, -std::f64::consts::PI));
    /// # Ok::<(), terrella::InvalidLatLon<f64>>(())
    /// ```
    #[must_use]
    #[inline]
    pub fn to_radians(self) -> (T, T) {
        let radians = |angle: T| {
            scaled(
                angle,
                T::pick(0.017_453_292_519_943_295, 0.017_453_292),
                T::pick(2.948_652_270_870_168_7e-19, 1.351_996e-10),
            )
        };
        (radians(self.lat), radians(self.lon))
    }

    /// The longitude as [`new`](Self::new) brings it into range, for up to two and a half turns; beyond, and
    /// for NaN, it stays out of range. No subtraction rounds: both numbers are within a factor of two.
    #[inline(always)]
    pub(crate) fn turned(lon: T) -> T {
        let size = lon.abs();
        let turns = select(
            size > T::of(540.0),
            T::of(720.0),
            select(size > T::of(180.0), T::of(360.0), T::ZERO),
        );
        (size - turns) * T::ONE.copysign(lon)
    }

    /// Creates a place with a latitude and longitude known to be in range.
    #[inline(always)]
    pub(crate) const fn within(lat: T, lon: T) -> Self {
        Self { lat, lon }
    }

    /// Returns the latitude in degrees, in [−90, 90].
    #[must_use]
    #[inline(always)]
    pub const fn lat(self) -> T {
        self.lat
    }

    /// Returns the longitude in degrees, in [−180, 180].
    #[must_use]
    #[inline(always)]
    pub const fn lon(self) -> T {
        self.lon
    }

    /// Returns the unit vector toward this latitude and longitude on the sphere.
    ///
    /// Worst error 2.2·10⁻¹⁶ rad (`f64`), 1.2·10⁻⁷ rad (`f32`). The result is exact on the axes. Next to
    /// them, no component loses digits.
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

    /// Sine and cosine of latitude and longitude.
    #[inline(always)]
    pub(crate) fn sin_cos(self) -> [(T, T); 2] {
        let [[sin_lon, sin_lat], [cos_lon, cos_lat]] = self.sines_and_cosines();
        [(sin_lat, cos_lat), (sin_lon, cos_lon)]
    }

    /// Not inlined: so the compiler computes both angles side by side, whatever a caller does between; not by
    /// the array's `map`, which it may leave a loop of calls. In this order: where it reads two of the numbers
    /// at once, they were written at once, else a processor waits until they are in its cache.
    #[inline(never)]
    fn sines_and_cosines(self) -> [[T; 2]; 2] {
        let (lat, lon) = (sin_cos_degrees(self.lat), sin_cos_degrees(self.lon));
        [[lon.0, lat.0], [lon.1, lat.1]]
    }
}

/// An angle in another unit. The factor is given as a number and its rounding error.
#[inline(always)]
fn scaled<T: Real>(angle: T, factor: T, lost: T) -> T {
    let (product, product_lost) = product_of_any(angle, factor);
    let rest = product_lost + angle * lost;
    // Not beyond the largest numbers, where infinities cancel; and −0 stays.
    select(rest.is_finite() & (rest != T::ZERO), product + rest, product)
}

impl<T: fmt::Display> fmt::Display for LatLon<T> {
    /// Writes latitude and longitude in decimal degrees, each with the formatter's options: `59.91, 10.75`.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.lat.fmt(f)?;
        f.write_str(", ")?;
        self.lon.fmt(f)
    }
}

/// Why a latitude and longitude were refused.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum InvalidLatLon<T> {
    /// The latitude is not in [−90, 90] degrees.
    Latitude(T),
    /// The longitude is infinite or NaN.
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
