//! Areas and lengths of polygons and polylines of geodesics.

use terrella::LatLon;
use terrella::geodesic::{Area, Geodesic, Karney};

use super::{Answer, Failure, Group, answer, group};
use crate::options::Planet;
use crate::read::Number;

pub const GROUP: Group = group! {
    "Polygons of geodesics":
    "polygon" "lat lon, any number of times -> area perimeter: positive counter-clockwise", polygon(Planet);
    "polygon-edges" "lat lon, then azimuth and length of each edge -> area perimeter", polygon_of_edges(Planet);
    "polyline" "lat lon, any number of times -> length", polyline(Planet);
};

fn polygon<T: Number>(planet: Planet) -> Result<Answer, Failure> {
    let area = Area::new(planet.ellipsoid::<T>()?)?;
    answer(move |corners: Vec<LatLon<T>>| {
        let mut polygon = area.polygon();
        corners.into_iter().for_each(|corner| polygon.add(corner));
        Ok([polygon.area(), polygon.perimeter()])
    })
}

fn polygon_of_edges<T: Number>(planet: Planet) -> Result<Answer, Failure> {
    let area = Area::new(planet.ellipsoid::<T>()?)?;
    answer(move |(first, edges): (LatLon<T>, Vec<[T; 2]>)| {
        let mut polygon = area.polygon();
        polygon.add(first);
        for [azimuth, length] in edges {
            polygon.add_edge(azimuth, length)?;
        }
        Ok([polygon.area(), polygon.perimeter()])
    })
}

fn polyline<T: Number>(planet: Planet) -> Result<Answer, Failure> {
    let karney = Karney::new(planet.ellipsoid::<T>()?)?;
    answer(move |places: Vec<LatLon<T>>| {
        let legs = places.iter().zip(places.iter().skip(1));
        let mut length = T::ZERO;
        for (&from, &to) in legs {
            length += karney.inverse(from, to)?.distance;
        }
        Ok(length)
    })
}
