//! Where geodesics of an ellipsoid intersect.
//!
//! C. F. F. Karney, *Geodesic intersections*, J. Surveying Eng. 150 (2024), arXiv 2308.00495. An intersection
//! is a point (x, y) of a plane: x is the displacement along the one line, y along the other. Distances in
//! this plane are |x| + |y|, so that places as far from a point are a square; in this measure intersections
//! are evenly spaced.

use core::f64::consts::PI;

use super::Segment;
use crate::geodesic::{GeodesicError, Karney, Line};
use crate::latitude::UnsupportedFlattening;
use crate::{Ellipsoid, LatLon, Real};

mod closest;
mod next;
mod segments;
mod spot;
mod step;
mod within;

pub use within::IntersectionsWithin;

use spot::{Spot, apart, moved};

/// Finds where geodesics of an ellipsoid intersect.
///
/// After C. F. F. Karney, *Geodesic intersections*, J. Surveying Eng. 150 (2024), arXiv 2308.00495: from a
/// pair of points, one on each line, the sphere of mean radius gives a better pair, and so on, in at most
/// [`STEPS`](Self::STEPS) steps, 3 or 4 of them usual; it takes all of them only between lines that are
/// parallel but for rounding, or that start at antipodes in `f32`. Bounds for how near and how far
/// intersections are from each other tell where to start, and that none was missed.
///
/// Displacements are in metres from the start of a line, negative behind it. The distance of an intersection
/// is the sum of the sizes of both. The worst errors of each, times the sine of the angle at which the lines
/// cross, in metres on the Earth:
///
/// | distance | `f64` | `f32` |
/// |---|---|---|
/// | below 1000 km | 1.5e-8 | 4 |
/// | below 20 000 km | 3e-8 | 15 |
/// | below 100 000 km | 6e-8 | 50 |
///
/// Lines coincide ([`Overlap`]) if one lies within 23 nm (`f32`: 12 m) of the other, and their directions are
/// within 3.6e-15 (`f32`: 1.9e-6) rad. If they miss that by a little, an intersection is some point of the
/// stretch where the two cannot be told apart.
///
/// ```
/// use terrella::geodesic::Karney;
/// use terrella::route::Intersections;
/// use terrella::{Ellipsoid, LatLon};
///
/// let earth = Karney::new(Ellipsoid::WGS84)?;
/// let intersections = Intersections::new(Ellipsoid::WGS84)?;
/// // Two radio beacons, and the bearings from them.
/// let one = earth.line(LatLon::new(50.0_f64, 4.0)?, 147.7)?;
/// let other = earth.line(LatLon::new(0.0, 0.0)?, 90.0)?;
/// let fix = intersections.closest(&one, &other);
/// assert_eq!(format!("{:.3} {:.3}", fix.displacement1, fix.displacement2), "6058048.653 3311252.996");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Intersections<T> {
    karney: Karney<T>,
    /// Of the sphere.
    radius: T,
    /// No two intersections are nearer than twice this.
    apart: T,
    /// Half of how far the closest intersection can be.
    half_reach: T,
    /// Two thirds of half of how far the next one can be.
    next_reach: T,
    /// From so far the steps lead to an intersection, less a margin.
    capture: T,
    /// The margin: nearer intersections are one.
    margin: T,
}

/// An intersection of two lines.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Intersection<T> {
    /// How far it is along the first line, in metres from its start.
    pub displacement1: T,
    /// How far it is along the second line, in metres from its start.
    pub displacement2: T,
    /// The place, as the first line has it.
    pub position: LatLon<T>,
    /// Whether the lines coincide there.
    pub overlap: Option<Overlap>,
}

/// How two lines coincide.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Overlap {
    /// They run in the same direction.
    Parallel,
    /// They run in opposite directions.
    Antiparallel,
}

impl<T: Real> Intersections<T> {
    /// The largest number of steps to one intersection.
    pub const STEPS: usize = 24;

    /// Makes the method for an ellipsoid.
    ///
    /// # Errors
    /// [`UnsupportedFlattening`] unless −1/9 ≤ f ≤ 1/10.
    pub fn new(ellipsoid: Ellipsoid<T>) -> Result<Self, UnsupportedFlattening<T>> {
        let karney = Karney::new(ellipsoid)?;
        let half = ellipsoid.a() * T::of(PI);
        let f = ellipsoid.f();
        let times = |slope: f64| half * (T::ONE + T::of(slope) * f);
        // Linear bounds of t₁ to t₄ (the paper's table 1) for the flattenings that are accepted.
        let [apart, reach, next, capture] = if f < T::ZERO {
            [times(0.512), times(-1.0), times(-0.507), times(0.809)]
        } else {
            [times(-1.0), times(0.5), times(-0.243), times(-1.0)]
        };
        let margin = half * T::of(1e-3);
        Ok(Self {
            karney,
            radius: ellipsoid.mean_radius(),
            apart,
            half_reach: reach * T::of(0.5),
            next_reach: next * T::of(2.0 / 3.0),
            capture: capture - margin,
            margin,
        })
    }

    /// Returns the intersection of two lines that is closest to both starts: the sum of both displacements is
    /// the smallest. There always is one.
    ///
    /// Lines that coincide have many: the result is halfway between the starts.
    #[must_use]
    pub fn closest(&self, one: &Line<T>, other: &Line<T>) -> Intersection<T> {
        self.answer(one, self.closest_spot(one, other, [T::ZERO; 2]))
    }

    /// Returns the intersection that is closest to a pair of points, given by their displacements in metres
    /// from the starts.
    ///
    /// # Errors
    /// [`GeodesicError::Distance`] or [`GeodesicError::TooFar`] if a displacement is infinite or NaN, or
    /// farther than 10⁴ (`f32`: 50) semi-major axes.
    pub fn closest_to(
        &self,
        one: &Line<T>,
        other: &Line<T>,
        origin: [T; 2],
    ) -> Result<Intersection<T>, GeodesicError<T>> {
        self.accepted(origin)?;
        Ok(self.answer(one, self.closest_spot(one, other, origin)))
    }

    /// Returns where two lines from one place next intersect, ahead or behind: the intersection closest to
    /// the place, other than the place itself. Several are often as close as each other: the result is one of
    /// them.
    ///
    /// Lines that coincide are said to intersect next where neighbouring lines from the place do, at its
    /// conjugate point.
    ///
    /// # Errors
    /// [`GeodesicError::Azimuth`] if an azimuth is infinite or NaN.
    ///
    /// ```
    /// use terrella::route::Intersections;
    /// use terrella::{Ellipsoid, LatLon};
    /// let intersections = Intersections::new(Ellipsoid::WGS84)?;
    /// let next = intersections.next(LatLon::new(50.0_f64, 10.0)?, 20.0, 30.0)?;
    /// assert_eq!(format!("{:.3}", next.position), "49.179, 9.279");
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn next(&self, place: LatLon<T>, azimuth1: T, azimuth2: T) -> Result<Intersection<T>, GeodesicError<T>> {
        let one = self.karney.line(place, azimuth1)?;
        let other = self.karney.line(place, azimuth2)?;
        Ok(self.answer(&one, self.next_spot(&one, &other)))
    }

    /// Returns all intersections within a distance in metres of both starts, the sum of both displacements.
    /// See [`IntersectionsWithin`].
    ///
    /// # Errors
    /// [`GeodesicError::Distance`] or [`GeodesicError::TooFar`] if the distance is negative, infinite or NaN,
    /// or longer than 10⁴ (`f32`: 50) semi-major axes.
    pub fn within(
        &self,
        one: &Line<T>,
        other: &Line<T>,
        distance: T,
    ) -> Result<IntersectionsWithin<T>, GeodesicError<T>> {
        self.within_of(one, other, distance, [T::ZERO; 2])
    }

    /// Returns all intersections within a distance of a pair of points, given by their displacements in
    /// metres from the starts.
    ///
    /// # Errors
    /// As [`within`](Self::within); also for a displacement as for the distance, if it is too far either way.
    pub fn within_of(
        &self,
        one: &Line<T>,
        other: &Line<T>,
        distance: T,
        origin: [T; 2],
    ) -> Result<IntersectionsWithin<T>, GeodesicError<T>> {
        self.accepted(origin)?;
        self.accepted([distance; 2])?;
        if distance < T::ZERO {
            return Err(GeodesicError::Distance(distance));
        }
        Ok(IntersectionsWithin::new(*self, [*one, *other], distance, origin))
    }

    /// Returns where two segments intersect, if they do.
    ///
    /// An end belongs to its segment, and so does a place beyond it by no more than the error of the method:
    /// 6 nm (`f32`: 3.1 m) and 9e-16 (`f32`: 4.8e-7) of both lengths, across the other segment. Segments
    /// that coincide intersect in the middle of their common part.
    ///
    /// If a segment is one of several shortest lines between its ends, as between poles, it is the one of
    /// [`Segment`].
    ///
    /// ```
    /// use terrella::geodesic::Karney;
    /// use terrella::route::{Intersections, Segment};
    /// use terrella::{Ellipsoid, LatLon};
    /// let earth = Karney::new(Ellipsoid::WGS84)?;
    /// let segment = |[lat1, lon1, lat2, lon2]: [f64; 4]| {
    ///     let ends = (LatLon::new(lat1, lon1)?, LatLon::new(lat2, lon2)?);
    ///     Ok::<_, terrella::InvalidLatLon<f64>>(Segment::new(&earth, ends.0, ends.1))
    /// };
    /// let intersections = Intersections::new(Ellipsoid::WGS84)?;
    /// let (ship, border) = (segment([50.0, -10.0, 60.0, 10.0])?, segment([60.0, -10.0, 50.0, 10.0])?);
    /// let crossing = intersections.of_segments(&ship, &border).unwrap().position;
    /// assert_eq!(format!("{:.3} {:.0}", crossing.lat(), crossing.lon().abs()), "56.035 0");
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[must_use]
    pub fn of_segments(&self, one: &Segment<T>, other: &Segment<T>) -> Option<Intersection<T>> {
        self.segment_spot(one, other).map(|spot| {
            let [displacement1, displacement2] = spot.at;
            Intersection {
                displacement1,
                displacement2,
                position: one.passage(displacement1).point.position,
                overlap: spot.overlap,
            }
        })
    }

    /// The segment on this ellipsoid.
    pub(crate) fn segment(&self, from: LatLon<T>, to: LatLon<T>) -> Segment<T> {
        Segment::new(&self.karney, from, to)
    }

    fn answer(&self, one: &Line<T>, spot: Spot<T>) -> Intersection<T> {
        let [displacement1, displacement2] = spot.at;
        Intersection {
            displacement1,
            displacement2,
            position: one.near(displacement1).position,
            overlap: spot.overlap,
        }
    }

    fn accepted(&self, displacements: [T; 2]) -> Result<(), GeodesicError<T>> {
        let limit = self.karney.ellipsoid().a() * T::pick(1e4, 50.0);
        for metres in displacements {
            // False for NaN.
            let near = metres.abs() <= limit;
            if !near {
                return Err(GeodesicError::refused(metres, limit));
            }
        }
        Ok(())
    }
}
