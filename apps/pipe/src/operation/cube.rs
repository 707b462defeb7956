//! Faces of the cube.

use terrella::cube::{CubeProjection, FacePoint};
use terrella::{Direction, LatLon};

use super::{Answer, Failure, Group, answer, group};
use crate::options::{Map, Numbered, Sphere};
use crate::read::Number;

pub const GROUP: Group = group! {
    "The cube":
    "project" "lat lon -> face x y: from the ellipsoid to the cube", project(Map);
    "unproject" "face x y -> lat lon: from the cube to the ellipsoid", unproject(Map);
    "forward" "X Y Z of any length -> face x y: from the sphere to the cube", forward(Sphere);
    "inverse" "face x y -> X Y Z on the unit sphere", inverse(Sphere);
    "numbered" "X Y Z of any length -> face u v, as --numbering numbers faces and lays axes", numbered(Numbered);
    "from-numbered" "face u v, as --numbering has them -> X Y Z on the unit sphere", from_numbered(Numbered);
};

fn project<T: Number>(map: Map) -> Result<Answer, Failure> {
    let map = map.map::<T>()?;
    answer(move |place: LatLon<T>| Ok(map.project(place)))
}

fn unproject<T: Number>(map: Map) -> Result<Answer, Failure> {
    let map = map.map::<T>()?;
    answer(move |point: FacePoint<T>| Ok(map.unproject(point)))
}

fn forward<T: Number>(sphere: Sphere) -> Result<Answer, Failure> {
    let projection = sphere.cube()?;
    answer(move |direction: Direction<T>| Ok(projection.project(direction)))
}

fn inverse<T: Number>(sphere: Sphere) -> Result<Answer, Failure> {
    let projection = sphere.cube()?;
    answer(move |point: FacePoint<T>| Ok(projection.unproject(point)))
}

fn numbered<T: Number>(Numbered { numbering, sphere }: Numbered) -> Result<Answer, Failure> {
    let projection = sphere.cube()?;
    answer(move |direction: Direction<T>| Ok(numbering.to_point(projection.project(direction))))
}

fn from_numbered<T: Number>(Numbered { numbering, sphere }: Numbered) -> Result<Answer, Failure> {
    let projection = sphere.cube()?;
    answer(move |(face, [u, v]): (u8, [T; 2])| Ok(projection.unproject(numbering.from_point(face, u, v)?)))
}
