//! Local frames: east, north and up; north, east and down; azimuth, elevation and range.

use terrella::{Aer, Ecef, Enu, Geodetic, LatLon, LocalFrame, Ned};

use super::{Answer, Failure, Group, answer, group};
use crate::options::{Local, Nothing, Planet};
use crate::read::{Number, Read};
use crate::write::Row;

pub const GROUP: Group = group! {
    "Local frames, about an origin lat0 lon0 h0":
    "to-enu" "lat lon h -> east north up of --origin", to_enu(Local);
    "from-enu" "east north up of --origin -> lat lon h", from_enu(Local);
    "geodetic-to-enu" "lat0 lon0 h0 lat lon h -> east north up", from_geodetic<Enu>(Planet);
    "geodetic-to-ned" "lat0 lon0 h0 lat lon h -> north east down", from_geodetic<Ned>(Planet);
    "geodetic-to-aer" "lat0 lon0 h0 lat lon h -> azimuth elevation range", from_geodetic<Aer>(Planet);
    "enu-to-geodetic" "lat0 lon0 h0 east north up -> lat lon h", to_geodetic<Enu>(Planet);
    "ned-to-geodetic" "lat0 lon0 h0 north east down -> lat lon h", to_geodetic<Ned>(Planet);
    "aer-to-geodetic" "lat0 lon0 h0 azimuth elevation range -> lat lon h", to_geodetic<Aer>(Planet);
    "ecef-to-enu" "lat0 lon0 h0 X Y Z -> east north up", from_ecef<Enu>(Planet);
    "ecef-to-ned" "lat0 lon0 h0 X Y Z -> north east down", from_ecef<Ned>(Planet);
    "ecef-to-aer" "lat0 lon0 h0 X Y Z -> azimuth elevation range", from_ecef<Aer>(Planet);
    "enu-to-ecef" "lat0 lon0 h0 east north up -> X Y Z", to_ecef<Enu>(Planet);
    "ned-to-ecef" "lat0 lon0 h0 north east down -> X Y Z", to_ecef<Ned>(Planet);
    "aer-to-ecef" "lat0 lon0 h0 azimuth elevation range -> X Y Z", to_ecef<Aer>(Planet);
    "vector-to-enu" "lat0 lon0 X Y Z -> east north up: turned, not moved", turned_to<Enu>(Planet);
    "vector-to-ned" "lat0 lon0 X Y Z -> north east down: turned, not moved", turned_to<Ned>(Planet);
    "vector-from-enu" "lat0 lon0 east north up -> X Y Z: turned, not moved", turned_from<Enu>(Planet);
    "vector-from-ned" "lat0 lon0 north east down -> X Y Z: turned, not moved", turned_from<Ned>(Planet);
    "enu-to-aer" "east north up -> azimuth elevation range", between<Enu, Aer>(Nothing);
    "ned-to-aer" "north east down -> azimuth elevation range", between<Ned, Aer>(Nothing);
    "aer-to-enu" "azimuth elevation range -> east north up", between<Aer, Enu>(Nothing);
    "aer-to-ned" "azimuth elevation range -> north east down", between<Aer, Ned>(Nothing);
};

fn to_enu<T: Number>(local: Local) -> Result<Answer, Failure> {
    let frame = local.frame::<T>()?;
    answer(move |place: Geodetic<T>| Ok(frame.geodetic_to_enu(place)))
}

fn from_enu<T: Number>(local: Local) -> Result<Answer, Failure> {
    let frame = local.frame::<T>()?;
    answer(move |enu: Enu<T>| Ok(frame.enu_to_geodetic(enu)?))
}

fn from_geodetic<T: Number, F: Row + From<Enu<T>>>(planet: Planet) -> Result<Answer, Failure> {
    let ellipsoid = planet.ellipsoid::<T>()?;
    answer(move |(origin, place): (Geodetic<T>, Geodetic<T>)| {
        Ok(F::from(LocalFrame::new(ellipsoid, origin).geodetic_to_enu(place)))
    })
}

fn to_geodetic<T: Number, F: Read + Into<Enu<T>>>(planet: Planet) -> Result<Answer, Failure> {
    let ellipsoid = planet.ellipsoid::<T>()?;
    answer(move |(origin, place): (Geodetic<T>, F)| {
        Ok(LocalFrame::new(ellipsoid, origin).enu_to_geodetic(place.into())?)
    })
}

fn from_ecef<T: Number, F: Row + From<Enu<T>>>(planet: Planet) -> Result<Answer, Failure> {
    let ellipsoid = planet.ellipsoid::<T>()?;
    answer(move |(origin, place): (Geodetic<T>, Ecef<T>)| Ok(F::from(LocalFrame::new(ellipsoid, origin).to_enu(place))))
}

fn to_ecef<T: Number, F: Read + Into<Enu<T>>>(planet: Planet) -> Result<Answer, Failure> {
    let ellipsoid = planet.ellipsoid::<T>()?;
    answer(move |(origin, place): (Geodetic<T>, F)| Ok(LocalFrame::new(ellipsoid, origin).from_enu(place.into())?))
}

fn turned_to<T: Number, F: Row + From<Enu<T>>>(planet: Planet) -> Result<Answer, Failure> {
    let ellipsoid = planet.ellipsoid::<T>()?;
    answer(move |(origin, vector): (LatLon<T>, [T; 3])| {
        Ok(F::from(LocalFrame::new(ellipsoid, origin.into()).vector_to_enu(vector)))
    })
}

fn turned_from<T: Number, F: Read + Into<Enu<T>>>(planet: Planet) -> Result<Answer, Failure> {
    let ellipsoid = planet.ellipsoid::<T>()?;
    answer(move |(origin, vector): (LatLon<T>, F)| {
        Ok(LocalFrame::new(ellipsoid, origin.into()).vector_from_enu(vector.into()))
    })
}

fn between<T: Number, A: Read + Into<B>, B: Row>(_: Nothing) -> Result<Answer, Failure> {
    answer(|place: A| Ok(place.into()))
}
