//! Geodesics on WGS84, both problems, by every method.

use std::rc::Rc;

use terrella::batch::geodesic;
use terrella::geodesic::{Geodesic, Method, Visitor};
use terrella::{Ellipsoid, LatLon};

use crate::bench::{Bench, Mode, Task};
use crate::set::{Set, batch, each};
use crate::truth::{Row, Scalar, rows};
use timing::points::{Order, Pairing, WGS84_A, WGS84_F, lines, pairs};

/// Lines of the truth that are longer go more than half way round, which no timed line does.
const LONGEST: f64 = 2.1e7;

/// The problems in a scalar.
struct Problems<T> {
    inverse: Task<T>,
    distance: Task<T>,
    direct: Task<T>,
}

impl<T: Scalar> Problems<T> {
    fn new(points: usize) -> Self {
        let set = |pairing: Pairing| {
            let p = pairs(pairing, points);
            let set = Set::new(vec![p.lat1, p.lon1, p.lat2, p.lon2]);
            (pairing.name(), Rc::new(set))
        };
        let [random, scan, mix, antipodal] = Pairing::COMMON.map(set);
        let ordinary = vec![random, scan];
        let all = [&ordinary[..], &[mix, antipodal], &Pairing::SPECIAL.map(set)].concat();
        let pairs = |operation: &str, inputs_timed| {
            let columns = ["lat1", "lon1", "lat2", "lon2"];
            let truth = rows::<T>("geod_inverse_wgs84", &columns);
            Task {
                chart: "distance",
                operation: operation.to_owned(),
                inputs: inputs_timed,
                truth: inputs(&truth, columns),
                error: Box::new(move |i, room: &Set<T>| truth[i].error("s12", room.columns[0][i])),
            }
        };

        let columns = ["lat1", "lon1", "azi1", "s12"];
        let mut truth = rows::<T>("geod_direct_wgs84", &columns);
        truth.retain(|row| row.value("s12").abs() < LONGEST);
        let set = |order| {
            let p = lines(order, points);
            Rc::new(Set::new(vec![p.lat, p.lon, p.azimuth, p.distance]))
        };
        let direct = Task {
            chart: "distance",
            operation: "direct".to_owned(),
            inputs: Order::ALL.map(|order| (order.name(), set(order))).into(),
            truth: inputs(&truth, columns),
            error: Box::new(move |i, room: &Set<T>| {
                let lat = truth[i].deviation("lat2", room.columns[0][i]);
                let lon = truth[i].deviation("lon2", room.columns[1][i]);
                displacement(lat, lon, truth[i].value("lat2"), 0.0)
            }),
        };
        Self {
            distance: pairs("distance", ordinary),
            inverse: pairs("inverse", all),
            direct,
        }
    }
}

/// Times a method, of this name, in both modes.
pub struct Timed<'a, T> {
    pub bench: &'a mut Bench,
    pub name: &'a str,
    /// Distance and both azimuths of pairs of places.
    pub inverse: &'a Task<T>,
    /// The distance alone.
    pub distance: &'a Task<T>,
    /// The ends of lines.
    pub direct: &'a Task<T>,
}

impl<T: Scalar> Visitor<T> for Timed<'_, T> {
    type Output = ();

    fn visit<M: Geodesic<T>>(self, method: M) {
        let Self { bench, name, .. } = self;
        let single = each(|[lat1, lon1, lat2, lon2]| {
            let line = method.inverse(LatLon::new(lat1, lon1).ok()?, LatLon::new(lat2, lon2).ok()?);
            let line = line.ok()?;
            Some([line.distance, line.azimuth1, line.azimuth2])
        });
        bench.run(self.inverse, name, Mode::OneByOne, &single);
        // A pair without an answer is NaN, and the others are there.
        let many = batch(|[lat1, lon1, lat2, lon2], lines| {
            let _ = geodesic::inverse(&method, [lat1, lon1], [lat2, lon2], lines);
        });
        bench.run(self.inverse, name, Mode::Batch, &many);

        let single = each(|[lat1, lon1, lat2, lon2]| {
            let distance = method.distance(LatLon::new(lat1, lon1).ok()?, LatLon::new(lat2, lon2).ok()?);
            Some([distance.ok()?])
        });
        bench.run(self.distance, name, Mode::OneByOne, &single);
        let many = batch(|[lat1, lon1, lat2, lon2], [distances]| {
            let _ = geodesic::distance(&method, [lat1, lon1], [lat2, lon2], distances);
        });
        bench.run(self.distance, name, Mode::Batch, &many);

        let single = each(|[lat, lon, azimuth, distance]| {
            let end = method.direct(LatLon::new(lat, lon).ok()?, azimuth, distance).ok()?;
            Some([end.position.lat(), end.position.lon(), end.azimuth])
        });
        bench.run(self.direct, name, Mode::OneByOne, &single);
        let many = batch(|[lat, lon, azimuth, distance], ends| {
            let _ = geodesic::direct(&method, [lat, lon], azimuth, distance, ends);
        });
        bench.run(self.direct, name, Mode::Batch, &many);
    }
}

/// The truth's inputs.
pub fn inputs<T: Scalar, const I: usize>(truth: &[Row<'static>], columns: [&str; I]) -> Set<T> {
    Set::new(
        columns
            .map(|column| truth.iter().map(|row| row.value(column)).collect())
            .into(),
    )
}

/// The length in metres of a small difference of latitude and longitude in degrees, at a latitude and height on WGS84.
pub fn displacement(lat_off: f64, lon_off: f64, lat: f64, height: f64) -> f64 {
    let e2 = WGS84_F * (2.0 - WGS84_F);
    let w2 = 1.0 - e2 * lat.to_radians().sin().powi(2);
    let across = WGS84_A / w2.sqrt();
    let along = across * (1.0 - e2) / w2;
    let cos = (90.0 - lat.abs()).to_radians().sin();
    let east = (across + height) * cos * 2.0 * (lon_off / 2.0).to_radians().sin();
    east.hypot((along + height) * lat_off.to_radians())
}

/// Runs the chart in a scalar.
pub fn run<T: Scalar>(bench: &mut Bench) {
    let problems = Problems::<T>::new(bench.points);
    // What holds about one place is timed by `scene`.
    for method in Method::ALL.iter().filter(|method| !method.needs_place()) {
        let solver = method.on(Ellipsoid::WGS84).expect("a method for the Earth");
        // Each by its own type, as where it is known when compiling.
        solver.visit(Timed {
            bench: &mut *bench,
            name: method.name(),
            inverse: &problems.inverse,
            distance: &problems.distance,
            direct: &problems.direct,
        });
    }
}
