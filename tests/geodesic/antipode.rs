//! Karney's geodesics next to the antipode and elsewhere, on ellipsoids of several flattenings: both of its ways answer, and right.

use geographiclib_rs::{DirectGeodesic, Geodesic as Reference, InverseGeodesic};
use terrella::geodesic::{Geodesic, Karney};
use terrella::{Ellipsoid, LatLon};
use testkit::{Worst, maximum, minimum};

use crate::along::turned;
use crate::sample::{awkward, even, place, signed};
use testkit::truth::Scalar;

/// The largest errors between many pairs of places.
#[derive(Debug, Default)]
struct Outcome {
    distance: f64,
    azimuth: f64,
}

/// Pairs made in `f64`, rounded to the scalar, against GeographicLib.
fn outcome<T: Scalar>(f: f64, pairs: usize, pair: impl Fn(&mut fastrand::Rng) -> [f64; 4]) -> Outcome {
    let (a, mut rng) = (6_378_137.0, fastrand::Rng::with_seed(12));
    let karney = Karney::new(Ellipsoid::new(T::of(a), T::of(f)).unwrap()).unwrap();
    let reference = Reference::new(a, f);
    let mut outcome = Outcome::default();
    for _ in 0..pairs {
        let [lat1, lon1, lat2, lon2] = pair(&mut rng).map(T::of);
        let (from, to): (LatLon<T>, _) = (place(lat1, lon1), place(lat2, lon2));
        let line = karney.inverse(from, to).unwrap();
        let [lat1, lon1, lat2, lon2] = [lat1, lon1, lat2, lon2].map(Into::into);
        let answer = |lat2| -> (f64, f64, f64, f64, f64) { reference.inverse(lat1, lon1, lat2, lon2) };
        let mut theirs = answer(lat2);
        // Between opposite meridians of an ellipsoid longer than wide, at latitudes that are opposite but for a
        // rounding, GeographicLib takes the root of a negative number.
        if theirs.0.is_nan() && f < 0.0 && (lat1 + lat2).abs() < 1e-13 {
            theirs = answer(-lat1);
        }
        let (distance, azimuth1, azimuth2, reduced, _) = theirs;
        let error = (line.distance.into() - distance).abs();
        outcome.distance = maximum(outcome.distance, error);
        // Of two shortest lines either will do; the way of flatter ellipsoids takes either next to opposite latitudes, too.
        let beside = match (f.abs() > 1.0 / 149.0, T::NAME) {
            (false, _) => 0.0,
            (true, "f32") => 1e-3,
            (true, _) => 1e-9,
        };
        if (lat1 + lat2).abs() > beside && (lon2 - lon1).abs() != 180.0 {
            let turn = maximum(turned(line.azimuth1, azimuth1), turned(line.azimuth2, azimuth2));
            let error = turn * minimum(reduced.abs(), distance);
            outcome.azimuth = maximum(outcome.azimuth, error);
        }
    }
    outcome
}

const FLATTENINGS: [(f64, [f64; 2]); 5] = [
    (1.0 / 298.257_223_563, [2.0e-8, 7.0]),
    (1.0 / 169.894_447_2, [2.0e-8, 7.0]),
    (-1.0 / 150.0, [2.0e-8, 7.0]),
    (1.0 / 60.0, [2.0e-8, 8.0]),
    (-1.0 / 60.0, [2.0e-8, 8.0]),
];

/// Nothing is wrong, of so many pairs for each flattening and scalar.
fn all_answered(pairs: usize, pair: impl Fn(&mut fastrand::Rng, f64) -> [f64; 4]) {
    for (f, [double, single]) in FLATTENINGS {
        for (outcome, claimed) in [
            (outcome::<f64>(f, pairs, |rng| pair(rng, f)), double),
            (outcome::<f32>(f, pairs, |rng| pair(rng, f)), single),
        ] {
            println!("{f:.5}: {outcome:?} of {claimed:.1e}");
            assert!(outcome.distance <= claimed && outcome.azimuth <= claimed);
        }
    }
}

/// How far ends of lines, the longest of so many metres, are from GeographicLib's, along the latitude and along the meridian, in metres.
fn ends<T: Scalar>(f: f64, longest: f64) -> f64 {
    let (a, mut rng) = (6_378_137.0, fastrand::Rng::with_seed(13));
    let karney = Karney::new(Ellipsoid::new(T::of(a), T::of(f)).unwrap()).unwrap();
    let reference = Reference::new(a, f);
    Worst::of((0..3000).map(|_| {
        let [lat, lon, azimuth, distance] = [80.0, 180.0, 180.0, longest].map(|most| T::of(most * signed(&mut rng)));
        let end = karney.direct(place(lat, lon), azimuth, distance).unwrap().position;
        let (lat2, lon2): (f64, f64) = reference.direct(lat.into(), lon.into(), azimuth.into(), distance.into());
        let north = end.lat().into() - lat2;
        let east = turned(end.lon(), lon2) * lat2.to_radians().cos();
        a * north.to_radians().hypot(east)
    }))
}

#[test]
fn ends_of_flatter_ellipsoids_too() {
    for (f, [double, single]) in FLATTENINGS {
        let (double, single) = ((ends::<f64>(f, 2e7), double), (ends::<f32>(f, 2e7), single));
        println!("{f:.5}: {double:?}, {single:?}");
        assert!(
            double.0 <= double.1 && single.0 <= single.1,
            "{f:.5}: {double:?}, {single:?}"
        );
    }
}

#[test]
fn near_the_antipode_it_answers() {
    // From 2° of the antipode down to 1e-13°.
    all_answered(100_000, |rng, _| {
        let (lat, lon) = even(rng);
        let (short, turn) = (2.0 * 10f64.powf(-13.0 * rng.f64()), std::f64::consts::PI * signed(rng));
        let east = short * turn.sin() / maximum(lat.to_radians().cos(), 0.01);
        [
            lat,
            lon,
            (short * turn.cos() - lat).clamp(-90.0, 90.0),
            lon + 180.0 + east,
        ]
    });
    // From half a degree to two.
    all_answered(100_000, |rng, _| {
        let (lat, lon) = even(rng);
        let (short, turn) = (0.5 + 1.5 * rng.f64(), std::f64::consts::PI * signed(rng));
        let east = short * turn.sin() / maximum(lat.to_radians().cos(), 0.01);
        [
            lat,
            lon,
            (short * turn.cos() - lat).clamp(-90.0, 90.0),
            lon + 180.0 + east,
        ]
    });
}

#[test]
fn where_lines_cross_it_answers() {
    // Nearly opposite latitudes, and longitudes on both sides of where the shortest line leaves the parallel.
    all_answered(100_000, |rng, f| {
        let lat = even(rng).0;
        let apart = 10f64.powf(-17.0 * rng.f64()).copysign(signed(rng));
        let limit = 180.0 * f.abs() * lat.to_radians().cos();
        let lon = match rng.u8(0..2) {
            0 => 180.0 - 2.2 * limit * rng.f64(),
            _ => 180.0 - limit * (1.0 + 10f64.powf(-15.0 * rng.f64()).copysign(signed(rng))),
        };
        [lat, 0.0, (apart - lat).clamp(-90.0, 90.0), lon]
    });
}

#[test]
fn elsewhere_it_answers() {
    all_answered(100_000, |rng, _| awkward(rng));
}

/// `cargo test --release --test geodesic -- --ignored ten_million`: some minutes.
#[test]
#[ignore = "10⁷ pairs of places"]
fn ten_million_near_the_antipode() {
    all_answered(1_000_000, |rng, _| {
        let (lat, lon) = even(rng);
        let (short, turn) = (2.0 * rng.f64(), std::f64::consts::PI * signed(rng));
        let east = short * turn.sin() / maximum(lat.to_radians().cos(), 0.01);
        [
            lat,
            lon,
            (short * turn.cos() - lat).clamp(-90.0, 90.0),
            lon + 180.0 + east,
        ]
    });
}
