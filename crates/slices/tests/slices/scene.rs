//! Answers of scenes.

use terrella::batch;
use terrella::geodesic::Geodesic;
use terrella::scene::{Order, Scene, View};
use terrella::{Ecef, Ellipsoid, Enu, Geodetic, LatLon};

use super::{ENDS, Scalar, compare, numbers, pairs, places, scaled};

fn every_answer<T: Scalar>() {
    let scene = Scene::around(Ellipsoid::WGS84, 47.0, 1e5).up_to(1e5);
    let origin = Geodetic::new(LatLon::new(T::of(47.0), T::of(8.0)).unwrap(), T::of(400.0)).unwrap();
    let [lat, lon] = places::<T>();
    let columns = [lat, lon, scaled(&numbers(10, ENDS), 1e5)];
    for view in View::ALL {
        let view = scene.positions_by::<T>(view).unwrap().about(origin);
        compare(
            "enu",
            &columns,
            &|[lat, lon, height]| {
                let place = Geodetic::new(LatLon::new(lat, lon).unwrap(), height).unwrap();
                let Enu { east, north, up } = view.enu(place);
                [east, north, up]
            },
            &|from, to| batch::scene::enu(&view, from, to).unwrap(),
        );
    }
    for order in Order::ALL {
        let solver = scene.geodetics_by::<T>(order).unwrap().solver();
        compare(
            "to_geodetic",
            &[11, 12, 13].map(|seed| scaled(&numbers(seed, ENDS), 7e6)),
            &|[x, y, z]| {
                let place = solver.to_geodetic(Ecef::new(x, y, z).unwrap());
                [place.lat(), place.lon(), place.height()]
            },
            &|from, to| batch::scene::to_geodetic(solver, from, to).unwrap(),
        );
    }
    for &method in Scene::METHODS {
        let method = scene.distances_by::<T>(method).unwrap().solver();
        let nothing = [T::of(f64::NAN); 3];
        compare(
            "inverse",
            &pairs::<T>(),
            &|[lat1, lon1, lat2, lon2]| {
                let (from, to) = (LatLon::new(lat1, lon1).unwrap(), LatLon::new(lat2, lon2).unwrap());
                let line = method.inverse(from, to);
                line.map_or(nothing, |line| [line.distance, line.azimuth1, line.azimuth2])
            },
            &|[lat1, lon1, lat2, lon2], lines| {
                let _ = batch::scene::inverse(method, [lat1, lon1], [lat2, lon2], lines);
            },
        );
        let [lat, lon, azimuth, distance] = pairs::<T>();
        compare(
            "direct",
            &[lat, lon, azimuth, scaled(&distance, 1e4)],
            &|[lat, lon, azimuth, distance]| {
                let end = method
                    .direct(LatLon::new(lat, lon).unwrap(), azimuth, distance)
                    .unwrap();
                [end.position.lat(), end.position.lon(), end.azimuth]
            },
            &|[lat, lon, azimuth, distance], ends| {
                batch::scene::direct(method, [lat, lon], azimuth, distance, ends).unwrap();
            },
        );
    }
}

#[test]
fn answers_of_scenes_are_the_same_bits() {
    every_answer::<f64>();
    every_answer::<f32>();
}
