use terrella::cube::{CubeMap, CubeProjection, Projection, ProjectionTask, QuadCube};
use terrella::distortion::{Ground, Jacobian, Tissot, texture};
use terrella::{Ellipsoid, Real, Shift};

use crate::points::Points;
use crate::sweep::Sweep;

/// One projection, by its own type.
struct One<'a, T> {
    sweep: Sweep,
    points: &'a Points<T>,
    name: &'a str,
}

impl<T: Real> ProjectionTask for One<'_, T> {
    type Output = ();

    fn run<P: CubeProjection>(self, projection: P) {
        let Self { sweep, points, name } = self;
        let map = CubeMap::new(Ellipsoid::WGS84, Shift::Authalic, projection).unwrap();
        let ground = Ground::new(map);
        let name = |function| format!("{function}, {name}");
        sweep.count(&name("project"), &points.directions, |direction| {
            projection.project(direction)
        });
        sweep.count(&name("unproject"), &points.face_points, |point| {
            projection.unproject(point)
        });
        sweep.count(&name("CubeMap::project"), &points.places, |place| map.project(place));
        sweep.count(&name("CubeMap::unproject"), &points.face_points, |point| {
            map.unproject(point)
        });
        sweep.count(&name("Ground::jacobian"), &points.face_points, |point| {
            ground.jacobian(point)
        });
    }
}

pub fn projections<T: Real>(sweep: Sweep, points: &Points<T>) {
    for &projection in Projection::ALL {
        let name = projection.name();
        projection.with(One { sweep, points, name });
    }
    let name = "quad-cube";
    One { sweep, points, name }.run(QuadCube::COBE);
}

pub fn distortion<T: Real>(sweep: Sweep, points: &Points<T>) {
    let map = CubeMap::new(Ellipsoid::WGS84, Shift::Authalic, Projection::Balanced).unwrap();
    let ground = Ground::new(map);
    let jacobians: Vec<_> = points
        .face_points
        .iter()
        .map(|&point| ground.jacobian(point).unwrap())
        .collect();
    sweep.count("Tissot::new", &jacobians, |jacobian| {
        Tissot::new(&jacobian, ground.unit())
    });
    sweep.count("Jacobian::area", &jacobians, |jacobian| jacobian.area());
    sweep.count("Jacobian::aspect", &jacobians, |jacobian| jacobian.aspect());
    sweep.count("Jacobian::deformation", &jacobians, |jacobian| jacobian.deformation());
    sweep.count("Jacobian::extremes", &jacobians, |jacobian| jacobian.extremes());
    sweep.count("Jacobian::grid_angle", &jacobians, |jacobian: Jacobian<T>| {
        jacobian.grid_angle()
    });
    let units = &points.units;
    sweep.count("texture::level", units, |[x, y]| texture::level([x, y], [y, x]));
    sweep.count("texture::anisotropic", units, |[x, y]| {
        texture::anisotropic([x, y], [y, x], T::of(16.0))
    });
    sweep.count("texture::corrected", units, |[x, y]| texture::corrected(x, y));
}
