use super::degrees::{hypot, northward_between_poles};
use super::ordinary::Ordinary;
use super::{Direct, Geodesic, GeodesicError, Inverse, Straight};
use crate::latitude::UnsupportedFlattening;
use crate::math::{max, select};
use crate::{Ellipsoid, LatLon, Real};

mod angle;
mod area;
mod astroid;
mod inverse;
mod lengths;
mod line;
mod newton;
mod polygon;
mod series;

use angle::Angle;
use inverse::{Arc, Canonical, tiny};
pub(super) use series::Series;

pub use area::Area;
pub use line::{Line, LinePoint};
pub use polygon::PolygonArea;

/// Karney's geodesics: both problems for any two places, with the lengths that error analysis needs.
///
/// Always converges. On the Earth the distance is within 7 nm, azimuths times the shorter of distance and reduced length within
/// 5 nm, and the direct problem's position within 10 nm for a line once around; in `f32` within 4 m and 1.5e-7 of the distance (the general way 30 m between nearly antipodal places within 10⁻⁴ degrees of the equator), and between neighbours within
/// 1e-6 of the distance. For f = 1/10 and −1/150 within 12 nm.
///
/// Both problems of [`Geodesic`] are straight lines of arithmetic where |f| ≤ 1/149: Newton's method for the longitude on the auxiliary sphere,
/// three evaluations; a few more between some places 150° or more apart. What they leave (coincident places,
/// from pole to pole, azimuths beyond ±360°, very many circuits), other ellipsoids and [`Line`] take the
/// general way. [`Karney::solve`] and [`Area::under`] are about the line of [`Geodesic::inverse`]. The direct
/// problem and [`Line`] agree to rounding, not to the bit.
///
/// Between latitudes that are exactly opposite the azimuths are equal, or add up to 180° within a rounding,
/// as the symmetry of the ellipsoid asks; if two shortest lines mirror each other in the equator, it is the
/// one that starts to the north.
///
/// The general way: series in the third flattening to order 6 on the Earth's ellipsoids and up to 12 beyond them; shorter ones in `f32`; Newton's
/// method with a bracket, at most 83 steps (`f64`), in practice 2 to 6 but next to the equator where the shortest line leaves it.
///
/// C. F. F. Karney, *Algorithms for geodesics*, J. Geodesy 87 (2013).
///
/// ```
/// use terrella::geodesic::{Geodesic, Karney};
/// use terrella::{Ellipsoid, LatLon};
///
/// let earth = Karney::new(Ellipsoid::WGS84).unwrap();
/// let (wellington, salamanca) = (LatLon::new(-41.32, 174.81).unwrap(), LatLon::new(40.96, -5.5).unwrap());
/// let line = earth.inverse(wellington, salamanca).unwrap();
/// assert!((line.distance - 19_959_679.267_353_82_f64).abs() < 1e-8);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Karney<T> {
    ellipsoid: Ellipsoid<T>,
    series: Series<T>,
    ordinary: Ordinary<T>,
    /// b/a = 1 − f.
    axes: T,
    /// The arc in radians below which the sphere of the middle latitude is exact enough.
    short: T,
}

/// The whole solution of the inverse problem.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Solution<T> {
    /// Distance and azimuths.
    pub inverse: Inverse<T>,
    /// The arc on the auxiliary sphere in degrees.
    pub arc: T,
    /// The reduced length in metres.
    pub reduced_length: T,
    /// The geodesic scale M₁₂.
    pub scale12: T,
    /// The geodesic scale M₂₁.
    pub scale21: T,
    /// How often the longitude was evaluated: mostly 3 (`f32`: 2); in the general way 0 where there is a
    /// closed form, along meridian and equator and between neighbours.
    pub evaluations: usize,
}

impl<T: Real> Karney<T> {
    /// For an ellipsoid.
    ///
    /// # Errors
    /// [`UnsupportedFlattening`] outside −1/9 ≤ f ≤ 1/10, where the series are too short.
    pub fn new(ellipsoid: Ellipsoid<T>) -> Result<Self, UnsupportedFlattening<T>> {
        // 1/19, and room for its rounding.
        if ellipsoid.n().abs() > T::of(0.052_632) {
            return Err(UnsupportedFlattening(ellipsoid.f()));
        }
        Ok(Self::within(ellipsoid))
    }

    /// For an ellipsoid known to be one that the series hold for.
    pub(crate) fn within(ellipsoid: Ellipsoid<T>) -> Self {
        let f = ellipsoid.f();
        let half = T::of(0.5);
        let size = max(T::of(0.001), f.abs());
        let narrow = if f > T::ZERO { T::ONE - half * f } else { T::ONE };
        let series = Series::new(ellipsoid);
        Self {
            ellipsoid,
            series,
            ordinary: Ordinary::new(ellipsoid, &series),
            axes: T::ONE - f,
            short: T::of(0.1) * T::EPSILON.sqrt() / (half * size * narrow).sqrt(),
        }
    }

    /// The general way.
    #[cold]
    #[inline(never)]
    fn general(&self, from: LatLon<T>, to: LatLon<T>) -> (Inverse<T>, Canonical<T>, Arc<T>) {
        let problem = Canonical::new(self, from, to);
        let arc = problem.solve(self);
        let ([alpha1, alpha2], _) = problem.turned_back(&arc);
        let degrees = |alpha: Angle<T>| select(arc.sigma == T::ZERO, T::ZERO, alpha.to_degrees());
        let line = Inverse {
            distance: arc.distance + T::ZERO,
            azimuth1: degrees(alpha1),
            azimuth2: degrees(alpha2),
        };
        (northward_between_poles(from, to, line), problem, arc)
    }

    /// The line of [`Geodesic::inverse`], the problem that is solved, and all of its solution. Between poles
    /// the latter is for the meridian of the second place's longitude, which the polygon's edge follows.
    fn whole(&self, from: LatLon<T>, to: LatLon<T>) -> (Inverse<T>, Canonical<T>, Arc<T>) {
        if self.ordinary.exact()
            && let Some(line) = self.ordinary.whole(from, to)
        {
            let problem = Canonical::new(self, from, to);
            let arc = problem.found(self, &line);
            return (line.inverse, problem, arc);
        }
        self.general(from, to)
    }

    #[cold]
    #[inline(never)]
    fn hard_direct(&self, from: LatLon<T>, azimuth: T, distance: T) -> Result<Direct<T>, GeodesicError<T>> {
        let point = self.line(from, azimuth)?.at(distance)?;
        Ok(Direct {
            position: point.position,
            azimuth: point.azimuth,
        })
    }

    /// The whole solution of the inverse problem: distance and azimuths those of [`Geodesic::inverse`] in
    /// every bit, the other lengths of the same line.
    #[must_use]
    pub fn solve(&self, from: LatLon<T>, to: LatLon<T>) -> Solution<T> {
        let (inverse, problem, arc) = self.whole(from, to);
        let (_, [scale12, scale21]) = problem.turned_back(&arc);
        Solution {
            inverse,
            arc: arc.sigma * T::of(180.0 / core::f64::consts::PI),
            reduced_length: arc.reduced + T::ZERO,
            scale12,
            scale21,
            evaluations: arc.evaluations,
        }
    }

    /// The geodesic from a place at an azimuth in degrees.
    ///
    /// # Errors
    /// [`GeodesicError::Azimuth`] if it is not finite.
    pub fn line(&self, from: LatLon<T>, azimuth: T) -> Result<Line<T>, GeodesicError<T>> {
        Line::new(self, from, azimuth)
    }

    /// The parametric latitude of a geodetic one in degrees, its cosine never 0, and √(cos²φ + (1 − f)² sin²φ).
    fn reduced(&self, lat: T) -> (Angle<T>, T) {
        let phi = Angle::degrees(lat);
        let sin = phi.sin * self.axes;
        let radius = hypot(sin, phi.cos);
        let beta = Angle {
            sin: sin / radius,
            cos: max(phi.cos / radius, tiny()),
        };
        (beta, radius)
    }

    /// √(1 + e'² sin²β).
    fn dn(&self, sin_beta: T) -> T {
        (T::ONE + self.ellipsoid.ep2() * sin_beta * sin_beta).sqrt()
    }
}

impl<T: Real> Geodesic<T> for Karney<T> {
    /// Never fails.
    #[inline]
    fn inverse(&self, from: LatLon<T>, to: LatLon<T>) -> Result<Inverse<T>, GeodesicError<T>> {
        if self.ordinary.exact()
            && let Some(line) = self.ordinary.inverse(from, to)
        {
            return Ok(line);
        }
        Ok(self.general(from, to).0)
    }

    #[inline]
    fn direct(&self, from: LatLon<T>, azimuth: T, distance: T) -> Result<Direct<T>, GeodesicError<T>> {
        let (there, found) = self.ordinary_direct(from, azimuth, distance);
        if found {
            return Ok(there);
        }
        self.hard_direct(from, azimuth, distance)
    }
}

impl<T: Real> Straight<T> for Karney<T> {
    #[inline(always)]
    fn ordinary_inverse(&self, from: LatLon<T>, to: LatLon<T>) -> (Inverse<T>, bool) {
        let (line, found) = self.ordinary.near_inverse(from, to);
        (line, found & self.ordinary.exact())
    }

    #[inline(always)]
    fn ordinary_direct(&self, from: LatLon<T>, azimuth: T, distance: T) -> (Direct<T>, bool) {
        let (there, found) = self.ordinary.few_direct(from, azimuth, distance);
        (there, found & self.ordinary.exact())
    }

    #[inline(always)]
    fn reaches(&self, distance: T) -> bool {
        self.ordinary.reaches(distance)
    }
}
