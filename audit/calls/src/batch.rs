use core::convert::Infallible;

use terrella::batch::{
    self, InvalidBatch, area::InvalidRing, cube::InvalidPoint, ellipsoid::InvalidGeodetic, geodesic::InvalidProblem,
};
use terrella::cube::{Adjusted, Balanced, CubeMap, CubeProjection, Face, Healpix, Vertex};
use terrella::geodesic::{Area, Geodesic, GreatCircle, Karney, Method, PlanarArea, Vincenty};
use terrella::latitude::Conversion;
use terrella::scene::{Order, Scene, Surface, View};
use terrella::{Ellipsoid, GeodeticSeries, Latitude, LocalFrame, Shift, Shifted};

use crate::{Arguments, Bits, Function, Hash, POINTS, Scalar, Visitor};

/// How often a batch is called.
const CALLS: usize = 2;

/// Columns of numbers.
pub type Columns<T, const N: usize> = [[T; POINTS]; N];

pub fn show<T: Scalar, V: Visitor>(visitor: &mut V) {
    positions::<T, V>(visitor);
    latitudes::<T, V>(visitor);
    frames::<T, V>(visitor);
    rings::<T, V>(visitor);
    if T::NAME == f64::NAME {
        // Scenes are asked in double precision, whatever they choose for.
        answers::<f64, V>(visitor);
        answers::<f32, V>(visitor);
    }
    cubes::<T, V>(visitor);
    let earth = Ellipsoid::<T>::WGS84;
    if let (Ok(karney), Ok(vincenty)) = (Karney::new(earth), Vincenty::new(earth)) {
        geodesics(visitor, &karney, "karney");
        points_of_lines(visitor, &karney);
        geodesics(visitor, &vincenty, "vincenty");
    }
}

pub fn function(name: &'static str, of: &'static str) -> Function {
    Function::of(name, of).calls(CALLS)
}

/// Numbers in [−1, 1) times what each column is to be in.
pub fn columns<T: Scalar, const N: usize>(arguments: &mut Arguments, units: [T; N]) -> Columns<T, N> {
    units.map(|unit| [(); POINTS].map(|()| arguments.unit::<T>() * unit))
}

pub fn places<T: Scalar>(arguments: &mut Arguments) -> Columns<T, 2> {
    columns(arguments, [T::of(90.0), T::of(180.0)])
}

/// Unit vectors one time, and vectors of any length the other.
pub fn vectors<T: Scalar>(arguments: &mut Arguments) -> Columns<T, 3> {
    let unit = arguments.below(2) == 0;
    let mut columns = [[T::ZERO; POINTS]; 3];
    let [x, y, z] = &mut columns;
    for ((x, y), z) in x.iter_mut().zip(y).zip(z) {
        let vector = arguments.direction::<T>().to_array();
        let length = if unit { T::ONE } else { T::of(3.0) };
        [*x, *y, *z] = vector.map(|part| part * length);
    }
    columns
}

pub fn face_points<T: Scalar>(arguments: &mut Arguments) -> ([Face; POINTS], Columns<T, 2>) {
    let faces = [(); POINTS].map(|()| arguments.face());
    (faces, columns(arguments, [T::ONE; 2]))
}

pub fn lent<T, const N: usize>(columns: &Columns<T, N>) -> [&[T]; N] {
    columns.each_ref().map(<[T; POINTS]>::as_slice)
}

/// The results of a batch, and whether it was refused.
pub fn into<T: Scalar, E: Bits, const N: usize>(
    batch: impl FnOnce([&mut [T]; N]) -> Result<(), E>,
) -> (Columns<T, N>, Result<(), E>) {
    let mut columns = [[T::ZERO; POINTS]; N];
    let outcome = batch(columns.each_mut().map(<[T; POINTS]>::as_mut_slice));
    (columns, outcome)
}

fn positions<T: Scalar, V: Visitor>(visitor: &mut V) {
    visitor.visit::<T, _, _>(function("batch::position::to_direction", ""), places::<T>, |places| {
        into(|directions| batch::position::to_direction(lent(&places), directions))
    });
    visitor.visit::<T, _, _>(function("batch::position::to_lat_lon", ""), vectors::<T>, |vectors| {
        into(|places| batch::position::to_lat_lon(lent(&vectors), places))
    });
    let earth = Ellipsoid::WGS84;
    let geodetics = |arguments: &mut Arguments| columns(arguments, [T::of(90.0), T::of(180.0), T::of(1e5)]);
    visitor.visit::<T, _, _>(function("batch::ellipsoid::to_ecef", ""), geodetics, |places| {
        into(|points| batch::ellipsoid::to_ecef(earth, lent(&places), points))
    });
    let points = |arguments: &mut Arguments| columns(arguments, [T::of(6.5e6); 3]);
    visitor.visit::<T, _, _>(function("batch::ellipsoid::to_geodetic", ""), points, |points| {
        into(|places| batch::ellipsoid::to_geodetic(earth, lent(&points), places))
    });
    let series = GeodeticSeries::new(earth);
    visitor.visit::<T, _, _>(function("batch::ellipsoid::second_order", ""), points, |points| {
        into(|places| batch::ellipsoid::second_order(series, lent(&points), places))
    });
    visitor.visit::<T, _, _>(function("batch::ellipsoid::third_order", ""), points, |points| {
        into(|places| batch::ellipsoid::third_order(series, lent(&points), places))
    });
    visitor.visit::<T, _, _>(function("batch::ellipsoid::fourth_order", ""), points, |points| {
        into(|places| batch::ellipsoid::fourth_order(series, lent(&points), places))
    });
    let refused = |arguments: &mut Arguments| {
        let [mut lat, lon] = places::<T>(arguments);
        if let Some(slot) = lat.get_mut(arguments.below(POINTS as u64) as usize) {
            *slot = T::of(90.5);
        }
        [lat, lon]
    };
    visitor.visit::<T, _, _>(
        function("batch::position::to_direction", "refused"),
        refused,
        |[lat, lon]| {
            let short = lon.get(1..).unwrap_or_default();
            (
                into(|directions| batch::position::to_direction([&lat, &lon], directions)),
                into(|directions| batch::position::to_direction([&lat, short], directions)),
            )
        },
    );
}

fn frames<T: Scalar, V: Visitor>(visitor: &mut V) {
    let frame = LocalFrame::new(Ellipsoid::WGS84, Arguments::new().geodetic::<T>());
    let geodetics = |arguments: &mut Arguments| columns(arguments, [T::of(90.0), T::of(180.0), T::of(1e5)]);
    let points = |arguments: &mut Arguments| columns(arguments, [T::of(6.5e6); 3]);
    // Some of them deep in the Earth.
    let enu = |arguments: &mut Arguments| columns(arguments, [T::of(1e7); 3]);
    let aer = |arguments: &mut Arguments| columns(arguments, [T::of(180.0), T::of(90.0), T::of(1e6)]);
    macro_rules! show {
        ($($name:literal $function:path, $draw:expr;)*) => {$(
            visitor.visit::<T, _, _>(function($name, ""), $draw, |from| {
                into(|to| $function(&frame, lent(&from), to))
            });
        )*};
    }
    show! {
        "batch::frame::to_enu" batch::frame::to_enu, points;
        "batch::frame::to_ned" batch::frame::to_ned, points;
        "batch::frame::to_aer" batch::frame::to_aer, points;
        "batch::frame::from_enu" batch::frame::from_enu, enu;
        "batch::frame::from_ned" batch::frame::from_ned, enu;
        "batch::frame::from_aer" batch::frame::from_aer, aer;
        "batch::frame::geodetic_to_enu" batch::frame::geodetic_to_enu, geodetics;
        "batch::frame::geodetic_to_ned" batch::frame::geodetic_to_ned, geodetics;
        "batch::frame::geodetic_to_aer" batch::frame::geodetic_to_aer, geodetics;
        "batch::frame::enu_to_geodetic" batch::frame::enu_to_geodetic, enu;
        "batch::frame::ned_to_geodetic" batch::frame::ned_to_geodetic, enu;
        "batch::frame::aer_to_geodetic" batch::frame::aer_to_geodetic, aer;
        "batch::frame::enu_to_offset" batch::frame::enu_to_offset, enu;
        "batch::frame::offset_to_enu" batch::frame::offset_to_enu, geodetics;
        "batch::frame::vector_to_enu" batch::frame::vector_to_enu, points;
        "batch::frame::vector_from_enu" batch::frame::vector_from_enu, enu;
    }
}

/// Rings within a degree, of which the last has too many corners.
const OFFSETS: [u32; 6] = [0, 0, 3, 20, 150, 151];

fn corners<T: Scalar>(arguments: &mut Arguments) -> Columns<T, 2> {
    columns(arguments, [T::ONE; 2])
}

fn rings<T: Scalar, V: Visitor>(visitor: &mut V) {
    let (Ok(area), Ok(plane)) = (Area::new(Ellipsoid::WGS84), PlanarArea::new(Ellipsoid::WGS84)) else {
        return;
    };
    visitor.visit::<T, _, _>(function("batch::area::polygons", ""), corners::<T>, |corners| {
        let (mut areas, mut perimeters) = ([T::ZERO; 5], [T::ZERO; 5]);
        let outcome = batch::area::polygons(&area, &OFFSETS, lent(&corners), &mut areas, &mut perimeters);
        (areas, perimeters, outcome)
    });
    visitor.visit::<T, _, _>(function("batch::area::fields", ""), corners::<T>, |corners| {
        let mut areas = [T::ZERO; 5];
        let outcome = batch::area::fields(&plane, &OFFSETS, lent(&corners), &mut areas);
        (areas, outcome)
    });
}

fn answers<T: Scalar, V: Visitor>(visitor: &mut V) {
    let scene = Scene::around(Ellipsoid::WGS84, 47.0, 1e5);
    let origin = Arguments::new().geodetic::<T>();
    for (view, name) in View::ALL.into_iter().zip(["linear", "quadratic", "full"]) {
        let Ok(positions) = scene.positions_by::<T>(view) else {
            continue;
        };
        let about = positions.about(origin);
        let geodetics = |arguments: &mut Arguments| columns(arguments, [T::of(90.0), T::of(180.0), T::of(1e5)]);
        visitor.visit::<T, _, _>(function("batch::scene::enu", name), geodetics, |places| {
            into(|enu| batch::scene::enu(&about, lent(&places), enu))
        });
    }
    if let Ok(distances) = scene.distances_by::<T>(Method::Flat) {
        let method = distances.solver();
        let pairs = |arguments: &mut Arguments| [places::<T>(arguments), places(arguments)];
        visitor.visit::<T, _, _>(function("batch::scene::inverse", "flat"), pairs, |[from, to]| {
            into(|lines| batch::scene::inverse(method, lent(&from), lent(&to), lines))
        });
        let starts =
            |arguments: &mut Arguments| columns(arguments, [T::of(90.0), T::of(180.0), T::of(180.0), T::of(2e4)]);
        visitor.visit::<T, _, _>(
            function("batch::scene::direct", "flat"),
            starts,
            |[lat, lon, azimuth, distance]| {
                into(|ends| batch::scene::direct(method, [&lat, &lon], &azimuth, &distance, ends))
            },
        );
    }
    for (order, name) in Order::ALL.into_iter().zip(["second", "third", "fourth", "full"]) {
        let Ok(chosen) = scene.geodetics_by::<T>(order) else {
            continue;
        };
        let points = |arguments: &mut Arguments| columns(arguments, [T::of(6.5e6); 3]);
        visitor.visit::<T, _, _>(function("batch::scene::to_geodetic", name), points, |points| {
            into(|places| batch::scene::to_geodetic(chosen.solver(), lent(&points), places))
        });
    }
    for (surface, name) in Surface::ALL.into_iter().zip(["plane", "ellipsoid"]) {
        let Ok(chosen) = scene.areas_by::<T>(surface) else {
            continue;
        };
        let solver = chosen.solver();
        visitor.visit::<T, _, _>(function("batch::scene::areas", name), corners::<T>, |corners| {
            let mut areas = [T::ZERO; 5];
            let outcome = batch::scene::areas(&solver, &OFFSETS, lent(&corners), &mut areas);
            (areas, outcome)
        });
    }
}

fn latitudes<T: Scalar, V: Visitor>(visitor: &mut V) {
    let earth = Ellipsoid::WGS84;
    for &shift in Shift::ALL {
        let Ok(shifted) = Shifted::new(earth, shift) else {
            continue;
        };
        let name = Shift::name(shift);
        visitor.visit::<T, _, _>(function("batch::latitude::to_direction", name), places::<T>, |places| {
            into(|directions| batch::latitude::to_direction(&shifted, lent(&places), directions))
        });
        visitor.visit::<T, _, _>(function("batch::latitude::to_lat_lon", name), vectors::<T>, |vectors| {
            into(|places| batch::latitude::to_lat_lon(&shifted, lent(&vectors), places))
        });
    }
    for &latitude in Latitude::ALL {
        let name = Latitude::name(latitude);
        let (Ok(there), Ok(back)) = (
            Conversion::new(earth, Latitude::Parametric, latitude),
            Conversion::new(earth, latitude, Latitude::Parametric),
        ) else {
            continue;
        };
        let degrees = |arguments: &mut Arguments| columns(arguments, [T::of(90.0)]);
        visitor.visit::<T, _, _>(function("batch::latitude::degrees", name), degrees, |[values]| {
            (
                into(|[results]| batch::latitude::degrees(&there, &values, results)),
                into(|[results]| batch::latitude::degrees(&back, &values, results)),
            )
        });
        let radians = |arguments: &mut Arguments| columns(arguments, [T::of(1.5)]);
        visitor.visit::<T, _, _>(function("batch::latitude::radians", name), radians, |[values]| {
            (
                into(|[results]| batch::latitude::radians(&there, &values, results)),
                into(|[results]| batch::latitude::radians(&back, &values, results)),
            )
        });
    }
}

/// Each more would be compiled for every set of instructions: these are one from polynomials, one by places, one with
/// steps of Newton's method, one with creases. All are hashed one by one.
fn cubes<T: Scalar, V: Visitor>(visitor: &mut V) {
    cube::<T, V, _>(visitor, Adjusted, "adjusted");
    cube::<T, V, _>(visitor, Healpix, "healpix");
    cube::<T, V, _>(visitor, Balanced, "balanced");
    cube::<T, V, _>(visitor, Vertex, "vertex");
}

fn cube<T: Scalar, V: Visitor, P: CubeProjection>(visitor: &mut V, projection: P, name: &'static str) {
    visitor.visit::<T, _, _>(function("batch::cube::project", name), vectors::<T>, |vectors| {
        let mut faces = [Face::Front; POINTS];
        let points = into(|points| batch::cube::project(projection, lent(&vectors), &mut faces, points));
        (faces, points)
    });
    visitor.visit::<T, _, _>(
        function("batch::cube::unproject", name),
        face_points::<T>,
        |(faces, points)| into(|vectors| batch::cube::unproject(projection, &faces, lent(&points), vectors)),
    );
    let Ok(map) = CubeMap::new(Ellipsoid::WGS84, Shift::Authalic, projection) else {
        return;
    };
    visitor.visit::<T, _, _>(function("batch::map::project", name), places::<T>, |places| {
        let mut faces = [Face::Front; POINTS];
        let points = into(|points| batch::map::project(&map, lent(&places), &mut faces, points));
        (faces, points)
    });
    visitor.visit::<T, _, _>(
        function("batch::map::unproject", name),
        face_points::<T>,
        |(faces, points)| into(|places| batch::map::unproject(&map, &faces, lent(&points), places)),
    );
}

fn geodesics<T: Scalar, V: Visitor, M: Geodesic<T>>(visitor: &mut V, method: &M, name: &'static str) {
    let pairs = |arguments: &mut Arguments| [places::<T>(arguments), places(arguments)];
    visitor.visit::<T, _, _>(function("batch::geodesic::inverse", name), pairs, |[from, to]| {
        into(|lines| batch::geodesic::inverse(method, lent(&from), lent(&to), lines))
    });
    visitor.visit::<T, _, _>(function("batch::geodesic::distance", name), pairs, |[from, to]| {
        (
            into(|[distances]| batch::geodesic::distance(method, lent(&from), lent(&to), distances)),
            into(|[distances]| batch::geodesic::legs(method, lent(&from), distances.get_mut(1..).unwrap_or_default())),
        )
    });
    let star = |arguments: &mut Arguments| (arguments.place::<T>(), places::<T>(arguments));
    visitor.visit::<T, _, _>(function("batch::geodesic, of one place", name), star, |(one, many)| {
        (
            into(|lines| batch::geodesic::inverse_from(method, one, lent(&many), lines)),
            into(|lines| batch::geodesic::inverse_to(method, lent(&many), one, lines)),
            into(|[distances]| batch::geodesic::distance_from(method, one, lent(&many), distances)),
            into(|[distances]| batch::geodesic::distance_to(method, lent(&many), one, distances)),
        )
    });
    let starts = |arguments: &mut Arguments| columns(arguments, [T::of(90.0), T::of(180.0), T::of(180.0), T::of(2e7)]);
    visitor.visit::<T, _, _>(
        function("batch::geodesic::direct", name),
        starts,
        |[lat, lon, azimuth, distance]| {
            into(|ends| batch::geodesic::direct(method, [&lat, &lon], &azimuth, &distance, ends))
        },
    );
    let one_way = |arguments: &mut Arguments| {
        let azimuth = arguments.unit::<T>() * T::of(180.0);
        (arguments.place::<T>(), azimuth, columns(arguments, [T::of(2e7)]))
    };
    visitor.visit::<T, _, _>(
        function("batch::geodesic::direct_from", name),
        one_way,
        |(from, azimuth, [distance])| into(|ends| batch::geodesic::direct_from(method, from, azimuth, &distance, ends)),
    );
    let fractions = |arguments: &mut Arguments| (arguments.pair::<T>(), columns(arguments, [T::ONE]));
    visitor.visit::<T, _, _>(
        function("batch::geodesic::intermediate", name),
        fractions,
        |([from, to], [fractions])| into(|places| batch::geodesic::intermediate(method, from, to, &fractions, places)),
    );
}

fn points_of_lines<T: Scalar, V: Visitor>(visitor: &mut V, karney: &Karney<T>) {
    let line = |arguments: &mut Arguments| {
        let azimuth = arguments.unit::<T>() * T::of(180.0);
        (arguments.place::<T>(), azimuth, columns(arguments, [T::of(2e8)]))
    };
    visitor.visit::<T, _, _>(
        function("batch::geodesic::along", ""),
        line,
        |(from, azimuth, [distance])| {
            let line = karney.line(from, azimuth).ok()?;
            Some(into(|points| batch::geodesic::along(&line, &distance, points)))
        },
    );
    let leg = |arguments: &mut Arguments| (arguments.pair::<T>(), places::<T>(arguments));
    let Ok(sphere) = GreatCircle::new(T::of(6.371e6)) else {
        return;
    };
    visitor.visit::<T, _, _>(
        function("batch::geodesic::tracks", ""),
        leg,
        |([start, end], places)| {
            (
                into(|tracks| batch::geodesic::tracks(&sphere, lent(&places), start, end, tracks)),
                into(|[along, cross]| {
                    let legs = [along, cross].map(|column| column.get_mut(1..).unwrap_or_default());
                    batch::geodesic::leg_tracks(&sphere, start, lent(&places), legs)
                }),
            )
        },
    );
}

impl Bits for Infallible {
    fn add_to(&self, _: &mut Hash) {}
}

impl<E: Bits> Bits for InvalidBatch<E> {
    fn add_to(&self, hash: &mut Hash) {
        match self {
            Self::Lengths { first, other } => (*first, *other).add_to(hash),
            Self::Elements { count, first, why } => ((*count, *first), why).add_to(hash),
        }
    }
}

impl<T: Scalar> Bits for InvalidPoint<T> {
    fn add_to(&self, hash: &mut Hash) {
        match self {
            Self::Face(why) => why.add_to(hash),
            Self::Point(why) => why.add_to(hash),
        }
    }
}

impl<T: Scalar> Bits for InvalidGeodetic<T> {
    fn add_to(&self, hash: &mut Hash) {
        match self {
            Self::LatLon(why) => why.add_to(hash),
            Self::Height(why) => why.add_to(hash),
        }
    }
}

impl<T: Scalar> Bits for InvalidRing<T> {
    fn add_to(&self, hash: &mut Hash) {
        match self {
            Self::Corner { index, why } => (*index, why).add_to(hash),
            Self::Offsets { start, end } => (*start, *end).add_to(hash),
        }
    }
}

impl<T: Scalar> Bits for InvalidProblem<T> {
    fn add_to(&self, hash: &mut Hash) {
        match self {
            Self::LatLon(why) => why.add_to(hash),
            Self::Geodesic(why) => why.add_to(hash),
        }
    }
}
