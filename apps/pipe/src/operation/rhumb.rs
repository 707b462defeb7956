//! Rhumb lines on the ellipsoid.

use terrella::LatLon;
use terrella::route::Rhumb;

use super::{Answer, Failure, Group, answer, group};
use crate::options::Planet;
use crate::read::Number;

pub const GROUP: Group = group! {
    "Rhumb lines":
    "rhumb-inverse"
        "lat1 lon1 lat2 lon2 -> s azi area: the shortest, with the area under it", inverse(Planet);
    "rhumb-direct" "lat lon azi s -> lat lon: where an azimuth and a distance lead", direct(Planet);
};

fn inverse<T: Number>(planet: Planet) -> Result<Answer, Failure> {
    let rhumb = Rhumb::new(planet.ellipsoid::<T>()?)?;
    answer(move |[from, to]: [LatLon<T>; 2]| {
        let line = rhumb.inverse(from, to);
        Ok([line.distance, line.azimuth, line.area])
    })
}

fn direct<T: Number>(planet: Planet) -> Result<Answer, Failure> {
    let rhumb = Rhumb::new(planet.ellipsoid::<T>()?)?;
    answer(move |(from, [azimuth, distance]): (LatLon<T>, [T; 2])| Ok(rhumb.direct(from, azimuth, distance)?.position))
}
