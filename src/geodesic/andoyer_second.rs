use super::andoyer::arc::{Departure, Ends, arc, is_less_than_a_turn, waves};
use super::angle::{between_poles, heading, northward_between_poles, turns_once};
use super::profile::profile;
use super::{Direct, Geodesic, GeodesicError, Inverse, nearly_round};
use crate::latitude::UnsupportedFlattening;
use crate::math::{max, min, repeat, sin_cos, sin_cos_degrees};
use crate::{Ellipsoid, LatLon, Real};

profile! {
    name: "andoyer-second",
    title: "Andoyer, 2nd order",
    surface: Ellipsoid,
    flattenings: [-1.0 / 60.0, 1.0 / 60.0],
    model: "second order in the flattening",
    good_to: "2e-9 of the distance to 3000 km",
    instructions: 1500,
    errors: {
        latitudes 0 to 90, f32 adds [7e-7 s] [7e-7 s] [7e-7 s + 2.0] {
            3000 km: [2e-9 s + 5e-9] [1e-9 s + 5e-9] [4e-9 s + 6e-9];
            5000 km: [0.02] [0.012] [0.015];
            10000 km: [0.2] [0.15] [0.02];
            15000 km: [2.0] [1.6] [0.03];
            18000 km: [20.0] [15.0] [0.03];
            19000 km: [80.0] [70.0] [0.03];
            20100 km: [3.5e4] [2.2e5] [0.03];
        }
    }
}

/// The great circle between the parametric latitudes, corrected to the second order in the flattening: the
/// order of Thomas' formula, by another way. In closed form, for any distance.
///
/// One step of Newton's method on the equation for the longitude that [`Vincenty`](crate::geodesic::Vincenty)
/// solves by iteration, and the series to ε². It has an answer everywhere.
///
/// Worst error on the Earth at any latitude, in metres:
///
#[doc = table!()]
///
/// Lines that go around any number of times reach the place to 1.5e-9 s. On other ellipsoids the error grows
/// with f³; on a sphere it is that of [`GreatCircle`](crate::geodesic::GreatCircle).
///
/// ```
/// use terrella::geodesic::{AndoyerSecond, Geodesic};
/// use terrella::{Ellipsoid, LatLon};
/// let earth = AndoyerSecond::new(Ellipsoid::<f64>::WGS84)?;
/// let way = earth.inverse(LatLon::new(59.91, 10.75)?, LatLon::new(-0.18, -78.47)?)?; // 9979770.89 m
/// assert_eq!(format!("{:.0}", way.distance), "9979771");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[doc(alias = "Thomas", alias = "Andoyer-Lambert-Thomas")]
pub struct AndoyerSecond<T> {
    a: T,
    f: T,
    axes: T,
    ep2: T,
}

/// A₁, 2C₁ₖ, A₃ and 2C₃ₖ (Karney 17, 18, 24 and 25), to the second order in the distance, the first in the
/// longitude.
struct SecondOrder<T> {
    a1: T,
    c1: [T; 2],
    a3: T,
    c3: [T; 1],
}

impl<T: Real> AndoyerSecond<T> {
    /// Makes the method for an ellipsoid.
    ///
    /// # Errors
    /// [`UnsupportedFlattening`] if |f| > 1/60.
    pub fn new(ellipsoid: Ellipsoid<T>) -> Result<Self, UnsupportedFlattening<T>> {
        nearly_round(ellipsoid).map(|ellipsoid| Self {
            a: ellipsoid.a(),
            f: ellipsoid.f(),
            axes: T::ONE - ellipsoid.f(),
            ep2: ellipsoid.ep2(),
        })
    }

    #[inline(always)]
    fn series(&self, cos2_alpha0: T) -> SecondOrder<T> {
        let k2 = self.ep2 * cos2_alpha0;
        let root = T::ONE + (T::ONE + k2).sqrt();
        let e = k2 / (root * root);
        let half = T::of(0.5) * e;
        SecondOrder {
            a1: (T::ONE + T::of(0.25) * e * e) / (T::ONE - e),
            c1: [-e, T::of(-0.125) * e * e],
            a3: T::ONE - half,
            c3: [half],
        }
    }
}

impl<T: Real> AndoyerSecond<T> {
    /// The line, but from pole to pole.
    #[inline(always)]
    fn line(&self, from: LatLon<T>, to: LatLon<T>) -> Inverse<T> {
        let ends = Ends::new(self.axes, from, to);
        let first = ends.arc(ends.lambda12);
        let series = self.series(first.cos2_alpha0);
        let integral = series.a3 * (first.sigma12 + first.waves(&series.c3, 1));
        let shift = ends.side * self.f * first.sin_alpha0 * integral;
        let slope =
            T::ONE - ends.side * self.f * first.dsin_alpha0 * integral - self.f * first.sin_alpha0 * first.sin_alpha0;
        // Near the antipode of a prolate ellipsoid the step could go anywhere.
        let arc = ends.arc(max(
            min(ends.lambda12 + shift / max(slope, T::of(0.5)), T::of(2.0)),
            T::ZERO,
        ));
        let series = self.series(arc.cos2_alpha0);
        let (azimuth1, azimuth2) = arc.azimuths();
        Inverse {
            distance: self.a * (self.axes * series.a1 * (arc.sigma12 + arc.waves(&series.c1, 2))),
            azimuth1,
            azimuth2,
        }
    }

    /// The end of a line of `many` turns or less than one; and the arc in radians, and by what it is divided.
    #[inline(always)]
    fn end(&self, from: LatLon<T>, heading: (T, T), distance: T, many: bool) -> (Direct<T>, T, T) {
        let start = Departure::new(self.axes, from, heading);
        let series = self.series(start.cos2_alpha0());
        let radius = self.a * (self.axes * series.a1);
        let (tau, whole) = arc(distance, radius, many);
        let mut sigma = tau;
        repeat!(2, {
            let turn = sin_cos(sigma);
            sigma = tau - waves(&series.c1, 2, turn, start.cos_2sigma_m(turn));
        });
        let turn = sin_cos(sigma);
        let lag = waves(&series.c3, 1, turn, start.cos_2sigma_m(turn));
        let shift = self.f * start.sin_alpha0() * series.a3 * ((sigma + (whole - tau)) + lag);
        (start.end(turn, shift, many), whole, radius)
    }
}

impl<T: Real> Geodesic<T> for AndoyerSecond<T> {
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
