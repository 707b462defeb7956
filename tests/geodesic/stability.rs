//! Every method at awkward places: finite, in range, and refused only for a reason.

use terrella::geodesic::{
    Andoyer, AndoyerSecond, Area, Bowring, Flat, Geodesic, GeodesicError, GreatCircle, Haversine, Karney, Vincenty,
};
use terrella::{Ellipsoid, LatLon};

use crate::sample::{awkward, place, worst};
use crate::truth::Scalar;

type Methods<T> = Vec<(&'static str, Box<dyn Geodesic<T>>)>;

fn methods<T: Scalar>(f: f64) -> Methods<T> {
    let earth = Ellipsoid::new(T::of(6.4e6), T::of(f)).unwrap();
    vec![
        ("great circle", Box::new(GreatCircle::new(earth.mean_radius()).unwrap())),
        ("haversine", Box::new(Haversine::new(earth.mean_radius()).unwrap())),
        ("flat", Box::new(Flat::new(earth).unwrap())),
        ("bowring", Box::new(Bowring::new(earth).unwrap())),
        ("andoyer", Box::new(Andoyer::new(earth).unwrap())),
        ("andoyer, second order", Box::new(AndoyerSecond::new(earth).unwrap())),
        ("vincenty", Box::new(Vincenty::new(earth).unwrap())),
    ]
}

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
                let line = method.inverse(from, to).unwrap_or_else(|why| panic!("{name}: {why}"));
                let distance_in_range = (0.0..=2.1e7).contains(&line.distance.into()) || *name == "flat";
                assert!(
                    distance_in_range && azimuth_in_range(line.azimuth1) && azimuth_in_range(line.azimuth2),
                    "{name}, {f}: {from:?} {to:?}: {line:?}"
                );
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

/// Opposite places: the line that is told leads there, and its end back, on a sphere and for Vincenty on the Earth.
fn opposite<T: Scalar>(most: f64) {
    let earth = methods::<T>(1.0 / 298.0)
        .into_iter()
        .filter(|(name, _)| *name == "vincenty");
    let sphere = methods::<T>(0.0)
        .into_iter()
        .filter(|(name, _)| !["flat", "bowring", "haversine"].contains(name));
    for (name, method) in earth.chain(sphere) {
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
            Err(GeodesicError::Distance(distance))
        );
    }
}

/// A pole is one place, by whatever longitudes it is named.
fn pole<T: Scalar>() {
    for (name, method) in methods::<T>(1.0 / 298.0) {
        for lat in [90.0, -90.0] {
            for lon in [1.0, 60.0, 91.0, 150.0, 180.0] {
                let line = method
                    .inverse(place(T::of(lat), T::ZERO), place(T::of(lat), T::of(lon)))
                    .unwrap();
                // The cosine of a latitude is never 0 there, nor is the plane's parallel.
                assert!(line.distance.into() < 1e-9, "{name} {lat} {lon}: {line:?}");
            }
        }
    }
}

#[test]
fn a_pole_is_no_way_from_itself() {
    pole::<f64>();
    pole::<f32>();
}

/// Opposite longitudes next to the equator, where what tells the azimuth is subnormal.
#[test]
fn vincenty_answers_where_numbers_are_subnormal() {
    for f in [1.0 / 298.257_223_563, 1.0 / 60.0, 1e-3, 1e-6, 1e-9] {
        let single = Vincenty::new(Ellipsoid::new(6.4e6_f32, f as f32).unwrap()).unwrap();
        for (lat, lon) in [(1.561_251_1e-16, 8.178_91e-25), (1e-20, 8.178_91e-25), (1e-30, 1e-38)] {
            assert!(
                single.inverse(place(lat, lon), place(lat, 180.0)).is_ok(),
                "{f:e} {lat:e}"
            );
            let near = single.inverse(place(0.0, 0.0), place(lat, lon)).unwrap().distance;
            let north = f64::from(lat).to_radians() * 6.4e6;
            assert!(
                (f64::from(near) - north).abs() < 1e-12 + 0.04 * north,
                "{f:e} {lat:e}: {near:e}"
            );
        }
        let double = Vincenty::new(Ellipsoid::new(6.4e6, f).unwrap()).unwrap();
        for (lat, lon) in [(1e-160, 1e-160), (1e-200, 1e-150), (1e-300, 1e-300)] {
            assert!(
                double.inverse(place(lat, lon), place(lat, 180.0)).is_ok(),
                "{f:e} {lat:e}"
            );
        }
    }
}

/// A rest of the longitudes' difference that is far larger than latitudes next to the equator: their line was 6.7 km long, or NaN.
#[test]
fn places_next_to_the_equator_on_both_sides_of_the_180th_meridian() {
    for f in [1.0 / 298.257_223_563, -0.003_977_724_557_181_414, 1e-9] {
        let karney = Karney::new(Ellipsoid::<f64>::new(6.4e6, f).unwrap()).unwrap();
        for lat1 in [3e-14, 3e-30, 1.8e-39, 3.022_224_993_467_109_4e-57, 3e-99, 3e-200, 0.0] {
            for lat2 in [0.0, 2.37e-322, 1e-99, 1e-30, lat1] {
                let (from, to) = (place(lat1, 180.0), place(-lat2, -179.999_999_999_999_97));
                let [distance, exact] =
                    [karney.inverse(from, to).unwrap(), karney.solve(from, to).inverse].map(|way| way.distance);
                assert!(
                    distance < 8e-9 && (distance - exact).abs() < 1e-11,
                    "{f:e} {lat1:e} {lat2:e}: {distance:e}, {exact:e}"
                );
            }
        }
    }
}

/// Where the shortest line turns from the equator, next to it: the arc turns on digits of the azimuth that its sine does not have, and
/// the bracket was taken for narrow enough, 0.34 µm off.
#[test]
fn next_to_the_equator_where_the_line_leaves_it() {
    let karney = Karney::new(Ellipsoid::<f64>::wgs84()).unwrap();
    let from = place(-3.802_189_603_447_914e-16, 133.986_035_638_785);
    let to = place(-2.604_281_682_330_787_3e-33, -46.617_474_095_695_265);
    for line in [karney.solve(from, to).inverse, karney.inverse(from, to).unwrap()] {
        assert!((line.distance - 19_970_325.946_458_112).abs() < 7e-9, "{line:?}");
    }
}

/// There, too: the bracket's steps did not reach azimuths that are so near to 90°, and it was 0.12 µm off, 18 µm for f = 1/20.
#[test]
fn nanometres_from_the_equator_count_as_nanometres() {
    for f in [1.0 / 298.257_223_563, 1.0 / 20.0, -1.0 / 20.0, 1e-3] {
        let karney = Karney::new(Ellipsoid::<f64>::new(6_378_137.0, f).unwrap()).unwrap();
        let leaves = 180.0 * (1.0 - f.abs());
        for lon in [-0.1, -1e-3, -7e-5, -1e-8, 1e-8, 3e-4, 0.1].map(|beyond| (leaves + beyond).min(180.0)) {
            let on = karney.solve(place(0.0, 0.0), place(0.0, lon)).inverse.distance;
            for exponent in (10..48).chain([100, 300]) {
                let lat = 7.0 * 10.0_f64.powi(-exponent);
                for (lat1, lat2) in [(lat, -lat * 1e-3), (-lat * 0.7, -lat), (lat * 1e-20, lat)] {
                    let beside = karney.solve(place(lat1, 0.0), place(lat2, lon)).inverse.distance;
                    assert!(
                        (beside - on).abs() < 1.2e-8 + 2.0 * 6.4e6 * lat.to_radians(),
                        "{f} {lon}: {lat1:e} {lat2:e}"
                    );
                }
            }
        }
    }
}

/// Where the shortest line leaves the equator, to the last digit of the longitude.
#[test]
fn the_equator_ends_where_it_does() {
    for f in [1.0 / 298.257_223_563, 1.0 / 170.0, 1.0 / 20.0, 0.1, 1e-3, 1e-6] {
        let karney = Karney::new(Ellipsoid::<f64>::new(6_378_137.0, f).unwrap()).unwrap();
        let leaves = 180.0 * (1.0 - f);
        for ulps in -20..=20 {
            let lon = leaves + f64::from(ulps) * leaves * 1.2e-16;
            let distance = karney.solve(place(0.0, 0.0), place(0.0, lon)).inverse.distance;
            let equator = 6_378_137.0 * lon.to_radians();
            assert!((distance - equator).abs() < 1.2e-8, "{f} {ulps}: {distance} {equator}");
        }
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

/// Opposite longitudes all but a rounding: in `f32` a line passed the pole on the other side, and the area under it had the other sign.
#[test]
fn lines_pass_a_pole_on_their_side() {
    let (single, double) = (
        Area::new(Ellipsoid::<f32>::wgs84()).unwrap(),
        Area::new(Ellipsoid::<f64>::wgs84()).unwrap(),
    );
    for lat in [89.981_36_f32, 89.0, 80.0, 45.0, 1.0, -1.0, -89.0] {
        for lon in [-2.425_776_7e-9_f32, -1e-20, -1e-7, -1e-5] {
            let found = single.under(place(lat, 180.0), place(lat, lon));
            let expected = double.under(place(lat.into(), 180.0), place(lat.into(), lon.into()));
            let error = (f64::from(found) - expected).abs();
            assert!(error < 1e-6 * expected.abs(), "{lat} {lon:e}: {found:e}, {expected:e}");
        }
    }
}

fn next_to_a_pole<T: Scalar>(most: f64) {
    let karney = Karney::new(Ellipsoid::<T>::wgs84()).unwrap();
    let mut rng = fastrand::Rng::with_seed(19);
    let error = worst((0..20_000).map(|_| {
        // From a place next to a pole, however near, back to it.
        let near = (90.0 - 10.0_f64.powf(rng.f64() * 17.0 - 16.0)).copysign(rng.f64() - 0.5);
        let [lon, azimuth] = [0; 2].map(|_| T::of(rng.f64() * 360.0 - 180.0));
        let pole = place(T::of(near), lon);
        let start = karney.direct(pole, azimuth, T::of(rng.f64() * 2e7)).unwrap();
        let line = karney.inverse(start.position, pole).unwrap();
        let there = karney.direct(start.position, line.azimuth1, line.distance).unwrap();
        let back = karney.direct(there.position, there.azimuth, -line.distance).unwrap();
        karney.inverse(back.position, start.position).unwrap().distance.into()
    }));
    assert!(error < most, "{}: {error:e} m", T::NAME);
}

/// The azimuth counts from the meridian of the longitude that is given, though rounding turned that meridian.
#[test]
fn lines_that_end_next_to_a_pole_lead_back() {
    next_to_a_pole::<f64>(1e-8);
    next_to_a_pole::<f32>(4.0);
}

/// Along a meridian over a pole and down the other side, where a plane's latitude is beyond 90°.
fn over_a_pole<T: Scalar>() {
    for (name, method) in methods::<T>(1.0 / 298.257_223_563) {
        // A degree is 111.7 km there, 111.2 on a sphere.
        for (lat, azimuth, distance, beyond) in [
            (89.5, 0.0, 1e5, 0.395),
            (-89.5, 180.0, 1e5, 0.395),
            (89.5, 180.0, -1e5, 0.395),
        ] {
            let end = method
                .direct(place(T::of(lat), T::of(-30.0)), T::of(azimuth), T::of(distance))
                .unwrap();
            let expected = [(90.0_f64 - beyond).copysign(lat), 150.0, 180.0 - azimuth];
            let found = [end.position.lat().into(), end.position.lon().into(), end.azimuth.into()];
            let off = |turn: f64| (turn.abs() + 1.0) % 360.0 - 1.0;
            assert!(
                (0..3).all(|i| off(found[i] - expected[i]).abs() < 0.006),
                "{name} {lat} {azimuth}: {found:?}, {expected:?}"
            );
        }
    }
}

#[test]
fn a_meridian_goes_on_beyond_the_pole() {
    over_a_pole::<f64>();
    over_a_pole::<f32>();
}
