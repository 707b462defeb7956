//! Vincenty's formulas against the truth, and at the antipode.

use geographiclib_rs::{DirectGeodesic, Geodesic as Reference, InverseGeodesic};
use terrella::geodesic::{Geodesic, GeodesicError, Vincenty};
use terrella::latitude::UnsupportedFlattening;
use terrella::{Ellipsoid, LatLon};
use testkit::{Worst, maximum, minimum};

use crate::along::{Errors, hold, turned};
use crate::great_circle::places;
use crate::sample::{awkward, even, place, signed};
use crate::truth::{Row, Scalar, Truth};

fn ellipsoid<T: Scalar>(name: &str) -> Ellipsoid<T> {
    match name {
        "wgs84" => Ellipsoid::wgs84(),
        "mars" => Ellipsoid::mars(),
        "moon" => Ellipsoid::moon(),
        "prolate150" => Ellipsoid::new(T::of(6.4e6), T::of(-1.0 / 150.0)).unwrap(),
        _ => Ellipsoid::new(T::of(6.4e6), T::of(0.1)).unwrap(),
    }
}

/// The largest errors in metres, of the distance and of the azimuths times the shorter of distance and reduced length, of all rows: none may be refused.
fn inverse<T: Scalar>(name: &str) -> [f64; 2] {
    let truth = Truth::read(&format!("geod_inverse_{name}"));
    let vincenty = Vincenty::<T>::new(ellipsoid(name)).unwrap();
    let rows = truth.exact_in::<T>(&["lat1", "lon1", "lat2", "lon2"]);
    let solve = |row: Row<'_>| {
        let (from, to) = places::<T>(row);
        vincenty.inverse(from, to).unwrap()
    };
    let azimuth = |row: Row<'_>| {
        let line = solve(row);
        let lever = minimum(row.value("m12").abs(), row.value("s12"));
        let turn = maximum(
            turned(line.azimuth1, row.value("azi1")),
            turned(line.azimuth2, row.value("azi2")),
        );
        turn * lever
    };
    [
        Worst::of(rows.iter().map(|&row| row.error("s12", solve(row).distance))),
        Worst::of(
            rows.iter()
                .filter(|row| row.text("multi") == "unique")
                .map(|&row| azimuth(row)),
        ),
    ]
}

/// The largest displacement of the direct problem's end, in metres, of lines of at most half a circle or of longer ones.
fn direct<T: Scalar>(name: &str, long: bool) -> f64 {
    let truth = Truth::read(&format!("geod_direct_{name}"));
    let ellipsoid = ellipsoid::<T>(name);
    let vincenty = Vincenty::new(ellipsoid).unwrap();
    let rows = truth.exact_in::<T>(&["lat1", "lon1", "azi1", "s12"]);
    let rows = rows.into_iter().filter(|row| (row.value("a12").abs() > 180.0) == long);
    Worst::of(rows.map(|row| {
        let [lat, lon, azimuth, distance] = ["lat1", "lon1", "azi1", "s12"].map(|column| row.input::<T>(column));
        let end = vincenty.direct(place(lat, lon), azimuth, distance).unwrap().position;
        let lon = row.error("lon2", end.lon());
        let lon = minimum(lon, (360.0 - lon).abs()) * row.value("lat2").to_radians().cos();
        row.error("lat2", end.lat()).hypot(lon).to_radians() * ellipsoid.a().into()
    }))
}

#[test]
fn it_is_as_accurate_as_claimed() {
    let claims = [
        ("wgs84", [2.0e-8, 1.5e-8, 2.0e-8, 5e-8], [7.0, 6.0, 7.0, 40.0]),
        ("mars", [2.0e-8, 2.0e-8, 2.0e-8, 5e-8], [7.0, 7.0, 7.0, 40.0]),
        ("moon", [2.0e-8, 2.0e-8, 2.0e-8, 5e-8], [7.0, 7.0, 7.0, 40.0]),
        ("prolate150", [2.0e-8, 2.0e-8, 2.0e-8, 5e-8], [7.0, 7.0, 7.0, 40.0]),
    ];
    fn measure<T: Scalar>(name: &str) -> [f64; 4] {
        let [distance, azimuth] = inverse::<T>(name);
        // No row of a longer line is exact in f32.
        let long = match T::NAME {
            "f32" => ends::<T>(ellipsoid::<f64>(name).f(), 2e8),
            _ => direct::<T>(name, true),
        };
        [distance, azimuth, direct::<T>(name, false), long]
    }
    let mut over = false;
    for (name, double, single) in claims {
        for (measured, claimed) in [(measure::<f64>(name), double), (measure::<f32>(name), single)] {
            println!("{name}: {measured:?} of {claimed:?}");
            over |= !measured.iter().zip(claimed).all(|(&error, claim)| error <= claim);
        }
    }
    assert!(!over);
    let distance = [measure::<f64>("wgs84")[0], measure::<f32>("wgs84")[0]];
    crate::table::hold("Vincenty inverse, distance", distance);
}

#[test]
fn it_holds_at_every_distance() {
    let double = Vincenty::new(Ellipsoid::wgs84()).unwrap();
    let single = Vincenty::new(Ellipsoid::wgs84()).unwrap();
    let claimed = Errors {
        distance: 2.0e-8,
        azimuth: 1.5e-8,
        position: 2.0e-8,
    };
    for distance in [1.0, 1e3, 1e5, 1e6, 5e6, 1e7, 1.5e7, 1.9e7, 2e7] {
        hold(&double, &single, distance, (0.0, 90.0), claimed);
    }
}

#[test]
fn a_flatter_ellipsoid_is_refused() {
    let oblate = ellipsoid::<f64>("oblate10");
    assert_eq!(Vincenty::new(oblate), Err(UnsupportedFlattening(oblate.f())));
    for f in [1.0 / 60.0, -1.0 / 60.0] {
        assert!(Vincenty::new(Ellipsoid::new(1.0, f).unwrap()).is_ok());
        assert!(Vincenty::new(Ellipsoid::new(1.0, f as f32).unwrap()).is_ok());
        assert!(Vincenty::new(Ellipsoid::new(1.0, 1.01 * f).unwrap()).is_err());
    }
}

/// What became of many pairs of places.
#[derive(Debug, Default)]
struct Outcome {
    refused: usize,
    distance: f64,
    azimuth: f64,
}

/// Pairs made in `f64`, rounded to the scalar, against GeographicLib.
fn outcome<T: Scalar>(f: f64, pairs: usize, pair: impl Fn(&mut fastrand::Rng) -> [f64; 4]) -> Outcome {
    let (a, mut rng) = (6_378_137.0, fastrand::Rng::with_seed(12));
    let vincenty = Vincenty::new(Ellipsoid::new(T::of(a), T::of(f)).unwrap()).unwrap();
    let reference = Reference::new(a, f);
    let mut outcome = Outcome::default();
    for _ in 0..pairs {
        let [lat1, lon1, lat2, lon2] = pair(&mut rng).map(T::of);
        let (from, to): (LatLon<T>, _) = (place(lat1, lon1), place(lat2, lon2));
        let line = match vincenty.inverse(from, to) {
            Ok(line) => line,
            Err(why) => {
                assert_eq!(why, GeodesicError::NotConverged(from, to));
                outcome.refused += 1;
                continue;
            }
        };
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
        // Of two shortest lines either will do.
        if lat1 != -lat2 && (lon2 - lon1).abs() != 180.0 {
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
    (1.0 / 60.0, [1.0e-6, 8.0]),
    (-1.0 / 60.0, [1.0e-6, 8.0]),
];

/// Nothing is refused and nothing is wrong, of so many pairs for each flattening and scalar.
fn all_answered(pairs: usize, pair: impl Fn(&mut fastrand::Rng, f64) -> [f64; 4]) {
    for (f, [double, single]) in FLATTENINGS {
        for (outcome, claimed) in [
            (outcome::<f64>(f, pairs, |rng| pair(rng, f)), double),
            (outcome::<f32>(f, pairs, |rng| pair(rng, f)), single),
        ] {
            println!("{f:.5}: {outcome:?} of {claimed:.1e}");
            assert_eq!(outcome.refused, 0);
            assert!(outcome.distance <= claimed && outcome.azimuth <= claimed);
        }
    }
}

/// How far ends of lines, the longest of so many metres, are from GeographicLib's, along the latitude and along the meridian, in metres.
fn ends<T: Scalar>(f: f64, longest: f64) -> f64 {
    let (a, mut rng) = (6_378_137.0, fastrand::Rng::with_seed(13));
    let vincenty = Vincenty::new(Ellipsoid::new(T::of(a), T::of(f)).unwrap()).unwrap();
    let reference = Reference::new(a, f);
    Worst::of((0..3000).map(|_| {
        let [lat, lon, azimuth, distance] = [80.0, 180.0, 180.0, longest].map(|most| T::of(most * signed(&mut rng)));
        let end = vincenty.direct(place(lat, lon), azimuth, distance).unwrap().position;
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
    all_answered(200_000, |rng, _| {
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
    all_answered(200_000, |rng, _| {
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
    all_answered(200_000, |rng, f| {
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
    all_answered(200_000, |rng, _| awkward(rng));
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
