//! Geodesics on WGS84: inverse (distance and both azimuths), distance alone, direct.

use geo::{Destination, Distance, Geodesic, Haversine, Point, VincentyDistance};
use geodesy::prelude::*;
use geographiclib_rs::{DirectGeodesic, InverseGeodesic};
use numkong::Geospatial;
use uom::si::length::meter;

use crate::bench::{Bench, Task};
use crate::pass::{Pass, Scalar, Set, batch, each};
use crate::position::place;
use crate::shim::Shim;
use crate::truth::{Exact, Truth};
use crate::{Unit, one_by_one};
use timing::points::{Order, Pairing, WGS84_A, WGS84_F, lines, pairs};

/// Points of a set.
const N: usize = timing::points::N;

fn inverse_task(operation: &str, unit: Unit) -> Task {
    inverse_task_of(operation, unit, Truth::read("geod_inverse_wgs84"))
}

fn inverse_task_of(operation: &str, unit: Unit, truth: Truth) -> Task {
    let set = |pairing| {
        let p = pairs(pairing, N);
        unit.of(Set::new(vec![p.lat1, p.lon1, p.lat2, p.lon2]), &[0, 1, 2, 3])
    };
    let column = |name| truth.values(name);
    let distance = truth.exact("s12");
    Task {
        chart: "distance",
        operation: operation.to_owned(),
        inputs: Pairing::COMMON.map(|pairing| (pairing.name(), set(pairing))).into(),
        truth: unit.of(
            Set::new(vec![column("lat1"), column("lon1"), column("lat2"), column("lon2")]),
            &[0, 1, 2, 3],
        ),
        error: Box::new(move |i, room| Some(Exact::from(room.columns[0][i]).minus(distance[i]).abs())),
    }
}

fn direct_task(unit: Unit) -> Task {
    let set = |order| {
        let p = lines(order, N);
        unit.of(Set::new(vec![p.lat, p.lon, p.azimuth, p.distance]), &[0, 1, 2])
    };
    // As the timed lines: no more than half way round.
    let half = |length: &str| length.parse::<f64>().expect("a number").abs() < 2.1e7;
    let truth = Truth::read("geod_direct_wgs84").keep("s12", half);
    let column = |name| truth.values(name);
    let (lat, lon) = (truth.exact("lat2"), truth.exact("lon2"));
    Task {
        chart: "distance",
        operation: "direct".to_owned(),
        inputs: Order::ALL.map(|order| (order.name(), set(order))).into(),
        truth: unit.of(
            Set::new(vec![column("lat1"), column("lon1"), column("azi1"), column("s12")]),
            &[0, 1, 2],
        ),
        error: Box::new(move |i, room| {
            let [lat2, lon2] = [0, 1].map(|k| unit.degrees(room.columns[k][i]));
            Some(displacement(lat2.minus(lat[i]), lon2.minus(lon[i]), lat[i].value, 0.0))
        }),
    }
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

/// NumKong's distances in batch, of places in radians. In `f32`, its errors are those of the rows whose degrees are
/// exact in it.
fn numkong<T: Geospatial + Scalar + 'static>(bench: &mut Bench) {
    let exact = |degrees: &str| degrees.parse::<f64>().is_ok_and(|value| T::of(value).into() == value);
    let columns = ["lat1", "lon1", "lat2", "lon2"];
    let truth = Truth::read("geod_inverse_wgs84");
    let truth = columns
        .into_iter()
        .fold(truth, |truth, column| truth.keep(column, exact));
    let task = inverse_task_of("distance", Unit::Radians, truth).rounded::<T>();
    let library = crate::crate_version("numkong");
    let slices = "slices of equal length";
    let haversine = batch(move |[lat1, lon1, lat2, lon2], distances| {
        T::haversine(lat1, lon1, lat2, lon2, distances).expect(slices);
    });
    bench.run(&task, &library, "Haversine", "batch", &haversine);
    let vincenty = batch(move |[lat1, lon1, lat2, lon2], distances| {
        T::vincenty(lat1, lon1, lat2, lon2, distances).expect(slices);
    });
    bench.run(&task, &library, "Vincenty", "batch", &vincenty);
}

/// Runs the chart.
pub fn run(bench: &mut Bench) {
    let inverse = inverse_task("inverse", Unit::Degrees);
    let distance = inverse_task("distance", Unit::Degrees);
    let direct = direct_task(Unit::Degrees);

    for shim in Shim::all("geographiclib", "GeographicLib") {
        one_by_one(bench, &inverse, &shim, "Geodesic::Inverse", "inverse");
        one_by_one(bench, &distance, &shim, "Geodesic::Inverse (distance only)", "distance");
        one_by_one(bench, &direct, &shim, "Geodesic::Direct", "direct");
    }
    for shim in Shim::all("proj", "PROJ") {
        one_by_one(bench, &inverse, &shim, "geod_inverse", "inverse");
        one_by_one(bench, &distance, &shim, "geod_inverse (distance only)", "distance");
        one_by_one(bench, &direct, &shim, "geod_direct", "direct");
    }
    numkong::<f64>(bench);
    numkong::<f32>(bench);
    let mut run = |task: &Task, library: &str, method: &str, pass: Pass| {
        bench.run(task, library, method, "one by one", &pass);
    };

    let library = crate::crate_version("geographiclib-rs");
    let earth = geographiclib_rs::Geodesic::wgs84();
    run(&inverse, &library, "inverse", {
        let earth = geographiclib_rs::Geodesic::wgs84();
        each(move |[lat1, lon1, lat2, lon2]| {
            let (distance, azimuth1, azimuth2, _) = earth.inverse(lat1, lon1, lat2, lon2);
            [distance, azimuth1, azimuth2]
        })
    });
    run(&distance, &library, "inverse (distance only)", {
        let earth = geographiclib_rs::Geodesic::wgs84();
        each(move |[lat1, lon1, lat2, lon2]| [earth.inverse(lat1, lon1, lat2, lon2)])
    });
    run(
        &direct,
        &library,
        "direct",
        each(move |[lat, lon, azimuth, distance]| {
            let (lat2, lon2, azimuth2) = earth.direct(lat, lon, azimuth, distance);
            [lat2, lon2, azimuth2]
        }),
    );

    let library = crate::crate_version("geo");
    run(
        &distance,
        &library,
        "vincenty_distance",
        each(|[lat1, lon1, lat2, lon2]| {
            [Point::new(lon1, lat1)
                .vincenty_distance(&Point::new(lon2, lat2))
                .unwrap_or(f64::NAN)]
        }),
    );
    run(
        &distance,
        &library,
        "Geodesic.distance",
        each(|[lat1, lon1, lat2, lon2]| [Geodesic.distance(Point::new(lon1, lat1), Point::new(lon2, lat2))]),
    );
    run(
        &distance,
        &library,
        "Haversine.distance",
        each(|[lat1, lon1, lat2, lon2]| [Haversine.distance(Point::new(lon1, lat1), Point::new(lon2, lat2))]),
    );
    run(
        &direct,
        &library,
        "Geodesic.destination",
        each(|[lat, lon, azimuth, distance]| {
            let end = Geodesic.destination(Point::new(lon, lat), azimuth, distance);
            [end.y(), end.x()]
        }),
    );
    run(
        &direct,
        &library,
        "Haversine.destination",
        each(|[lat, lon, azimuth, distance]| {
            let end = Haversine.destination(Point::new(lon, lat), azimuth, distance);
            [end.y(), end.x()]
        }),
    );

    let library = crate::crate_version("geo3d");
    run(
        &inverse,
        &library,
        "geodesic_inverse",
        each(|[lat1, lon1, lat2, lon2]| {
            let (from, to) = (
                geo3d::Geodetic::new(lat1, lon1, 0.0),
                geo3d::Geodetic::new(lat2, lon2, 0.0),
            );
            match geo3d::WGS84.geodesic_inverse(from, to) {
                Some(line) => [line.distance_m, line.initial_bearing_deg, line.final_bearing_deg],
                None => [f64::NAN; 3],
            }
        }),
    );
    run(
        &direct,
        &library,
        "geodesic_direct",
        each(|[lat, lon, azimuth, distance]| {
            let (end, azimuth2) = geo3d::WGS84.geodesic_direct(geo3d::Geodetic::new(lat, lon, 0.0), azimuth, distance);
            [end.lat_deg, end.lon_deg, azimuth2]
        }),
    );

    let library = crate::crate_version("sguaba");
    let distance_radians = inverse_task("distance", Unit::Radians);
    run(
        &distance_radians,
        &library,
        "haversine_distance_on_surface",
        each(
            |[lat1, lon1, lat2, lon2]| match (place(lat1, lon1, 0.0), place(lat2, lon2, 0.0)) {
                (Some(from), Some(to)) => [from.haversine_distance_on_surface(&to).get::<meter>()],
                _ => [f64::NAN],
            },
        ),
    );

    let library = crate::crate_version("geodesy");
    let mut inverse_radians = inverse_task("inverse", Unit::Radians);
    // Up to 1000 iterations each: hours on the antipodal pairs.
    inverse_radians.inputs.retain(|(input, _)| *input != "antipodal");
    let earth = Ellipsoid::named("WGS84").expect("a known ellipsoid");
    run(&inverse_radians, &library, "geodesic_inv (Vincenty)", {
        each(move |[lat1, lon1, lat2, lon2]| {
            let line = earth.geodesic_inv(&Coor2D::raw(lon1, lat1), &Coor2D::raw(lon2, lat2));
            // The fourth is the count of iterations: at 1000 it gave up.
            if line[3] < 1000.0 {
                [line[2], line[0], line[1]]
            } else {
                [f64::NAN; 3]
            }
        })
    });
    let earth = Ellipsoid::named("WGS84").expect("a known ellipsoid");
    run(
        &direct_task(Unit::Radians),
        &library,
        "geodesic_fwd (Vincenty)",
        each(move |[lat, lon, azimuth, distance]| {
            let end = earth.geodesic_fwd(&Coor2D::raw(lon, lat), azimuth, distance);
            if end[3] < 1000.0 {
                [end[1], end[0], end[2]]
            } else {
                [f64::NAN; 3]
            }
        }),
    );
}
