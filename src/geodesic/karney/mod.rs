use super::fast;
use super::general::{self, Canonical, Line, Segment};
use super::profile::profile;
use super::series::Integrals;
use super::{Direct, Geodesic, GeodesicError, Inverse};
use crate::latitude::UnsupportedFlattening;
use crate::{Ellipsoid, LatLon, Real};

mod area;
mod edge;
mod polygon;

pub use area::Area;
pub(crate) use edge::{Edge, Edges};
pub use polygon::PolygonArea;

profile! {
    name: "karney",
    title: "Karney",
    surface: Ellipsoid,
    flattenings: [-1.0 / 9.0, 1.0 / 10.0],
    model: "geodesic of the ellipsoid: series, Newton’s steps, bracketed where hard",
    good_to: "7 nm everywhere, 12 nm for f = 1/10; lines, scales, areas",
    instructions: 1100,
    errors: {
        latitudes 0 to 90, f32 adds [7e-7 s + 1e-6] [7e-7 s + 1e-6] [7e-7 s + 2.0] {
            4700 km: [7e-9] [5e-9] [1e-8];
        }
        latitudes 0 to 90, f32 adds [1.5e-7 s + 4.0] [1.5e-7 s + 4.0] [1.5e-7 s + 4.0] {
            40000 km: [7e-9] [5e-9] [1e-8];
        }
    }
}

/// Karney's geodesics: both problems for any two places, to nanometres, with reduced length and scales.
///
/// C. F. F. Karney, *Algorithms for geodesics*, J. Geodesy 87 (2013): what GeographicLib computes.
///
/// Worst error on the Earth, in metres:
///
#[doc = table!()]
///
/// For f = 1/10 and −1/150 all are within 12 nm. In `f32`, if the bracketed solver is needed, within 30 m
/// between nearly antipodal places within 10⁻⁴ degrees of the equator.
///
/// [`inverse`](Geodesic::inverse) never fails and always converges. On ellipsoids with |f| < 1/149, the
/// Earth's among them, both problems are solved by a fixed sequence of operations, without branches that
/// depend on the places: Newton's method for the longitude on the auxiliary sphere, in three evaluations
/// (`f32`: two), with a few more between some places 150° or more apart. It falls back to the bracketed
/// solver, which is slower, when
///
/// * the ellipsoid is flatter, or more elongated, than that;
/// * the places coincide, or both are poles;
/// * an azimuth is beyond ±360°, or a distance beyond 300 (`f32`: 60) polar radii.
///
/// The bracketed solver takes series in the third flattening, to order 6 on the Earth's ellipsoids and up to
/// 12 on flatter ones (`f32`: 6 at most), and at most 83 steps (`f32`: 54). 2 to 6 are usual, more next to
/// the equator where the shortest line leaves it.
///
/// [`Karney::solve`] and [`Area::under`] are about the line of [`inverse`](Geodesic::inverse).
/// [`direct`](Geodesic::direct) and [`Line::at`] agree to rounding, not to the bit. Between latitudes that
/// are exactly opposite, the azimuths are equal, or add up to 180° within a rounding; if two shortest lines
/// are mirror images in the equator, the result is the one that starts to the north.
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
#[doc(alias = "GeographicLib", alias = "geod_geodesic", alias = "geod_init")]
pub struct Karney<T> {
    general: general::Solver<T>,
    fast: fast::Solver<T>,
}

/// The solution of the inverse problem with reduced length and scales, from [`Karney::solve`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Solution<T> {
    /// The distance and the azimuths.
    pub inverse: Inverse<T>,
    /// The arc σ₁₂ on the auxiliary sphere, in degrees, in [0, 180].
    pub arc: T,
    /// The reduced length m₁₂ in metres: a turn of one radian at the first place moves the end of the line by
    /// this much sideways.
    pub reduced_length: T,
    /// The geodesic scale M₁₂, without a unit: two lines that start parallel and one metre apart are M₁₂
    /// metres apart at the second place.
    pub scale12: T,
    /// The geodesic scale M₂₁: the same for two lines that are parallel at the second place, at the first.
    pub scale21: T,
    /// How often the longitude was evaluated, a measure of the cost: mostly 3 (`f32`: 2). In the bracketed
    /// solver 0 if there is a closed form: along a meridian, along the equator, and between neighbours.
    pub evaluations: usize,
}

impl<T: Real> Karney<T> {
    /// Makes the method for an ellipsoid.
    ///
    /// # Errors
    /// [`UnsupportedFlattening`] unless −1/9 ≤ f ≤ 1/10: beyond, the series are too short.
    pub fn new(ellipsoid: Ellipsoid<T>) -> Result<Self, UnsupportedFlattening<T>> {
        // 1/19, and room for its rounding.
        if ellipsoid.n().abs() > T::of(0.052_632) {
            return Err(UnsupportedFlattening(ellipsoid.f()));
        }
        Ok(Self::within(ellipsoid))
    }

    /// For an ellipsoid known to be one that the series hold for.
    pub(crate) fn within(ellipsoid: Ellipsoid<T>) -> Self {
        let general = general::Solver::new(ellipsoid);
        Self {
            general,
            fast: fast::Solver::new(ellipsoid, &general.integrals),
        }
    }

    pub(crate) fn ellipsoid(&self) -> Ellipsoid<T> {
        self.general.ellipsoid
    }

    fn integrals(&self) -> &Integrals<T> {
        &self.general.integrals
    }

    /// The line of [`Geodesic::inverse`], the canonical problem, and all of its solution. Between poles the
    /// latter is for the meridian of the second place's longitude, which the polygon's edge follows.
    fn whole(&self, from: LatLon<T>, to: LatLon<T>) -> (Inverse<T>, Canonical<T>, Segment<T>) {
        if self.fast.exact() {
            if let Some(found) = self.fast.outcome(from, to) {
                let problem = Canonical::new(&self.general, from, to);
                let arcs = [found.sigma12, found.growth];
                let segment = problem.segment(&self.general, found.inverse, arcs, found.evaluations);
                return (found.inverse, problem, segment);
            }
        }
        self.general.inverse(from, to)
    }

    #[cold]
    #[inline(never)]
    fn general_direct(&self, from: LatLon<T>, azimuth: T, distance: T) -> Result<Direct<T>, GeodesicError<T>> {
        let point = self.line(from, azimuth)?.at(distance)?;
        Ok(Direct {
            position: point.position,
            azimuth: point.azimuth,
        })
    }

    /// Solves the inverse problem with reduced length and scales. Distance and azimuths have the bits of
    /// [`Geodesic::inverse`]; the rest belongs to the same line.
    #[must_use]
    #[doc(alias = "geod_geninverse")]
    pub fn solve(&self, from: LatLon<T>, to: LatLon<T>) -> Solution<T> {
        let (inverse, problem, segment) = self.whole(from, to);
        let (_, [scale12, scale21]) = problem.turned_back(&segment);
        Solution {
            inverse,
            arc: segment.sigma12 * T::of(180.0 / core::f64::consts::PI),
            reduced_length: segment.reduced + T::ZERO,
            scale12,
            scale21,
            evaluations: segment.evaluations,
        }
    }

    /// Makes the line from a place at an azimuth in degrees.
    ///
    /// # Errors
    /// [`GeodesicError::Azimuth`] if the azimuth is infinite or NaN.
    #[doc(alias = "geod_lineinit", alias = "GeodesicLine")]
    pub fn line(&self, from: LatLon<T>, azimuth: T) -> Result<Line<T>, GeodesicError<T>> {
        Line::new(&self.general, from, azimuth)
    }

    /// The line of [`Geodesic::inverse`], which never fails.
    #[inline]
    pub(crate) fn way(&self, from: LatLon<T>, to: LatLon<T>) -> Inverse<T> {
        if self.fast.exact() {
            if let Some(line) = self.fast.inverse(from, to) {
                return line;
            }
        }
        self.general.inverse(from, to).0
    }

    /// The line of [`Geodesic::inverse`], also for many points.
    pub(crate) fn line_between(&self, from: LatLon<T>, to: LatLon<T>) -> (Line<T>, Inverse<T>) {
        let way = self.way(from, to);
        (Line::along(&self.general, from, way.azimuth1), way)
    }
}

impl<T: Real> Geodesic<T> for Karney<T> {
    /// Never fails.
    #[inline]
    fn inverse(&self, from: LatLon<T>, to: LatLon<T>) -> Result<Inverse<T>, GeodesicError<T>> {
        Ok(self.way(from, to))
    }

    /// # Errors
    /// As [`Line::at`].
    #[inline]
    fn direct(&self, from: LatLon<T>, azimuth: T, distance: T) -> Result<Direct<T>, GeodesicError<T>> {
        let (end, found) = self.fast_direct(from, azimuth, distance);
        if found {
            return Ok(end);
        }
        self.general_direct(from, azimuth, distance)
    }

    #[inline(always)]
    fn fast_inverse(&self, from: LatLon<T>, to: LatLon<T>) -> (Inverse<T>, bool) {
        let (line, found) = self.fast.near_inverse(from, to);
        (line, found & self.fast.exact())
    }

    #[inline(always)]
    fn far_inverse(&self, from: LatLon<T>, to: LatLon<T>) -> (Inverse<T>, bool) {
        let (line, found) = self.fast.far_inverse(from, to);
        (line, found & self.fast.exact())
    }

    #[inline(always)]
    fn fast_direct(&self, from: LatLon<T>, azimuth: T, distance: T) -> (Direct<T>, bool) {
        let (end, found) = self.fast.direct(from, azimuth, distance);
        (end, found & self.fast.exact())
    }
}
