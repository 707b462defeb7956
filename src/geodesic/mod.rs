//! Distances, azimuths, destinations and areas on the ellipsoid and on the sphere.
//!
//! Each method is a type, made for one ellipsoid or sphere, and solves the same two problems through the
//! trait [`Geodesic`]: the *inverse* problem (two places → distance and azimuths) and the *direct* problem
//! (place, azimuth, distance → destination). Take [`Karney`] unless code size or speed forces another choice;
//! [`scene`](crate::scene) chooses the cheapest method for a region and a tolerance.
//!
#![doc = include_str!("methods.md")]
//!
//! [`Area`] and [`PolygonArea`] measure polygons of any size, [`PlanarArea`] fields of some hundred
//! kilometres. [`batch::geodesic`](crate::batch::geodesic) solves whole slices.
//!
//! Azimuths are in degrees clockwise from north, distances in metres, latitudes and longitudes in degrees.

// From the floor up: angles; the auxiliary sphere and its series; the two solvers; the methods.
mod angle;
mod error;
mod fast;
mod general;
mod half_angle;
mod half_arc;
mod mid_latitude;
mod series;
mod sphere;

mod method;
mod planar_area;
mod profile;

pub(crate) use angle::{
    between_poles, heading, latitude_difference, longitude_difference, longitude_step, off_pole, turns_once, wrapped,
};
pub use error::GeodesicError;
pub use general::{Line, LinePoint, Passage};
pub use karney::{Area, PolygonArea, Solution};
pub(crate) use karney::{Edge, Edges};
pub use method::{InvalidMethod, UnknownMethod, Visitor};
pub(crate) use planar_area::Tangent;
pub use planar_area::{PlanarArea, PlanarPolygon};
pub use profile::{Linear, Profile, Surface, WorstErrors};

use crate::latitude::UnsupportedFlattening;
use crate::{Ellipsoid, LatLon, Real};
use method::methods;

// One line a method, the fewest instructions first. To add one, write its file and its line.
methods! {
    plane::Plane |e, place| Plane::new(e, place);
    flat::Flat |e| Flat::new(e);
    gauss::Gauss |e| Gauss::new(e);
    great_circle::GreatCircle |e| Ok(GreatCircle::mean(e));
    haversine::Haversine |e| Ok(Haversine::mean(e));
    bowring::Bowring |e| Bowring::new(e);
    andoyer::Andoyer |e| Andoyer::new(e);
    karney::Karney |e| Karney::new(e);
    andoyer_second::AndoyerSecond |e| AndoyerSecond::new(e);
    vincenty::Vincenty |e| Vincenty::new(e);
}

/// A method that solves the inverse and the direct problem of geodesy.
///
/// The distance and both azimuths of an [`Inverse`] belong to the same line: from the first place along
/// `azimuth1`, after `distance` metres, it reaches the second place and arrives there with `azimuth2`. If
/// there are several shortest lines, all three numbers belong to one of them.
///
/// At a pole, an azimuth counts from the meridian of the longitude that is given with the pole. Between some
/// places the azimuths are not determined. There all methods follow the same rule: the line starts to the
/// north, with `azimuth1` = 0:
///
/// | places | distance | `azimuth2` |
/// |---|---|---|
/// | coincident | 0 | 0 |
/// | the same pole, with two longitudes | 0 | λ₂ − λ₁ at the north pole, λ₁ − λ₂ at the south pole |
/// | from pole to pole | half of a meridian | λ₂ − λ₁ at the north pole, λ₁ − λ₂ at the south pole |
/// | antipodes on a sphere | half of a circle | 180 |
///
/// Your own method needs [`inverse`](Self::inverse) and [`direct`](Self::direct), and then goes through
/// [`batch::geodesic`](crate::batch::geodesic), too. The other functions are there to make batches faster.
///
/// ```
/// use terrella::geodesic::{Direct, Geodesic, GeodesicError, GreatCircle, Inverse};
/// use terrella::{LatLon, batch};
///
/// /// A sphere on which everything is measured in nautical miles.
/// struct Nautical(GreatCircle<f64>);
///
/// impl Geodesic<f64> for Nautical {
///     fn inverse(&self, from: LatLon<f64>, to: LatLon<f64>) -> Result<Inverse<f64>, GeodesicError<f64>> {
///         let line = self.0.inverse(from, to)?;
///         Ok(Inverse { distance: line.distance / 1852.0, ..line })
///     }
///
///     fn direct(
///         &self,
///         from: LatLon<f64>,
///         azimuth: f64,
///         distance: f64,
///     ) -> Result<Direct<f64>, GeodesicError<f64>> {
///         self.0.direct(from, azimuth, 1852.0 * distance)
///     }
/// }
///
/// let earth = Nautical(GreatCircle::new(6_366_707.0)?);
/// let (mut distance, mut there, mut back) = ([0.0; 2], [0.0; 2], [0.0; 2]);
/// let (from, to): ([&[f64]; 2], [&[f64]; 2]) = ([&[0.0, 0.0], &[0.0, 0.0]], [&[1.0, 0.0], &[0.0, 2.0]]);
/// batch::geodesic::inverse(&earth, from, to, [&mut distance, &mut there, &mut back])?;
/// assert_eq!(distance.map(f64::round), [60.0, 120.0]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub trait Geodesic<T: Real> {
    /// Solves the inverse problem: returns the distance between two places and the azimuths at both.
    ///
    /// # Errors
    /// None, unless the method says so: only [`Vincenty`] does, with [`GeodesicError::NotConverged`].
    #[doc(alias = "geod_inverse", alias = "bearing")]
    fn inverse(&self, from: LatLon<T>, to: LatLon<T>) -> Result<Inverse<T>, GeodesicError<T>>;

    /// Returns the distance between two places in metres, with the bits of [`inverse`](Self::inverse) and
    /// without computing azimuths.
    ///
    /// ```
    /// use terrella::geodesic::{Geodesic, GreatCircle};
    /// use terrella::LatLon;
    /// let sphere = GreatCircle::new(6_371_000.0)?;
    /// let (here, there) = (LatLon::new(0.0, 0.0)?, LatLon::new(0.0, 90.0)?);
    /// assert_eq!(sphere.distance(here, there)?, sphere.inverse(here, there)?.distance);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// Those of [`inverse`](Self::inverse).
    #[inline(always)]
    fn distance(&self, from: LatLon<T>, to: LatLon<T>) -> Result<T, GeodesicError<T>> {
        // The compiler leaves out what computes azimuths. For size there is one copy of the solver.
        if !cfg!(small) {
            let (line, found) = self.fast_inverse(from, to);
            if found {
                return Ok(line.distance);
            }
        }
        self.inverse(from, to).map(|line| line.distance)
    }

    /// Solves the direct problem: returns the place that is reached from a place, at an azimuth in degrees,
    /// after a distance in metres, and the azimuth there. A negative distance goes backwards.
    ///
    /// # Errors
    /// [`GeodesicError::Azimuth`] or [`GeodesicError::Distance`] for a value that is infinite or NaN;
    /// [`GeodesicError::TooFar`] for a distance that is longer than the method's limit, if it has one. A
    /// method on an ellipsoid of metres or less may refuse the largest numbers.
    #[doc(alias = "geod_direct", alias = "destination")]
    fn direct(&self, from: LatLon<T>, azimuth: T, distance: T) -> Result<Direct<T>, GeodesicError<T>>;

    /// Solves the inverse problem for [`batch::geodesic::inverse`](crate::batch::geodesic::inverse). Returns
    /// a line, and whether it is that of [`inverse`](Self::inverse), bit for bit. If not, the line may hold
    /// any numbers, and the batch calls [`inverse`](Self::inverse).
    ///
    /// The default calls [`inverse`](Self::inverse). Override it, with `#[inline(always)]`, if most places
    /// can be solved without a branch that depends on them, so that the loop vectorises. It must return for
    /// any numbers, also for latitudes and longitudes that [`LatLon::new`] refuses.
    #[inline(always)]
    fn fast_inverse(&self, from: LatLon<T>, to: LatLon<T>) -> (Inverse<T>, bool) {
        match self.inverse(from, to) {
            Ok(line) => (line, true),
            Err(_) => (Inverse::nothing(), false),
        }
    }

    /// As [`fast_inverse`](Self::fast_inverse), for places between which that finds no line, as nearly
    /// antipodal ones: a batch solves them together. The default finds none.
    #[inline(always)]
    fn far_inverse(&self, _from: LatLon<T>, _to: LatLon<T>) -> (Inverse<T>, bool) {
        (Inverse::nothing(), false)
    }

    /// As [`fast_inverse`](Self::fast_inverse) for [`batch::geodesic::distance`](crate::batch::geodesic::distance):
    /// a number of which [`finish_distance`](Self::finish_distance) makes the distance. By default the distance
    /// itself.
    #[inline(always)]
    fn fast_distance(&self, from: LatLon<T>, to: LatLon<T>) -> (T, bool) {
        let (line, found) = self.fast_inverse(from, to);
        (line.distance, found)
    }

    /// The distance from the number that [`fast_distance`](Self::fast_distance) found. A batch calls it in a
    /// second loop: a processor overlaps more places in two short loops than in a long one. By default the
    /// number itself.
    #[inline(always)]
    fn finish_distance(&self, number: T) -> T {
        number
    }

    /// Solves the direct problem for [`batch::geodesic::direct`](crate::batch::geodesic::direct), as
    /// [`fast_inverse`](Self::fast_inverse) does the inverse one.
    #[inline(always)]
    fn fast_direct(&self, from: LatLon<T>, azimuth: T, distance: T) -> (Direct<T>, bool) {
        match self.direct(from, azimuth, distance) {
            Ok(end) => (end, true),
            Err(_) => (Direct::nothing(), false),
        }
    }

    /// Runs a task with the method's own type. An [`AnyMethod`] runs it with the type that it holds, so that a
    /// loop over places chooses the method once.
    #[doc(hidden)]
    #[inline(always)]
    fn with<W: GeodesicTask<T>>(&self, task: W) -> W::Output
    where
        Self: Sized,
    {
        task.run(self)
    }
}

/// A task for a method whose type is not known yet: see [`Geodesic::with`].
///
/// ```
/// use terrella::geodesic::{Geodesic, GeodesicTask, Method};
/// use terrella::Ellipsoid;
///
/// struct Size;
///
/// impl GeodesicTask<f64> for Size {
///     type Output = usize;
///     fn run<M: Geodesic<f64>>(self, _: &M) -> usize {
///         size_of::<M>()
///     }
/// }
///
/// assert_eq!(Method::GreatCircle.on(Ellipsoid::<f64>::WGS84)?.with(Size), 8);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[doc(hidden)]
pub trait GeodesicTask<T: Real> {
    /// What is returned.
    type Output;

    /// Runs the task with a method.
    fn run<M: Geodesic<T>>(self, method: &M) -> Self::Output;
}

/// The solution of the inverse problem.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Inverse<T> {
    /// The distance in metres, not negative.
    pub distance: T,
    /// The azimuth at the first place toward the second, in degrees clockwise from north, in [−180, 180].
    pub azimuth1: T,
    /// The azimuth of travel at the second place, in degrees clockwise from north, in [−180, 180]. It points
    /// away from the first place; the way back starts at `azimuth2` + 180.
    pub azimuth2: T,
}

/// The solution of the direct problem.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Direct<T> {
    /// The place reached.
    pub position: LatLon<T>,
    /// The azimuth of travel there, in degrees clockwise from north, in [−180, 180].
    pub azimuth: T,
}

impl<T: Real> Inverse<T> {
    /// What stands for a line where there is none.
    fn nothing() -> Self {
        Self {
            distance: T::ZERO,
            azimuth1: T::ZERO,
            azimuth2: T::ZERO,
        }
    }
}

impl<T: Real> Direct<T> {
    /// What stands for an end where there is none.
    fn nothing() -> Self {
        Self {
            position: LatLon::within(T::ZERO, T::ZERO),
            azimuth: T::ZERO,
        }
    }
}

/// The ellipsoid, if its flattening is at most 1/60: that far the short series and polynomials of the simpler
/// methods keep what they claim.
pub(crate) fn nearly_round<T: Real>(ellipsoid: Ellipsoid<T>) -> Result<Ellipsoid<T>, UnsupportedFlattening<T>> {
    // 1/60, and room for its rounding.
    if ellipsoid.f().abs() > T::of(1.0 / 60.0 + 1e-8) {
        return Err(UnsupportedFlattening(ellipsoid.f()));
    }
    Ok(ellipsoid)
}
