//! The operations: each a function from the numbers of a line to what is written for it.

use std::error::Error;
use std::process::ExitCode;
use std::str::FromStr;

use terrella::cube::{CubeMap, CubeProjection, Face, FacePoint};
use terrella::latitude::Conversion;
use terrella::{Direction, Ellipsoid, LatLon, Real};

use crate::command::{Latitudes, Map, Operation, Planet, Sphere};
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
    })
}

fn cube_map<T: Real>(map: Map) -> Result<CubeMap<T, impl CubeProjection>, Box<dyn Error>> {
    Ok(CubeMap::new(ellipsoid(map.planet)?, map.shift, map.sphere.projection)?)
}

/// The ellipsoid, its axis and flattening rounded to the scalar.
fn ellipsoid<T: Real>(Planet { ellipsoid }: Planet) -> Result<Ellipsoid<T>, Box<dyn Error>> {
    Ok(Ellipsoid::new(T::of(ellipsoid.a()), T::of(ellipsoid.f()))?)
}

fn face_point<T: Real>([face, x, y]: [T; 3]) -> Result<FacePoint<T>, Box<dyn Error>> {
    let number = |face: &Face| T::of(f64::from(face.index()));
    match Face::ALL.iter().find(|known| number(known) == face) {
        Some(&face) => Ok(FacePoint::new(face, x, y)?),
        None => Err(format!("face {face} is not an integer in 0 to 5").into()),
    }
}
