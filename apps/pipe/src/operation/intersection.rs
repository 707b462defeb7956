//! Where geodesics of the ellipsoid intersect.

use std::fmt;

use terrella::LatLon;
use terrella::geodesic::Karney;
use terrella::route::{Intersections, Segment};

use super::{Answer, Failure, Group, answer, group};
use crate::options::Planet;
use crate::read::Number;
use crate::write::{Columns, Row};

pub const GROUP: Group = group! {
    "Intersections of geodesics":
    "intersect"
        "lat1 lon1 azi1 lat2 lon2 azi2 -> metres along each line to the closest intersection, lat lon", lines(Planet);
    "intersect-segments"
        "lat lon of both ends of a segment, of both of another -> lat lon, or none", segments(Planet);
};

/// A place, or the word for no place.
struct OrNone<T>(Option<LatLon<T>>);

impl<T: Number> Row for OrNone<T> {
    fn write(&self, columns: &mut Columns) -> fmt::Result {
        match self.0 {
            Some(place) => place.write(columns),
            None => columns.put("none"),
        }
    }
}

fn lines<T: Number>(planet: Planet) -> Result<Answer, Failure> {
    let ellipsoid = planet.ellipsoid::<T>()?;
    let (karney, intersections) = (Karney::new(ellipsoid)?, Intersections::new(ellipsoid)?);
    answer(move |lines: [(LatLon<T>, T); 2]| {
        let [(place1, azimuth1), (place2, azimuth2)] = lines;
        let (one, other) = (karney.line(place1, azimuth1)?, karney.line(place2, azimuth2)?);
        let met = intersections.closest(&one, &other);
        Ok(([met.displacement1, met.displacement2], met.position))
    })
}

fn segments<T: Number>(planet: Planet) -> Result<Answer, Failure> {
    let ellipsoid = planet.ellipsoid::<T>()?;
    let (karney, intersections) = (Karney::new(ellipsoid)?, Intersections::new(ellipsoid)?);
    answer(move |ends: [[LatLon<T>; 2]; 2]| {
        let [one, other] = ends.map(|[from, to]| Segment::new(&karney, from, to));
        let met = intersections.of_segments(&one, &other);
        Ok(OrNone(met.map(|met| met.position)))
    })
}
