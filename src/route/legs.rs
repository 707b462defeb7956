use super::path::{Path, nearest};
use super::{Closest, OnPath, Track};
use crate::{LatLon, Real};

/// A surface on which two places have a shortest line between them, a leg, and a place has a closest point of
/// it.
///
/// Your own surface needs [`leg`](Self::leg), [`length`](Self::length), [`closest_on`](Self::closest_on) and
/// [`track_beside`](Self::track_beside). Polylines, rings and [`batch::route`](crate::batch::route) then
/// work on it, too.
///
/// ```
/// use terrella::geodesic::GreatCircle;
/// use terrella::route::{Closest, Legs, Reach, SphereLeg, Track};
/// use terrella::LatLon;
///
/// /// The Earth for who counts in nautical miles.
/// struct Nautical(GreatCircle<f64>);
///
/// impl Legs<f64> for Nautical {
///     type Leg = SphereLeg<f64>;
///
///     fn leg(&self, start: LatLon<f64>, end: LatLon<f64>) -> Self::Leg {
///         self.0.leg(start, end)
///     }
///
///     fn length(&self, leg: &Self::Leg) -> f64 {
///         self.0.length(leg) / 1852.0
///     }
///
///     fn closest_on(&self, leg: &Self::Leg, place: LatLon<f64>) -> Closest<f64> {
///         let closest = self.0.closest_on(leg, place);
///         Closest { distance: closest.distance / 1852.0, along: closest.along / 1852.0, ..closest }
///     }
///
///     fn track_beside(&self, leg: &Self::Leg, place: LatLon<f64>) -> Track<f64> {
///         let track = self.0.track_beside(leg, place);
///         Track { across: track.across / 1852.0, along: track.along / 1852.0 }
///     }
/// }
///
/// let sea = Nautical(GreatCircle::new(6_366_707.0)?);
/// let triangle = [LatLon::new(0.0, 0.0)?, LatLon::new(0.0, 10.0)?, LatLon::new(10.0, 10.0)?];
/// let found = sea.closest_of_ring(LatLon::new(1.0, 11.0)?, triangle).expect("a ring has a place");
/// assert_eq!((found.leg, found.closest.reach), (1, Reach::Within));
/// assert!((found.closest.distance - 60.0).abs() < 0.1);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub trait Legs<T: Real> {
    /// A leg, with what depends on it alone: it is computed once for many places.
    type Leg;

    /// Makes the leg between two places. If they coincide, or several shortest lines are as long, it is the
    /// one that [`Geodesic::inverse`](crate::geodesic::Geodesic::inverse) takes.
    fn leg(&self, start: LatLon<T>, end: LatLon<T>) -> Self::Leg;

    /// Returns the length of a leg in metres.
    fn length(&self, leg: &Self::Leg) -> T;

    /// Finds the point of a leg that is closest to a place. If several points are as close, it is one of
    /// them.
    #[doc(alias = "distance_to_segment")]
    fn closest_on(&self, leg: &Self::Leg, place: LatLon<T>) -> Closest<T>;

    /// Measures where a place is beside the whole line of a leg.
    fn track_beside(&self, leg: &Self::Leg, place: LatLon<T>) -> Track<T>;

    /// Returns a distance in metres that [`closest_on`](Self::closest_on) is not below for this place and the
    /// leg between two places. It is cheap: polylines and rings skip legs by it. By default 0.
    #[inline]
    fn at_least(&self, _place: LatLon<T>, _start: LatLon<T>, _end: LatLon<T>) -> T {
        T::ZERO
    }

    /// Finds the point of the leg between two places that is closest to a place.
    #[inline]
    fn closest(&self, place: LatLon<T>, start: LatLon<T>, end: LatLon<T>) -> Closest<T> {
        self.closest_on(&self.leg(start, end), place)
    }

    /// Measures where a place is beside the whole line through two places.
    #[inline]
    #[doc(alias("cross_track", "along_track"))]
    fn track(&self, place: LatLon<T>, start: LatLon<T>, end: LatLon<T>) -> Track<T> {
        self.track_beside(&self.leg(start, end), place)
    }

    /// Finds the point of a polyline that is closest to a place; none if the polyline has no places. A single
    /// place is a leg of no length.
    ///
    /// Legs that are surely farther than one before are skipped. The answer is that of all legs; of legs that
    /// are as close it is the first.
    #[doc(alias = "nearest_point_on_line")]
    fn closest_of_path(&self, place: LatLon<T>, path: impl IntoIterator<Item = LatLon<T>>) -> Option<OnPath<T>> {
        nearest(self, place, path, Path::Open)
    }

    /// Finds the point of a ring that is closest to a place, as [`closest_of_path`](Self::closest_of_path)
    /// does. A leg closes the ring from the last place to the first; it has no length if they are the same.
    fn closest_of_ring(&self, place: LatLon<T>, ring: impl IntoIterator<Item = LatLon<T>>) -> Option<OnPath<T>> {
        nearest(self, place, ring, Path::Closed)
    }
}
