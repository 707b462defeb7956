//! Every cube projection both ways, from and to unit vectors and from and to latitude and longitude, and a pass that does nothing but
//! move as many bytes.

use std::rc::Rc;

use terrella::batch;
use terrella::cube::{CubeMap, CubeProjection, Face, FacePoint, Projection, ProjectionTask};
use terrella::latitude::Conversion;
use terrella::{Direction, Ellipsoid, LatLon, Latitude, Shift};

use crate::bench::{Bench, Mode, Task};
use crate::set::{self, Set, each_from_face, each_to_face};
use crate::truth::{Row, Scalar, rows};
use timing::points::{Order, directions, face_points, lat_lons};
use timing::record::{METRES_PER_FACE_UNIT, METRES_PER_RADIAN};

/// What a point off the cube is.
#[derive(Clone, Copy, PartialEq)]
pub enum Ground {
    /// A unit vector.
    Vector,
    /// Latitude and longitude of the sphere.
    Sphere,
    /// Latitude and longitude on WGS84, the geocentric latitude being that on the sphere.
    Geocentric,
    /// The same of the authalic latitude.
    Authalic,
}

impl Ground {
    /// All of them.
    pub const ALL: [Self; 4] = [Self::Vector, Self::Sphere, Self::Geocentric, Self::Authalic];

    /// The words for a record's method.
    pub fn name(self) -> &'static str {
        match self {
            Self::Vector => "unit vectors",
            Self::Sphere => "lat lon",
            Self::Geocentric => "geodetic lat lon; geocentric",
            Self::Authalic => "geodetic lat lon; authalic",
        }
    }

    fn map<T: Scalar, P: CubeProjection>(self, projection: P) -> CubeMap<T, P> {
        let sphere = Ellipsoid::new(T::of(METRES_PER_RADIAN), T::ZERO).expect("a sphere");
        let (ellipsoid, shift) = match self {
            Self::Vector | Self::Sphere => (sphere, Shift::Geodetic),
            Self::Geocentric => (Ellipsoid::WGS84, Shift::Geocentric),
            Self::Authalic => (Ellipsoid::WGS84, Shift::Authalic),
        };
        CubeMap::new(ellipsoid, shift, projection).expect("a shift for the Earth")
    }

    /// The latitude on the sphere in radians, of one in radians here; or the other way round.
    fn latitude(self, back: bool, latitude: f64) -> f64 {
        let kind = match self {
            Self::Vector | Self::Sphere => return latitude,
            Self::Geocentric => Latitude::Geocentric,
            Self::Authalic => Latitude::Authalic,
        };
        let (from, to) = if back {
            (kind, Latitude::Geodetic)
        } else {
            (Latitude::Geodetic, kind)
        };
        let conversion = Conversion::new(Ellipsoid::WGS84, from, to).expect("a latitude for the Earth");
        conversion.radians(latitude).expect("a latitude")
    }

    /// A unit vector as it is given here.
    fn encode(self, [x, y, z]: [f64; 3]) -> Vec<f64> {
        if self == Self::Vector {
            return vec![x, y, z];
        }
        let lat = self.latitude(true, z.atan2(x.hypot(y)));
        vec![lat.to_degrees(), y.atan2(x).to_degrees()]
    }

    /// The unit vector of a result.
    fn decode(self, result: &[f64]) -> [f64; 3] {
        let &[lat, lon] = &result[..2] else {
            return [f64::NAN; 3];
        };
        if self == Self::Vector {
            return [lat, lon, result[2]];
        }
        let (sin, cos) = self.latitude(false, lat.to_radians()).sin_cos();
        let (sin_lon, cos_lon) = lon.to_radians().sin_cos();
        [cos * cos_lon, cos * sin_lon, sin]
    }
}

/// The timed sets, which all projections share.
struct Sets<T> {
    vectors: Vec<(&'static str, Rc<Set<T>>)>,
    places: Vec<(&'static str, Rc<Set<T>>)>,
    points: Vec<(&'static str, Rc<Set<T>>)>,
}

impl<T: Scalar> Sets<T> {
    fn new(n: usize) -> Self {
        let sets = |make: &dyn Fn(Order) -> Set<T>| {
            let named = |order: Order| (order.name(), Rc::new(make(order)));
            Order::ALL.map(named).into()
        };
        Self {
            vectors: sets(&|order| {
                let d = directions(order, n);
                Set::new(vec![d.x, d.y, d.z])
            }),
            places: sets(&|order| {
                let p = lat_lons(order, n);
                Set::new(vec![p.lat, p.lon])
            }),
            points: sets(&|order| {
                let p = face_points(order, n);
                Set::on(p.face.into_iter().map(face).collect(), vec![p.x, p.y])
            }),
        }
    }
}

fn face(index: u8) -> Face {
    Face::from_index(index).expect("a face")
}

/// The truth's columns, by the paper's axes, in the order of the Earth's.
const EARTH: [&str; 3] = ["vz", "vx", "vy"];

/// What a forward projection should give.
enum Expected {
    /// A row of the truth.
    Row(Row<'static>),
    /// What `f64` gives, for places that are rounded to `f32`.
    Double(FacePoint<f64>),
}

impl Expected {
    /// How far a point is off, in metres.
    fn error(&self, projection: Projection, found: FacePoint<f64>) -> f64 {
        let (theirs, off) = match self {
            Self::Row(row) => {
                let at = face(row.value("face") as u8);
                let theirs = FacePoint::new(at, row.value("x"), row.value("y"));
                let off = [row.deviation("x", found.x()), row.deviation("y", found.y())];
                (theirs.expect("a point of a face"), off)
            }
            Self::Double(point) => (*point, [found.x() - point.x(), found.y() - point.y()]),
        };
        if theirs.face() == found.face() {
            return off[0].hypot(off[1]) * METRES_PER_FACE_UNIT;
        }
        // On an edge, or as near as rounding, the neighbour's point is as right, if it is the same direction.
        let [a, b] = [theirs, found].map(|point| projection.unproject(point).to_array());
        let off = [0, 1, 2].map(|k| a[k] - b[k]);
        off[0].hypot(off[1]).hypot(off[2]) * METRES_PER_RADIAN
    }
}

fn forward<T: Scalar>(projection: Projection, ground: Ground, sets: &Sets<T>) -> Task<T> {
    // The forward polynomials of the two are one.
    let same = if projection == Projection::Cobe {
        Projection::CobeExact
    } else {
        projection
    };
    let inputs: &[&str] = if ground == Ground::Vector { &EARTH } else { &[] };
    let truth = rows::<T>(&format!("cube_{same}_forward"), inputs);
    let places = truth
        .iter()
        .map(|row| ground.encode(EARTH.map(|c| row.value(c))))
        .collect();
    let set = Set::<T>::rows(places);
    let map = ground.map::<f64, _>(projection);
    let expected = truth.into_iter().enumerate().map(|(i, row)| {
        if ground == Ground::Vector || T::NAME == "f64" {
            return Expected::Row(row);
        }
        let [lat, lon] = [0, 1].map(|k: usize| set.columns[k][i].into());
        Expected::Double(map.project(LatLon::new(lat, lon).expect("a place")))
    });
    let expected: Vec<_> = expected.collect();
    Task {
        chart: "projection",
        operation: format!("{projection} forward"),
        inputs: if ground == Ground::Vector {
            sets.vectors.clone()
        } else {
            sets.places.clone()
        },
        truth: set,
        error: Box::new(move |i, room| {
            let found = FacePoint::new(room.face[i], room.columns[0][i].into(), room.columns[1][i].into());
            expected[i].error(projection, found.expect("a point of a face"))
        }),
    }
}

fn inverse<T: Scalar>(projection: Projection, ground: Ground, sets: &Sets<T>) -> Task<T> {
    let truth = rows::<T>(&format!("cube_{projection}_inverse"), &["x", "y"]);
    let faces = truth.iter().map(|row| face(row.value("face") as u8)).collect();
    let points = ["x", "y"].map(|column| truth.iter().map(|row| row.value(column)).collect());
    Task {
        chart: "projection",
        operation: format!("{projection} inverse"),
        inputs: sets.points.clone(),
        truth: Set::on(faces, points.into()),
        error: Box::new(move |i, room| {
            let result = [0, 1, 2].map(|k: usize| room.columns[k][i].into());
            let vector = ground.decode(&result);
            let off = [0, 1, 2].map(|k: usize| truth[i].deviation(EARTH[k], vector[k]));
            off[0].hypot(off[1]).hypot(off[2]) * METRES_PER_RADIAN
        }),
    }
}

/// All passes of a projection.
struct Passes<'a, T> {
    bench: &'a mut Bench,
    sets: &'a Sets<T>,
    projection: Projection,
}

impl<T: Scalar> ProjectionTask for Passes<'_, T> {
    type Output = ();

    fn run<P: CubeProjection>(self, projection: P) {
        let Self { bench, sets, .. } = self;
        for ground in Ground::ALL {
            let method = format!("{}; {}", self.projection, ground.name());
            let out = forward(self.projection, ground, sets);
            let back = inverse(self.projection, ground, sets);
            if ground == Ground::Vector {
                let single = each_to_face(|[x, y, z]| Some(projection.project(Direction::new(x, y, z).ok()?)));
                bench.run(&out, &method, Mode::OneByOne, &single);
                let many = set::batch_to_face(|vectors, faces, points| {
                    batch::cube::project(projection, vectors, faces, points).expect("vectors");
                });
                bench.run(&out, &method, Mode::Batch, &many);
                let single = each_from_face(|point: FacePoint<T>| projection.unproject(point).to_array());
                bench.run(&back, &method, Mode::OneByOne, &single);
                let many = set::batch_from_face(|faces, points, vectors| {
                    batch::cube::unproject(projection, faces, points, vectors).expect("points");
                });
                bench.run(&back, &method, Mode::Batch, &many);
                continue;
            }
            let map = ground.map::<T, P>(projection);
            let single = each_to_face(|[lat, lon]| Some(map.project(LatLon::new(lat, lon).ok()?)));
            bench.run(&out, &method, Mode::OneByOne, &single);
            let many = set::batch_to_face(|places, faces, points| {
                batch::map::project(&map, places, faces, points).expect("places");
            });
            bench.run(&out, &method, Mode::Batch, &many);
            let single = each_from_face(|point| {
                let place = map.unproject(point);
                [place.lat(), place.lon()]
            });
            bench.run(&back, &method, Mode::OneByOne, &single);
            let many = set::batch_from_face(|faces, points, places| {
                batch::map::unproject(&map, faces, points, places).expect("points");
            });
            bench.run(&back, &method, Mode::Batch, &many);
        }
    }
}

/// The operations of the passes that move bytes.
pub const BYTES: [&str; 2] = ["bytes forward", "bytes inverse"];

fn move_bytes<T: Scalar>(bench: &mut Bench, sets: &Sets<T>) {
    let [out, back] = [(BYTES[0], &sets.vectors), (BYTES[1], &sets.points)].map(|(operation, inputs)| Task {
        chart: "projection",
        operation: operation.to_owned(),
        inputs: inputs.clone(),
        truth: Set::new(vec![Vec::new(); 3]),
        error: Box::new(|_, _| f64::NAN),
    });
    let forward = set::batch_to_face(|[x, y, z]: [&[T]; 3], faces, [u, v]| {
        u.copy_from_slice(x);
        v.copy_from_slice(y);
        for (face, &z) in faces.iter_mut().zip(z) {
            *face = if z < T::ZERO { Face::Bottom } else { Face::Front };
        }
    });
    bench.run(
        &out,
        "read three coordinates; write a face and two",
        Mode::Batch,
        &forward,
    );
    let inverse = set::batch_from_face(|faces, [u, v]: [&[T]; 2], [x, y, z]| {
        x.copy_from_slice(u);
        y.copy_from_slice(v);
        for (z, &face) in z.iter_mut().zip(faces) {
            *z = if face == Face::Front { T::ZERO } else { T::ONE };
        }
    });
    bench.run(
        &back,
        "read a face and two coordinates; write three",
        Mode::Batch,
        &inverse,
    );
}

/// Runs the chart in a scalar.
pub fn run<T: Scalar>(bench: &mut Bench) {
    let sets = Sets::<T>::new(bench.points);
    move_bytes(bench, &sets);
    for &projection in Projection::ALL {
        projection.with(Passes {
            bench: &mut *bench,
            sets: &sets,
            projection,
        });
    }
}
