//! Maps of conformal and equal-area projections.

use terrella::batch::{self, InvalidBatch};
use terrella::grid::{Hemisphere, LambertAzimuthal, PolarStereographic, TransverseMercator, Utm, Zone};
use terrella::{Ellipsoid, LatLon};

use super::{ENDS, Scalar, compare, numbers, places, scaled};

fn points<T: Scalar>(size: f64) -> [Vec<T>; 2] {
    [7, 8].map(|seed| scaled(&numbers(seed, ENDS), size))
}

fn place<T: Scalar>([lat, lon]: [T; 2]) -> LatLon<T> {
    LatLon::new(lat, lon).unwrap()
}

fn both<T: Scalar>(place: LatLon<T>) -> [T; 2] {
    [place.lat(), place.lon()]
}

fn maps<T: Scalar>(ellipsoid: Ellipsoid<T>) {
    let map = TransverseMercator::new(ellipsoid, T::of(0.9996), T::of(-177.0)).unwrap();
    compare(
        "transverse Mercator",
        &places::<T>(),
        &|at| map.forward(place(at)),
        &|places, points| batch::grid::transverse_mercator(&map, places, points).unwrap(),
    );
    compare(
        "transverse Mercator, inverse",
        &points::<T>(1e7),
        &|at| both(map.inverse(at).unwrap()),
        &|points, places| batch::grid::transverse_mercator_inverse(&map, points, places).unwrap(),
    );
    let utm = Utm::new(ellipsoid).unwrap();
    let zone = Zone::new(31).unwrap();
    let map = utm.zone(zone).unwrap();
    let [lat, lon] = places::<T>();
    let near = [
        scaled(&lat, 0.85),
        lon.iter().map(|&lon| lon * T::of(0.02) + T::of(3.0)).collect(),
    ];
    for hemisphere in [Hemisphere::North, Hemisphere::South] {
        compare(
            "UTM",
            &near,
            &|at| {
                let here = utm.in_zone(zone, place(at)).unwrap();
                let shift = match (here.hemisphere, hemisphere) {
                    (Hemisphere::North, Hemisphere::North) | (Hemisphere::South, Hemisphere::South) => T::ZERO,
                    // The other hemisphere's northing is rounded by itself.
                    (_, Hemisphere::South) => T::of(1e7),
                    (_, Hemisphere::North) => {
                        return [map.forward(place(at))[0] + T::of(5e5), map.forward(place(at))[1]];
                    }
                };
                [here.easting, here.northing + shift]
            },
            &|places, positions| batch::grid::utm(&map, hemisphere, places, positions).unwrap(),
        );
    }
    let [x, y] = points::<T>(3e5);
    let positions = [x.iter().map(|&x| x + T::of(5e5)).collect(), scaled(&y, 20.0)];
    compare(
        "UTM, inverse",
        &positions,
        &|[x, y]| both(map.inverse([x - T::of(5e5), y]).unwrap()),
        &|positions, places| batch::grid::utm_inverse(&map, Hemisphere::North, positions, places).unwrap(),
    );
    let map = PolarStereographic::new(ellipsoid, T::of(0.994)).unwrap();
    for about in [Hemisphere::North, Hemisphere::South] {
        compare(
            "polar stereographic",
            &places::<T>(),
            &|at| map.forward(about, place(at)),
            &|places, points| batch::grid::polar_stereographic(&map, about, places, points).unwrap(),
        );
        compare(
            "polar stereographic, inverse",
            &points::<T>(1e7),
            &|at| both(map.inverse(about, at).unwrap()),
            &|points, places| batch::grid::polar_stereographic_inverse(&map, about, points, places).unwrap(),
        );
    }
    for centre in [[52.0, 10.0], [0.0, 0.0], [-90.0, 0.0]] {
        let map = LambertAzimuthal::new(ellipsoid, place(centre.map(T::of))).unwrap();
        compare(
            "Lambert azimuthal",
            &places::<T>(),
            &|at| map.forward(place(at)).unwrap_or([T::of(f64::NAN); 2]),
            &|places, points| {
                let _ = batch::grid::lambert_azimuthal(&map, places, points);
            },
        );
        compare(
            "Lambert azimuthal, inverse",
            &points::<T>(1.3e7),
            &|at| map.inverse(at).map_or([T::of(f64::NAN); 2], both),
            &|points, places| {
                let _ = batch::grid::lambert_azimuthal_inverse(&map, points, places);
            },
        );
    }
}

#[test]
fn maps_are_those_of_one_by_one() {
    maps::<f64>(Ellipsoid::WGS84);
    maps::<f32>(Ellipsoid::WGS84);
    maps::<f64>(Ellipsoid::new(6.4e6, -0.01).unwrap());
}

#[test]
fn what_is_refused_is_nan_and_counted() {
    let map = TransverseMercator::<f64>::new(Ellipsoid::WGS84, 1.0, 0.0).unwrap();
    let nan = f64::NAN;
    let (mut x, mut y) = ([0.0; 6], [0.0; 6]);
    let result = batch::grid::transverse_mercator(
        &map,
        [&[1.0, 91.0, 2.0, 3.0, nan, 4.0], &[0.0, 0.0, 0.0, nan, 0.0, 362.0]],
        [&mut x, &mut y],
    );
    assert!(
        matches!(result, Err(InvalidBatch::Elements { count: 3, first: 1, .. })),
        "{result:?}"
    );
    assert_eq!(x.map(f64::is_nan), [false, true, false, true, true, false]);
    assert_eq!([x[5], y[5]], map.forward(place([4.0, 2.0])));
    let result = batch::grid::transverse_mercator_inverse(
        &map,
        [&[1.0, 2e7, 2.0, 3.0, nan, 4.0], &[0.0, 0.0, 0.0, 1e9, 0.0, 1.0]],
        [&mut x, &mut y],
    );
    assert!(
        matches!(result, Err(InvalidBatch::Elements { count: 3, first: 1, .. })),
        "{result:?}"
    );
    assert_eq!(y.map(f64::is_nan), [false, true, false, true, true, false]);
    let laea = LambertAzimuthal::<f64>::new(Ellipsoid::WGS84, place([0.0, 0.0])).unwrap();
    let result = batch::grid::lambert_azimuthal(
        &laea,
        [&[1.0, 0.0, 2.0, 3.0, nan, 4.0], &[0.0, 180.0, 0.0, 0.0, 0.0, 1.0]],
        [&mut x, &mut y],
    );
    assert!(
        matches!(result, Err(InvalidBatch::Elements { count: 2, first: 1, .. })),
        "{result:?}"
    );
    assert_eq!(y.map(f64::is_nan), [false, true, false, false, true, false]);
    let result = batch::grid::utm(&map, Hemisphere::North, [&[1.0], &[]], [&mut x, &mut y]);
    assert!(matches!(result, Err(InvalidBatch::Lengths { .. })));
}
