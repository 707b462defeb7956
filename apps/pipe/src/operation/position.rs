//! Ellipsoids, and where something is: on them, in Earth axes, on the sphere.

use terrella::{Direction, Ecef, Geodetic, LatLon, LocalFrame};

use super::{Answer, Failure, Group, answer, group};
use crate::options::{Nothing, Planet, rounded};
use crate::read::{Count, Fields, Number, Read};

pub const GROUP: Group = group! {
    "Ellipsoids and positions":
    "radii" "[NAME|A,F] -> a b f n e2 ep2, mean, volumetric and authalic radius of an ellipsoid", radii(Planet);
    "to-ecef" "lat lon h -> X Y Z", to_ecef(Planet);
    "from-ecef" "X Y Z -> lat lon h of the nearest point of the ellipsoid, and the height above it", from_ecef(Planet);
    "direction" "lat lon -> X Y Z on the unit sphere", direction(Nothing);
    "latlon" "X Y Z of any length -> lat lon on the sphere", lat_lon(Nothing);
    "up" "lat lon -> X Y Z of the unit vector upward", up(Planet);
    "north" "lat lon -> X Y Z of the unit vector to the north", north(Planet);
    "east" "lat lon -> X Y Z of the unit vector to the east", east(Planet);
};

/// An ellipsoid as a column.
struct Ellipsoid(terrella::Ellipsoid<f64>);

impl Read for Ellipsoid {
    const COLUMNS: Count = Count::exactly(1);

    fn read(fields: &mut Fields) -> Result<Self, Failure> {
        Ok(Self(draw::ellipsoid::parse(fields.text()?)?))
    }
}

fn radii<T: Number>(planet: Planet) -> Result<Answer, Failure> {
    let default = planet.ellipsoid::<T>()?;
    answer(move |other: Option<Ellipsoid>| {
        let e = other.map_or(Ok(default), |Ellipsoid(other)| rounded(other))?;
        let radii = [e.mean_radius(), e.volumetric_radius(), e.authalic_radius()];
        Ok(([e.a(), e.b(), e.f(), e.n(), e.e2(), e.ep2()], radii))
    })
}

fn to_ecef<T: Number>(planet: Planet) -> Result<Answer, Failure> {
    let ellipsoid = planet.ellipsoid::<T>()?;
    answer(move |place: Geodetic<T>| Ok(ellipsoid.to_ecef(place)))
}

fn from_ecef<T: Number>(planet: Planet) -> Result<Answer, Failure> {
    let ellipsoid = planet.ellipsoid::<T>()?;
    answer(move |point: Ecef<T>| Ok(ellipsoid.to_geodetic(point)))
}

fn direction<T: Number>(_: Nothing) -> Result<Answer, Failure> {
    answer(|place: LatLon<T>| Ok(place.to_direction()))
}

fn lat_lon<T: Number>(_: Nothing) -> Result<Answer, Failure> {
    answer(|direction: Direction<T>| Ok(direction.to_lat_lon()))
}

fn up<T: Number>(planet: Planet) -> Result<Answer, Failure> {
    axis::<T>(&planet, LocalFrame::up)
}

fn north<T: Number>(planet: Planet) -> Result<Answer, Failure> {
    axis::<T>(&planet, LocalFrame::north)
}

fn east<T: Number>(planet: Planet) -> Result<Answer, Failure> {
    axis::<T>(&planet, LocalFrame::east)
}

fn axis<T: Number>(planet: &Planet, axis: fn(&LocalFrame<T>) -> Direction<T>) -> Result<Answer, Failure> {
    let ellipsoid = planet.ellipsoid()?;
    answer(move |place: LatLon<T>| Ok(axis(&LocalFrame::new(ellipsoid, place.into()))))
}
