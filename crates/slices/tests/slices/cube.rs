//! Cube projections and maps.

use terrella::batch::{self, FaceNumber};
use terrella::cube::{
    CubeMap, CubeProjection, Face, FacePoint, Healpix, Projection, QuadCube, Rotation, Stretched, Turned, Vertex,
};
use terrella::{Direction, Ellipsoid, LatLon, Real, Shift};

use super::{Scalar, bytes, compare, directions, faces, number, places, points, store};

/// A projection, in both directions; faces are given by `columns`: as such, or as their numbers.
fn projection<T: Scalar, P: CubeProjection, F: FaceNumber>(name: &str, p: P, columns: fn(&[T]) -> Vec<F>) {
    compare(
        &format!("{name} project"),
        &directions::<T>(),
        &|[x, y, z]| {
            let point = p.project(Direction::new(x, y, z).unwrap());
            [number(point.face()), point.x(), point.y()]
        },
        &|from, [face, x, y]| {
            let mut faces = vec![Face::Front; face.len()];
            batch::cube::project(p, from, &mut faces, [x, y]).unwrap();
            store(&faces, face);
        },
    );
    compare(
        &format!("{name} unproject"),
        &points::<T>(),
        &|[face, x, y]| p.unproject(FacePoint::new(faces(&[face])[0], x, y).unwrap()).to_array(),
        &|[face, x, y], to| batch::cube::unproject(p, &columns(face), [x, y], to).unwrap(),
    );
}

fn map<T: Scalar, P: CubeProjection, F: FaceNumber>(name: &str, p: P, shift: Shift, columns: fn(&[T]) -> Vec<F>) {
    let map = CubeMap::new(Ellipsoid::<T>::WGS84, shift, p).unwrap();
    compare(
        &format!("{name} map, {shift}"),
        &places::<T>(),
        &|[lat, lon]| {
            let point = map.project(LatLon::new(lat, lon).unwrap());
            [number(point.face()), point.x(), point.y()]
        },
        &|from, [face, x, y]| {
            let mut faces = vec![Face::Front; face.len()];
            batch::map::project(&map, from, &mut faces, [x, y]).unwrap();
            store(&faces, face);
        },
    );
    compare(
        &format!("{name} map back, {shift}"),
        &points::<T>(),
        &|[face, x, y]| {
            let place = map.unproject(FacePoint::new(faces(&[face])[0], x, y).unwrap());
            [place.lat(), place.lon()]
        },
        &|[face, x, y], to| batch::map::unproject(&map, &columns(face), [x, y], to).unwrap(),
    );
}

/// A projection that the crate does not know, from its documentation.
#[derive(Clone, Copy)]
struct Gnomonic;

impl CubeProjection for Gnomonic {
    fn forward<T: Real>(&self, _: Face, [right, up, outward]: [T; 3]) -> [T; 2] {
        [right / outward, up / outward]
    }
    fn inverse<T: Real>(&self, _: Face, [x, y]: [T; 2]) -> [T; 3] {
        let length = (x * x + y * y + T::ONE).sqrt();
        [x / length, y / length, T::ONE / length]
    }
}

fn every_projection<T: Scalar>() {
    for &p in Projection::ALL {
        projection::<T, _, _>(p.name(), p, bytes);
    }
    projection::<T, _, _>("gnomonic", Gnomonic, faces);
    projection::<T, _, _>("vertex", Vertex, faces);
    projection::<T, _, _>("HEALPix", Healpix, faces);
    projection::<T, _, _>("quad cube", QuadCube::COBE, faces);
    for &shift in Shift::ALL {
        map::<T, _, _>("vertex", Projection::Vertex, shift, bytes);
    }
    map::<T, _, _>("gnomonic", Gnomonic, Shift::Authalic, faces);
    map::<T, _, _>("HEALPix", Healpix, Shift::Authalic, faces);
    let rotation = Rotation::facing(Face::Left, LatLon::new(47.4, 8.5).unwrap().to_direction(), 33.0).unwrap();
    let oblique = Turned::new(Stretched::new(Vertex, 2.5).unwrap(), rotation);
    projection::<T, _, _>("oblique vertex", oblique, bytes);
    map::<T, _, _>("oblique vertex", oblique, Shift::Authalic, bytes);
    map::<T, _, _>("turned HEALPix", Turned::new(Healpix, rotation), Shift::Authalic, bytes);
}

#[test]
fn projections_are_the_same_bits() {
    every_projection::<f64>();
    every_projection::<f32>();
}
