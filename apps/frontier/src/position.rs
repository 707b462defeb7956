//! Earth-centred coordinates, auxiliary latitudes and directions, both ways.

use std::rc::Rc;

use terrella::batch;
use terrella::latitude::Conversion;
use terrella::{Direction, Ecef, Ellipsoid, Geodetic, GeodeticSeries, LatLon, Latitude};

use crate::bench::{Bench, Error, Mode, Task};
use crate::distance::{displacement, inputs};
use crate::set::{self, Set, each};
use crate::truth::{Row, Scalar, rows};
use timing::points::{Order, WGS84_A, directions, lat_lons, positions};
use timing::record::METRES_PER_RADIAN;

/// Heights of less are of no use to anybody, and most libraries do not claim them.
const DEEPEST: f64 = -10_000.0;

/// Heights that the errors of [`GeodeticSeries`] are told for, in metres.
const NEAR: [f64; 2] = [-500.0, 1e5];

fn task<T: Scalar>(
    operation: &str,
    points: impl Fn(Order) -> Vec<Vec<f64>>,
    truth: Set<T>,
    error: Error<T>,
) -> Task<T> {
    Task {
        chart: "position",
        operation: operation.to_owned(),
        inputs: Order::ALL
            .map(|order| (order.name(), Rc::new(Set::new(points(order)))))
            .into(),
        truth,
        error,
    }
}

/// The length of the difference of three components.
fn length<T: Scalar>(truth: Vec<Row<'static>>, columns: [&'static str; 3], metres: f64) -> Error<T> {
    Box::new(move |i, room| {
        let off = [0, 1, 2].map(|k| truth[i].deviation(columns[k], room.columns[k][i]));
        off[0].hypot(off[1]).hypot(off[2]) * metres
    })
}

fn ecef<T: Scalar>(bench: &mut Bench) {
    let wgs84 = Ellipsoid::<T>::WGS84;
    let n = bench.points;
    let high = |name: &str, columns: &[&str]| {
        let mut truth = rows::<T>(name, columns);
        truth.retain(|row| row.value("h") >= DEEPEST);
        truth
    };

    let columns = ["lat", "lon", "h"];
    let truth = high("ecef_forward_wgs84", &columns);
    let set = inputs::<T, _>(&truth, columns);
    let places = |order| {
        let p = positions(order, n);
        vec![p.lat, p.lon, p.height]
    };
    let out = task("geodetic to ecef", places, set, length(truth, ["X", "Y", "Z"], 1.0));
    let single = each(|[lat, lon, height]| {
        let place = Geodetic::new(LatLon::new(lat, lon).ok()?, height).ok()?;
        Some(wgs84.to_ecef(place).to_array())
    });
    bench.run(&out, "Ellipsoid::to_ecef", Mode::OneByOne, &single);
    let many = set::batch(|places, points| batch::ellipsoid::to_ecef(wgs84, places, points).expect("places"));
    bench.run(&out, "Ellipsoid::to_ecef", Mode::Batch, &many);

    let columns = ["X", "Y", "Z"];
    let axes = |order| {
        let p = positions(order, n);
        vec![p.x, p.y, p.z]
    };
    let to_geodetic = |truth: Vec<Row<'static>>| {
        let set = inputs::<T, _>(&truth, columns);
        let error = move |i: usize, room: &Set<T>| {
            let [lat, lon, up] =
                [("lat", 0), ("lon", 1), ("h", 2)].map(|(c, k)| truth[i].deviation(c, room.columns[k][i]));
            displacement(lat, lon, truth[i].value("lat"), truth[i].value("h")).hypot(up)
        };
        task("ecef to geodetic", axes, set, Box::new(error))
    };
    let truth = high("ecef_reverse_wgs84", &columns);
    let back = to_geodetic(truth.clone());
    let single = each(|[x, y, z]| {
        let place = wgs84.to_geodetic(Ecef::new(x, y, z).ok()?);
        Some([place.lat(), place.lon(), place.height()])
    });
    bench.run(&back, "Ellipsoid::to_geodetic", Mode::OneByOne, &single);
    let many = set::batch(|points, places| batch::ellipsoid::to_geodetic(wgs84, points, places).expect("points"));
    bench.run(&back, "Ellipsoid::to_geodetic", Mode::Batch, &many);

    let near = |row: &Row| (NEAR[0]..=NEAR[1]).contains(&row.value("h"));
    let back = to_geodetic(truth.into_iter().filter(near).collect());
    let series = GeodeticSeries::new(wgs84);
    macro_rules! order {
        ($name:ident) => {
            let single = each(|[x, y, z]| {
                let place = series.$name(Ecef::new(x, y, z).ok()?);
                Some([place.lat(), place.lon(), place.height()])
            });
            let name = concat!("GeodeticSeries::", stringify!($name));
            bench.run(&back, name, Mode::OneByOne, &single);
            let many = set::batch(|points, places| batch::ellipsoid::$name(series, points, places).expect("points"));
            bench.run(&back, name, Mode::Batch, &many);
        };
    }
    order!(second_order);
    order!(third_order);
    order!(fourth_order);
}

fn direction<T: Scalar>(bench: &mut Bench) {
    let n = bench.points;
    let columns = ["lat", "lon"];
    let truth = rows::<T>("kernel_direction", &columns);
    let set = inputs::<T, _>(&truth, columns);
    let places = |order| {
        let p = lat_lons(order, n);
        vec![p.lat, p.lon]
    };
    let out = task(
        "lat lon to direction",
        places,
        set,
        length(truth, ["x", "y", "z"], METRES_PER_RADIAN),
    );
    let single = each(|[lat, lon]| Some(LatLon::new(lat, lon).ok()?.to_direction().to_array()));
    bench.run(&out, "LatLon::to_direction", Mode::OneByOne, &single);
    let many = set::batch(|places, vectors| batch::position::to_direction(places, vectors).expect("places"));
    bench.run(&out, "LatLon::to_direction", Mode::Batch, &many);

    let columns = ["x", "y", "z"];
    let truth = rows::<T>("kernel_lat_lon", &columns);
    let set = inputs::<T, _>(&truth, columns);
    let vectors = |order| {
        let p = directions(order, n);
        vec![p.x, p.y, p.z]
    };
    let error = move |i: usize, room: &Set<T>| {
        let [lat, lon] = [("lat", 0), ("lon", 1)].map(|(c, k)| truth[i].deviation(c, room.columns[k][i]).to_radians());
        let cos = (90.0 - truth[i].value("lat").abs()).to_radians().sin();
        lat.hypot(cos * lon) * METRES_PER_RADIAN
    };
    let back = task("direction to lat lon", vectors, set, Box::new(error));
    let single = each(|[x, y, z]| {
        let place = Direction::new(x, y, z).ok()?.to_lat_lon();
        Some([place.lat(), place.lon()])
    });
    bench.run(&back, "Direction::to_lat_lon", Mode::OneByOne, &single);
    let many = set::batch(|vectors, places| batch::position::to_lat_lon(vectors, places).expect("vectors"));
    bench.run(&back, "Direction::to_lat_lon", Mode::Batch, &many);
}

/// In radians, as the truth of both ways is.
fn latitude<T: Scalar>(bench: &mut Bench, kind: Latitude) {
    let n = bench.points;
    let wgs84 = Ellipsoid::<T>::WGS84;
    let angles = |order| vec![lat_lons(order, n).lat.iter().map(|lat| lat.to_radians()).collect()];
    let error = |truth: Vec<Row<'static>>, column: &'static str| -> Error<T> {
        Box::new(move |i, room| truth[i].error(column, room.columns[0][i]) * WGS84_A)
    };

    let mut truth = rows::<T>("auxlat_wgs84_rad", &["phi"]);
    truth.retain(|row| row.value(kind.name()).is_finite());
    let set = inputs::<T, _>(&truth, ["phi"]);
    let there = task(&format!("{kind} latitude"), angles, set, error(truth, kind.name()));
    let conversion = Conversion::new(wgs84, Latitude::Geodetic, kind).expect("a latitude for the Earth");
    both(bench, &there, conversion);

    let mut truth = rows::<T>("auxlat_inverse_wgs84_rad", &["value"]);
    truth.retain(|row| row.text("kind") == kind.name());
    let set = inputs::<T, _>(&truth, ["value"]);
    let back = task(
        &format!("{kind} to geodetic latitude"),
        angles,
        set,
        error(truth, "phi"),
    );
    let conversion = Conversion::new(wgs84, kind, Latitude::Geodetic).expect("a latitude for the Earth");
    both(bench, &back, conversion);
}

fn both<T: Scalar>(bench: &mut Bench, task: &Task<T>, conversion: Conversion<T>) {
    let single = each(|[value]| Some([conversion.radians(value).ok()?]));
    bench.run(task, "Conversion::radians", Mode::OneByOne, &single);
    let many = set::batch(|[values], [results]| {
        batch::latitude::radians(&conversion, values, results).expect("latitudes");
    });
    bench.run(task, "Conversion::radians", Mode::Batch, &many);
}

/// Runs the chart in a scalar.
pub fn run<T: Scalar>(bench: &mut Bench) {
    ecef::<T>(bench);
    direction::<T>(bench);
    for &kind in Latitude::ALL.iter().filter(|&&kind| kind != Latitude::Geodetic) {
        latitude::<T>(bench, kind);
    }
}
