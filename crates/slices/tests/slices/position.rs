//! Positions, latitudes, Earth-centred coordinates.

use terrella::batch;
use terrella::latitude::Conversion;
use terrella::{Direction, Ecef, Ellipsoid, Geodetic, GeodeticSeries, LatLon, Latitude, Shift, Shifted};

use super::{ENDS, Scalar, compare, directions, numbers, places, scaled};

fn every_position<T: Scalar>() {
    compare(
        "to_direction",
        &places::<T>(),
        &|[lat, lon]| LatLon::new(lat, lon).unwrap().to_direction().to_array(),
        &|from, to| batch::position::to_direction(from, to).unwrap(),
    );
    compare(
        "to_lat_lon",
        &directions::<T>(),
        &|[x, y, z]| {
            let place = Direction::new(x, y, z).unwrap().to_lat_lon();
            [place.lat(), place.lon()]
        },
        &|from, to| batch::position::to_lat_lon(from, to).unwrap(),
    );
    for (ellipsoid, &shift) in [Ellipsoid::WGS84, Ellipsoid::new(T::of(6e6), T::of(0.08)).unwrap()]
        .into_iter()
        .flat_map(|ellipsoid| Shift::ALL.iter().map(move |shift| (ellipsoid, shift)))
    {
        let shifted = Shifted::new(ellipsoid, shift).unwrap();
        compare(
            &format!("to_direction, {shift}"),
            &places::<T>(),
            &|[lat, lon]| shifted.to_direction(LatLon::new(lat, lon).unwrap()).to_array(),
            &|from, to| batch::latitude::to_direction(&shifted, from, to).unwrap(),
        );
        compare(
            &format!("to_lat_lon, {shift}"),
            &directions::<T>(),
            &|[x, y, z]| {
                let place = shifted.to_lat_lon(Direction::new(x, y, z).unwrap());
                [place.lat(), place.lon()]
            },
            &|from, to| batch::latitude::to_lat_lon(&shifted, from, to).unwrap(),
        );
    }
}

#[test]
fn positions_are_the_same_bits() {
    every_position::<f64>();
    every_position::<f32>();
}

fn every_latitude<T: Scalar>() {
    let [degrees, _] = places::<T>();
    let right = core::f64::consts::FRAC_PI_2;
    let radians = scaled(
        &numbers(4, ENDS),
        if T::EPSILON.into() > 1e-10 { 1.570_796_2 } else { right },
    );
    for f in [1.0 / 298.257, 0.09] {
        let ellipsoid = Ellipsoid::new(T::of(6.4e6), T::of(f)).unwrap();
        for (&from, &to) in Latitude::ALL
            .iter()
            .flat_map(|a| Latitude::ALL.iter().map(move |b| (a, b)))
        {
            let conversion = Conversion::new(ellipsoid, from, to).unwrap();
            let isometric = scaled(&numbers(9, &[0.0, -0.0, 0.1, f64::INFINITY, f64::NEG_INFINITY]), 10.0);
            let values = if from == Latitude::Isometric {
                &isometric
            } else {
                &degrees
            };
            compare(
                &format!("{from} to {to} in degrees"),
                &[values.to_vec()],
                &|[value]| [conversion.degrees(value).unwrap()],
                &|[from], [to]| batch::latitude::degrees(&conversion, from, to).unwrap(),
            );
            let values = if from == Latitude::Isometric {
                &isometric
            } else {
                &radians
            };
            compare(
                &format!("{from} to {to} in radians"),
                &[values.to_vec()],
                &|[value]| [conversion.radians(value).unwrap()],
                &|[from], [to]| batch::latitude::radians(&conversion, from, to).unwrap(),
            );
        }
    }
}

#[test]
fn latitudes_are_the_same_bits() {
    every_latitude::<f64>();
    every_latitude::<f32>();
}

fn every_ecef<T: Scalar>() {
    let [lat, lon] = places::<T>();
    let sizes = [0.0, -0.0, 1.0, 1e-4, 3e-3, 1e-30, 1e20];
    for ellipsoid in [
        Ellipsoid::<T>::WGS84,
        Ellipsoid::MOON,
        Ellipsoid::new(T::of(6e6), T::of(-0.1)).unwrap(),
    ] {
        let heights = scaled(&numbers(10, ENDS), 1e7);
        compare(
            "to_ecef",
            &[lat.clone(), lon.clone(), heights],
            &|[lat, lon, height]| {
                let place = Geodetic::new(LatLon::new(lat, lon).unwrap(), height).unwrap();
                ellipsoid.to_ecef(place).to_array()
            },
            &|from, to| batch::ellipsoid::to_ecef(ellipsoid, from, to).unwrap(),
        );
        for special in [&sizes[..], &[]] {
            compare(
                "to_geodetic",
                &[11, 12, 13].map(|seed| scaled(&numbers(seed, special), 7e6)),
                &|[x, y, z]| {
                    let place = ellipsoid.to_geodetic(Ecef::new(x, y, z).unwrap());
                    [place.lat(), place.lon(), place.height()]
                },
                &|from, to| batch::ellipsoid::to_geodetic(ellipsoid, from, to).unwrap(),
            );
            series(
                ellipsoid,
                &[11, 12, 13].map(|seed| scaled(&numbers(seed, special), 7e6)),
            );
        }
    }
}

fn series<T: Scalar>(ellipsoid: Ellipsoid<T>, points: &[Vec<T>; 3]) {
    let series = GeodeticSeries::new(ellipsoid);
    let one = |convert: fn(&GeodeticSeries<T>, Ecef<T>) -> Geodetic<T>| {
        move |[x, y, z]: [T; 3]| {
            let place = convert(&series, Ecef::new(x, y, z).unwrap());
            [place.lat(), place.lon(), place.height()]
        }
    };
    compare(
        "second_order",
        points,
        &one(GeodeticSeries::second_order),
        &|from, to| {
            batch::ellipsoid::second_order(series, from, to).unwrap();
        },
    );
    compare("third_order", points, &one(GeodeticSeries::third_order), &|from, to| {
        batch::ellipsoid::third_order(series, from, to).unwrap();
    });
    compare(
        "fourth_order",
        points,
        &one(GeodeticSeries::fourth_order),
        &|from, to| {
            batch::ellipsoid::fourth_order(series, from, to).unwrap();
        },
    );
}

#[test]
fn ecef_is_the_same_bits() {
    every_ecef::<f64>();
    every_ecef::<f32>();
}
