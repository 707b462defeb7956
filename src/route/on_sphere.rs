use super::bound::at_least;
use super::{Closest, Legs, Reach, Track};
use crate::geodesic::{Geodesic, GreatCircle, Inverse};
use crate::{Ellipsoid, LatLon, Real};

/// An arc of a great circle, from [`Legs::leg`] of [`GreatCircle`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct SphereLeg<T> {
    start: LatLon<T>,
    end: LatLon<T>,
    azimuth: T,
    length: T,
}

/// Legs of the sphere are arcs of great circles, of at most half a circle.
///
/// The worst error of the distance is 2e-15 (`f32`: 1e-6) of the distance from the start to the place, or of
/// the radius if that is less: as that of [`GreatCircle::cross_track`]. The closest point is as accurate,
/// divided by the cosine of the distance in radii.
///
/// ```
/// use terrella::geodesic::GreatCircle;
/// use terrella::route::{Legs, Reach};
/// use terrella::LatLon;
/// let earth = GreatCircle::new(6_371_008.8_f64)?;
/// let (start, end) = (LatLon::new(55.984_67, 13.544_43)?, LatLon::new(55.984_618, 13.544_295)?);
/// let place = LatLon::new(55.976_093, 13.547_599)?;
/// // The circle through both passes the place at 897 m, but not the leg.
/// let closest = earth.closest(place, start, end);
/// assert_eq!((closest.reach, closest.distance.round()), (Reach::PastEnd, 970.0));
/// assert_eq!(earth.track(place, start, end).across.round(), -897.0);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
impl<T: Real> Legs<T> for GreatCircle<T> {
    type Leg = SphereLeg<T>;

    fn leg(&self, start: LatLon<T>, end: LatLon<T>) -> SphereLeg<T> {
        let (Inverse { azimuth1, distance, .. }, _) = self.fast_inverse(start, end);
        SphereLeg {
            start,
            end,
            azimuth: azimuth1,
            length: distance,
        }
    }

    fn length(&self, leg: &SphereLeg<T>) -> T {
        leg.length
    }

    fn closest_on(&self, leg: &SphereLeg<T>, place: LatLon<T>) -> Closest<T> {
        let SphereLeg {
            start,
            end,
            azimuth,
            length,
        } = *leg;
        let Track { across, along } = self.track_beside(leg, place);
        if (along >= T::ZERO) & (along <= length) {
            return Closest {
                distance: across.abs(),
                position: self.fast_direct(start, azimuth, along).0.position,
                along,
                reach: Reach::Within,
            };
        }
        let apart = |end: LatLon<T>| self.fast_inverse(place, end).0.distance;
        let (from_start, from_end) = (apart(start), apart(end));
        if from_start <= from_end {
            Closest {
                distance: from_start,
                position: start,
                along: T::ZERO,
                reach: Reach::BeforeStart,
            }
        } else {
            Closest {
                distance: from_end,
                position: end,
                along: length,
                reach: Reach::PastEnd,
            }
        }
    }

    fn track_beside(&self, leg: &SphereLeg<T>, place: LatLon<T>) -> Track<T> {
        let [along, across] = self.tracks_beside(place, leg.start, leg.azimuth);
        Track { across, along }
    }

    fn at_least(&self, place: LatLon<T>, start: LatLon<T>, end: LatLon<T>) -> T {
        // A radius that was accepted once is again.
        Ellipsoid::sphere(self.radius()).map_or(T::ZERO, |sphere| at_least(sphere, place, start, end))
    }
}
