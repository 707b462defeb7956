//! Geodesics: inverse and direct problems, distances alone, methods of a user.

use terrella::batch::{self, InvalidBatch, geodesic::InvalidProblem};
use terrella::geodesic::{Direct, Geodesic, GeodesicError, GreatCircle, Inverse, Karney, Method, Vincenty, Visitor};
use terrella::{Ellipsoid, InvalidLatLon, LatLon};

use super::{ALL, ENDS, Scalar, bits, compare, numbers, pairs, scaled};

fn every_geodesic<T: Scalar, M: Geodesic<T>>(method: &M) {
    let nothing = [T::of(f64::NAN); 3];
    compare(
        "inverse",
        &pairs::<T>(),
        &|[lat1, lon1, lat2, lon2]| match method
            .inverse(LatLon::new(lat1, lon1).unwrap(), LatLon::new(lat2, lon2).unwrap())
        {
            Ok(line) => [line.distance, line.azimuth1, line.azimuth2],
            Err(_) => nothing,
        },
        &|[lat1, lon1, lat2, lon2], lines| {
            let places = |i: usize| {
                let here = LatLon::new(lat1[i], lon1[i]).unwrap();
                (here, LatLon::new(lat2[i], lon2[i]).unwrap())
            };
            let refused = (0..lat1.len()).filter_map(|index| {
                let (from, to) = places(index);
                let why = method.inverse(from, to).err()?;
                Some((index, InvalidProblem::Geodesic(why)))
            });
            let refused: Vec<_> = refused.collect();
            let result = batch::geodesic::inverse(method, [lat1, lon1], [lat2, lon2], lines);
            let count = refused.len();
            let first = refused.into_iter().next();
            let expected = first.map_or(Ok(()), |(first, why)| Err(InvalidBatch::Elements { count, first, why }));
            assert_eq!(result, expected);
        },
    );
    let [lat, lon, azimuth, distance] = pairs::<T>();
    // The slow door too: azimuths beyond 360° and lines of many circuits.
    for (turns, length) in [(1.0, 2e5), (3.0, 1.5e6)] {
        compare(
            "direct",
            &[
                lat.clone(),
                lon.clone(),
                scaled(&azimuth, turns * 2.0),
                scaled(&distance, length),
            ],
            &|[lat, lon, azimuth, distance]| {
                let end = method
                    .direct(LatLon::new(lat, lon).unwrap(), azimuth, distance)
                    .unwrap();
                [end.position.lat(), end.position.lon(), end.azimuth]
            },
            &|[lat, lon, azimuth, distance], ends| {
                batch::geodesic::direct(method, [lat, lon], azimuth, distance, ends).unwrap();
            },
        );
    }
}

/// Distances alone, of one place, and of the legs of a path; a bad place among them.
fn every_distance<T: Scalar, M: Geodesic<T>>(method: &M) {
    let [lat1, lon1, lat2, lon2] = pairs::<T>();
    let one = LatLon::new(lat1[3], lon1[3]).unwrap();
    let distance = |from: [T; 2], to: [T; 2]| {
        let places = LatLon::new(from[0], from[1]).ok().zip(LatLon::new(to[0], to[1]).ok());
        let line = places.and_then(|(from, to)| {
            let line = method.inverse(from, to);
            assert_eq!(method.distance(from, to), line.map(|line| line.distance));
            line.ok()
        });
        line.map_or([T::of(f64::NAN); 3], |line| {
            [line.distance, line.azimuth1, line.azimuth2]
        })
    };
    for length in [0, 1, 2, 5, 64, 131] {
        let (mut lat1, lon1) = (lat1[..length].to_vec(), &lon1[..length]);
        let (lat2, lon2) = (&lat2[..length], &lon2[..length]);
        if let Some(bad) = lat1.get_mut(length / 2 + 1) {
            *bad = T::of(f64::NAN);
        }
        let many = [&lat1[..], lon1];
        let nothing = vec![T::of(7.0); length];
        let (here, there) = (|i: usize| [lat1[i], lon1[i]], |i: usize| [lat2[i], lon2[i]]);
        let alone = [one.lat(), one.lon()];
        let check = |what: &str, found: &[T], expected: &dyn Fn(usize) -> T| {
            let expected: Vec<T> = (0..found.len()).map(expected).collect();
            assert_eq!(bits(found), bits(&expected), "{what}, {length}");
        };
        let mut found = nothing.clone();
        let _ = batch::geodesic::distance(method, many, [lat2, lon2], &mut found);
        check("distance", &found, &|i| distance(here(i), there(i))[0]);
        let mut found = nothing.clone();
        let _ = batch::geodesic::distance_from(method, one, many, &mut found);
        check("distance_from", &found, &|i| distance(alone, here(i))[0]);
        let mut found = nothing.clone();
        let _ = batch::geodesic::distance_to(method, many, one, &mut found);
        check("distance_to", &found, &|i| distance(here(i), alone)[0]);
        let mut lines = [nothing.clone(), nothing.clone(), nothing.clone()];
        let _ = batch::geodesic::inverse_from(method, one, many, lines.each_mut().map(|c| &mut c[..]));
        for (column, found) in lines.iter().enumerate() {
            check("inverse_from", found, &|i| distance(alone, here(i))[column]);
        }
        let _ = batch::geodesic::inverse_to(method, many, one, lines.each_mut().map(|c| &mut c[..]));
        for (column, found) in lines.iter().enumerate() {
            check("inverse_to", found, &|i| distance(here(i), alone)[column]);
        }
        let mut found = nothing[length.min(1)..].to_vec();
        let _ = batch::geodesic::legs(method, many, &mut found);
        check("legs", &found, &|i| distance(here(i), here(i + 1))[0]);
    }
    let (column, mut found) = ([T::ZERO; 3], [T::ONE; 3]);
    let unequal = batch::geodesic::legs(method, [&column, &column], &mut found);
    assert_eq!(unequal, Err(InvalidBatch::Lengths { first: 2, other: 3 }));
    let unequal = batch::geodesic::distance_from(method, one, [&column[1..], &column], &mut found);
    assert_eq!(unequal, Err(InvalidBatch::Lengths { first: 2, other: 3 }));
    assert_eq!(bits(&found), bits(&[T::ONE; 3]));
}

/// Places on one meridian, at a pole, on the equator, and the same place twice, also across 180°.
#[test]
fn special_lines_are_the_same_bits() {
    fn by<T: Scalar>() {
        let (lat, other) = (
            scaled(&numbers::<T>(51, ENDS), 90.0),
            scaled(&numbers::<T>(53, ENDS), 90.0),
        );
        let ends = &[1.0, -1.0, 0.0, -0.0];
        let (lon, far) = (
            scaled(&numbers::<T>(52, ends), 180.0),
            scaled(&numbers::<T>(54, ends), 180.0),
        );
        let turned: Vec<T> = lon.iter().map(|&lon| lon + T::of(360.0)).collect();
        let (pole, equator) = (vec![T::of(90.0); ALL], vec![T::ZERO; ALL]);
        let earth = Karney::new(Ellipsoid::<T>::WGS84).unwrap();
        for columns in [
            [&lat, &lon, &lat, &lon],
            [&lat, &lon, &lat, &turned],
            [&lat, &lon, &other, &lon],
            [&lat, &lon, &pole, &far],
            [&pole, &lon, &pole, &lon],
            [&equator, &lon, &equator, &far],
        ] {
            compare(
                "special",
                &columns.map(Vec::clone),
                &|[lat1, lon1, lat2, lon2]| {
                    let (from, to) = (LatLon::new(lat1, lon1).unwrap(), LatLon::new(lat2, lon2).unwrap());
                    let line = earth.inverse(from, to).unwrap();
                    [line.distance, line.azimuth1, line.azimuth2]
                },
                &|[lat1, lon1, lat2, lon2], lines| {
                    batch::geodesic::inverse(&earth, [lat1, lon1], [lat2, lon2], lines).unwrap();
                },
            );
        }
    }
    by::<f64>();
    by::<f32>();
}

#[test]
fn geodesics_are_the_same_bits() {
    fn both<T: Scalar>(f: f64) {
        let ellipsoid = Ellipsoid::new(T::of(6.4e6), T::of(f)).unwrap();
        every_geodesic(&Karney::new(ellipsoid).unwrap());
        if let Ok(vincenty) = Vincenty::new(ellipsoid) {
            every_geodesic(&vincenty);
        }
    }
    for f in [1.0 / 298.257, 0.0, 1.0 / 293.0, 1.0 / 170.0, -1.0 / 150.0, 0.015, 0.1] {
        both::<f64>(f);
        both::<f32>(f);
    }
}

/// [`every_geodesic`], by a method's own type.
struct Every;

impl<T: Scalar> Visitor<T> for Every {
    type Output = ();

    fn visit<M: Geodesic<T>>(self, method: M) {
        every_geodesic(&method);
        every_distance(&method);
    }
}

#[test]
fn all_methods_are_the_same_bits() {
    fn both<T: Scalar>() {
        let earth = Ellipsoid::new(T::of(6.4e6), T::of(1.0 / 298.257)).unwrap();
        for method in Method::ALL {
            let place = LatLon::new(T::of(47.0), T::of(8.0)).unwrap();
            let method = method.about(earth, place).unwrap();
            method.visit(Every);
            every_distance(&method);
        }
    }
    both::<f64>();
    both::<f32>();
}

/// A user's method: a sphere whose places in the west it refuses, and whose lines have a longest one.
struct East(GreatCircle<f64>);

impl Geodesic<f64> for East {
    fn inverse(&self, from: LatLon<f64>, to: LatLon<f64>) -> Result<Inverse<f64>, GeodesicError<f64>> {
        if from.lon() < 0.0 || to.lon() < 0.0 {
            return Err(GeodesicError::NotConverged(from, to));
        }
        self.0.inverse(from, to)
    }

    fn direct(&self, from: LatLon<f64>, azimuth: f64, distance: f64) -> Result<Direct<f64>, GeodesicError<f64>> {
        let limit = 2e9;
        if distance.abs() > limit {
            return Err(GeodesicError::TooFar { distance, limit });
        }
        self.0.direct(from, azimuth, distance)
    }
}

/// The same with a fast answer for some places alone.
struct Fast(East);

impl Geodesic<f64> for Fast {
    fn inverse(&self, from: LatLon<f64>, to: LatLon<f64>) -> Result<Inverse<f64>, GeodesicError<f64>> {
        self.0.inverse(from, to)
    }

    fn direct(&self, from: LatLon<f64>, azimuth: f64, distance: f64) -> Result<Direct<f64>, GeodesicError<f64>> {
        self.0.direct(from, azimuth, distance)
    }

    fn fast_inverse(&self, from: LatLon<f64>, to: LatLon<f64>) -> (Inverse<f64>, bool) {
        let nothing = Inverse {
            distance: f64::NAN,
            azimuth1: f64::NAN,
            azimuth2: f64::NAN,
        };
        let (line, found) = self.0.fast_inverse(from, to);
        let found = found & (from.lat() > 0.0);
        (if found { line } else { nothing }, found)
    }
}

#[test]
fn a_users_method_goes_through() {
    fn by(method: &impl Geodesic<f64>) {
        every_geodesic(method);
        every_distance(method);
        let too_far = GeodesicError::TooFar {
            distance: -3e9,
            limit: 2e9,
        };
        let mut ends = [[7.0; 3]; 3];
        let [a, b, c] = &mut ends;
        let refused = batch::geodesic::direct(method, [&[0.0; 3], &[0.0; 3]], &[1.0; 3], &[1e7, -3e9, 4e9], [a, b, c]);
        let (count, first, why) = (2, 1, InvalidProblem::Geodesic(too_far));
        assert_eq!(refused, Err(InvalidBatch::Elements { count, first, why }));
        assert_eq!(ends.map(|column| column.map(f64::is_nan)), [[false, true, true]; 3]);
    }
    let sphere = GreatCircle::new(6.4e6).unwrap();
    by(&East(sphere));
    by(&Fast(East(sphere)));
}

#[test]
fn geodesics_that_are_refused() {
    let earth = Karney::new(Ellipsoid::WGS84).unwrap();
    let refused = |lat, azimuth, distance| {
        let mut ends = [[7.0_f64]; 3];
        let [a, b, c] = &mut ends;
        let why = batch::geodesic::direct(&earth, [&[lat], &[0.0]], &[azimuth], &[distance], [a, b, c]).unwrap_err();
        assert!(ends.as_flattened().iter().all(|end| end.is_nan()));
        why
    };
    let element = |why| InvalidBatch::Elements {
        count: 1,
        first: 0,
        why,
    };
    assert_eq!(
        refused(91.0, 0.0, 0.0),
        element(InvalidProblem::LatLon(InvalidLatLon::Latitude(91.0)))
    );
    assert_eq!(
        refused(0.0, f64::INFINITY, 0.0),
        element(InvalidProblem::Geodesic(GeodesicError::Azimuth(f64::INFINITY)))
    );
    assert_eq!(
        refused(0.0, 0.0, 1e15),
        element(InvalidProblem::Geodesic(
            earth.direct(LatLon::new(0.0, 0.0).unwrap(), 0.0, 1e15).unwrap_err()
        ))
    );
    let mut lines = [[0.0; 2], [0.0; 2], [0.0; 2]];
    let [a, b, c] = &mut lines;
    let why = batch::geodesic::inverse(&earth, [&[0.0, 0.0], &[0.0, 0.0]], [&[0.0], &[0.0]], [a, b, c]).unwrap_err();
    assert_eq!(why, InvalidBatch::Lengths { first: 2, other: 1 });
}
