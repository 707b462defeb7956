//! Great circles on a sphere.

use terrella::LatLon;
use terrella::geodesic::{Geodesic, GreatCircle, Haversine};

use super::{Answer, Failure, Group, answer, group};
use crate::options::Nothing;
use crate::read::Number;

pub const GROUP: Group = group! {
    "Great circles on a sphere":
    "gc-inverse" "radius lat1 lon1 lat2 lon2 -> s12 azi1 azi2", inverse(Nothing);
    "hav-inverse" "radius lat1 lon1 lat2 lon2 -> s12 azi1 azi2, by the haversine", haversine(Nothing);
    "gc-direct" "radius lat1 lon1 azi1 s12 -> lat2 lon2 azi2", direct(Nothing);
    "gc-xt" "radius, lat lon of a place, a leg's start and end -> metres to the right of the leg", cross_track(Nothing);
    "gc-at" "radius, lat lon of a place, a leg's start and end -> metres along the leg", along_track(Nothing);
    "gc-frac" "lat1 lon1 lat2 lon2 fraction -> lat lon: where a fraction of the way is done", fraction(Nothing);
    "gc-mid" "lat1 lon1 lat2 lon2 -> lat lon: halfway", middle(Nothing);
};

fn inverse<T: Number>(_: Nothing) -> Result<Answer, Failure> {
    answer(|(radius, [from, to]): (T, [LatLon<T>; 2])| Ok(GreatCircle::new(radius)?.inverse(from, to)?))
}

fn haversine<T: Number>(_: Nothing) -> Result<Answer, Failure> {
    answer(|(radius, [from, to]): (T, [LatLon<T>; 2])| Ok(Haversine::new(radius)?.inverse(from, to)?))
}

fn direct<T: Number>(_: Nothing) -> Result<Answer, Failure> {
    answer(|(radius, from, [azimuth, distance]): (T, LatLon<T>, [T; 2])| {
        Ok(GreatCircle::new(radius)?.direct(from, azimuth, distance)?)
    })
}

fn cross_track<T: Number>(_: Nothing) -> Result<Answer, Failure> {
    answer(|(radius, [place, start, end]): (T, [LatLon<T>; 3])| {
        Ok(GreatCircle::new(radius)?.cross_track(place, start, end))
    })
}

fn along_track<T: Number>(_: Nothing) -> Result<Answer, Failure> {
    answer(|(radius, [place, start, end]): (T, [LatLon<T>; 3])| {
        Ok(GreatCircle::new(radius)?.along_track(place, start, end))
    })
}

fn fraction<T: Number>(_: Nothing) -> Result<Answer, Failure> {
    let sphere = GreatCircle::new(T::ONE)?;
    answer(move |([from, to], fraction): ([LatLon<T>; 2], T)| Ok(sphere.intermediate(from, to, fraction)?))
}

fn middle<T: Number>(_: Nothing) -> Result<Answer, Failure> {
    let sphere = GreatCircle::new(T::ONE)?;
    answer(move |[from, to]: [LatLon<T>; 2]| Ok(sphere.midpoint(from, to)))
}
