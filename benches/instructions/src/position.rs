use terrella::latitude::Conversion;
use terrella::{
    Aer, Direction, Ecef, Ellipsoid, Enu, Geodetic, GeodeticSeries, LatLon, Latitude, LocalFrame, Real, Shift, Shifted,
    math,
};

use crate::points::Points;
use crate::sweep::Sweep;

pub fn kernels<T: Real>(sweep: Sweep, points: &Points<T>) {
    let units = &points.units;
    sweep.count("math::sin_cos", units, |[x, _]| math::sin_cos(x));
    sweep.count("math::sin_cos_degrees", units, |[x, _]| {
        math::sin_cos_degrees(x * T::of(180.0))
    });
    sweep.count("math::tan", units, |[x, _]| math::tan(x * T::of(0.75)));
    sweep.count("math::atan", units, |[x, _]| math::atan(x));
    sweep.count("math::atan2", units, |[x, y]| math::atan2(y, x));
    sweep.count("math::atan2_degrees", units, |[x, y]| math::atan2_degrees(y, x));
    sweep.count("math::cbrt", units, |[x, _]| math::cbrt(x));
    sweep.count("math::exp_m1", units, |[x, _]| math::exp_m1(x));
    sweep.count("math::log2", units, |[x, _]| math::log2(x.abs()));
}

pub fn positions<T: Real>(sweep: Sweep, points: &Points<T>) {
    sweep.count("LatLon::new", &points.units, |[x, y]| {
        LatLon::new(x * T::of(90.0), y * T::of(180.0))
    });
    sweep.count("LatLon::new, wrapped", &points.units, |[x, y]| {
        LatLon::new(x, y + T::of(540.0))
    });
    sweep.count("LatLon::to_direction", &points.places, LatLon::to_direction);
    sweep.count("Direction::new", &points.vectors, |[x, y, z]| Direction::new(x, y, z));
    sweep.count("Direction::to_lat_lon", &points.directions, Direction::to_lat_lon);
    for &shift in Shift::ALL {
        let earth = Shifted::new(Ellipsoid::WGS84, shift).unwrap();
        let name = |function| format!("Shifted::{function}, {shift}");
        sweep.count(&name("to_direction"), &points.places, |place| earth.to_direction(place));
        sweep.count(&name("to_lat_lon"), &points.directions, |direction| {
            earth.to_lat_lon(direction)
        });
    }
    let earth = Ellipsoid::WGS84;
    sweep.count("Geodetic::new", &points.places, |place| {
        Geodetic::new(place, place.lat())
    });
    sweep.count("Ecef::new", &points.vectors, |[x, y, z]| Ecef::new(x, y, z));
    sweep.count("Ellipsoid::to_ecef", &points.geodetics, |place| earth.to_ecef(place));
    let ecefs: Vec<_> = points.geodetics.iter().map(|&place| earth.to_ecef(place)).collect();
    sweep.count("Ellipsoid::to_geodetic", &ecefs, |point| earth.to_geodetic(point));
    let series = GeodeticSeries::new(earth);
    sweep.count("GeodeticSeries::second_order", &ecefs, |point| {
        series.second_order(point)
    });
    sweep.count("GeodeticSeries::third_order", &ecefs, |point| series.third_order(point));
    sweep.count("GeodeticSeries::fourth_order", &ecefs, |point| {
        series.fourth_order(point)
    });
    let deep: Vec<_> = points.vectors.iter().map(|v| v.map(|x| x * T::of(3e4))).collect();
    let deep: Vec<_> = deep.iter().map(|&[x, y, z]| Ecef::new(x, y, z).unwrap()).collect();
    sweep.count("Ellipsoid::to_geodetic, near the centre", &deep, |point| {
        earth.to_geodetic(point)
    });
}

pub fn latitudes<T: Real>(sweep: Sweep, points: &Points<T>) {
    let (earth, geodetic) = (Ellipsoid::WGS84, Latitude::Geodetic);
    for &latitude in Latitude::ALL {
        for (from, to) in [(geodetic, latitude), (latitude, geodetic)] {
            if from == to {
                continue;
            }
            let conversion = Conversion::new(earth, from, to).unwrap();
            let name = |unit| format!("Conversion::{unit}, {from} to {to}");
            sweep.count(&name("degrees"), &points.units, |[x, _]| {
                conversion.degrees(x * T::of(90.0))
            });
            sweep.count(&name("radians"), &points.units, |[x, _]| {
                conversion.radians(x * T::of(1.5))
            });
        }
    }
}

pub fn frames<T: Real>(sweep: Sweep, points: &Points<T>) {
    let earth = Ellipsoid::WGS84;
    let places = &points.geodetics;
    let frame = LocalFrame::new(earth, places[0]);
    let ecefs: Vec<_> = places.iter().map(|&place| earth.to_ecef(place)).collect();
    let enus: Vec<_> = ecefs.iter().map(|&point| frame.to_enu(point)).collect();
    let aers: Vec<_> = enus.iter().map(|&enu| Aer::from(enu)).collect();
    sweep.count("LocalFrame::new", places, |origin| LocalFrame::new(earth, origin));
    sweep.count("LocalFrame::to_enu", &ecefs, |point| frame.to_enu(point));
    sweep.count("LocalFrame::to_ned", &ecefs, |point| frame.to_ned(point));
    sweep.count("LocalFrame::to_aer", &ecefs, |point| frame.to_aer(point));
    sweep.count("LocalFrame::from_enu", &enus, |enu| frame.from_enu(enu));
    sweep.count("LocalFrame::from_ned", &enus, |enu| frame.from_ned(enu.into()));
    sweep.count("LocalFrame::from_aer", &aers, |aer| frame.from_aer(aer));
    sweep.count("LocalFrame::geodetic_to_enu", places, |place| {
        frame.geodetic_to_enu(place)
    });
    sweep.count("LocalFrame::geodetic_to_ned", places, |place| {
        frame.geodetic_to_ned(place)
    });
    sweep.count("LocalFrame::geodetic_to_aer", places, |place| {
        frame.geodetic_to_aer(place)
    });
    sweep.count("LocalFrame::vector_to_enu", &points.vectors, |vector| {
        frame.vector_to_enu(vector)
    });
    sweep.count("LocalFrame::vector_from_enu", &enus, |enu| frame.vector_from_enu(enu));
    sweep.count("Aer::from", &enus, Aer::from);
    sweep.count("Enu::from", &aers, Enu::from);
}
