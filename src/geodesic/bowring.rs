use super::angle::{
    between_poles, heading, latitude_difference, longitude_difference, northward_between_poles, turns_once, wrapped,
};
use super::great_circle::{Delambre, end};
use super::profile::profile;
use super::{Direct, Geodesic, GeodesicError, Inverse, nearly_round};
use crate::latitude::UnsupportedFlattening;
use crate::math::{atan2_degrees, max, min, sin_cos, sin_cos_degrees};
use crate::{Ellipsoid, LatLon, Real};

profile! {
    name: "bowring",
    title: "Bowring",
    surface: Local,
    flattenings: [-1.0 / 60.0, 1.0 / 60.0],
    model: "sphere that touches the ellipsoid",
    good_to: "1 µm at 10 km, 1.1 mm at 100 km",
    instructions: 1000,
    errors: {
        latitudes 0 to 90, f32 adds [7e-7 s] [7e-7 s] [7e-7 s + 2.0] {
            1 km: [6e-9] [6.4e-9] [6e-9];
            10 km: [1e-6] [4e-7] [1e-6];
            100 km: [1.1e-3] [6e-4] [1.1e-3];
            150 km: [4e-3] [3e-3] [4e-3];
            1000 km: [5.0] [7.0] [5.0];
        }
    }
}

/// Bowring's formulas for lines up to 150 km: the great circle on a sphere that touches the ellipsoid at the
/// first place.
///
/// B. R. Bowring, *The direct and inverse problems for short geodesic lines on the ellipsoid*, Surveying and
/// Mapping 41, 1981. The map from the ellipsoid to the sphere is conformal, and both problems have a closed
/// form.
///
/// Worst error on the Earth at any latitude, in metres:
///
#[doc = table!()]
///
/// Beyond, the error grows with the cube of the distance and faster, up to hundreds of kilometres.
///
/// ```
/// use terrella::geodesic::{Bowring, Geodesic};
/// use terrella::{Ellipsoid, LatLon};
/// let earth = Bowring::new(Ellipsoid::<f64>::WGS84)?;
/// let way = earth.inverse(LatLon::new(48.8584, 2.2945)?, LatLon::new(49.2583, 4.0317)?)?;
/// assert_eq!(format!("{:.3}", way.distance), "134525.353");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Bowring<T> {
    /// The polar radius of curvature, a√(1 + e′²).
    c: T,
    ep2: T,
}

/// The sphere that touches the ellipsoid at a place; A and B as in the paper.
struct Sphere<T> {
    /// Degrees of longitude on it to one on the ellipsoid.
    a: T,
    b: T,
    radius: T,
    /// Sine and cosine of the latitude on it.
    u: (T, T),
}

impl<T: Real> Bowring<T> {
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
            c: ellipsoid.a() / (T::ONE - ellipsoid.f()),
            ep2: ellipsoid.ep2(),
        }
    }

    #[inline(always)]
    fn sphere(&self, lat: T) -> Sphere<T> {
        let (sin, cos) = sin_cos_degrees(lat);
        let cos2 = cos * cos;
        let a = (T::ONE + self.ep2 * cos2 * cos2).sqrt();
        let b2 = T::ONE + self.ep2 * cos2;
        let b = b2.sqrt();
        Sphere {
            a,
            b,
            radius: self.c / b2,
            u: (sin / a, b * cos / a),
        }
    }
}

impl<T: Real> Bowring<T> {
    /// The line, but from pole to pole.
    #[inline(always)]
    fn line(&self, from: LatLon<T>, to: LatLon<T>) -> Inverse<T> {
        let of = T::of;
        let Sphere { a, b, radius, u } = self.sphere(from.lat());
        let difference = latitude_difference(from, to);
        let lat = difference.value() * of(RADIAN);
        let difference = longitude_difference(from, to);
        let w = difference.value() * of(RADIAN) * a * of(0.5);
        let (sin, _) = sin_cos_degrees(from.lat() * of(2.0) + difference_third(lat));
        let d = lat / (b + b) * (T::ONE + of(0.75) * self.ep2 / (b * b) * lat * sin);
        let (sin_d, cos_d) = sin_cos(d);
        let middle = (u.0 * cos_d + u.1 * sin_d, u.1 * cos_d - u.0 * sin_d);
        let line = Delambre::new(sin_cos(w), (sin_d, cos_d), middle);
        let (azimuth1, azimuth2) = line.azimuths();
        Inverse {
            distance: line.angle() * radius,
            azimuth1,
            azimuth2,
        }
    }

    /// The end of a line of `distance`, less its whole turns of the sphere if there are `many`, and whether
    /// that is less than a turn.
    #[inline(always)]
    fn end(&self, from: LatLon<T>, heading: (T, T), distance: T, many: bool) -> (Direct<T>, bool) {
        let of = T::of;
        let Sphere { a, b, radius, u } = self.sphere(from.lat());
        let circle = radius * of(2.0 * core::f64::consts::PI);
        let once = if many { distance.remainder(circle) } else { distance };
        let angle = once / radius;
        let end = end(u, heading, sin_cos(angle), T::ONE);
        let d = (end.lat - atan2_degrees(u.0, u.1)) * of(0.5);
        let (sin, _) = sin_cos_degrees(from.lat() * of(2.0) + b * d * of(4.0 / 3.0));
        let lat = from.lat() + (d + d) * (b - of(1.5) * self.ep2 * (d * of(RADIAN)) * sin);
        let end = Direct {
            position: LatLon::within(max(min(lat, of(90.0)), of(-90.0)), wrapped(from.lon() + end.lon / a)),
            azimuth: end.azimuth,
        };
        (end, once.abs() < circle)
    }
}

impl<T: Real> Geodesic<T> for Bowring<T> {
    /// Never fails.
    #[inline]
    fn inverse(&self, from: LatLon<T>, to: LatLon<T>) -> Result<Inverse<T>, GeodesicError<T>> {
        Ok(northward_between_poles(from, to, self.line(from, to)))
    }

    /// # Errors
    /// [`GeodesicError::Azimuth`] or [`GeodesicError::Distance`] for a value that is infinite or NaN.
    #[inline]
    fn direct(&self, from: LatLon<T>, azimuth: T, distance: T) -> Result<Direct<T>, GeodesicError<T>> {
        Ok(self.end(from, heading(azimuth, distance)?, distance, true).0)
    }

    /// Not found between poles.
    #[inline(always)]
    fn fast_inverse(&self, from: LatLon<T>, to: LatLon<T>) -> (Inverse<T>, bool) {
        (self.line(from, to), !between_poles(from, to))
    }

    /// Not found after a turn or more.
    #[inline(always)]
    fn fast_direct(&self, from: LatLon<T>, azimuth: T, distance: T) -> (Direct<T>, bool) {
        let (end, found) = self.end(from, sin_cos_degrees(azimuth), distance, false);
        (end, found & turns_once(azimuth))
    }
}

const RADIAN: f64 = core::f64::consts::PI / 180.0;

/// Two thirds of an angle in radians, in degrees.
#[inline(always)]
fn difference_third<T: Real>(radians: T) -> T {
    radians * T::of(2.0 / 3.0 / RADIAN)
}
