//! Points of lines, and tracks beside great circles.

use core::fmt::Debug;

use terrella::batch::{self, InvalidBatch, geodesic::InvalidProblem};
use terrella::geodesic::{Geodesic, GeodesicError, GreatCircle, Karney, Method, Vincenty};
use terrella::{Ellipsoid, LatLon};

use super::{ALL, ENDS, OverSlices, Scalar, bits, numbers, pairs, parts, scaled};

/// What one by one gives, or why it does not; the batch has the same, NaN and the count.
fn compare<T: Scalar, E: Debug, const I: usize, const O: usize>(
    what: &str,
    columns: &[Vec<T>; I],
    one: &dyn Fn([T; I]) -> Result<[T; O], E>,
    batch: &OverSlices<'_, T, I, O, Result<(), InvalidBatch<E>>>,
) {
    for part in parts() {
        let mut results = [(); O].map(|()| vec![T::of(7.0); part.len()]);
        let outcome = batch(
            columns.each_ref().map(|column| &column[part.clone()]),
            results.each_mut().map(|column| &mut column[..]),
        );
        let (mut count, mut refused) = (0, None);
        for (index, i) in part.clone().enumerate() {
            let expected = one(columns.each_ref().map(|column| column[i])).unwrap_or_else(|why| {
                count += 1;
                refused.get_or_insert((index, why));
                [T::of(f64::NAN); O]
            });
            let found = results.each_ref().map(|column| column[index]);
            assert_eq!(bits(&found), bits(&expected), "{what}, {index} of {part:?}");
        }
        let expected = match refused {
            Some((first, why)) => Err(InvalidBatch::Elements { count, first, why }),
            None => Ok(()),
        };
        assert_eq!(format!("{outcome:?}"), format!("{expected:?}"), "{what}, {part:?}");
    }
}

fn place<T: Scalar>(lat: f64, lon: f64) -> LatLon<T> {
    LatLon::new(T::of(lat), T::of(lon)).unwrap()
}

/// Anywhere, at poles, on the equator, along meridians, at −0 and at 180.
const STARTS: [[f64; 3]; 8] = [
    [40.6, -73.8, 53.5],
    [90.0, 20.0, 70.0],
    [-90.0, -0.0, 0.0],
    [0.0, -0.0, 90.0],
    [0.0, 180.0, -90.0],
    [-45.0, -0.0, 180.0],
    [-0.0, 0.0, 0.0],
    [1e-10, 5.0, 89.999_999_999],
];

/// Distances of no circuit, of few and of many; and two that are refused, if there may be such.
fn distances<T: Scalar>(size: f64, refused: bool) -> Vec<T> {
    let mut distances = scaled(&numbers::<T>(61, ENDS), size);
    if refused {
        distances[40] = T::of(f64::NAN);
        distances[70] = T::of(f64::NEG_INFINITY);
        distances[200] = T::of(1e18);
    }
    distances
}

#[test]
fn points_of_lines_are_the_same_bits() {
    fn both<T: Scalar>(f: f64) {
        let earth = Karney::new(Ellipsoid::new(T::of(6.4e6), T::of(f)).unwrap()).unwrap();
        for [lat, lon, azimuth] in STARTS {
            let line = earth.line(place(lat, lon), T::of(azimuth)).unwrap();
            for (size, refused) in [(4e7, false), (6e8, true), (1e11, true)] {
                compare(
                    &format!("along, f = {f}, {lat} {lon} {azimuth}"),
                    &[distances::<T>(size, refused)],
                    &|[distance]| {
                        let point = line.at(distance)?;
                        Ok([point.position.lat(), point.position.lon(), point.azimuth])
                    },
                    &|[distance], points| batch::geodesic::along(&line, distance, points),
                );
            }
        }
    }
    for f in [1.0 / 298.257, 0.0, 1.0 / 170.0, -1.0 / 150.0, 0.012, -0.013, 0.1] {
        both::<f64>(f);
        both::<f32>(f);
    }
}

#[test]
fn ends_of_one_start_are_the_same_bits() {
    fn both<T: Scalar>() {
        let earth = Ellipsoid::new(T::of(6.4e6), T::of(1.0 / 298.257)).unwrap();
        for (kind, [lat, lon, azimuth]) in STARTS.into_iter().enumerate() {
            for &method in Method::ALL {
                let from = place::<T>(lat, lon);
                let azimuth = T::of(if kind == 0 { azimuth + 720.0 } else { azimuth });
                let solver = method.about(earth, place(47.0, 8.0)).unwrap();
                compare(
                    &format!("direct_from, {method}, {lat} {lon}"),
                    &[distances::<T>(1e9, true)],
                    &|[distance]| {
                        let end = solver.direct(from, azimuth, distance);
                        let end = end.map_err(InvalidProblem::Geodesic)?;
                        Ok([end.position.lat(), end.position.lon(), end.azimuth])
                    },
                    &|[distance], ends| batch::geodesic::direct_from(&solver, from, azimuth, distance, ends),
                );
            }
        }
        // An azimuth that is refused refuses all.
        let sphere = GreatCircle::new(T::ONE).unwrap();
        let (mut a, mut b, mut c) = ([T::ONE; 9], [T::ONE; 9], [T::ONE; 9]);
        let nan = T::of(f64::INFINITY);
        let refused =
            batch::geodesic::direct_from(&sphere, place(0.0, 0.0), nan, &[T::ONE; 9], [&mut a, &mut b, &mut c]);
        let why = InvalidProblem::Geodesic(GeodesicError::Azimuth(nan));
        let (count, first) = (9, 0);
        assert_eq!(refused, Err(InvalidBatch::Elements { count, first, why }));
        assert!([a, b, c].as_flattened().iter().all(|value| !value.is_finite()));
    }
    both::<f64>();
    both::<f32>();
}

#[test]
fn places_between_are_the_same_bits() {
    fn both<T: Scalar>() {
        let earth = Ellipsoid::new(T::of(6.4e6), T::of(1.0 / 298.257)).unwrap();
        let mut fractions = scaled(&numbers::<T>(62, ENDS), 1.5);
        fractions[33] = T::of(f64::NAN);
        fractions[99] = T::of(3e38);
        fractions[300] = T::of(1e30);
        for [lat, lon, other] in STARTS {
            let (from, to) = (
                place::<T>(lat, lon),
                place::<T>(-0.9 * lat + 3.0 * other.signum(), other),
            );
            let sphere = GreatCircle::new(T::of(6.371e6)).unwrap();
            compare(
                "intermediate of a great circle",
                &[fractions.clone()],
                &|[fraction]| {
                    let place = sphere.intermediate(from, to, fraction)?;
                    Ok([place.lat(), place.lon()])
                },
                &|[fraction], places| batch::geodesic::intermediate(&sphere, from, to, fraction, places),
            );
            for &method in Method::ALL {
                let solver = method.about(earth, place(47.0, 8.0)).unwrap();
                let Ok(line) = solver.inverse(from, to) else { continue };
                compare(
                    &format!("intermediate, {method}"),
                    &[fractions.clone()],
                    &|[fraction]| {
                        let end = solver.direct(from, line.azimuth1, line.distance * fraction);
                        let end = end.map_err(|why| match why {
                            GeodesicError::Distance(_) => GeodesicError::Fraction(fraction),
                            why => why,
                        })?;
                        Ok([end.position.lat(), end.position.lon()])
                    },
                    &|[fraction], places| batch::geodesic::intermediate(&solver, from, to, fraction, places),
                );
            }
        }
        // Without a line there is no place on it.
        let vincenty = Vincenty::new(Ellipsoid::<T>::WGS84).unwrap();
        let (from, to) = (place(0.0, 0.0), place(0.3, 179.9));
        let why = vincenty.inverse(from, to).unwrap_err();
        let (mut lat, mut lon) = ([T::ONE; 5], [T::ONE; 5]);
        let refused =
            batch::geodesic::intermediate(&vincenty, from, to, &[T::ZERO; 5], [&mut lat, &mut lon]).unwrap_err();
        let (count, first) = (5, 0);
        assert_eq!(refused, InvalidBatch::Elements { count, first, why });
        assert!(lat.iter().chain(&lon).all(|value| !value.is_finite()));
        let unequal = batch::geodesic::intermediate(&vincenty, from, to, &[T::ZERO; 4], [&mut lat, &mut lon]);
        assert_eq!(unequal, Err(InvalidBatch::Lengths { first: 4, other: 5 }));
    }
    both::<f64>();
    both::<f32>();
}

#[test]
fn tracks_are_the_same_bits() {
    fn both<T: Scalar>() {
        let sphere = GreatCircle::new(T::of(6.371e6)).unwrap();
        let [mut lat, mut lon, lat2, lon2] = pairs::<T>();
        lat[20] = T::of(90.5);
        lat[130] = T::of(f64::NAN);
        lon[131] = T::of(f64::INFINITY);
        lon[50] = T::of(725.0);
        for i in [0, 3, 77] {
            let (start, end) = (
                LatLon::new(lat[i], lon[i]).unwrap(),
                LatLon::new(lat2[i], lon2[i]).unwrap(),
            );
            compare(
                "tracks",
                &[lat.clone(), lon.clone()],
                &|[lat, lon]| {
                    let place = LatLon::new(lat, lon)?;
                    Ok([
                        sphere.along_track(place, start, end),
                        sphere.cross_track(place, start, end),
                    ])
                },
                &|places, tracks| batch::geodesic::tracks(&sphere, places, start, end, tracks),
            );
            // Legs as pairs, of which a path is made.
            let rows = |column: &[T]| (1..ALL).map(|i| column[i]).chain([T::ZERO]).collect::<Vec<_>>();
            compare(
                "tracks beside legs",
                &[lat.clone(), lon.clone(), rows(&lat), rows(&lon)],
                &|[lat1, lon1, lat2, lon2]| {
                    let (one, other) = (LatLon::new(lat1, lon1)?, LatLon::new(lat2, lon2)?);
                    Ok([
                        sphere.along_track(start, one, other),
                        sphere.cross_track(start, one, other),
                    ])
                },
                &|[lat1, lon1, lat2, lon2], tracks| {
                    let path = [(lat1, lat2), (lon1, lon2)].map(|(one, other)| {
                        let first = one.first().into_iter();
                        first.chain(other).copied().collect::<Vec<_>>()
                    });
                    batch::geodesic::leg_tracks(&sphere, start, path.each_ref().map(|column| &column[..]), tracks)
                },
            );
        }
        let (mut along, mut cross) = ([T::ONE; 2], [T::ONE; 2]);
        let unequal = batch::geodesic::leg_tracks(
            &sphere,
            place(0.0, 0.0),
            [&lat[..4], &lon[..4]],
            [&mut along, &mut cross],
        );
        assert_eq!(unequal, Err(InvalidBatch::Lengths { first: 3, other: 2 }));
    }
    both::<f64>();
    both::<f32>();
}
