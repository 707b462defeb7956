//! Geodesics on WGS84, both problems, by every method.

use std::rc::Rc;

use terrella::batch::geodesic;
use terrella::geodesic::{AnyMethod, Geodesic, Method, Visitor};
use terrella::{Ellipsoid, LatLon};

use crate::bench::{Bench, Mode, Task};
use crate::set::{Set, batch, each};
use crate::truth::{Row, Scalar, rows};
use timing::points::{Order, Pairing, WGS84_A, WGS84_F, lines, pairs};

/// Lines of the truth that are longer go more than half way round, which no timed line does.
const LONGEST: f64 = 2.1e7;

/// Both problems in a scalar.
struct Problems<T> {
    inverse: Task<T>,
    direct: Task<T>,
}

impl<T: Scalar> Problems<T> {
    fn new(points: usize) -> Self {
        let columns = ["lat1", "lon1", "lat2", "lon2"];
        let truth = rows::<T>("geod_inverse_wgs84", &columns);
        let set = |pairing| {
            let p = pairs(pairing, points);
            Rc::new(Set::new(vec![p.lat1, p.lon1, p.lat2, p.lon2]))
        };
        let inverse = Task {
            chart: "distance",
            operation: "inverse".to_owned(),
            inputs: Pairing::ALL.map(|pairing| (pairing.name(), set(pairing))).into(),
            truth: inputs(&truth, columns),
            error: Box::new(move |i, room: &Set<T>| truth[i].error("s12", room.columns[0][i])),
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
        Self { inverse, direct }
    }

    fn one_by_one(&self, bench: &mut Bench, name: &str, method: &impl Geodesic<T>) {
        let inverse = each(|[lat1, lon1, lat2, lon2]| {
            let line = method
                .inverse(LatLon::new(lat1, lon1).ok()?, LatLon::new(lat2, lon2).ok()?)
                .ok()?;
            Some([line.distance, line.azimuth1, line.azimuth2])
        });
        bench.run(&self.inverse, name, Mode::OneByOne, &inverse);
        let direct = each(|[lat, lon, azimuth, distance]| {
            let end = method.direct(LatLon::new(lat, lon).ok()?, azimuth, distance).ok()?;
            Some([end.position.lat(), end.position.lon(), end.azimuth])
        });
        bench.run(&self.direct, name, Mode::OneByOne, &direct);
    }

    fn both(&self, bench: &mut Bench, name: &str, method: &impl Geodesic<T>) {
        self.one_by_one(bench, name, method);
        // A pair without an answer is NaN, and the others are there.
        let inverse = batch(|[lat1, lon1, lat2, lon2], lines| {
            let _ = geodesic::inverse(method, [lat1, lon1], [lat2, lon2], lines);
        });
        bench.run(&self.inverse, name, Mode::Batch, &inverse);
        let direct = batch(|[lat, lon, azimuth, distance], ends| {
            let _ = geodesic::direct(method, [lat, lon], azimuth, distance, ends);
        });
        bench.run(&self.direct, name, Mode::Batch, &direct);
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
        let name = method.name();
        match method.on(Ellipsoid::WGS84).expect("a method for the Earth") {
            AnyMethod::Vincenty(m) => problems.both(bench, name, &m),
            AnyMethod::Karney(m) => problems.both(bench, name, &m),
            other => other.visit(OneByOne(&problems, bench, name)),
        }
    }
}

/// Times a method one by one.
struct OneByOne<'a, T>(&'a Problems<T>, &'a mut Bench, &'a str);

impl<T: Scalar> Visitor<T> for OneByOne<'_, T> {
    type Output = ();

    fn visit<M: Geodesic<T>>(self, method: M) {
        let Self(problems, bench, name) = self;
        problems.one_by_one(bench, name, &method);
    }
}
