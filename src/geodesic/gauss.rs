use super::angle::{
    between_poles, latitude_difference, longitude_difference, northward_between_poles, off_pole, wrapped,
};
use super::profile::profile;
use super::{Bowring, Direct, Geodesic, GeodesicError, Inverse, nearly_round};
use crate::latitude::UnsupportedFlattening;
use crate::math::{DoubleWord, atan2_degrees, hypot};
use crate::{Ellipsoid, LatLon, Real};

profile! {
    name: "gauss",
    title: "Gauss",
    surface: Local,
    flattenings: [-1.0 / 60.0, 1.0 / 60.0],
    model: "plane of the middle latitude, with terms of the third order",
    good_to: "0.3 mm at 100 km below 60°",
    instructions: 500,
    errors: {
        latitudes 0 to 60, f32 adds [7e-7 s] [7e-7 s] [7e-7 s + 2.0] {
            1 km: [6e-9] [6e-9] [6e-9];
            10 km: [3e-7] [2e-7] [1e-6];
            100 km: [3e-4] [3e-4] [1.1e-3];
            150 km: [1e-3] [1e-3] [4e-3];
        }
        latitudes 60 to 80, f32 adds [7e-7 s] [7e-7 s] [7e-7 s + 2.0] {
            1 km: [6e-9] [6e-9] [6e-9];
            10 km: [3e-7] [2e-7] [1e-6];
            100 km: [5e-3] [5e-3] [1.1e-3];
            150 km: [4e-2] [4e-2] [4e-3];
        }
    }
}

/// Gauss's mid-latitude formula, to the third order: below latitude 60 and up to 150 km nearer to the
/// geodesic than [`Bowring`], at half of the cost.
///
/// C. F. Gauss, *Untersuchungen über Gegenstände der höheren Geodäsie*, second part, 1847. Distance and
/// azimuths are series in the differences of latitude and longitude about the mean latitude, where the terms
/// of even order vanish. [`Flat`](super::Flat) has the first order of the same series.
///
/// The direct problem is that of [`Bowring`], in closed form: Gauss's would be an iteration.
///
/// Worst error on the Earth, in metres:
///
#[doc = table!()]
///
/// Beyond, the error grows with the fifth power of the distance, and with powers of the tangent of the
/// latitude. Nearer to a pole than ten times the distance, and beyond 1000 km anywhere, do not use it:
/// results are finite, and may be wrong by more than their own size.
///
/// ```
/// use terrella::geodesic::{Gauss, Geodesic};
/// use terrella::{Ellipsoid, LatLon};
/// let earth = Gauss::new(Ellipsoid::<f64>::WGS84)?;
/// let way = earth.inverse(LatLon::new(48.8584, 2.2945)?, LatLon::new(49.2583, 4.0317)?)?;
/// assert_eq!(format!("{:.3}", way.distance), "134525.354");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[doc(alias = "mid-latitude", alias = "Mittelbreitenformel")]
pub struct Gauss<T> {
    a: T,
    e2: T,
    ep2: T,
    bowring: Bowring<T>,
}

impl<T: Real> Gauss<T> {
    /// Makes the method for an ellipsoid.
    ///
    /// # Errors
    /// [`UnsupportedFlattening`] if |f| > 1/60.
    pub fn new(ellipsoid: Ellipsoid<T>) -> Result<Self, UnsupportedFlattening<T>> {
        nearly_round(ellipsoid).map(Self::within)
    }

    /// For an ellipsoid known to be nearly round.
    pub(crate) fn within(ellipsoid: Ellipsoid<T>) -> Self {
        Self {
            a: ellipsoid.a(),
            e2: ellipsoid.e2(),
            ep2: ellipsoid.ep2(),
            bowring: Bowring::within(ellipsoid),
        }
    }
}

impl<T: Real> Gauss<T> {
    /// The line, but from pole to pole.
    #[inline(always)]
    fn line(&self, from: LatLon<T>, to: LatLon<T>) -> Inverse<T> {
        let of = T::of;
        let (lat, lon) = (latitude_difference(from, to), longitude_difference(from, to));
        let (b, l) = (lat.value() * of(RADIAN), lon.value() * of(RADIAN));
        let (sin, cos) = DoubleWord::sum(from.lat(), to.lat()).half().sin_cos_degrees();
        // η² = e′² cos² φ, V² = 1 + η², and η² tan² φ.
        let (sin2, cos2) = (sin * sin, cos * cos);
        let (eta2, eta2_tan2) = (self.ep2 * cos2, self.ep2 * sin2);
        let v2 = T::ONE + eta2;
        let n = self.a / (T::ONE - self.e2 * sin2).sqrt();
        let (b2, l2) = (b * b * of(1.0 / 24.0) / (v2 * v2), l * l * of(1.0 / 24.0));
        let two = T::ONE + T::ONE;
        let three = two + T::ONE;
        let east = T::ONE + b2 * (v2 + eta2 * eta2 - of(9.0) * eta2_tan2) - l2 * sin2;
        let north = T::ONE + b2 * (three * (eta2 - eta2_tan2)) - l2 * (cos2 * (two + eta2 + eta2) + three * sin2);
        let turn = T::ONE + b2 * (three + (eta2 + eta2) * (T::ONE - eta2)) + l2 * (two * cos2 * v2);
        let (east, north) = (n * off_pole(cos) * l * east, n / v2 * b * north);
        let azimuth = atan2_degrees(east, north);
        let convergence = of(0.5) * lon.value() * sin * turn;
        Inverse {
            distance: hypot(north, east),
            azimuth1: wrapped(azimuth - convergence),
            azimuth2: wrapped(azimuth + convergence),
        }
    }
}

impl<T: Real> Geodesic<T> for Gauss<T> {
    /// Never fails.
    #[inline]
    fn inverse(&self, from: LatLon<T>, to: LatLon<T>) -> Result<Inverse<T>, GeodesicError<T>> {
        Ok(northward_between_poles(from, to, self.line(from, to)))
    }

    /// The direct problem of [`Bowring`].
    ///
    /// # Errors
    /// [`GeodesicError::Azimuth`] or [`GeodesicError::Distance`] for a value that is infinite or NaN.
    #[inline]
    fn direct(&self, from: LatLon<T>, azimuth: T, distance: T) -> Result<Direct<T>, GeodesicError<T>> {
        self.bowring.direct(from, azimuth, distance)
    }

    /// Not found between poles.
    #[inline(always)]
    fn fast_inverse(&self, from: LatLon<T>, to: LatLon<T>) -> (Inverse<T>, bool) {
        (self.line(from, to), !between_poles(from, to))
    }

    #[inline(always)]
    fn fast_direct(&self, from: LatLon<T>, azimuth: T, distance: T) -> (Direct<T>, bool) {
        self.bowring.fast_direct(from, azimuth, distance)
    }
}

const RADIAN: f64 = core::f64::consts::PI / 180.0;
