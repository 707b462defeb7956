//! Every method at awkward places: finite, in range, and refused only for a reason.

use terrella::geodesic::{Geodesic, GeodesicError, Karney, Method, Surface, Vincenty};
use terrella::{Ellipsoid, LatLon};

use crate::methods::{Methods, methods};
use crate::sample::{awkward, place};
use testkit::truth::Scalar;

/// Numbers at which something may go wrong.
fn hard<T: Scalar>(rng: &mut fastrand::Rng, most: f64) -> T {
    let least = T::of(if T::NAME == "f32" { 1.4e-45 } else { 5e-324 });
    let number = match rng.u8(0..6) {
        0 => least,
        1 => T::ZERO,
        2 => least * T::of(1e5),
        3 => T::of(1e-12),
        4 => T::of(most) * (T::ONE - T::EPSILON * T::of(f64::from(rng.u8(0..3)))),
        _ => T::of(most * 0.5),
    };
    if rng.bool() { -number } else { number }
}

fn pair<T: Scalar>(rng: &mut fastrand::Rng) -> (LatLon<T>, LatLon<T>) {
    if rng.bool() {
        let [lat1, lon1, lat2, lon2] = awkward(rng).map(T::of);
        return (place(lat1, lon1), place(lat2, lon2));
    }
    (
        place(hard(rng, 90.0), hard(rng, 180.0)),
        place(hard(rng, 90.0), hard(rng, 180.0)),
    )
}

fn azimuth_in_range<T: Scalar>(azimuth: T) -> bool {
    azimuth.into().abs() <= 180.0
}

fn total<T: Scalar>() {
    for f in [0.0, 1.0 / 298.0, 1.0 / 60.0, -1.0 / 150.0] {
        let mut rng = fastrand::Rng::with_seed(2);
        let methods = methods::<T>(f);
        for _ in 0..100_000 {
            let (from, to) = pair::<T>(&mut rng);
            let azimuth = if rng.bool() {
                hard(&mut rng, 360.0)
            } else {
                T::of(1e30) * hard::<T>(&mut rng, 1.0)
            };
            let distance = if rng.bool() {
                hard(&mut rng, 2e7)
            } else {
                T::of(1e37) * hard::<T>(&mut rng, 1.0)
            };
            for (name, method) in &methods {
                match method.inverse(from, to) {
                    Ok(line) => {
                        // A plane has no other side.
                        let distance_in_range =
                            (0.0..=2.1e7).contains(&line.distance.into()) || name.profile().surface == Surface::Local;
                        assert!(
                            distance_in_range && azimuth_in_range(line.azimuth1) && azimuth_in_range(line.azimuth2),
                            "{name}, {f}: {from:?} {to:?}: {line:?}"
                        );
                    }
                    Err(why) => assert!(
                        *name == Method::Vincenty && why == GeodesicError::NotConverged(from, to),
                        "{name}: {why}"
                    ),
                }
                let end = method
                    .direct(from, azimuth, distance)
                    .unwrap_or_else(|why| panic!("{name}: {why}"));
                let position = end.position;
                assert!(
                    position.lat().into().abs() <= 90.0
                        && position.lon().into().abs() <= 180.0
                        && azimuth_in_range(end.azimuth),
                    "{name}, {f}: {from:?} {azimuth:?} {distance:?}: {end:?}"
                );
            }
        }
    }
}

#[test]
fn nothing_is_out_of_range() {
    total::<f64>();
    total::<f32>();
}

/// Coincident places, with any signs of zero and either name of the antimeridian: distance 0, azimuths +0.
fn coincident<T: Scalar>() {
    let zero = T::ZERO;
    let half = T::of(180.0);
    for (name, method) in methods::<T>(1.0 / 298.0) {
        let zeros = [zero, -zero];
        let same = zeros.into_iter().flat_map(|a| zeros.map(|b| [[zero, a], [zero, b]]));
        let same = same.chain(zeros.into_iter().flat_map(|a| zeros.map(|b| [[a, zero], [b, zero]])));
        let turned = [half, -half]
            .into_iter()
            .flat_map(|a| [half, -half].map(|b| [[T::of(45.0), a], [T::of(45.0), b]]));
        let poles = [90.0, -90.0, 30.0].map(|lat| [[T::of(lat), T::of(7.0)]; 2]);
        for [[lat1, lon1], [lat2, lon2]] in same.chain(turned).chain(poles) {
            let line = method.inverse(place(lat1, lon1), place(lat2, lon2)).unwrap();
            let all: [f64; 3] = [line.distance, line.azimuth1, line.azimuth2].map(Into::into);
            assert!(
                all.iter().all(|x| x.to_bits() == 0),
                "{name}: {lat1:?} {lon1:?} {lat2:?} {lon2:?}: {line:?}"
            );
        }
    }
}

#[test]
fn coincident_places_are_zero_apart() {
    coincident::<f64>();
    coincident::<f32>();
}

/// Along a meridian, by any signs of its longitude: north is +0, south +180.
fn meridian<T: Scalar>() {
    for (name, method) in methods::<T>(1.0 / 298.0) {
        for lons in [T::ZERO, T::of(180.0)].map(|lon| [lon, -lon]) {
            for (lon1, lon2) in lons.into_iter().flat_map(|lon1| lons.map(|lon2| (lon1, lon2))) {
                for (lat1, lat2, azimuth) in [
                    (-1.0, 1.5, 0.0),
                    (0.0, 1.0, 0.0),
                    (-1.0, -0.0, 0.0),
                    (1.0, 0.5, 180.0),
                    (-0.0, -1.0, 180.0),
                ] {
                    let line = method
                        .inverse(place(T::of(lat1), lon1), place(T::of(lat2), lon2))
                        .unwrap();
                    for found in [line.azimuth1, line.azimuth2] {
                        let found: f64 = found.into();
                        assert!(
                            found.to_bits() == f64::to_bits(azimuth),
                            "{name}: {lat1} {lon1:?} {lat2} {lon2:?}: {found}"
                        );
                    }
                }
            }
        }
    }
}

#[test]
fn meridians_lead_north_and_south() {
    meridian::<f64>();
    meridian::<f32>();
}

/// Across the 180th meridian as across that of 0, though 360° takes digits from the difference.
fn antimeridian<T: Scalar>(digits: f64) {
    let half = T::of(180.0);
    for (name, method) in methods::<T>(1.0 / 298.0) {
        for step in (0..20).map(|n| half * T::of(0.812_3 * 2.0_f64.powi(-n))) {
            let (lon1, lon2) = (half - step, step * T::of(0.7) - half);
            let across = method.inverse(place(T::ZERO, lon1), place(T::ZERO, lon2)).unwrap();
            let turned = method
                .inverse(place(T::ZERO, lon1 - half), place(T::ZERO, lon2 + half))
                .unwrap();
            let ratio = across.distance.into() / turned.distance.into();
            assert!((ratio - 1.0).abs() <= digits, "{name}: {lon1:?} {lon2:?}: {ratio}");
        }
    }
}

#[test]
fn nothing_is_lost_across_the_180th_meridian() {
    antimeridian::<f64>(1e-15);
    antimeridian::<f32>(5e-7);
}

/// Opposite places: the line that is told leads there, and its end back, on a sphere and for Karney on the Earth.
fn opposite<T: Scalar>(most: f64) {
    let karney = Karney::new(Ellipsoid::new(T::of(6.4e6), T::of(1.0 / 298.0)).unwrap()).unwrap();
    let earth: Methods<T> = vec![(Method::Karney, Box::new(karney))];
    let sphere = methods::<T>(0.0)
        .into_iter()
        .filter(|(method, _)| method.profile().surface != Surface::Local && *method != Method::Haversine);
    for (name, method) in earth.into_iter().chain(sphere) {
        for lat in [0.0, 1e-3, 10.0, -30.0, 89.0, 90.0, -90.0] {
            let (from, to) = (place(T::of(lat), T::of(20.0)), place(T::of(-lat), T::of(-160.0)));
            let line = method.inverse(from, to).unwrap();
            let there = method.direct(from, line.azimuth1, line.distance).unwrap().position;
            let back = method.direct(to, line.azimuth2, -line.distance).unwrap().position;
            for (end, wanted) in [(there, to), (back, from)] {
                let miss: f64 = method.inverse(end, wanted).unwrap().distance.into();
                assert!(miss < most, "{name} {lat}: {line:?} misses by {miss}");
            }
        }
    }
}

#[test]
fn lines_between_opposite_places_lead_there() {
    opposite::<f64>(1e-7);
    opposite::<f32>(3.0);
}

/// A nanometre, and its direction: nothing is lost to cancellation. Near 0° N 0° E, where coordinates resolve it.
fn nanometre<T: Scalar>(digits: f64) {
    let degree = 1e-9 / 6.4e6 * 57.295_779_513_082_32;
    for (name, method) in methods::<T>(0.0) {
        let line = method
            .inverse(place(T::ZERO, T::ZERO), place(T::of(degree), T::of(degree)))
            .unwrap();
        let distance: f64 = line.distance.into();
        let azimuth: f64 = line.azimuth1.into();
        assert!(
            (distance / (1e-9 * 2f64.sqrt()) - 1.0).abs() <= digits,
            "{name}: {line:?}"
        );
        assert!((azimuth / 45.0 - 1.0).abs() <= digits, "{name}: {line:?}");
    }
}

#[test]
fn a_nanometre_is_resolved() {
    nanometre::<f64>(1e-15);
    nanometre::<f32>(5e-7);
}

#[test]
fn what_is_not_finite_is_refused() {
    for (name, method) in methods::<f64>(1.0 / 298.0) {
        let here = place(1.0, 2.0);
        for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            let azimuth = method.direct(here, bad, 1.0).unwrap_err();
            assert!(
                matches!(azimuth, GeodesicError::Azimuth(x) if x.to_bits() == bad.to_bits()),
                "{name}"
            );
            let distance = method.direct(here, 1.0, bad).unwrap_err();
            assert!(
                matches!(distance, GeodesicError::Distance(x) if x.to_bits() == bad.to_bits()),
                "{name}"
            );
        }
    }
}

/// A distance in radii is a number, and so is twice of it: then it is taken, however far.
#[test]
fn the_longest_distance_is_half_of_the_largest_number() {
    for (name, method) in methods::<f64>(1.0 / 298.0) {
        let here = place(1.0, 2.0);
        for distance in [1e200, 8e307] {
            assert!(method.direct(here, 30.0, distance).is_ok(), "{name} {distance:e}");
        }
    }
    let tiny = Vincenty::new(Ellipsoid::new(1e-3, 1.0 / 298.0).unwrap()).unwrap();
    assert!(tiny.direct(place(1.0, 2.0), 30.0, 8e304).is_ok());
    for distance in [1e305, 1e307] {
        assert_eq!(
            tiny.direct(place(1.0, 2.0), 30.0, distance),
            Err(GeodesicError::TooFar {
                distance,
                limit: f64::MAX * (0.5 * 1e-3 * (1.0 - 1.0 / 298.0))
            })
        );
    }
}

/// Latitudes an ulp apart whose parametric sines round to the other order: the cosine of an azimuth was the root of a negative number.
#[test]
fn all_but_equal_latitudes_have_a_line() {
    let karney = Karney::new(Ellipsoid::<f64>::new(6.4e6, -1.0 / 9.0).unwrap()).unwrap();
    for lon in [1e-200, 9.704_187_067_161_276e-101, 1e-30] {
        let (from, to) = (
            place(22.500_000_000_003_453, lon),
            place(-22.500_000_000_003_457, -180.0),
        );
        let distance = karney.inverse(from, to).unwrap().distance;
        assert!((distance - 20_303_021.049_734).abs() < 1e-6, "{lon:e}: {distance}");
    }
}

/// On the smallest bodies a distance in radii is infinite, and was NaN; the sphere of the largest ones was refused, as a flattening.
#[test]
fn bodies_of_any_size_have_methods() {
    for (a, f) in [(1e-15, 1.0 / 300.0), (1e15, -1e-3), (1e15, 1e-3)] {
        let ellipsoid = Ellipsoid::new(a, f).unwrap();
        for method in Method::ALL {
            let Ok(on) = method.about(ellipsoid, place(1.0, 2.0)) else {
                assert!(*method == Method::Vincenty && f < 0.0, "{method} {f}");
                continue;
            };
            for distance in [1.0, 1e300, f64::MAX] {
                match on.direct(place(1.0, 2.0), 3.0, distance) {
                    Ok(end) => assert!(
                        end.azimuth.abs() <= 180.0 && end.position.lat().abs() <= 90.0,
                        "{end:?}"
                    ),
                    Err(GeodesicError::TooFar { distance: far, limit }) => assert!(far == distance && far >= limit),
                    Err(why) => panic!("{why}"),
                }
            }
        }
    }
}
