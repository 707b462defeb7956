//! Azimuths are those of a line: who follows the first one arrives with the second. A place alone does not tell, for to the other pole and to
//! an antipode every line leads.

use geographiclib_rs::{DirectGeodesic, Geodesic as Theirs};
use terrella::geodesic::{Area, Geodesic, Haversine, Inverse, Karney, Method, Surface};
use terrella::math::sin_cos_degrees;
use terrella::{Ellipsoid, LatLon};
use testkit::{Worst, maximum};

use crate::sample::{awkward, place};
use testkit::truth::Scalar;

/// A course in space, of a place and an azimuth.
fn course(lat: f64, lon: f64, azimuth: f64) -> [f64; 3] {
    let (sin, cos) = sin_cos_degrees(lat);
    let ((sin_lon, cos_lon), (east, north)) = (sin_cos_degrees(lon), sin_cos_degrees(azimuth));
    [
        -north * sin * cos_lon - east * sin_lon,
        -north * sin * sin_lon + east * cos_lon,
        north * cos,
    ]
}

fn apart(one: [f64; 3], other: [f64; 3]) -> f64 {
    let squares = one.iter().zip(other).map(|(a, b)| (a - b) * (a - b));
    squares.sum::<f64>().sqrt()
}

/// How far off the line leads, in metres, and how much its azimuth there is off, in radians.
fn strays<T: Scalar>(reference: &Theirs, (from, to): (LatLon<T>, LatLon<T>), line: Inverse<T>) -> [f64; 2] {
    let [lat1, lon1, lat2, lon2] = [from.lat(), from.lon(), to.lat(), to.lon()].map(Into::<f64>::into);
    let end: (f64, f64, f64) = reference.direct(lat1, lon1, line.azimuth1.into(), line.distance.into());
    let (lat, lon, azimuth) = end;
    let up = |lat: f64, lon: f64| {
        let ((sin, cos), (sin_lon, cos_lon)) = (sin_cos_degrees(lat), sin_cos_degrees(lon));
        [cos * cos_lon, cos * sin_lon, sin]
    };
    [
        6.4e6 * apart(up(lat, lon), up(lat2, lon2)),
        apart(course(lat, lon, azimuth), course(lat2, lon2, line.azimuth2.into())),
    ]
}

const LATITUDES: [f64; 11] = [
    90.0,
    -90.0,
    0.0,
    -0.0,
    30.0,
    -30.0,
    45.0,
    -45.0,
    89.0,
    90.0 - 1e-13,
    1e-13,
];
const LONGITUDES: [f64; 11] = [
    10.0, 30.0, -170.0, -150.0, 0.0, -0.0, 180.0, -180.0, 179.5, 100.0, -80.0,
];

/// Every pair of the places of the lists: coincident ones, poles, antipodes, opposite meridians, the equator.
fn pairs<T: Scalar>() -> impl Iterator<Item = (LatLon<T>, LatLon<T>)> {
    let places = || {
        LATITUDES
            .into_iter()
            .flat_map(|lat| LONGITUDES.map(|lon| place(T::of(lat), T::of(lon))))
    };
    places().flat_map(move |from| places().map(move |to| (from, to)))
}

/// What [`Geodesic`] says of places that leave the azimuths open.
fn open<T: Scalar>((from, to): (LatLon<T>, LatLon<T>)) -> Option<f64> {
    let [lat1, lon1, lat2, lon2] = [from.lat(), from.lon(), to.lat(), to.lon()].map(Into::<f64>::into);
    if lat1.abs() == 90.0 && lat2.abs() == 90.0 {
        Some((lon2 - lon1).copysign((lon2 - lon1) * lat2))
    } else {
        let turn = (lon2 - lon1).abs();
        (lat1 == lat2 && (turn == 0.0 || turn == 360.0)).then_some(0.0)
    }
}

fn turned(one: f64, other: f64) -> f64 {
    let turn = (one - other).abs();
    if turn > 180.0 { (360.0 - turn).abs() } else { turn }
}

fn open_azimuths<T: Scalar>() {
    for f in [1.0 / 298.257_223_563, 0.0, -1.0 / 150.0] {
        let ellipsoid = Ellipsoid::<T>::new(T::of(6.4e6), T::of(f)).unwrap();
        for method in Method::ALL {
            let Ok(earth) = method.about(ellipsoid, LatLon::default()) else {
                assert!(*method == Method::Vincenty && f < 0.0, "{method} {f}");
                continue;
            };
            for pair in pairs() {
                let Some(azimuth2) = open(pair) else { continue };
                let line = earth.inverse(pair.0, pair.1).unwrap();
                let same = pair.0.lat() == pair.1.lat();
                assert!(
                    line.azimuth1 == T::ZERO && turned(line.azimuth2.into(), azimuth2) < 1e-4,
                    "{method} {} {f} {pair:?}: {line:?}, not 0 and {azimuth2}",
                    T::NAME
                );
                assert!(
                    !same || line.distance == T::ZERO,
                    "{method} {} {f} {pair:?}: {line:?}",
                    T::NAME
                );
            }
        }
    }
}

/// GeographicLib's `signtest` and a user's question: azimuths from pole to pole were of no meridian, and of a place and itself 180 in the north.
#[test]
fn where_azimuths_are_open_all_methods_start_to_the_north() {
    open_azimuths::<f64>();
    open_azimuths::<f32>();
}

/// Worst of [`strays`] over awkward pairs and those of the lists, by any of some methods and by [`Karney::solve`].
fn followed<T: Scalar>(methods: &[Method], ellipsoid: Ellipsoid<T>) -> [f64; 2] {
    let reference = Theirs::new(ellipsoid.a().into(), ellipsoid.f().into());
    let mut rng = fastrand::Rng::with_seed(16);
    let random = (0..40_000).map(|_| {
        let [lat1, lon1, lat2, lon2] = awkward(&mut rng).map(T::of);
        (place(lat1, lon1), place(lat2, lon2))
    });
    let karney = Karney::new(ellipsoid).unwrap();
    let methods: Vec<_> = methods.iter().map(|method| method.on(ellipsoid).unwrap()).collect();
    let mut worst = [Worst::default(), Worst::default()];
    for pair in random.collect::<Vec<_>>().into_iter().chain(pairs()) {
        // Vincenty's iteration has no answer for some.
        let lines = methods.iter().filter_map(|method| method.inverse(pair.0, pair.1).ok());
        for line in lines.chain([karney.solve(pair.0, pair.1).inverse]) {
            for (worst, stray) in worst.iter_mut().zip(strays(&reference, pair, line)) {
                worst.add(stray);
            }
        }
    }
    worst.map(|worst| worst.value())
}

/// From pole to pole, between antipodes and near conjugate places, where a place says nothing of the azimuth there.
#[test]
fn who_follows_the_first_azimuth_arrives_with_the_second() {
    let earth = [Method::Karney];
    // On a sphere all formulas for any distance are exact. Two are less exact near the antipode.
    let exact = |method: &&Method| {
        method.profile().surface != Surface::Local && !matches!(method, Method::Haversine | Method::Vincenty)
    };
    let sphere: Vec<_> = Method::ALL.iter().filter(exact).copied().collect();
    for f in [1.0 / 298.257_223_563, 0.0, 1.0 / 150.0, -1.0 / 150.0] {
        let methods: &[Method] = if f == 0.0 { &sphere } else { &earth };
        let double = followed(methods, Ellipsoid::<f64>::new(6.4e6, f).unwrap());
        let single = followed(methods, Ellipsoid::<f32>::new(6.4e6, f as f32).unwrap());
        println!("{f:.5}: {double:?} {single:?}");
        assert!(double[0] < 3e-8 && double[1] < 1e-14, "{f} f64: {double:?}");
        assert!(single[0] < 7.0 && single[1] < 3e-6, "{f} f32: {single:?}");
    }
    for f in [1.0 / 298.257_223_563, 0.0] {
        let double = followed(&[Method::Vincenty], Ellipsoid::<f64>::new(6.4e6, f).unwrap());
        let single = followed(&[Method::Vincenty], Ellipsoid::<f32>::new(6.4e6, f as f32).unwrap());
        println!("Vincenty {f:.5}: {double:?} {single:?}");
        assert!(double[0] < 2e-4 && double[1] < 2e-11, "{f} f64: {double:?}");
        assert!(single[0] < 14.0 && single[1] < 3e-6, "{f} f32: {single:?}");
    }
    // The general way; GeographicLib's series, of one order for all flattenings, are no better.
    for f in [0.01, -0.01] {
        let double = followed(&earth, Ellipsoid::<f64>::new(6.4e6, f).unwrap());
        println!("{f:.5}: {double:?}");
        assert!(double[0] < 3e-7 && double[1] < 1e-13, "{f} f64: {double:?}");
    }
}

/// Between antipodes the formula's north is nothing but rounding.
#[test]
fn the_haversine_formula_knows_antipodes() {
    let sphere = Haversine::new(1.0_f64).unwrap();
    for (lat, lon) in [(30.0, 10.0), (-30.0, -170.0), (0.0, 0.0), (7.3, 11.75), (89.0, -1.0)] {
        let line = sphere
            .inverse(place(lat, lon), place(-lat, lon - 180.0_f64.copysign(lon)))
            .unwrap();
        assert!(
            (line.azimuth1, line.azimuth2.abs()) == (0.0, 180.0)
                && (line.distance - core::f64::consts::PI).abs() < 1e-7,
            "{lat} {lon}: {line:?}"
        );
    }
}

/// Latitudes exactly opposite, about where the shortest line turns from the north: azimuths are equal, or add up to 180°.
fn symmetric<T: Scalar>() -> f64 {
    let mut worst = Worst::default();
    for f in [1.0 / 298.257_223_563, 1.0 / 150.0, 1e-6, 0.0, -1.0 / 150.0] {
        let karney = Karney::new(Ellipsoid::<T>::new(T::of(6.4e6), T::of(f)).unwrap()).unwrap();
        let mut rng = fastrand::Rng::with_seed(4);
        for _ in 0..40_000 {
            let lat = 90.0 * (2.0 * rng.f64() - 1.0).powi(*rng.choice(&[1, 9]).unwrap());
            let beta = ((1.0 - f) * lat.to_radians().tan()).atan();
            let turns = 180.0 * f.abs() * beta.cos() * (1.0 - 0.25 * f * (1.0 + beta.sin().powi(2)));
            let beyond = turns * (1.0 + 10.0_f64.powf(-17.0 * rng.f64()) * (rng.f64() - 0.5));
            let part = rng.f64();
            let short = [beyond, turns * part, 2.0 * part, 180.0 * part][rng.usize(0..4)];
            let (from, to) = (place(T::of(lat), T::ZERO), place(T::of(-lat), T::of(180.0 - short)));
            let line = karney.inverse(from, to).unwrap();
            let (one, other) = (line.azimuth1.into(), line.azimuth2.into());
            let supplement = (180.0 - one - other).abs();
            let error = (one - other).abs();
            worst.add(if supplement < error { supplement } else { error });
        }
    }
    worst.value()
}

/// They were up to 0.39° apart.
#[test]
fn opposite_latitudes_have_symmetric_azimuths() {
    let (double, single) = (symmetric::<f64>(), symmetric::<f32>());
    println!("{double:e} {single:e}");
    // A rounding of an angle beyond 128°.
    assert!(double <= 2.9e-14 && single <= 1.6e-5);
    let karney = Karney::new(Ellipsoid::<f64>::WGS84).unwrap();
    // Of the conjugate place, by GeographicLib 2.1 and by 40 digits.
    let line = karney.inverse(place(45.0, 0.0), place(-45.0, 179.572_719)).unwrap();
    assert_eq!(line.azimuth1, line.azimuth2);
    assert!((line.azimuth1 - 90.000_000_28).abs() < 1e-8, "{line:?}");
}

/// The same bits of distance and azimuths, by a solver whose answers were of other lines in places.
fn one_answer<T: Scalar>() {
    for f in [1.0 / 298.257_223_563, 0.05, 0.0, -1.0 / 150.0, -0.1] {
        let karney = Karney::new(Ellipsoid::<T>::new(T::of(6.4e6), T::of(f)).unwrap()).unwrap();
        let mut rng = fastrand::Rng::with_seed(3);
        let random = (0..40_000).map(|_| {
            let [lat1, lon1, lat2, lon2] = awkward(&mut rng).map(T::of);
            (place(lat1, lon1), place(lat2, lon2))
        });
        for (from, to) in random.collect::<Vec<_>>().into_iter().chain(pairs()) {
            let bits = |line: Inverse<T>| [line.distance, line.azimuth1, line.azimuth2].map(|x| x.into().to_bits());
            let (line, whole) = (karney.inverse(from, to).unwrap(), karney.solve(from, to).inverse);
            assert_eq!(
                bits(line),
                bits(whole),
                "{} {f} {from:?} {to:?}: {line:?} {whole:?}",
                T::NAME
            );
        }
    }
}

#[test]
fn inverse_and_solve_agree_in_every_bit() {
    one_answer::<f64>();
    one_answer::<f32>();
}

/// The rest of the solution is of the same line: what is known of it from its first azimuth and its distance.
#[test]
fn the_whole_solution_is_of_that_line() {
    let karney = Karney::new(Ellipsoid::<f64>::WGS84).unwrap();
    let mut rng = fastrand::Rng::with_seed(2);
    let mut worst = [0.0; 3];
    for _ in 0..40_000 {
        let [lat1, lon1, lat2, lon2] = awkward(&mut rng);
        let whole = karney.solve(place(lat1, lon1), place(lat2, lon2));
        let line = karney.line(place(lat1, lon1), whole.inverse.azimuth1).unwrap();
        let end = line.at(whole.inverse.distance).unwrap();
        let errors = [
            (whole.reduced_length - end.reduced_length).abs(),
            (whole.arc - end.arc).abs().to_radians() * 6.4e6,
            (whole.scale12 - end.scale12).abs() + (whole.scale21 - end.scale21).abs(),
        ];
        worst = [0, 1, 2].map(|i| maximum(worst[i], errors[i]));
    }
    println!("{worst:?}");
    assert!(worst[0] < 2e-8 && worst[1] < 2e-8 && worst[2] < 1e-14);
}

/// Areas are under the line of the inverse problem, over whichever pole that goes.
#[test]
fn areas_are_under_that_line() {
    let earth = Ellipsoid::<f64>::WGS84;
    let (karney, area) = (Karney::new(earth).unwrap(), Area::new(earth).unwrap());
    let mut rng = fastrand::Rng::with_seed(6);
    let opposite = [30.0, -30.0, 0.0, 1e-13, -60.0, 45.0].map(|lat| [lat, 0.0, -lat, 180.0]);
    let random: Vec<_> = (0..20_000).map(|_| awkward(&mut rng)).collect();
    for [lat1, lon1, lat2, lon2] in opposite.into_iter().chain(random) {
        let (from, to) = (place(lat1, lon1), place(lat2, lon2));
        // Near a pole the end of a direct line is ill-conditioned; over it the way to the west is not told from that to the east.
        let polar = lat1.abs() > 60.0 || lat2.abs() > 60.0;
        if polar || (lon2 - lon1).abs() == 180.0 && lon2 - lon1 != 180.0 {
            continue;
        }
        let whole = karney.solve(from, to);
        if whole.reduced_length < 0.1 * whole.inverse.distance && lat1 != -lat2 {
            continue; // where azimuths and areas are ill-conditioned
        }
        let line = whole.inverse;
        let along = area.under_direct(from, line.azimuth1, line.distance).unwrap();
        let error = (area.under(from, to) - along).abs();
        assert!(error < 0.5, "{from:?} {to:?}: {error:e} of {along:e}");
    }
}
