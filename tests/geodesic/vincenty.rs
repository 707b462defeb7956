//! Vincenty's method of 1975: his own lines, the truth, GeographicLib, and where it fails.

use geographiclib_rs::{DirectGeodesic, Geodesic as Reference, InverseGeodesic};
use terrella::geodesic::{Geodesic, GeodesicError, Vincenty};
use terrella::latitude::UnsupportedFlattening;
use terrella::{Ellipsoid, LatLon};
use testkit::{Worst, maximum, minimum};

use crate::along::turned;
use crate::great_circle::places;
use crate::sample::{awkward, even, place, signed};
use testkit::truth::{Row, Scalar, Truth};

/// The flattest ellipsoid that is taken.
const FLATTEST: f64 = 1.0 / 293.0;

/// Degrees from degrees, minutes and seconds.
fn dms(degrees: f64, minutes: f64, seconds: f64) -> f64 {
    (degrees.abs() + minutes / 60.0 + seconds / 3600.0).copysign(degrees)
}

/// The five lines of table II, from Rainsford (1955): ellipsoid, φ₁, φ₂, L, α₁, α₂ and s as the paper prints them, and how far its azimuths are
/// off, in seconds.
fn published() -> [(Ellipsoid<f64>, [f64; 6], f64); 5] {
    let (bessel, international) = (Ellipsoid::BESSEL1841, Ellipsoid::INTERNATIONAL1924);
    [
        (
            bessel,
            [
                dms(55.0, 45.0, 0.0),
                dms(-33.0, 26.0, 0.0),
                dms(108.0, 13.0, 0.0),
                dms(96.0, 36.0, 8.79960),
                dms(137.0, 52.0, 22.01454),
                14_110_526.170,
            ],
            2e-4,
        ),
        (
            international,
            [
                dms(37.0, 19.0, 54.95367),
                dms(26.0, 7.0, 42.83946),
                dms(41.0, 28.0, 35.50729),
                dms(95.0, 27.0, 59.63089),
                dms(118.0, 5.0, 58.96161),
                4_085_966.703,
            ],
            2e-4,
        ),
        (
            international,
            [
                dms(35.0, 16.0, 11.24862),
                dms(67.0, 22.0, 14.77638),
                dms(137.0, 47.0, 28.31435),
                dms(15.0, 44.0, 23.74850),
                dms(144.0, 55.0, 39.92147),
                8_084_823.839,
            ],
            2e-4,
        ),
        (
            international,
            [
                dms(1.0, 0.0, 0.0),
                -dms(0.0, 59.0, 53.83076),
                dms(179.0, 17.0, 48.02997),
                dms(89.0, 0.0, 0.0),
                dms(91.0, 0.0, 6.11773),
                19_960_000.000,
            ],
            1.1e-3,
        ),
        (
            international,
            [
                dms(1.0, 0.0, 0.0),
                dms(1.0, 1.0, 15.18952),
                dms(179.0, 46.0, 17.84244),
                dms(4.0, 59.0, 59.99995),
                dms(174.0, 59.0, 59.88481),
                19_780_006.558,
            ],
            2e-4,
        ),
    ]
}

/// T. Vincenty, Survey Review 23 (176), 1975, table II. The paper says of its own figures: a millimetre, 10⁻⁵ seconds of arc in position.
#[test]
fn his_own_lines() {
    for (ellipsoid, [lat1, lat2, lon, azimuth1, azimuth2, distance], seconds) in published() {
        let vincenty = Vincenty::new(ellipsoid).unwrap();
        let (from, to) = (place(lat1, 0.0), place(lat2, lon));
        let line = vincenty.inverse(from, to).unwrap();
        assert!((line.distance - distance).abs() <= 1e-3, "{line:?} {distance}");
        for (found, printed) in [(line.azimuth1, azimuth1), (line.azimuth2, azimuth2)] {
            assert!((found - printed).abs() <= seconds / 3600.0, "{line:?} {printed}");
        }
        let end = vincenty.direct(from, azimuth1, distance).unwrap();
        assert!((end.position.lat() - lat2).abs() <= 4e-5 / 3600.0, "{end:?} {lat2}");
        assert!((end.position.lon() - lon).abs() <= 4e-5 / 3600.0, "{end:?} {lon}");
        assert!((end.azimuth - azimuth2).abs() <= seconds / 3600.0, "{end:?} {azimuth2}");
    }
}

/// How far a place is from another's antipode, in degrees on a sphere.
fn short_of_antipode(lat1: f64, lon1: f64, lat2: f64, lon2: f64) -> f64 {
    let half = |degrees: f64| (0.5 * degrees.to_radians()).sin().powi(2);
    let beside = lat1.to_radians().cos() * lat2.to_radians().cos() * half(lon2 - lon1 - 180.0);
    2.0 * (half(lat1 + lat2) + beside).sqrt().asin().to_degrees()
}

/// No pair fails that is farther from being antipodal: degrees.
const FAILING: f64 = 0.8;

/// What is claimed of a distance, and of an azimuth times the shorter of it and the reduced length: metres.
fn claim<T: Scalar>(distance: f64) -> f64 {
    if T::NAME == "f32" {
        minimum(7e-7 * distance, 7.0)
    } else {
        minimum(1e-11 * distance + 5e-9, 1e-4)
    }
}

/// What became of many pairs of places.
#[derive(Debug, Default)]
struct Outcome {
    pairs: usize,
    refused: usize,
    /// The largest errors, in parts of what is claimed.
    distance: f64,
    azimuth: f64,
}

impl Outcome {
    fn add(&mut self, distance: f64, azimuth: f64) {
        self.distance = maximum(self.distance, distance);
        self.azimuth = maximum(self.azimuth, azimuth);
    }

    fn share_refused(&self) -> f64 {
        self.refused as f64 / self.pairs as f64
    }
}

/// Pairs made in `f64`, rounded to the scalar, against GeographicLib: right as claimed, or refused next to the antipode.
fn outcome<T: Scalar>(f: f64, pairs: usize, pair: impl Fn(&mut fastrand::Rng) -> [f64; 4]) -> Outcome {
    let (a, mut rng) = (6_378_137.0, fastrand::Rng::with_seed(12));
    let vincenty = Vincenty::new(Ellipsoid::new(T::of(a), T::of(f)).unwrap()).unwrap();
    let reference = Reference::new(a, f);
    let mut outcome = Outcome {
        pairs,
        ..Outcome::default()
    };
    for _ in 0..pairs {
        let [lat1, lon1, lat2, lon2] = pair(&mut rng).map(T::of);
        let (from, to): (LatLon<T>, _) = (place(lat1, lon1), place(lat2, lon2));
        let [lat1, lon1, lat2, lon2] = [lat1, lon1, lat2, lon2].map(Into::into);
        let line = match vincenty.inverse(from, to) {
            Ok(line) => line,
            Err(why) => {
                assert_eq!(why, GeodesicError::NotConverged(from, to));
                let short = short_of_antipode(lat1, lon1, lat2, lon2);
                assert!(short <= FAILING, "{f} {from:?} {to:?}: {short}° short of the antipode");
                outcome.refused += 1;
                continue;
            }
        };
        let (distance, azimuth1, azimuth2, reduced, _): (f64, f64, f64, f64, f64) =
            reference.inverse(lat1, lon1, lat2, lon2);
        // What the reference itself may be off, and numbers too small for their squares.
        let claimed = claim::<T>(distance) + if T::NAME == "f32" { 1e-11 } else { 1.5e-8 };
        let error = (line.distance.into() - distance).abs();
        // Of two shortest lines either will do.
        let turn = if lat1 != -lat2 && (lon2 - lon1).abs() != 180.0 {
            maximum(turned(line.azimuth1, azimuth1), turned(line.azimuth2, azimuth2))
        } else {
            0.0
        };
        outcome.add(error / claimed, turn * minimum(reduced.abs(), distance) / claimed);
    }
    println!("{} 1/{:.1}: {outcome:?}", T::NAME, 1.0 / f);
    assert!(outcome.distance <= 1.0 && outcome.azimuth <= 1.0, "{f}: {outcome:?}");
    outcome
}

/// Right or refused, on a sphere, the Earth and the flattest ellipsoid in both scalars; the shares refused on the Earth.
fn right_or_refused(pairs: usize, pair: impl Fn(&mut fastrand::Rng) -> [f64; 4] + Copy) -> [f64; 2] {
    for f in [0.0, 1e-5, 1.0 / 1000.0, FLATTEST] {
        outcome::<f64>(f, pairs, pair);
        outcome::<f32>(f, pairs, pair);
    }
    let f = Ellipsoid::WGS84.f();
    [
        outcome::<f64>(f, pairs, pair).share_refused(),
        outcome::<f32>(f, pairs, pair).share_refused(),
    ]
}

/// Within so many degrees of the antipode, evenly.
fn near(rng: &mut fastrand::Rng, degrees: f64) -> [f64; 4] {
    let (lat, lon) = even(rng);
    let (short, turn) = (degrees * rng.f64().sqrt(), std::f64::consts::PI * signed(rng));
    let east = short * turn.sin() / maximum(lat.to_radians().cos(), 0.01);
    [
        lat,
        lon,
        (short * turn.cos() - lat).clamp(-90.0, 90.0),
        lon + 180.0 + east,
    ]
}

#[test]
fn any_two_places() {
    let [double, single] = right_or_refused(50_000, |rng| {
        let ((lat1, lon1), (lat2, lon2)) = (even(rng), even(rng));
        [lat1, lon1, lat2, lon2]
    });
    assert!(double < 5e-5 && single < 5e-5, "{double} {single}");
    right_or_refused(50_000, awkward);
}

#[test]
fn near_the_antipode_it_is_right_or_fails() {
    let [double, single] = right_or_refused(50_000, |rng| near(rng, 2.0));
    assert!(
        (0.07..0.08).contains(&double) && (0.06..0.08).contains(&single),
        "{double} {single}"
    );
    let [double, single] = right_or_refused(50_000, |rng| near(rng, 0.5));
    assert!(
        (0.72..0.75).contains(&double) && (0.65..0.75).contains(&single),
        "{double} {single}"
    );
    // Down to 1e-13°.
    right_or_refused(50_000, |rng| {
        let (lat, lon) = even(rng);
        let (short, turn) = (2.0 * 10f64.powf(-13.0 * rng.f64()), std::f64::consts::PI * signed(rng));
        [
            lat,
            lon,
            (short * turn.cos() - lat).clamp(-90.0, 90.0),
            lon + 180.0 + short * turn.sin(),
        ]
    });
    // Opposite latitudes, or nearly, where λ alone decides.
    right_or_refused(50_000, |rng| {
        let lat = 20.0 * signed(rng);
        let apart = if rng.bool() {
            0.0
        } else {
            10f64.powf(-16.0 * rng.f64()) * signed(rng)
        };
        [lat, 0.0, apart - lat, 180.0 - 10f64.powf(-14.0 * rng.f64())]
    });
}

/// `cargo test --release --test geodesic -- --ignored ten_million_by_vincenty`
#[test]
#[ignore = "10⁷ pairs of places"]
fn ten_million_by_vincenty() {
    right_or_refused(500_000, |rng| near(rng, 2.0));
    right_or_refused(500_000, awkward);
}

/// The largest errors in metres of all rows that are answered, and how many are not.
fn inverse<T: Scalar>(name: &str, ellipsoid: Ellipsoid<T>) -> (f64, usize) {
    let truth = Truth::read(&format!("geod_inverse_{name}"));
    let vincenty = Vincenty::new(ellipsoid).unwrap();
    let mut refused = 0;
    let error = |&row: &Row<'_>| {
        let (from, to) = places::<T>(row);
        let Ok(line) = vincenty.inverse(from, to) else {
            let [lat1, lon1, lat2, lon2] = ["lat1", "lon1", "lat2", "lon2"].map(|column| row.value(column));
            assert!(short_of_antipode(lat1, lon1, lat2, lon2) <= FAILING);
            refused += 1;
            return 0.0;
        };
        let turn = maximum(
            turned(line.azimuth1, row.value("azi1")),
            turned(line.azimuth2, row.value("azi2")),
        );
        let turn = if row.text("multi") == "unique" { turn } else { 0.0 };
        let lever = minimum(row.value("m12").abs(), row.value("s12"));
        maximum(row.error("s12", line.distance), turn * lever)
    };
    let rows = truth.exact_in::<T>(&["lat1", "lon1", "lat2", "lon2"]);
    (Worst::of(rows.iter().map(error)), refused)
}

/// What is claimed of a line's end: metres.
fn claim_end<T: Scalar>(distance: f64) -> f64 {
    if T::NAME == "f32" {
        maximum(3.5e-7 * distance.abs(), 7.0)
    } else {
        maximum(6e-12 * distance.abs(), 1e-4)
    }
}

/// The largest displacement of the ends of lines, in parts of what is claimed.
fn direct<T: Scalar>(name: &str, ellipsoid: Ellipsoid<T>) -> f64 {
    let truth = Truth::read(&format!("geod_direct_{name}"));
    let vincenty = Vincenty::new(ellipsoid).unwrap();
    Worst::of(
        truth
            .exact_in::<T>(&["lat1", "lon1", "azi1", "s12"])
            .into_iter()
            .map(|row| {
                let [lat, lon, azimuth, distance] =
                    ["lat1", "lon1", "azi1", "s12"].map(|column| row.input::<T>(column));
                let end = vincenty.direct(place(lat, lon), azimuth, distance).unwrap().position;
                let lon = row.error("lon2", end.lon());
                let lon = minimum(lon, (360.0 - lon).abs()) * row.value("lat2").to_radians().cos();
                let off = row.error("lat2", end.lat()).hypot(lon).to_radians() * ellipsoid.a().into();
                off / claim_end::<T>(row.value("s12"))
            }),
    )
}

#[test]
fn it_is_as_accurate_as_claimed() {
    fn hold<T: Scalar>(claimed: f64) -> f64 {
        let (earth, refused) = inverse::<T>("wgs84", Ellipsoid::WGS84);
        let (moon, none) = inverse::<T>("moon", Ellipsoid::MOON);
        let ends = [
            direct::<T>("wgs84", Ellipsoid::WGS84),
            direct::<T>("moon", Ellipsoid::MOON),
        ];
        println!("{}: {earth:e}, {refused} refused; {moon:e}; {ends:?}", T::NAME);
        assert!(refused > 0 && none == 0, "{refused} {none}");
        assert!(earth <= claimed && moon <= claimed && ends.iter().all(|&part| part <= 1.0));
        earth
    }
    testkit::table::hold("Vincenty inverse, distance", [hold::<f64>(1e-4), hold::<f32>(7.0)]);
}

/// How far ends of lines of up to a few circuits are from GeographicLib's, in parts of what is claimed.
fn ends<T: Scalar>(f: f64, longest: f64) -> f64 {
    let (a, mut rng) = (6_378_137.0, fastrand::Rng::with_seed(13));
    let vincenty = Vincenty::new(Ellipsoid::new(T::of(a), T::of(f)).unwrap()).unwrap();
    let reference = Reference::new(a, f);
    Worst::of((0..20_000).map(|_| {
        let (lat, lon) = even(&mut rng);
        let [lat, lon, azimuth, distance] = [lat, lon, 180.0 * signed(&mut rng), longest * signed(&mut rng)].map(T::of);
        let end = vincenty.direct(place(lat, lon), azimuth, distance).unwrap();
        let (lat2, lon2, azimuth2): (f64, f64, f64) =
            reference.direct(lat.into(), lon.into(), azimuth.into(), distance.into());
        let north = end.position.lat().into() - lat2;
        let cos = lat2.to_radians().cos();
        let off = a * north.to_radians().hypot(turned(end.position.lon(), lon2) * cos);
        let azimuth = a * turned(end.azimuth, azimuth2) * cos;
        maximum(off, azimuth) / claim_end::<T>(distance.into())
    }))
}

#[test]
fn ends_of_lines() {
    for f in [0.0, Ellipsoid::WGS84.f(), FLATTEST] {
        for longest in [1e6, 2e7, 3e8] {
            let (double, single) = (ends::<f64>(f, longest), ends::<f32>(f, longest));
            println!("{f:.5} {longest:e}: {double:e}, {single:e}");
            assert!(double <= 1.0 && single <= 1.0);
        }
    }
}

#[test]
fn flatter_and_prolate_ellipsoids_are_refused() {
    fn outside<T: Scalar>() {
        for f in [1.01 * FLATTEST, 1.0 / 169.9, 0.1, -1e-4, -1.0 / 298.0] {
            let ellipsoid = Ellipsoid::new(T::of(6.4e6), T::of(f)).unwrap();
            assert_eq!(Vincenty::new(ellipsoid), Err(UnsupportedFlattening(ellipsoid.f())));
        }
        // Clarke 1880 (RGS) is the flattest of the Earth's.
        for f in [0.0, -0.0, 1e-9, 1.0 / 300.801_7, 1.0 / 293.465, FLATTEST] {
            assert!(Vincenty::new(Ellipsoid::new(T::of(1.0), T::of(f)).unwrap()).is_ok());
        }
    }
    outside::<f64>();
    outside::<f32>();
}

/// Along the equator cos²α is 0, by which the paper divides: the distance is a L up to where the shortest line leaves it, and beyond there is no
/// answer; only half way round the line over the pole is found.
#[test]
fn along_the_equator() {
    fn equator<T: Scalar>(off: f64) {
        let ellipsoid = Ellipsoid::<T>::WGS84;
        let (a, f): (f64, f64) = (ellipsoid.a().into(), ellipsoid.f().into());
        let vincenty = Vincenty::new(ellipsoid).unwrap();
        let from = place(T::ZERO, T::ZERO);
        let leaves = 180.0 * (1.0 - f);
        for lon in [1e-9, 1e-3, 1.0, 90.0, 179.0, leaves - 0.05].map(T::of) {
            let to = place(T::ZERO, lon);
            let line = vincenty.inverse(from, to).unwrap();
            let expected = a * to.lon().into().to_radians();
            assert!(
                (line.distance.into() - expected).abs() <= off * expected,
                "{to:?}: {line:?}"
            );
            assert!(line.azimuth1.into() == 90.0 && line.azimuth2.into() == 90.0, "{line:?}");
        }
        for lon in [leaves + 0.05, 179.9, 179.999] {
            let (from, to) = (place(T::ZERO, T::ZERO), place(T::ZERO, T::of(lon)));
            assert_eq!(vincenty.inverse(from, to), Err(GeodesicError::NotConverged(from, to)));
            assert_eq!(vincenty.evaluations(from, to), None);
        }
    }
    equator::<f64>(1e-11);
    equator::<f32>(7e-7);
}

/// Opposite places, the one case next to the antipode that needs no iteration: half of a meridian, to the north and down again.
#[test]
fn opposite_places_are_half_a_meridian_apart() {
    fn opposite<T: Scalar>(off: f64) {
        let vincenty = Vincenty::new(Ellipsoid::<T>::WGS84).unwrap();
        for lat in [0.0, 1e-3, 10.0, -10.0, 22.0, 45.0, -67.0, 89.0] {
            let line = vincenty
                .inverse(place(T::of(lat), T::of(10.0)), place(T::of(-lat), T::of(-170.0)))
                .unwrap();
            assert!(
                (line.distance.into() - 20_003_931.458_625_4).abs() <= off,
                "{lat}: {line:?}"
            );
            assert!(
                line.azimuth1.into() == 0.0 && line.azimuth2.into() == 180.0,
                "{lat}: {line:?}"
            );
        }
        for (lat1, lat2, azimuth) in [(90.0, -90.0, -20.0), (-90.0, 90.0, 20.0)] {
            let line = vincenty
                .inverse(place(T::of(lat1), T::of(10.0)), place(T::of(lat2), T::of(30.0)))
                .unwrap();
            assert!((line.distance.into() - 20_003_931.458_625_4).abs() <= off, "{line:?}");
            assert!(
                line.azimuth1.into() == 0.0 && line.azimuth2.into() == azimuth,
                "{line:?}"
            );
        }
    }
    opposite::<f64>(1e-4);
    opposite::<f32>(7.0);
}

/// Mean numbers of evaluations anywhere, and next to the antipode of those that converge.
#[test]
fn it_needs_as_few_steps_as_it_says() {
    fn mean<T: Scalar>(pair: impl Fn(&mut fastrand::Rng) -> [f64; 4]) -> f64 {
        let vincenty = Vincenty::new(Ellipsoid::<T>::WGS84).unwrap();
        let mut rng = fastrand::Rng::with_seed(8);
        let counts: Vec<usize> = (0..20_000)
            .filter_map(|_| {
                let [lat1, lon1, lat2, lon2] = pair(&mut rng).map(T::of);
                vincenty.evaluations(place(lat1, lon1), place(lat2, lon2))
            })
            .collect();
        assert!(counts.iter().all(|count| (1..=100).contains(count)));
        counts.iter().sum::<usize>() as f64 / counts.len() as f64
    }
    let anywhere = |rng: &mut fastrand::Rng| {
        let ((lat1, lon1), (lat2, lon2)) = (even(rng), even(rng));
        [lat1, lon1, lat2, lon2]
    };
    let means = [
        mean::<f64>(anywhere),
        mean::<f32>(anywhere),
        mean::<f64>(|rng| near(rng, 2.0)),
        mean::<f32>(|rng| near(rng, 2.0)),
    ];
    println!("{means:?}");
    for (mean, limit) in means.into_iter().zip([5.05, 3.06, 17.5, 9.6]) {
        assert!(mean <= limit, "{means:?}");
    }
}
