use crate::batch::InvalidBatch;
use crate::batch::engine::solve_each;
use crate::batch::geodesic::path_legs;
use crate::route::{Closest, Legs, Track};
use crate::{InvalidLatLon, LatLon, Real};

fn place<T: Real>([lat, lon]: [T; 2]) -> Result<LatLon<T>, InvalidLatLon<T>> {
    LatLon::new(lat, lon)
}

fn point<T: Real>(closest: Closest<T>) -> [T; 4] {
    let Closest {
        distance,
        position,
        along,
        ..
    } = closest;
    [distance, position.lat(), position.lon(), along]
}

fn beside<T: Real>(track: Track<T>) -> [T; 2] {
    [track.across, track.along]
}

/// Finds the points of one leg that are closest to places: distances in metres, latitudes and longitudes in
/// degrees, and distances along the leg, with the bits of [`Legs::closest`]. The leg is made once.
///
/// # Errors
/// [`InvalidBatch`] if slices have unequal lengths, or [`LatLon::new`] refuses a place.
///
/// ```
/// use terrella::{LatLon, batch::route, geodesic::GreatCircle};
/// let sphere = GreatCircle::new(6_371_000.0_f64)?;
/// let (start, end) = (LatLon::new(0.0, 0.0)?, LatLon::new(0.0, 90.0)?);
/// let (mut distance, mut lat, mut lon, mut along) = ([0.0; 2], [0.0; 2], [0.0; 2], [0.0; 2]);
/// let found = [&mut distance[..], &mut lat, &mut lon, &mut along];
/// route::closest(&sphere, [&[-1.0, 0.0], &[30.0, -1.0]], start, end, found)?;
/// assert_eq!((distance.map(f64::round), lon.map(f64::round)), ([111_195.0, 111_195.0], [30.0, 0.0]));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn closest<T: Real, S: Legs<T>>(
    surface: &S,
    places: [&[T]; 2],
    start: LatLon<T>,
    end: LatLon<T>,
    found: [&mut [T]; 4],
) -> Result<(), InvalidBatch<InvalidLatLon<T>>> {
    let leg = surface.leg(start, end);
    solve_each(places, found, |row| Ok(point(surface.closest_on(&leg, place(row)?))))
}

/// Finds the point of each leg of a path that is closest to one place, as [`closest`] does. There is one leg
/// less than places of the path.
///
/// # Errors
/// Those of [`closest`]; an element is a leg. A place of the path that is refused spoils two legs.
pub fn leg_closest<T: Real, S: Legs<T>>(
    surface: &S,
    ship: LatLon<T>,
    path: [&[T]; 2],
    found: [&mut [T]; 4],
) -> Result<(), InvalidBatch<InvalidLatLon<T>>> {
    solve_each(path_legs(path), found, |(start, end)| {
        Ok(point(surface.closest(ship, place(start)?, place(end)?)))
    })
}

/// Measures where places are across and along the whole line of one leg: distances in metres, with the bits
/// of
/// [`Legs::track`]. The leg is made once.
///
/// # Errors
/// Those of [`closest`].
#[doc(alias("cross track distance", "along track distance"))]
pub fn tracks<T: Real, S: Legs<T>>(
    surface: &S,
    places: [&[T]; 2],
    start: LatLon<T>,
    end: LatLon<T>,
    tracks: [&mut [T]; 2],
) -> Result<(), InvalidBatch<InvalidLatLon<T>>> {
    let leg = surface.leg(start, end);
    solve_each(places, tracks, |row| {
        Ok(beside(surface.track_beside(&leg, place(row)?)))
    })
}

/// Measures where one place is across and along the line of each leg of a path, as [`tracks`] does. There is
/// one leg less than places of the path.
///
/// # Errors
/// Those of [`closest`]; an element is a leg. A place of the path that is refused spoils two legs.
pub fn leg_tracks<T: Real, S: Legs<T>>(
    surface: &S,
    ship: LatLon<T>,
    path: [&[T]; 2],
    tracks: [&mut [T]; 2],
) -> Result<(), InvalidBatch<InvalidLatLon<T>>> {
    solve_each(path_legs(path), tracks, |(start, end)| {
        Ok(beside(surface.track(ship, place(start)?, place(end)?)))
    })
}
