//! The operations: each a function from the numbers of a line to what is written for it.

use std::error::Error;
use std::process::ExitCode;
use std::str::FromStr;

use terrella::cube::{CubeMap, CubeProjection, Face, FacePoint};
use terrella::frame::{Enu, LocalFrame};
use terrella::geodesic::Geodesic;
use terrella::latitude::Conversion;
use terrella::{Direction, Ecef, Ellipsoid, Geodetic, LatLon, Real};

use crate::command::{Latitudes, Line, Local, Map, Operation, Planet, Sphere};
use crate::lines::for_each_line;

/// Processes all lines in the scalar `T`.
///
/// # Errors
/// What is wrong with the options.
pub fn run<T: Real + FromStr>(operation: Operation) -> Result<ExitCode, Box<dyn Error>> {
    Ok(match operation {
        Operation::Forward(Sphere { projection }) => {
            for_each_line(|[x, y, z]: [T; 3]| Ok(projection.project(Direction::new(x, y, z)?)))
        }
        Operation::Inverse(Sphere { projection }) => {
            for_each_line(|point: [T; 3]| Ok(projection.unproject(face_point(point)?)))
        }
        Operation::Project(map) => {
            let map = cube_map(map)?;
            for_each_line(|[lat, lon]: [T; 2]| Ok(map.project(LatLon::new(lat, lon)?)))
        }
        Operation::Unproject(map) => {
            let map = cube_map(map)?;
            for_each_line(|point: [T; 3]| Ok(map.unproject(face_point(point)?)))
        }
        Operation::Latitude(Latitudes {
            from,
            to,
            radians,
            planet,
        }) => {
            let conversion = Conversion::<T>::new(ellipsoid(planet)?, from, to)?;
            let convert = if radians {
                Conversion::radians
            } else {
                Conversion::degrees
            };
            for_each_line(|[latitude]: [T; 1]| Ok([convert(&conversion, latitude)?]))
        }
        Operation::GeodesicInverse(Line { method, planet }) => {
            let geodesic = method.on(ellipsoid::<T>(planet)?)?;
            for_each_line(|[lat1, lon1, lat2, lon2]: [T; 4]| {
                Ok(geodesic.inverse(LatLon::new(lat1, lon1)?, LatLon::new(lat2, lon2)?)?)
            })
        }
        Operation::GeodesicDirect(Line { method, planet }) => {
            let geodesic = method.on(ellipsoid::<T>(planet)?)?;
            for_each_line(|[lat, lon, azimuth, distance]: [T; 4]| {
                Ok(geodesic.direct(LatLon::new(lat, lon)?, azimuth, distance)?)
            })
        }
        Operation::ToEcef(planet) => {
            let ellipsoid = ellipsoid(planet)?;
            for_each_line(|place: [T; 3]| Ok(ellipsoid.to_ecef(geodetic(place)?)))
        }
        Operation::FromEcef(planet) => {
            let ellipsoid = ellipsoid(planet)?;
            for_each_line(|[x, y, z]: [T; 3]| Ok(ellipsoid.to_geodetic(Ecef::new(x, y, z)?)))
        }
        Operation::ToEnu(local) => {
            let frame = frame(local)?;
            for_each_line(|place: [T; 3]| Ok(frame.geodetic_to_enu(geodetic(place)?)))
        }
        Operation::FromEnu(local) => {
            let frame = frame(local)?;
            for_each_line(|[east, north, up]: [T; 3]| {
                Ok(frame.ellipsoid().to_geodetic(frame.from_enu(Enu { east, north, up })?))
            })
        }
    })
}

fn cube_map<T: Real>(map: Map) -> Result<CubeMap<T, impl CubeProjection>, Box<dyn Error>> {
    Ok(CubeMap::new(ellipsoid(map.planet)?, map.shift, map.sphere.projection)?)
}

/// The ellipsoid, its axis and flattening rounded to the scalar.
fn ellipsoid<T: Real>(Planet { ellipsoid }: Planet) -> Result<Ellipsoid<T>, Box<dyn Error>> {
    Ok(Ellipsoid::new(T::of(ellipsoid.a()), T::of(ellipsoid.f()))?)
}

fn geodetic<T: Real>([lat, lon, height]: [T; 3]) -> Result<Geodetic<T>, Box<dyn Error>> {
    Ok(Geodetic::new(LatLon::new(lat, lon)?, height)?)
}

fn frame<T: Real>(Local { origin, planet }: Local) -> Result<LocalFrame<T>, Box<dyn Error>> {
    Ok(LocalFrame::new(ellipsoid(planet)?, geodetic(origin.map(T::of))?))
}

fn face_point<T: Real>([face, x, y]: [T; 3]) -> Result<FacePoint<T>, Box<dyn Error>> {
    let number = |face: &Face| T::of(f64::from(face.index()));
    match Face::ALL.iter().find(|known| number(known) == face) {
        Some(&face) => Ok(FacePoint::new(face, x, y)?),
        None => Err(format!("face {face} is not an integer in 0 to 5").into()),
    }
}
