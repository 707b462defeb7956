//! Geodesics on the ellipsoid.

use terrella::LatLon;
use terrella::geodesic::{Area, Geodesic, Karney};

use super::{Answer, Failure, Group, answer, group};
use crate::options::{Line, Planet};
use crate::read::Number;

pub const GROUP: Group = group! {
    "Geodesics":
    "geodesic-inverse" "lat1 lon1 lat2 lon2 -> s12 azi1 azi2: from one place to another, by any method", inverse(Line);
    "geodesic-direct"
        "lat1 lon1 azi1 s12 -> lat2 lon2 azi2: where an azimuth and a distance lead, by any method", direct(Line);
    "solve" "lat1 lon1 lat2 lon2 -> s12 azi1 azi2 a12 m12 M12 M21 S12: all of the solution", solve(Planet);
    "line" "lat1 lon1 azi1 s12 -> lat2 lon2 azi2 a12 m12 M12 M21 S12: the same", line(Planet);
    "line-between"
        "lat1 lon1 lat2 lon2 fraction -> lat lon azi: where a fraction of the way is done", line_between(Planet);
    "line-toward"
        "lat1 lon1 lat2 lon2 s -> lat lon azi a12 m12 M12 M21 S12: at a distance on the way", line_toward(Planet);
};

fn inverse<T: Number>(line: Line) -> Result<Answer, Failure> {
    let geodesic = line.method::<T>()?;
    answer(move |[from, to]: [LatLon<T>; 2]| Ok(geodesic.inverse(from, to)?))
}

fn direct<T: Number>(line: Line) -> Result<Answer, Failure> {
    let geodesic = line.method::<T>()?;
    answer(move |(from, [azimuth, distance]): (LatLon<T>, [T; 2])| Ok(geodesic.direct(from, azimuth, distance)?))
}

fn solve<T: Number>(planet: Planet) -> Result<Answer, Failure> {
    let (karney, area) = (Karney::new(planet.ellipsoid::<T>()?)?, Area::new(planet.ellipsoid()?)?);
    answer(move |[from, to]: [LatLon<T>; 2]| {
        let way = karney.solve(from, to);
        let rest = [
            way.arc,
            way.reduced_length,
            way.scale12,
            way.scale21,
            area.under(from, to),
        ];
        Ok((way.inverse, rest))
    })
}

fn line<T: Number>(planet: Planet) -> Result<Answer, Failure> {
    let (karney, area) = (Karney::new(planet.ellipsoid::<T>()?)?, Area::new(planet.ellipsoid()?)?);
    answer(move |(from, [azimuth, distance]): (LatLon<T>, [T; 2])| {
        let end = karney.line(from, azimuth)?.at(distance)?;
        Ok((end, area.under_direct(from, azimuth, distance)?))
    })
}

fn line_between<T: Number>(planet: Planet) -> Result<Answer, Failure> {
    let karney = Karney::new(planet.ellipsoid::<T>()?)?;
    answer(move |([from, to], fraction): ([LatLon<T>; 2], T)| {
        let way = karney.solve(from, to).inverse;
        let point = karney.line(from, way.azimuth1)?.at(way.distance * fraction)?;
        Ok((point.position, point.azimuth))
    })
}

fn line_toward<T: Number>(planet: Planet) -> Result<Answer, Failure> {
    let (karney, area) = (Karney::new(planet.ellipsoid::<T>()?)?, Area::new(planet.ellipsoid()?)?);
    answer(move |([from, to], distance): ([LatLon<T>; 2], T)| {
        let azimuth = karney.solve(from, to).inverse.azimuth1;
        let point = karney.line(from, azimuth)?.at(distance)?;
        Ok((point, area.under_direct(from, azimuth, distance)?))
    })
}
