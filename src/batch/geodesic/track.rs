//! Distances along and across great circles.

use crate::batch::InvalidBatch;
use crate::batch::engine::solve_by;
use crate::batch::position::{Pairs, Places};
use crate::geodesic::GreatCircle;
use crate::simd::{Behind, Door, Kernel, lanes};
use crate::{InvalidLatLon, LatLon, Real};

use super::{Pair, path_legs, within};

/// Beside one great circle.
#[derive(Clone, Copy)]
struct Beside<T> {
    sphere: GreatCircle<T>,
    start: LatLon<T>,
    azimuth: T,
}

impl<T: Real> Kernel<[T; 2]> for Beside<T> {
    type Output = [T; 2];

    #[inline(always)]
    fn apply(&self, place: [T; 2]) -> [T; 2] {
        self.sphere.tracks_beside(within(place), self.start, self.azimuth)
    }
}

/// Beside many legs.
#[derive(Clone, Copy)]
struct BesideLeg<T> {
    sphere: GreatCircle<T>,
    place: LatLon<T>,
}

impl<T: Real> Kernel<Pair<T>> for BesideLeg<T> {
    type Output = [T; 2];

    #[inline(always)]
    fn apply(&self, (start, end): Pair<T>) -> [T; 2] {
        let (start, end) = (within(start), within(end));
        let azimuth = GreatCircle::course(start, end);
        self.sphere.tracks_beside(self.place, start, azimuth)
    }
}

/// Measures where places lie along and beside the great circle through two others: distances in metres, with
/// the bits of [`GreatCircle::along_track`] and [`GreatCircle::cross_track`]. The circle is found once.
///
/// # Errors
/// [`InvalidBatch`] if slices have unequal lengths, or [`LatLon::new`] refuses a place.
///
/// ```
/// use terrella::{LatLon, batch::geodesic, geodesic::GreatCircle};
/// let sphere = GreatCircle::new(6_371_000.0_f64)?;
/// let (start, end) = (LatLon::new(0.0, 0.0)?, LatLon::new(0.0, 90.0)?);
/// let (mut along, mut cross) = ([0.0; 2], [0.0; 2]);
/// geodesic::tracks(&sphere, [&[-1.0, 0.5], &[30.0, -1.0]], start, end, [&mut along, &mut cross])?;
/// assert_eq!(along.map(f64::round), [3_335_848.0, -111_195.0]);
/// assert_eq!(cross.map(f64::round), [111_195.0, -55_597.0]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[doc(alias = "cross track distance", alias = "along track distance")]
pub fn tracks<T: Real>(
    sphere: &GreatCircle<T>,
    places: [&[T]; 2],
    start: LatLon<T>,
    end: LatLon<T>,
    tracks: [&mut [T]; 2],
) -> Result<(), InvalidBatch<InvalidLatLon<T>>> {
    let beside = Beside {
        sphere: *sphere,
        start,
        azimuth: GreatCircle::course(start, end),
    };
    solve_by(
        places,
        tracks,
        |place| Ok(beside.apply(Places.admit(place)?)),
        |places, tracks, tally| lanes(Behind(Places, beside), places, tracks, tally),
    )
}

/// Measures where a place lies along and beside each leg of a path, as [`tracks`] does: along and beside the
/// great circle from each place of the path to the next. There is one leg less than places.
///
/// A place is beside the leg itself if its along-track distance is from 0 to the length that
/// [`legs`](super::legs) gives.
///
/// # Errors
/// Those of [`tracks`]; an element is a leg. A place of the path that is refused spoils two legs.
///
/// ```
/// use terrella::{LatLon, batch::geodesic, geodesic::GreatCircle};
/// let sphere = GreatCircle::new(6_371_000.0_f64)?;
/// let ship = LatLon::new(1.0, 9.5)?;
/// let (mut along, mut cross) = ([0.0; 2], [0.0; 2]);
/// geodesic::leg_tracks(&sphere, ship, [&[0.0, 0.0, 10.0], &[0.0, 10.0, 10.0]], [&mut along, &mut cross])?;
/// assert_eq!(cross.map(f64::round), [-111_195.0, -55_589.0]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn leg_tracks<T: Real>(
    sphere: &GreatCircle<T>,
    place: LatLon<T>,
    path: [&[T]; 2],
    tracks: [&mut [T]; 2],
) -> Result<(), InvalidBatch<InvalidLatLon<T>>> {
    let beside = BesideLeg { sphere: *sphere, place };
    solve_by(
        path_legs(path),
        tracks,
        |leg| Ok(beside.apply(Pairs.admit(leg)?)),
        |legs, tracks, tally| lanes(Behind(Pairs, beside), legs, tracks, tally),
    )
}
