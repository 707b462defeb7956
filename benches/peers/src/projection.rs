//! Cube projections and HEALPix: from longitude and latitude, or from unit vectors, to a face and back.
//!
//! Every library's plane is brought to the faces of the truth; the sphere's radius is 6371 km.

use std::f64::consts::{FRAC_PI_4, PI};

use s2::cellid::CellID;

use crate::bench::{Bench, Task};
use crate::pass::{Pass, Set, each};
use crate::shim::Shim;
use crate::truth::{Exact, Truth};
use timing::points::{N, Order, WGS84_A, WGS84_F, directions, face_points, lat_lons};
use timing::record::{METRES_PER_FACE_UNIT, METRES_PER_RADIAN};

/// (b/a)² of WGS84.
const AXES2: f64 = (1.0 - WGS84_F) * (1.0 - WGS84_F);

/// Where a library puts a point of a face.
#[derive(Clone, Copy)]
enum Layout {
    /// A plane per face: `scale`·x + `offset`.
    Faces { scale: f64, offset: f64 },
    /// The cube unfolded as FITS does, a face 90 wide.
    Unfolded,
    /// The HEALPix plane; the width of half an equatorial face.
    Healpix(f64),
    /// S2's leaf cell, its number in two halves.
    Cells,
}

/// Leaf cells to the side of a face.
const LEAVES: f64 = (1u64 << 30) as f64;

/// A cell's number as two coordinates.
fn halves(cell: CellID) -> [f64; 2] {
    [(cell.0 >> 32) as f64, (cell.0 & 0xffff_ffff) as f64]
}

/// The cell of two coordinates.
fn whole([high, low]: [f64; 2]) -> CellID {
    CellID((high as u64) << 32 | low as u64)
}

/// A library's plane.
#[derive(Clone, Copy)]
struct Plane {
    layout: Layout,
    /// The axes of S2's faces.
    s2_axes: bool,
    /// The numbering of S2's faces; for libraries that number them.
    s2_numbers: bool,
}

/// The truth's face of each of S2's.
const OF_S2: [u8; 6] = [0, 1, 4, 2, 3, 5];

impl Plane {
    const fn new(layout: Layout) -> Self {
        Self {
            layout,
            s2_axes: false,
            s2_numbers: false,
        }
    }

    /// How far east of the truth's the library's longitudes are, in radians.
    fn turn(self) -> f64 {
        match self.layout {
            Layout::Healpix(_) => HEALPIX_TURN * FRAC_PI_4,
            _ => 0.0,
        }
    }

    /// A face point as the library has it.
    fn encode(self, face: u8, x: f64, y: f64) -> (u8, [f64; 2]) {
        let [u, v] = match (self.s2_axes, face) {
            (true, 4) => [y, -x],
            (true, 2 | 3) => [-y, x],
            _ => [x, y],
        };
        let number = OF_S2.iter().position(|&ours| ours == face).expect("a face") as u8;
        let point = match self.layout {
            Layout::Faces { scale, offset } => [scale * u + offset, scale * v + offset],
            Layout::Unfolded => {
                let [u0, v0] = unfolded(face);
                [45.0 * (u0 + u), 45.0 * (v0 + v)]
            }
            Layout::Healpix(scale) => {
                let [u, v] = healpix(face, u, v);
                [scale * wrap(u + HEALPIX_TURN), scale * v]
            }
            Layout::Cells => {
                let [i, j] = [u, v].map(|c| (0.5 * (c + 1.0) * LEAVES).clamp(0.0, LEAVES - 1.0) as i32);
                halves(CellID::from_face_ij(number, i, j))
            }
        };
        (if self.s2_numbers { number } else { face }, point)
    }

    /// A library's result as a point of the face on which the truth has it. Another face: NaN.
    fn decode(self, truth: u8, mut face: u8, [x, y]: [f64; 2]) -> [f64; 2] {
        let [u, v] = match self.layout {
            Layout::Cells => {
                let (number, i, j, _) = whole([x, y]).face_ij_orientation();
                face = number;
                [i, j].map(|c| 2.0 * (f64::from(c) + 0.5) / LEAVES - 1.0)
            }
            Layout::Faces { scale, offset } => [(x - offset) / scale, (y - offset) / scale],
            Layout::Unfolded => {
                let [u0, v0] = unfolded(truth);
                [wrap(x / 45.0 - u0), y / 45.0 - v0]
            }
            Layout::Healpix(scale) => healpix_face(truth, x / scale - HEALPIX_TURN, y / scale),
        };
        if self.s2_numbers && OF_S2[usize::from(face)] != truth {
            return [f64::NAN; 2];
        }
        match (self.s2_axes, truth) {
            (true, 4) => [-v, u],
            (true, 2 | 3) => [v, -u],
            _ => [u, v],
        }
    }
}

/// Modulo a turn of eight half faces, exactly.
fn wrap(u: f64) -> f64 {
    if u > 4.0 {
        u - 8.0
    } else if u < -4.0 {
        u + 8.0
    } else {
        u
    }
}

/// The centre of a face in FITS's unfolded cube, in half faces.
fn unfolded(face: u8) -> [f64; 2] {
    match face {
        4 => [0.0, 2.0],
        5 => [0.0, -2.0],
        side => [2.0 * f64::from(side), 0.0],
    }
}

/// Half faces by which HEALPix's own polar triangles, on 45°, 135°, ..., are east of those of the truth: its longitudes
/// are turned by that before a library sees them, and back.
const HEALPIX_TURN: f64 = 1.0;

/// The HEALPix plane of a face point, in half faces: longitude 0 in the middle, wide 8, high 4.
fn healpix(face: u8, x: f64, y: f64) -> [f64; 2] {
    let centre = |quarter: u8| [0.0, 2.0, 4.0, -2.0][usize::from(quarter)];
    // On the polar faces: the quarter of longitude, the distance from the pole, and how far east in the quarter.
    let north = if face == 5 { -1.0 } else { 1.0 };
    match face {
        0..=3 => [centre(face) + x, y],
        _ => {
            let down = -y * north;
            let (quarter, from_pole, east) = match (down.abs() >= x.abs(), down >= 0.0, x >= 0.0) {
                (true, true, _) => (0, down, x),
                (true, false, _) => (2, -down, -x),
                (false, _, true) => (1, x, -down),
                (false, _, false) => (3, -x, down),
            };
            [centre(quarter) + east, north * (2.0 - from_pole)]
        }
    }
}

/// The other way round.
fn healpix_face(truth: u8, u: f64, v: f64) -> [f64; 2] {
    if truth < 4 {
        return [wrap(u - [0.0, 2.0, 4.0, -2.0][usize::from(truth)]), v];
    }
    let north = if truth == 5 { -1.0 } else { 1.0 };
    let quarter = (u / 2.0).round();
    let (from_pole, east) = (2.0 - v * north, u - 2.0 * quarter);
    let [x, down] = match (quarter as i64).rem_euclid(4) {
        0 => [east, from_pole],
        1 => [from_pole, -east],
        2 => [-east, -from_pole],
        _ => [-from_pole, east],
    };
    [x, -down * north]
}

/// What a library calls a place on the sphere.
#[derive(Clone, Copy, PartialEq)]
enum Place {
    /// Longitude and latitude in degrees.
    Degrees,
    /// Longitude and latitude in radians.
    Radians,
    /// Longitude and geodetic latitude on WGS84 in radians, the geocentric latitude being that on the sphere.
    Wgs84,
    /// A unit vector in Earth axes.
    Vector,
}

impl Place {
    /// A unit vector, rounded, as the library wants it, after a turn to the east in radians.
    fn encode(self, [x, y, z]: [f64; 3], turn: f64) -> Vec<f64> {
        let (lon, r) = (y.atan2(x) + turn, x.hypot(y));
        let lon = if lon > PI { lon - 2.0 * PI } else { lon };
        match self {
            Self::Degrees => vec![lon.to_degrees(), z.atan2(r).to_degrees()],
            Self::Radians => vec![lon, z.atan2(r)],
            Self::Wgs84 => vec![lon, z.atan2(AXES2 * r)],
            Self::Vector => vec![x, y, z],
        }
    }

    /// The unit vector of a library's result, after a turn to the west.
    fn decode(self, result: &[f64], turn: f64) -> [f64; 3] {
        let (lon, lat) = match self {
            Self::Degrees => (result[0].to_radians() - turn, result[1].to_radians()),
            _ => (result[0] - turn, result[1]),
        };
        match self {
            Self::Vector => [result[0], result[1], result[2]],
            Self::Wgs84 => {
                let (sin, cos) = lat.sin_cos();
                let length = (AXES2 * sin).hypot(cos);
                let (sin, cos) = (AXES2 * sin / length, cos / length);
                [cos * lon.cos(), cos * lon.sin(), sin]
            }
            _ => [lat.cos() * lon.cos(), lat.cos() * lon.sin(), lat.sin()],
        }
    }

    /// The timed set of an order, with the truth's faces (those of HEALPix no library asks for).
    fn set(self, order: Order) -> Set {
        let columns = if self == Self::Vector {
            let d = directions(order, N);
            vec![d.x, d.y, d.z]
        } else {
            let p = lat_lons(order, N);
            vec![p.lon, p.lat]
        };
        let face = (0..N)
            .map(|i| {
                let here: Vec<f64> = columns.iter().map(|column| column[i]).collect();
                let place = if self == Self::Vector {
                    Self::Vector
                } else {
                    Self::Degrees
                };
                face_of(place.decode(&here, 0.0))
            })
            .collect();
        let set = Set::on(face, columns);
        match self {
            Self::Radians | Self::Wgs84 => set.map(0, f64::to_radians).map(1, f64::to_radians),
            _ => set,
        }
    }
}

/// The face of the component of largest magnitude.
fn face_of([x, y, z]: [f64; 3]) -> u8 {
    let side = |value: f64, positive: u8, negative: u8| if value > 0.0 { positive } else { negative };
    if x.abs() >= y.abs().max(z.abs()) {
        side(x, 0, 2)
    } else if y.abs() >= z.abs() {
        side(y, 1, 3)
    } else {
        side(z, 4, 5)
    }
}

/// Both directions of a projection of the truth, as one library has them.
struct Pair {
    forward: Task,
    inverse: Task,
    /// The same with points sorted by face.
    forward_sorted: Task,
    inverse_sorted: Task,
}

fn transpose(rows: Vec<Vec<f64>>) -> Vec<Vec<f64>> {
    (0..rows[0].len())
        .map(|k| rows.iter().map(|row| row[k]).collect())
        .collect()
}

fn forward(name: &str, operation: &str, place: Place, plane: Plane) -> Task {
    let truth = Truth::read(&format!("cube_{name}_forward"));
    let vectors = [truth.values("vz"), truth.values("vx"), truth.values("vy")];
    let face: Vec<u8> = truth.values("face").iter().map(|&face| face as u8).collect();
    let rows = (0..face.len())
        .map(|i| place.encode([0, 1, 2].map(|k: usize| vectors[k][i]), plane.turn()))
        .collect();
    let (x, y, class) = (truth.exact("x"), truth.exact("y"), truth.text("class"));
    let truth = Set::on(face.clone(), transpose(rows));
    Task {
        chart: "projection",
        operation: format!("{operation} forward"),
        inputs: Order::ALL.map(|order| (order.name(), place.set(order))).into(),
        truth,
        error: Box::new(move |i, room| {
            let [u, v] = plane.decode(face[i], room.face[i], [room.columns[0][i], room.columns[1][i]]);
            let off = Exact::from(u).minus(x[i]).hypot(Exact::from(v).minus(y[i]));
            // On an edge, or as near as rounding, the neighbouring face is as right.
            let tie = ["exact", "edge_1e-15", "corner_1e-15"]
                .iter()
                .any(|near| class[i].starts_with(near));
            let edge = x[i].value.abs().max(y[i].value.abs()) > 1.0 - 1e-12;
            (!(tie && edge) || off < 1e-3).then_some(if off.is_nan() {
                f64::INFINITY
            } else {
                off * METRES_PER_FACE_UNIT
            })
        }),
    }
}

fn inverse(name: &str, operation: &str, place: Place, plane: Plane) -> Task {
    let set_of = |face: &[u8], x: &[f64], y: &[f64]| {
        let points: Vec<(u8, [f64; 2])> = (0..face.len()).map(|i| plane.encode(face[i], x[i], y[i])).collect();
        let column = |k: usize| points.iter().map(|(_, point)| point[k]).collect();
        Set::on(
            points.iter().map(|&(face, _)| face).collect(),
            vec![column(0), column(1)],
        )
    };
    let inputs = Order::ALL.map(|order| {
        let points = face_points(order, N);
        (order.name(), set_of(&points.face, &points.x, &points.y))
    });
    let truth = Truth::read(&format!("cube_{name}_inverse"));
    let face: Vec<u8> = truth.values("face").iter().map(|&face| face as u8).collect();
    let vectors = [truth.exact("vz"), truth.exact("vx"), truth.exact("vy")];
    let set = set_of(&face, &truth.values("x"), &truth.values("y"));
    Task {
        chart: "projection",
        operation: format!("{operation} inverse"),
        inputs: inputs.into(),
        truth: set,
        error: Box::new(move |i, room| {
            let v = place.decode(&[0, 1, 2].map(|k: usize| room.columns[k][i]), plane.turn());
            let off = [0, 1, 2].map(|k: usize| Exact::from(v[k]).minus(vectors[k][i]));
            Some(off[0].hypot(off[1]).hypot(off[2]) * METRES_PER_RADIAN)
        }),
    }
}

impl Pair {
    /// `name` in the truth files, `operation` in the records.
    fn new(name: &str, operation: &str, place: Place, plane: Plane) -> Self {
        let sorted = |mut task: Task| {
            task.inputs.iter_mut().for_each(|(_, set)| *set = set.sorted_by_face());
            task
        };
        Self {
            forward: forward(name, operation, place, plane),
            inverse: inverse(name, operation, place, plane),
            forward_sorted: sorted(forward(name, operation, place, plane)),
            inverse_sorted: sorted(inverse(name, operation, place, plane)),
        }
    }

    /// The four passes of a shim.
    fn run(&self, bench: &mut Bench, shim: &Shim, name: &str, [single, many]: [&str; 2], sorted: bool) {
        let (forward, inverse) = match sorted {
            true => (&self.forward_sorted, &self.inverse_sorted),
            false => (&self.forward, &self.inverse),
        };
        let pass = |suffix: &str| shim.pass(&format!("{name}_{suffix}"));
        bench.run(&self.forward, &shim.library, single, "one by one", &pass("forward"));
        bench.run(&self.inverse, &shim.library, single, "one by one", &pass("inverse"));
        bench.run(forward, &shim.library, many, "batch", &pass("forward_batch"));
        bench.run(inverse, &shim.library, many, "batch", &pass("inverse_batch"));
    }
}

/// Runs the chart.
pub fn run(bench: &mut Bench) {
    let faces = |scale: f64, offset: f64| Plane::new(Layout::Faces { scale, offset });
    let s2_axes = |plane: Plane| Plane { s2_axes: true, ..plane };
    let s2 = |plane: Plane| Plane {
        s2_axes: true,
        s2_numbers: true,
        ..plane
    };

    for shim in Shim::all("proj", "PROJ") {
        let whole = faces(1.0, 0.0);
        let half = s2_axes(faces(0.5, 0.5));
        let sphere = [
            "+proj=qsc +R=1; lat lon; proj_trans",
            "+proj=qsc +R=1; lat lon; proj_trans_generic by face",
        ];
        Pair::new("quadrilateralized", "quadrilateralized", Place::Radians, whole)
            .run(bench, &shim, "qsc", sphere, true);
        let wgs84 = [
            "+proj=qsc +ellps=WGS84; geodetic lat lon; proj_trans",
            "+proj=qsc +ellps=WGS84; geodetic lat lon; proj_trans_generic by face",
        ];
        Pair::new(
            "quadrilateralized",
            "quadrilateralized",
            Place::Wgs84,
            faces(WGS84_A, 0.0),
        )
        .run(bench, &shim, "qsc_wgs84", wgs84, true);
        let s2_way = [
            "+proj=s2 +R=1; lat lon; proj_trans",
            "+proj=s2 +R=1; lat lon; proj_trans_generic by face",
        ];
        Pair::new("s2-quadratic", "s2-quadratic", Place::Radians, half).run(bench, &shim, "s2_quadratic", s2_way, true);
        let tangent = [
            "+proj=s2 +UVtoST=tangent +R=1; lat lon; proj_trans",
            "+proj=s2 +UVtoST=tangent +R=1; lat lon; proj_trans_generic by face",
        ];
        Pair::new("adjusted", "adjusted", Place::Radians, half).run(bench, &shim, "s2_tangent", tangent, true);
        let none = [
            "+proj=s2 +UVtoST=none +R=1; lat lon; proj_trans",
            "+proj=s2 +UVtoST=none +R=1; lat lon; proj_trans_generic by face",
        ];
        Pair::new("tangential", "tangential", Place::Radians, s2_axes(whole)).run(bench, &shim, "s2_none", none, true);
        let healpix = [
            "+proj=healpix +R=1; lat lon; proj_trans",
            "+proj=healpix +R=1; lat lon; proj_trans_generic",
        ];
        let plane = Plane::new(Layout::Healpix(FRAC_PI_4));
        Pair::new("healpix", "healpix", Place::Radians, plane).run(bench, &shim, "healpix", healpix, false);
    }

    for shim in Shim::all("wcslib", "WCSLIB") {
        let plane = Plane::new(Layout::Unfolded);
        for (code, name) in [
            ("qsc", "quadrilateralized"),
            ("tsc", "tangential"),
            ("csc", "cobe-exact"),
        ] {
            let methods = ["n = 1", "vector"].map(|call| format!("{code}s2x and {code}x2s; lat lon; {call}"));
            let methods = [methods[0].as_str(), methods[1].as_str()];
            Pair::new(name, name, Place::Degrees, plane).run(bench, &shim, code, methods, false);
        }
        // Its inverse is the published polynomial, which is not quite the inverse of the forward one.
        let published = inverse("cobe", "cobe", Place::Degrees, plane);
        for (mode, call, suffix) in [("one by one", "n = 1", ""), ("batch", "vector", "_batch")] {
            let pass = shim.pass(&format!("csc_inverse{suffix}"));
            bench.run(
                &published,
                &shim.library,
                &format!("cscs2x and cscx2s; lat lon; {call}"),
                mode,
                &pass,
            );
        }
        let methods = [
            "hpxs2x and hpxx2s; lat lon; n = 1",
            "hpxs2x and hpxx2s; lat lon; vector",
        ];
        let plane = Plane::new(Layout::Healpix(45.0));
        Pair::new("healpix", "healpix", Place::Degrees, plane).run(bench, &shim, "healpix", methods, false);
    }

    let quadratic = Pair::new("s2-quadratic", "s2-quadratic", Place::Vector, s2(faces(0.5, 0.5)));
    let gnomonic = Pair::new("tangential", "tangential", Place::Vector, s2(faces(1.0, 0.0)));
    for shim in Shim::all("s2geometry", "S2") {
        for (pair, name, method) in [
            (&quadratic, "s2_quadratic", "S2::XYZtoFaceUV and UVtoST; unit vectors"),
            (&gnomonic, "gnomonic", "S2::XYZtoFaceUV; unit vectors"),
        ] {
            let pass = |suffix: &str| shim.pass(&format!("{name}_{suffix}"));
            bench.run(&pair.forward, &shim.library, method, "one by one", &pass("forward"));
            bench.run(&pair.inverse, &shim.library, method, "one by one", &pass("inverse"));
        }
    }

    let mut run = |task: &Task, library: &str, method: &str, pass: Pass| {
        bench.run(task, library, method, "one by one", &pass);
    };
    // The crate s2 keeps its planes to itself: what it offers is the cell of 30 bits either way.
    let library = crate::crate_version("s2");
    let method = "CellID::from(Point) and back; leaf cells of 1 cm; unit vectors";
    let cells = Pair::new(
        "s2-quadratic",
        "s2-quadratic",
        Place::Vector,
        s2(Plane::new(Layout::Cells)),
    );
    run(
        &cells.forward,
        &library,
        method,
        each(|[x, y, z]| halves(CellID::from(s2::point::Point(s2::r3::vector::Vector { x, y, z })))),
    );
    run(
        &cells.inverse,
        &library,
        method,
        each(|cell| {
            let p = s2::point::Point::from(whole(cell)).0;
            [p.x, p.y, p.z]
        }),
    );

    let library = crate::crate_version("cdshealpix");
    let healpix = Pair::new("healpix", "healpix", Place::Radians, Plane::new(Layout::Healpix(1.0)));
    run(
        &healpix.forward,
        &library,
        "proj and unproj; lat lon",
        each(|[lon, lat]| cdshealpix::proj(lon, lat).into()),
    );
    run(
        &healpix.inverse,
        &library,
        "proj and unproj; lat lon",
        each(|[x, y]| cdshealpix::unproj(x, y).into()),
    );
}
