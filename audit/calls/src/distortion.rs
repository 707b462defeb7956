use terrella::cube::{CubeMap, Projection, Vertex};
use terrella::distortion::{Cells, Ground, Jacobian, Kinks, Statistic, Survey, Tissot, texture};
use terrella::{Ellipsoid, Shift};

use crate::{Arguments, Function, Scalar, Visitor};

pub fn show<T: Scalar, V: Visitor>(visitor: &mut V) {
    for &projection in Projection::ALL {
        grounds::<T, V>(visitor, projection);
    }
    surveys::<T, V>(visitor);
    let jacobian = |arguments: &mut Arguments| Jacobian {
        by_x: arguments.units::<T, 2>(),
        by_y: arguments.units(),
    };
    visitor.function::<T, _, _>("Jacobian, its measures", jacobian, |j| {
        let sizes = [Jacobian::width(&j), Jacobian::height(&j), Jacobian::area(&j)];
        let shapes = [Jacobian::aspect(&j), Jacobian::sides(&j), Jacobian::grid_angle(&j)];
        (sizes, shapes, Jacobian::deformation(&j), Jacobian::extremes(&j))
    });
    visitor.function::<T, _, _>("Jacobian::isotropy", jacobian, |j| Jacobian::isotropy(&j));
    visitor.function::<T, _, _>("Tissot::new", jacobian, |j| Tissot::new(&j, T::of(6.4e6)));
    let four = Arguments::units::<T, 4>;
    visitor.function::<T, _, _>("texture::level", four, |[a, b, c, d]| texture::level([a, b], [c, d]));
    visitor.function::<T, _, _>("texture::anisotropic", four, |[a, b, c, d]| {
        texture::anisotropic([a, b], [c, d], T::of(16.0))
    });
    visitor.function::<T, _, _>("texture::corrected", Arguments::units::<T, 2>, |[level, area]| {
        texture::corrected(level, area.abs())
    });
    let two = |arguments: &mut Arguments| [arguments.face_point::<T>(), arguments.face_point()];
    visitor.function::<T, _, _>("Statistic::include", two, |[a, b]| {
        let mut one = Statistic::about(T::ONE);
        let mut other = Statistic::about(T::ONE);
        Statistic::include(&mut one, a, a.x());
        Statistic::include(&mut other, b, b.y());
        Statistic::merge(&mut one, &other);
        one
    });
}

fn grounds<T: Scalar, V: Visitor>(visitor: &mut V, projection: Projection) {
    let Ok(map) = CubeMap::new(Ellipsoid::WGS84, Shift::Authalic, projection) else {
        return;
    };
    let ground = Ground::new(map);
    let name = |function| Function::of(function, Projection::name(projection));
    visitor.visit::<T, _, _>(name("Ground::jacobian"), Arguments::face_point::<T>, |point| {
        Ground::jacobian(&ground, point)
    });
    visitor.visit::<T, _, _>(name("Ground::tissot"), Arguments::face_point::<T>, |point| {
        (Ground::tissot(&ground, point), Ground::unit(&ground))
    });
    visitor.visit::<T, _, _>(name("Ground::differences"), Arguments::face_point::<T>, |point| {
        let step = T::of(if T::DIGITS > 24 { 1e-6 } else { 1e-3 });
        let slopes = Ground::differences(&ground, point.face(), [point.x(), point.y()], step);
        let earth = CubeMap::shifted(&Ground::map(&ground)).ellipsoid();
        (
            slopes,
            Ground::central_texel(&ground),
            [Ground::ellipsoid(&ground), earth],
        )
    });
}

/// Of one projection, by its own type: each more would be compiled for every set of instructions.
fn surveys<T: Scalar, V: Visitor>(visitor: &mut V) {
    let Ok(map) = CubeMap::new(Ellipsoid::<T>::WGS84, Shift::Authalic, Vertex) else {
        return;
    };
    let ground = Ground::new(map);
    let function = |what| Function::of(what, "vertex").calls(1);
    visitor.visit::<T, _, _>(function("Survey::face"), Arguments::face, |face| {
        let mut survey = Survey::new(T::of(3e13));
        Survey::face(&mut survey, &ground, face, 3);
        survey
    });
    visitor.visit::<T, _, _>(function("Survey::sphere"), Arguments::face_point::<T>, |point| {
        let (mut one, mut other) = (Survey::new(T::of(3e13)), Survey::new(T::of(3e13)));
        Survey::sphere(&mut one, &ground, 1);
        if let Ok(texel) = Ground::jacobian(&ground, point) {
            Survey::include(&mut other, point, &texel);
        }
        Survey::merge(&mut one, &other);
        one
    });
    visitor.visit::<T, _, _>(function("Survey::face_where"), Arguments::face, |face| {
        let mut survey = Survey::new(Ground::fair_texel(&ground));
        Survey::face_where(&mut survey, &ground, face, 3, |normal| normal.x() > normal.y());
        (
            [*Survey::scale(&survey), *Survey::isotropy(&survey)],
            *Survey::area(&survey),
            Survey::skipped(&survey),
        )
    });
    visitor.visit::<T, _, _>(function("Cells::sphere"), Arguments::face, |face| {
        let (mut one, mut other) = (Cells::new(), Cells::new());
        Cells::sphere(&mut one, &ground, 2);
        Cells::face(&mut other, &ground, face, 3);
        Cells::merge(&mut one, &other);
        one
    });
    visitor.visit::<T, _, _>(function("Kinks::sphere"), Arguments::face, |face| {
        let (mut one, mut other) = (Kinks::new(), Kinks::new());
        Kinks::sphere(&mut one, &ground, 2);
        Kinks::face(&mut other, &ground, face, 2);
        Kinks::merge(&mut one, &other);
        one
    });
}
