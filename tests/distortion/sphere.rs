//! The ground that most tests use.

use terrella::cube::{CubeMap, CubeProjection, Face, FacePoint, Projection};
use terrella::distortion::Ground;
use terrella::{Ellipsoid, Real, Shift};

/// The unit sphere.
pub fn unit_sphere<T: Real, P: CubeProjection>(projection: P) -> Ground<T, P> {
    on(Ellipsoid::sphere(T::ONE).unwrap(), Shift::Geodetic, projection)
}

/// An ellipsoid laid on the sphere.
pub fn on<T: Real, P: CubeProjection>(ellipsoid: Ellipsoid<T>, shift: Shift, projection: P) -> Ground<T, P> {
    Ground::new(CubeMap::new(ellipsoid, shift, projection).unwrap())
}

pub fn at<T: Real>(face: Face, x: T, y: T) -> FacePoint<T> {
    FacePoint::new(face, x, y).unwrap()
}

/// Random places of all faces, none of them on a crease.
pub fn places(count: usize, seed: u64) -> impl Iterator<Item = FacePoint<f64>> {
    let mut random = fastrand::Rng::with_seed(seed);
    std::iter::repeat_with(move || {
        let mut coordinate = || random.f64() * 2.0 - 1.0;
        let (x, y) = (coordinate(), coordinate());
        at(Face::ALL[random.usize(0..6)], x, y)
    })
    .take(count)
}

/// Those whose corner the map turns into no right angle's double: smooth and symmetric about the diagonal.
pub fn smooth() -> impl Iterator<Item = Projection> {
    let creased = [
        Projection::Quadrilateralized,
        Projection::Healpix,
        Projection::Vertex,
        Projection::Conformal,
    ];
    let square = |p: Projection| p.faces().are_square(Face::Top);
    Projection::ALL
        .iter()
        .copied()
        .filter(move |&p| !creased.contains(&p) && square(p))
}
