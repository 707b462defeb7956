use core::marker::PhantomData;

use terrella::cube::{
    Cell, Corner, CubeMap, CubeProjection, Edge, Face, FacePoint, Faces, Healpix, Numbering, Projection,
    ProjectionTask, QuadCube, Rotation, Stretched, Tangential, Turned, Vertex,
};
use terrella::{Dual, Ellipsoid, Real, Shift};

use crate::{Arguments, Function, Scalar, Visitor};

pub fn show<T: Scalar, V: Visitor>(visitor: &mut V) {
    faces::<T, V>(visitor);
    for &projection in Projection::ALL {
        CubeProjection::with(projection, One::<T, V>::new(visitor, Projection::name(projection)));
        derivatives::<T, V>(visitor, projection);
    }
    ProjectionTask::run(One::<T, V>::new(visitor, "quad-cube"), QuadCube::COBE);
    maps::<T, V>(visitor);
    if T::NAME == f64::NAME {
        rotations(visitor);
        stretches(visitor);
    }
    oblique::<T, V>(visitor);
}

/// One projection, by its own type.
struct One<'a, T, V> {
    visitor: &'a mut V,
    name: &'static str,
    scalar: PhantomData<T>,
}

impl<'a, T, V> One<'a, T, V> {
    fn new(visitor: &'a mut V, name: &'static str) -> Self {
        Self {
            visitor,
            name,
            scalar: PhantomData,
        }
    }
}

impl<T: Scalar, V: Visitor> ProjectionTask for One<'_, T, V> {
    type Output = ();

    fn run<P: CubeProjection>(self, projection: P) {
        let Self { visitor, name, .. } = self;
        let name = |function| Function::of(function, name);
        visitor.visit::<T, _, _>(
            name("CubeProjection::project"),
            Arguments::direction::<T>,
            |direction| CubeProjection::project(&projection, direction),
        );
        visitor.visit::<T, _, _>(
            name("CubeProjection::project_place"),
            Arguments::direction::<T>,
            |direction| {
                let [x, y, z] = direction.to_array();
                let polar = CubeProjection::is_polar(&projection, direction);
                (
                    polar,
                    CubeProjection::project_place(&projection, (z, Real::sqrt(x * x + y * y)), T::of(99.0)),
                )
            },
        );
        visitor.visit::<T, _, _>(
            name("CubeProjection::unproject_place"),
            Arguments::face_point::<T>,
            |point| {
                let ((sin, cos), lon) = CubeProjection::unproject_place(
                    &projection,
                    [T::whole(point.face().index().into()), point.x(), point.y()],
                );
                [sin, cos, lon]
            },
        );
        visitor.visit::<T, _, _>(name("CubeProjection::unproject"), Arguments::face_point::<T>, |point| {
            CubeProjection::unproject(&projection, point)
        });
    }
}

/// The projection chosen at run time, with derivatives.
fn derivatives<T: Scalar, V: Visitor>(visitor: &mut V, projection: Projection) {
    let name = |function| Function::of(function, Projection::name(projection));
    visitor.visit::<T, _, _>(
        name("CubeProjection::forward"),
        Arguments::direction::<T>,
        |direction| {
            let face = CubeProjection::face(&projection, direction);
            let local = Face::to_local(face, direction.to_array());
            (face, CubeProjection::forward(&projection, face, Dual::variables(local)))
        },
    );
    visitor.visit::<T, _, _>(name("CubeProjection::inverse"), Arguments::face_point::<T>, |point| {
        let place = Dual::variables([point.x(), point.y()]);
        CubeProjection::inverse(&projection, point.face(), place)
    });
}

fn maps<T: Scalar, V: Visitor>(visitor: &mut V) {
    let shifts = [
        Shift::Geodetic,
        Shift::Geocentric,
        Shift::Parametric,
        Shift::Authalic,
        Shift::Conformal,
        Shift::Rectifying,
    ];
    for (&projection, &shift) in Projection::ALL.iter().zip(shifts.iter().cycle()) {
        let Ok(map) = CubeMap::new(Ellipsoid::WGS84, shift, projection) else {
            continue;
        };
        let name = |function| Function::of(function, Projection::name(projection));
        visitor.visit::<T, _, _>(name("CubeMap::project"), Arguments::place::<T>, |place| {
            CubeMap::project(&map, place)
        });
        visitor.visit::<T, _, _>(name("CubeMap::unproject"), Arguments::face_point::<T>, |point| {
            CubeMap::unproject(&map, point)
        });
    }
    visitor.function::<T, _, _>("CubeMap::new", Arguments::ellipsoid::<T>, |ellipsoid| {
        let map = CubeMap::new(ellipsoid, Shift::Authalic, Projection::Vertex);
        map.map(|map| {
            let name = Projection::name(CubeMap::projection(&map));
            (CubeMap::shifted(&map).ellipsoid(), name)
        })
    });
    let any_name = |arguments: &mut Arguments| {
        let index = arguments.below(Projection::ALL.len() as u64 + 1) as usize;
        Projection::ALL
            .get(index)
            .map_or("nothing", |projection| projection.name())
    };
    visitor.function::<T, _, _>("Projection, by name", any_name, |name| {
        name.parse().map(Projection::name).ok()
    });
}

/// Rotations are made in double precision, whatever they turn.
fn rotations<V: Visitor>(visitor: &mut V) {
    let angle = |arguments: &mut Arguments| arguments.unit::<f64>() * 360.0;
    let matrix = |rotation: Rotation| Rotation::matrix(&rotation);
    visitor.function::<f64, _, _>("Rotation::new", Arguments::units::<f64, 2>, |[tilt, twist]| {
        let (sin, cos) = terrella::math::sin_cos_degrees(tilt * 90.0);
        let rows = [[cos, -sin, 0.0], [sin, cos, 0.0], [0.0, 0.0, 1.0]];
        let rough = [[cos, twist, 0.0], [-twist, cos, 0.0], [0.0, 0.0, 1.0]];
        [rows, rough].map(|rows| Rotation::new(rows).map(matrix).map_err(|invalid| invalid.departure))
    });
    visitor.function::<f64, _, _>("Rotation::about_axis", angle, |angle| {
        Rotation::about_axis(angle)
            .map(matrix)
            .map_err(|invalid| invalid.departure)
    });
    let placed = |arguments: &mut Arguments| {
        let face = arguments.face();
        (face, arguments.direction::<f64>(), arguments.unit::<f64>() * 360.0)
    };
    visitor.function::<f64, _, _>("Rotation::facing", placed, |(face, place, heading)| {
        Rotation::facing(face, place, heading)
            .map(matrix)
            .map_err(|invalid| invalid.departure)
    });
    visitor.function::<f64, _, _>("Turned::new", angle, |angle| {
        Rotation::about_axis(angle).ok().map(|rotation| {
            let turned = Turned::new(Projection::Vertex, rotation);
            let name = Projection::name(Turned::projection(&turned));
            (name, matrix(Turned::rotation(&turned)))
        })
    });
}

fn stretches<V: Visitor>(visitor: &mut V) {
    let factor = |arguments: &mut Arguments| arguments.unit::<f64>() * 20.0;
    visitor.function::<f64, _, _>("Stretched::new", factor, |factor| {
        Stretched::new(Projection::Vertex, factor)
            .map(|stretched| {
                let name = Projection::name(Stretched::projection(&stretched));
                (name, Stretched::factor(&stretched))
            })
            .map_err(|invalid| invalid.0)
    });
}

/// A rotation that the compiler makes: it takes double precision.
const fn rotation(rows: [[f64; 3]; 3]) -> Rotation {
    match Rotation::new(rows) {
        Ok(rotation) => rotation,
        Err(_) => unreachable!(),
    }
}

/// The rotation that brings X to Y, Y to Z and Z to X.
const CYCLE: Rotation = rotation([[0.0, 0.0, 1.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]]);
const TILTED: Rotation = rotation([[0.6, 0.0, -0.8], [0.0, 1.0, 0.0], [0.8, 0.0, 0.6]]);
const STRETCHED: Stretched<Tangential> = match Stretched::new(Tangential, 2.5) {
    Ok(stretched) => stretched,
    Err(_) => unreachable!(),
};

fn oblique<T: Scalar, V: Visitor>(visitor: &mut V) {
    let (cycle, tilted, stretched) = (CYCLE, TILTED, STRETCHED);
    ProjectionTask::run(
        One::<T, V>::new(visitor, "healpix, turned"),
        Turned::new(Healpix, cycle),
    );
    ProjectionTask::run(One::<T, V>::new(visitor, "vertex, turned"), Turned::new(Vertex, tilted));
    ProjectionTask::run(One::<T, V>::new(visitor, "tangential, stretched"), stretched);
    let turned = Turned::new(stretched, tilted);
    visitor.function::<T, _, _>("CubeProjection::to_cube", Arguments::direction::<T>, |direction| {
        let vector = CubeProjection::to_cube(&turned, direction.to_array());
        (vector, CubeProjection::to_earth(&turned, vector))
    });
    visitor.function::<T, _, _>("CubeProjection::vector", Arguments::face_point::<T>, |point| {
        CubeProjection::vector(&turned, point.face(), Dual::variables([point.x(), point.y()]))
    });
    visitor.function::<T, _, _>("CubeProjection::bend", Arguments::unit::<T>, |scale| {
        scale * CubeProjection::bend::<T>(&turned)
    });
    if let Ok(map) = CubeMap::new(Ellipsoid::WGS84, Shift::Authalic, turned) {
        visitor.visit::<T, _, _>(
            Function::of("CubeMap::project", "oblique"),
            Arguments::place::<T>,
            |place| CubeMap::project(&map, place),
        );
        visitor.visit::<T, _, _>(
            Function::of("CubeMap::unproject", "oblique"),
            Arguments::face_point::<T>,
            |point| CubeMap::unproject(&map, point),
        );
    }
}

fn faces<T: Scalar, V: Visitor>(visitor: &mut V) {
    visitor.function::<T, _, _>("Face::containing", Arguments::direction::<T>, |direction| {
        let face = Face::containing(direction);
        let local = Face::to_local(face, direction.to_array());
        (
            face,
            local,
            Face::to_earth(face, local),
            Face::is_polar(face),
            Face::index(face),
        )
    });
    visitor.function::<T, _, _>(
        "Face::neighbour",
        |arguments| (arguments.face(), arguments.below(4) as usize),
        |(face, index)| {
            let edge = Edge::ALL.get(index).copied().unwrap_or(Edge::Up);
            let corner = Corner::ALL.get(index).copied().unwrap_or(Corner::UpLeft);
            let index = index as u8;
            (
                Face::neighbour(face, edge),
                Face::corner(face, corner),
                Corner::edges(corner),
                Face::from_index(index * 2),
            )
        },
    );
    visitor.function::<T, _, _>(
        "Faces::agree",
        |arguments| {
            (
                arguments.below(4) as usize,
                arguments.face(),
                arguments.below(4) as usize,
            )
        },
        |(which, face, edge)| {
            let projections = [
                Projection::Square,
                Projection::Healpix,
                Projection::Continuous,
                Projection::Arvo,
            ];
            let projection = projections.get(which).copied().unwrap_or(Projection::Arvo);
            let edge = Edge::ALL.get(edge).copied().unwrap_or(Edge::Up);
            let faces = CubeProjection::faces(&projection);
            (Faces::agree(faces, face, edge), Faces::are_square(faces, face))
        },
    );
    visitor.function::<T, _, _>(
        "Face::name",
        |arguments| arguments.below(6) as usize,
        |index| Face::ALL.get(index).map(|&face| Face::name(face).len()),
    );
    let cells = |arguments: &mut Arguments| {
        let n = arguments.below(100) as u32;
        let index = [(); 2].map(|()| arguments.below(100) as u32);
        (arguments.face_point::<T>(), n, index, arguments.below(4) as usize)
    };
    visitor.function::<T, _, _>("Cell::containing", cells, |(point, n, [i, j], index)| {
        let edge = Edge::ALL.get(index).copied().unwrap_or(Edge::Up);
        let corner = Corner::ALL.get(index).copied().unwrap_or(Corner::UpLeft);
        let numbers = |cell: Cell| (Cell::face(cell), Cell::n(cell), Cell::i(cell), Cell::j(cell));
        let places = |cell: Cell| {
            (
                Cell::centre::<T>(cell),
                Cell::corner::<T>(cell, corner),
                Cell::corners::<T>(cell),
            )
        };
        let beside = |cell: Cell| {
            (
                numbers(Cell::neighbour(cell, edge)),
                Cell::diagonal(cell, corner).map(numbers),
            )
        };
        let all = |cell: Cell| (numbers(cell), places(cell), beside(cell));
        let given = Cell::new(point.face(), n, i, j).map(all).ok();
        (Cell::containing(point, n).map(all).ok(), given)
    });
    visitor.function::<T, _, _>("FacePoint::new", Arguments::units::<T, 2>, |[x, y]| {
        let twice = T::of(2.0);
        FacePoint::new(Face::Back, x * twice, y * twice)
    });
    for (numbering, name) in [
        (Numbering::S2, "S2"),
        (Numbering::OpenGl, "OpenGL"),
        (Numbering::Fits, "FITS"),
        (Numbering::Eac, "EAC"),
    ] {
        visitor.visit::<T, _, _>(Function::of("Numbering", name), Arguments::face_point::<T>, |point| {
            let number = Numbering::number(numbering, point.face());
            let (_, x, y) = Numbering::to_point(numbering, point);
            let there = Numbering::to_point(numbering, point);
            let back = Numbering::from_point(numbering, number, x + x, y);
            (number, Numbering::face(numbering, number + 1), there, back)
        });
    }
}
