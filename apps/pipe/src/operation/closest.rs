//! Closest points of legs, and places beside them.

use terrella::LatLon;
use terrella::geodesic::Karney;
use terrella::route::Legs;

use super::{Answer, Failure, Group, answer, group};
use crate::options::Planet;
use crate::read::Number;

pub const GROUP: Group = group! {
    "Legs of geodesics: lat lon of a place, of the start, of the end":
    "closest-segment" "lat lon lat1 lon1 lat2 lon2 -> distance lat lon along: the leg's closest point", closest(Planet);
    "cross-track" "lat lon lat1 lon1 lat2 lon2 -> across along: metres right of and along the whole line", track(Planet);
};

fn closest<T: Number>(planet: Planet) -> Result<Answer, Failure> {
    let earth = Karney::new(planet.ellipsoid::<T>()?)?;
    answer(move |[place, start, end]: [LatLon<T>; 3]| {
        let closest = earth.closest(place, start, end);
        Ok((closest.distance, closest.position, closest.along))
    })
}

fn track<T: Number>(planet: Planet) -> Result<Answer, Failure> {
    let earth = Karney::new(planet.ellipsoid::<T>()?)?;
    answer(move |[place, start, end]: [LatLon<T>; 3]| {
        let track = earth.track(place, start, end);
        Ok([track.across, track.along])
    })
}
