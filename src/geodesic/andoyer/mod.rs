use super::angle::{between_poles, heading, northward_between_poles, turns_once};
use super::profile::profile;
use super::{Direct, Geodesic, GeodesicError, Inverse, nearly_round};
use crate::latitude::UnsupportedFlattening;
use crate::math::{sin_cos, sin_cos_degrees};
use crate::{Ellipsoid, LatLon, Real};

pub(super) mod arc;

use arc::{Departure, Ends, is_less_than_a_turn};

profile! {
    name: "andoyer",
    title: "Andoyer",
    surface: Ellipsoid,
    flattenings: [-1.0 / 60.0, 1.0 / 60.0],
    model: "first order in the flattening",
    good_to: "1.5e-6 of the distance to 5000 km",
    instructions: 1000,
    errors: {
        latitudes 0 to 90, f32 adds [7e-7 s] [7e-7 s] [7e-7 s + 2.0] {
            5000 km: [1.5e-6 s + 1e-8] [4e-6 s + 1e-8] [6e-6 s + 1e-8];
            10000 km: [15.0] [45.0] [40.0];
            15000 km: [70.0] [200.0] [50.0];
            18000 km: [280.0] [600.0] [40.0];
            19000 km: [600.0] [1300.0] [40.0];
            20100 km: [3.5e4] [2.2e5] [40.0];
        }
    }
}

/// Andoyer and Lambert's formula: the great circle between the parametric latitudes, corrected to the first
/// order in the flattening. In closed form, for any distance.
///
/// s = a(σ − f/2 cos²α₀ (σ + sin σ cos 2σₘ)), with the azimuth α₀ at the equator, the arc σ and its middle σₘ
/// counted from the equator; W. D. Lambert, *The distance between two widely separated points on the surface
/// of the Earth*, 1942, writes it with half angles. The azimuths are corrected for the longitude f σ sin α₀
/// that the sphere lacks.
///
/// Worst error on the Earth at any latitude, in metres:
///
#[doc = table!()]
///
/// Lines that go around any number of times reach the place to 1.5e-6 s. On other ellipsoids the error grows
/// with f²; on a sphere it is that of [`GreatCircle`](super::GreatCircle).
///
/// ```
/// use terrella::geodesic::{Andoyer, Geodesic};
/// use terrella::{Ellipsoid, LatLon};
/// let earth = Andoyer::new(Ellipsoid::<f64>::WGS84)?;
/// let way = earth.inverse(LatLon::new(59.91, 10.75)?, LatLon::new(-0.18, -78.47)?)?; // 9979.771 km
/// assert_eq!(format!("{:.1}", way.distance / 1e3), "9979.8");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[doc(alias = "Lambert", alias = "Andoyer-Lambert")]
pub struct Andoyer<T> {
    a: T,
    f: T,
    axes: T,
}

impl<T: Real> Andoyer<T> {
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
            f: ellipsoid.f(),
            axes: T::ONE - ellipsoid.f(),
        }
    }
}

impl<T: Real> Andoyer<T> {
    /// The line, but from pole to pole.
    #[inline(always)]
    fn line(&self, from: LatLon<T>, to: LatLon<T>) -> Inverse<T> {
        let ends = Ends::new(self.axes, from, to);
        let arc = ends.arc(ends.lambda12);
        let lacking = T::of(0.5) * self.f * arc.cos2_alpha0 * (arc.sigma12 + arc.sin_sigma12 * arc.cos_2sigma_m);
        let (azimuth1, azimuth2) = ends.azimuths_after(&arc, self.f * arc.sin_alpha0 * arc.sigma12);
        Inverse {
            distance: self.a * (arc.sigma12 - lacking),
            azimuth1,
            azimuth2,
        }
    }

    /// The end of a line of `many` turns or less than one; and the arc in radians, and by what it is divided.
    #[inline(always)]
    fn end(&self, from: LatLon<T>, heading: (T, T), distance: T, many: bool) -> (Direct<T>, T, T) {
        let start = Departure::new(self.axes, from, heading);
        // With the λ reached s = a(σ(1 − f) + f/2 cos²α (σ − sin σ cos 2σₘ)); solved for σ to the first
        // order.
        let half = T::of(0.5) * self.f * start.cos2_alpha0();
        let radius = self.a * (self.axes + half);
        let (tau, whole) = arc::arc(distance, radius, many);
        let turn = sin_cos(tau);
        let sigma = tau + half * turn.0 * start.cos_2sigma_m(turn);
        let shift = self.f * start.sin_alpha0() * (sigma + (whole - tau));
        (start.end(sin_cos(sigma), shift, many), whole, radius)
    }
}

impl<T: Real> Geodesic<T> for Andoyer<T> {
    /// Never fails.
    #[inline]
    fn inverse(&self, from: LatLon<T>, to: LatLon<T>) -> Result<Inverse<T>, GeodesicError<T>> {
        Ok(northward_between_poles(from, to, self.line(from, to)))
    }

    /// # Errors
    /// [`GeodesicError::Azimuth`] or [`GeodesicError::Distance`] for a value that is infinite or NaN;
    /// [`GeodesicError::TooFar`] on an ellipsoid of a metre or less, for a distance that it divides beyond
    /// all numbers.
    #[inline]
    fn direct(&self, from: LatLon<T>, azimuth: T, distance: T) -> Result<Direct<T>, GeodesicError<T>> {
        let (end, whole, radius) = self.end(from, heading(azimuth, distance)?, distance, true);
        if !whole.is_finite() {
            return Err(GeodesicError::quotient(distance, radius));
        }
        Ok(end)
    }

    /// Not found between poles.
    #[inline(always)]
    fn fast_inverse(&self, from: LatLon<T>, to: LatLon<T>) -> (Inverse<T>, bool) {
        (self.line(from, to), !between_poles(from, to))
    }

    /// Not found after a turn or more.
    #[inline(always)]
    fn fast_direct(&self, from: LatLon<T>, azimuth: T, distance: T) -> (Direct<T>, bool) {
        let (end, whole, _) = self.end(from, sin_cos_degrees(azimuth), distance, false);
        (end, turns_once(azimuth) & is_less_than_a_turn(whole))
    }
}
