//! Karney's geodesics against the truth and against GeographicLib.

use geographiclib_rs::{Geodesic as Theirs, InverseGeodesic, PolygonArea as TheirPolygon, Winding};
use terrella::geodesic::{Area, Geodesic, GeodesicError, Karney};
use terrella::{Ellipsoid, LatLon, Real};
use testkit::{Worst, maximum, minimum};

use testkit::table::hold;
use testkit::truth::{Row, Scalar, Truth};

fn ellipsoid<T: Real>(name: &str) -> Ellipsoid<T> {
    let (a, f) = match name {
        "wgs84" => (6_378_137.0, 1.0 / 298.257_223_563),
        "mars" => (3_396_190.0, 1.0 / 169.894_447_2),
        "moon" => (1_737_400.0, 0.0),
        "oblate10" => (6.4e6, 0.1),
        "prolate150" => (6.4e6, -1.0 / 150.0),
        other => panic!("no ellipsoid {other}"),
    };
    Ellipsoid::new(T::of(a), T::of(f)).unwrap()
}

fn place<T: Scalar>(row: Row, lat: &str, lon: &str) -> LatLon<T> {
    LatLon::new(row.input(lat), row.input(lon)).unwrap()
}

/// |computed − truth| of an angle in degrees, in radians.
fn turn<T: Scalar>(row: Row, column: &str, computed: T) -> f64 {
    let error = row.error(column, computed);
    minimum(error, (360.0 - error).abs()).to_radians()
}

/// In `f32` an error may grow by 1.5e-7 of the distance before it counts.
fn beyond_rounding<T: Scalar>(error: f64, distance: f64) -> f64 {
    let allowed = if T::NAME == "f32" { 1.5e-7 * distance.abs() } else { 0.0 };
    maximum(error - allowed, 0.0)
}

#[derive(Default)]
struct Inverse {
    distance: Worst,
    /// Azimuth times the smaller of |m₁₂| and s₁₂.
    azimuth: Worst,
    reduced_length: Worst,
    area: Worst,
    area_of_short: Worst,
}

fn inverse<T: Scalar>(name: &str) -> Inverse {
    let truth = Truth::read(&format!("geod_inverse_{name}"));
    let karney = Karney::<T>::new(ellipsoid(name)).unwrap();
    let area = Area::<T>::new(ellipsoid(name)).unwrap();
    let mut worst = Inverse::default();
    for row in truth.exact_in::<T>(&["lat1", "lon1", "lat2", "lon2"]) {
        let (from, to) = (place(row, "lat1", "lon1"), place(row, "lat2", "lon2"));
        let (s12, m12) = (row.value("s12"), row.value("m12").abs());
        let found = karney.solve(from, to);
        for way in [found.inverse, karney.inverse(from, to).unwrap()] {
            let error = beyond_rounding::<T>(row.error("s12", way.distance), s12);
            worst.distance.add(error);

            let off = |one: T, other: T| maximum(turn(row, "azi1", one), turn(row, "azi2", other)) * minimum(m12, s12);
            let (azimuth1, azimuth2) = (way.azimuth1, way.azimuth2);
            let error = match row.text("multi") {
                "two_swap" => minimum(off(azimuth1, azimuth2), off(azimuth2, azimuth1)),
                "two_ew" => minimum(off(azimuth1, azimuth2), off(-azimuth1, -azimuth2)),
                "infinite" | "coincident" => 0.0,
                _ => off(azimuth1, azimuth2),
            };
            worst.azimuth.add(error);
        }

        // Near conjugate points m₁₂ and S₁₂ are as ill-conditioned as the azimuths.
        if row.text("multi") == "unique" && (s12 < 1e6 || m12 > 0.1 * s12) {
            worst.reduced_length.add(row.error("m12", found.reduced_length));
            let error = row.error("S12", area.under(from, to));
            worst.area.add(error);
            if s12 < 1e6 {
                worst.area_of_short.add(error);
            }
        }
    }
    worst
}

/// The largest displacement in metres, of lines up to once around and of longer ones.
fn direct<T: Scalar>(name: &str) -> [f64; 2] {
    let truth = Truth::read(&format!("geod_direct_{name}"));
    let e = ellipsoid::<f64>(name);
    let karney = Karney::<T>::new(ellipsoid(name)).unwrap();
    let mut worst = [Worst::default(); 2];
    for row in truth.exact_in::<T>(&["lat1", "lon1", "azi1", "s12"]) {
        let s12 = row.value("s12");
        let from = place(row, "lat1", "lon1");
        let (azimuth, distance) = (row.input("azi1"), row.input("s12"));
        let there = karney.direct(from, azimuth, distance).unwrap().position;
        let along = karney.line(from, azimuth).unwrap().at(distance).unwrap().position;
        let phi = row.value("lat2").to_radians();
        let w = 1.0 - e.e2() * phi.sin().powi(2);
        let (rho, nu) = (e.a() * (1.0 - e.e2()) / w.powf(1.5), e.a() / w.sqrt());
        for (lat, lon) in [there, along].map(|place| (place.lat(), place.lon())) {
            assert!(
                lat.into().abs() <= 90.0 && lon.into().abs() <= 180.0,
                "{there:?} {along:?}"
            );
            let north = rho * row.error("lat2", lat).to_radians();
            let east = turn(row, "lon2", lon);
            let east = if row.text("multi") == "pole_end" {
                0.0
            } else {
                nu * phi.cos() * east
            };
            let error = beyond_rounding::<T>(north.hypot(east), s12);
            let around = usize::from(s12.abs() > 1.01 * std::f64::consts::TAU * e.a());
            worst[around].add(error);
        }
    }
    worst.map(Worst::value)
}

/// The largest displacement in `f32` past 1.5e-7 of the distance, of lines up to ten times around, against `f64`: no truth row
/// that long is exact in `f32`.
fn circuits_in_single(name: &str) -> f64 {
    let (single, double) = (
        Karney::<f32>::new(ellipsoid(name)).unwrap(),
        Karney::<f64>::new(ellipsoid(name)).unwrap(),
    );
    let mut rng = fastrand::Rng::with_seed(10);
    let mut worst = Worst::default();
    for _ in 0..20_000 {
        let [lat, lon, azimuth, distance] = [80.0, 180.0, 180.0, 4e8].map(|range: f32| range * (2.0 * rng.f32() - 1.0));
        let found = single
            .direct(LatLon::new(lat, lon).unwrap(), azimuth, distance)
            .unwrap()
            .position;
        let [lat, lon, azimuth, distance] = [lat, lon, azimuth, distance].map(f64::from);
        let expected = double
            .direct(LatLon::new(lat, lon).unwrap(), azimuth, distance)
            .unwrap()
            .position;
        let found = LatLon::new(f64::from(found.lat()), f64::from(found.lon())).unwrap();
        let error = double.solve(expected, found).inverse.distance;
        worst.add(beyond_rounding::<f32>(error, distance));
    }
    worst.value()
}

#[test]
fn karney_is_as_accurate_as_claimed() {
    let both = |name| {
        (
            inverse::<f64>(name),
            inverse::<f32>(name),
            direct::<f64>(name),
            direct::<f32>(name),
        )
    };
    let (earth, earth32, direct_earth, direct_earth32) = both("wgs84");
    hold(
        "Karney inverse, distance",
        [earth.distance.value(), earth32.distance.value()],
    );
    hold(
        "Karney inverse, azimuth times length",
        [earth.azimuth.value(), earth32.azimuth.value()],
    );
    hold(
        "Karney inverse, reduced length",
        [earth.reduced_length.value(), earth32.reduced_length.value()],
    );
    hold("Karney direct, position", [direct_earth[0], direct_earth32[0]]);
    hold(
        "Karney direct, position after several circuits",
        [direct_earth[1], circuits_in_single("wgs84")],
    );
    hold("Karney area under a line", [earth.area.value(), earth32.area.value()]);
    hold(
        "Karney area under a line of less than 1000 km",
        [earth.area_of_short.value(), earth32.area_of_short.value()],
    );
    for name in ["mars", "moon"] {
        let (inverse, inverse32, direct, direct32) = both(name);
        hold(
            "Karney on Mars and the Moon",
            [
                maximum(inverse.distance.value(), direct[0]),
                maximum(inverse32.distance.value(), direct32[0]),
            ],
        );
    }
    for name in ["oblate10", "prolate150"] {
        let (inverse, inverse32, direct, direct32) = both(name);
        hold(
            "Karney for f = 1/10 and −1/150",
            [
                maximum(inverse.distance.value(), direct[0]),
                maximum(inverse32.distance.value(), direct32[0]),
            ],
        );
        hold(
            "Karney for f = 1/10 and −1/150, several circuits",
            [direct[1], circuits_in_single(name)],
        );
    }
}

#[test]
fn area_of_direct_lines() {
    let truth = Truth::read("geod_direct_wgs84");
    let area = Area::<f64>::new(ellipsoid("wgs84")).unwrap();
    let mut rows = 0;
    for row in truth.exact_in::<f64>(&["lat1", "lon1", "azi1", "s12"]) {
        if row.text("multi") == "unique" && ["random", "short"].contains(&row.text("class")) {
            let from = place(row, "lat1", "lon1");
            let found = area.under_direct(from, row.value("azi1"), row.value("s12")).unwrap();
            assert!(
                row.error("S12", found) < 0.1,
                "{} {}",
                row.text("lat1"),
                row.text("azi1")
            );
            rows += 1;
        }
    }
    assert!(rows > 500);
}

#[test]
fn a_line_is_its_points() {
    let karney = Karney::<f64>::new(ellipsoid("wgs84")).unwrap();
    let from = LatLon::new(40.0, -75.0).unwrap();
    let line = karney.line(from, 35.0).unwrap();
    for i in -40..=40 {
        let distance = f64::from(i) * 1e6;
        let point = line.at(distance).unwrap();
        let direct = karney.direct(from, 35.0, distance).unwrap();
        let (there, end) = (point.position, direct.position);
        let off = [
            there.lat() - end.lat(),
            there.lon() - end.lon(),
            point.azimuth - direct.azimuth,
        ];
        assert!(off.iter().all(|x| x.abs() < 5e-13), "{distance} {off:?}");
        if distance > 0.0 && distance < 1.9e7 {
            let back = karney.solve(from, point.position);
            assert!((back.inverse.distance - distance).abs() < 1e-8 && (back.inverse.azimuth1 - 35.0).abs() < 1e-9);
            assert!((back.reduced_length - point.reduced_length).abs() < 1e-7);
            assert!((back.scale12 - point.scale12).abs() < 1e-14 && (back.scale21 - point.scale21).abs() < 1e-14);
        }
    }
}

#[test]
fn what_is_not_finite_is_refused() {
    let karney = Karney::<f64>::new(ellipsoid("wgs84")).unwrap();
    let from = LatLon::new(1.0, 2.0).unwrap();
    assert!(matches!(karney.direct(from, f64::NAN, 1.0), Err(GeodesicError::Azimuth(a)) if a.is_nan()));
    assert_eq!(
        karney.direct(from, f64::INFINITY, 1.0),
        Err(GeodesicError::Azimuth(f64::INFINITY))
    );
    assert!(matches!(karney.direct(from, 1.0, f64::NAN), Err(GeodesicError::Distance(d)) if d.is_nan()));
    let line = karney.line(from, 1.0).unwrap();
    for far in [1e15, -1e15, f64::MAX] {
        let why = karney.direct(from, 1.0, far).unwrap_err();
        assert_eq!(line.at(far), Err(why));
        let GeodesicError::TooFar { distance, limit } = why else {
            panic!("{why}");
        };
        // 10⁵ polar radii, and what the meridian is longer than a circle of one.
        assert!(distance == far && (limit / 6.356_752e11 - 1.0017).abs() < 1e-4, "{why}");
        assert!(line.at(0.999_999 * limit).is_ok() && line.at(1.000_001 * limit).is_err());
        assert!(
            why.to_string().contains(&format!("{far:?} is longer than {limit:?}")),
            "{why}"
        );
    }
    assert!(Karney::new(Ellipsoid::new(1.0_f64, 0.2).unwrap()).is_err());
}

/// Between neighbours a distance keeps its digits: in `f32` against `f64` at the same places.
#[test]
fn short_lines_keep_their_digits() {
    let (single, double) = (
        Karney::<f32>::new(ellipsoid("wgs84")).unwrap(),
        Karney::<f64>::new(ellipsoid("wgs84")).unwrap(),
    );
    let mut rng = fastrand::Rng::with_seed(9);
    let signed = |rng: &mut fastrand::Rng| 2.0 * rng.f32() - 1.0;
    let mut worst = Worst::default();
    for i in 0..100_000 {
        let (lat, lon) = (85.0 * signed(&mut rng), 170.0 * signed(&mut rng));
        let size = 10f32.powf(-5.0 * rng.f32());
        let east = if i % 4 == 0 { 0.0 } else { size * signed(&mut rng) };
        let (lat2, lon2) = (lat + size * signed(&mut rng), lon + east);
        let both = |lat: f32, lon: f32| {
            (
                LatLon::new(lat, lon).unwrap(),
                LatLon::new(f64::from(lat), f64::from(lon)).unwrap(),
            )
        };
        let ((from, from64), (to, to64)) = (both(lat, lon), both(lat2, lon2));
        let expected = double.solve(from64, to64).inverse.distance;
        for way in [single.solve(from, to).inverse, single.inverse(from, to).unwrap()] {
            worst.add((f64::from(way.distance) - expected).abs() / maximum(expected, 1.0));
        }
    }
    let truth = Truth::read("geod_inverse_wgs84");
    let short = truth
        .exact_in::<f64>(&["lat1"])
        .into_iter()
        .filter(|row| row.value("s12") < 1.5e5);
    let errors = short.map(|row| {
        let (from, to) = (place(row, "lat1", "lon1"), place(row, "lat2", "lon2"));
        let ways = [double.solve(from, to).inverse, double.inverse(from, to).unwrap()];
        let [one, other] = ways.map(|way| row.error("s12", way.distance));
        maximum(one, other) / maximum(row.value("s12"), 1.0)
    });
    hold(
        "Karney inverse to 150 km, relative to 1 m or more",
        [Worst::of(errors), worst.value()],
    );
}

/// After so many circuits that the flattening alone makes circles of longitude, a place is still one.
#[test]
fn very_many_circuits_end_on_the_globe() {
    fn check<T: Scalar>(radii: f64) {
        for name in ["wgs84", "oblate10", "prolate150"] {
            let karney = Karney::<T>::new(ellipsoid(name)).unwrap();
            for azimuth in [-120.0, -90.0, 0.0, 45.0, 73.0] {
                for part in [-1.0, -0.51, 0.06, 0.3, 0.99] {
                    let distance = T::of(part * radii * 5.7e6);
                    let from = LatLon::new(T::of(8.0), T::of(170.0)).unwrap();
                    let end = karney.direct(from, T::of(azimuth), distance).unwrap().position;
                    assert_eq!(
                        LatLon::new(end.lat(), end.lon()),
                        Ok(end),
                        "{name} {azimuth} {distance:?}"
                    );
                }
            }
        }
    }
    check::<f64>(1e5);
    check::<f32>(98.0);
}

/// Places so near each other that products of their differences are 0.
#[test]
fn places_next_to_each_other_have_azimuths() {
    fn check<T: Scalar>(least: f64) {
        let karney = Karney::<T>::new(ellipsoid("wgs84")).unwrap();
        for lat in [-75.585_94, 0.0, 30.0, 75.585_94, 90.0] {
            for east in [least, 3.0 * least, 100.0 * least] {
                let [from, to] = [0.0, east].map(|lon| LatLon::new(T::of(lat), T::of(lon)).unwrap());
                for line in [karney.solve(from, to).inverse, karney.inverse(from, to).unwrap()] {
                    assert!(line.distance.into() < 1e-30, "{lat} {east:e}: {line:?}");
                    assert!(
                        line.azimuth1.into().abs() <= 180.0 && line.azimuth2.into().abs() <= 180.0,
                        "{line:?}"
                    );
                }
            }
        }
    }
    check::<f64>(5e-324);
    check::<f32>(1.4e-45);
}

/// Opposite places next to the equator of an ellipsoid slightly longer than wide: along it, where the azimuth cannot be told.
#[test]
fn opposite_places_of_a_prolate_equator() {
    fn check<T: Scalar>(flattenings: [f64; 3], lat: f64, allowed: f64) {
        for f in flattenings {
            let ellipsoid = Ellipsoid::new(T::of(6.4e6), T::of(f)).unwrap();
            let karney = Karney::new(ellipsoid).unwrap();
            for (lat1, lat2) in [(0.0, lat), (-lat, 2.0 * lat), (3.0 * lat, 3.0 * lat)] {
                let from = LatLon::new(T::of(lat1), T::of(-180.0)).unwrap();
                let to = LatLon::new(T::of(lat2), T::ZERO).unwrap();
                let error = (karney.solve(from, to).inverse.distance.into() - std::f64::consts::PI * 6.4e6).abs();
                assert!(error <= allowed, "{f:e} {lat1:e} {lat2:e}: {error:e}");
            }
        }
    }
    check::<f64>([-1e-5, -2.4e-6, -5e-7], 2f64.powi(-57), 4e-9);
    check::<f32>([-1e-6, -5.9e-8, -2e-8], 2f64.powi(-38), 2.0);
}

/// Corners around a place, and the same polygon by GeographicLib.
fn polygons(corners: &[(f64, f64)]) -> [[f64; 2]; 2] {
    let area = Area::<f64>::new(ellipsoid("wgs84")).unwrap();
    let mut ours = area.polygon();
    let wgs84 = Theirs::wgs84();
    let mut theirs = TheirPolygon::new(&wgs84, Winding::CounterClockwise);
    for &(lat, lon) in corners {
        ours.add(LatLon::new(lat, lon).unwrap());
        theirs.add_point(lat, lon);
    }
    let (perimeter, signed, _) = theirs.compute(true);
    [[ours.area(), ours.perimeter()], [signed, perimeter]]
}

#[test]
fn polygons_are_those_of_geographiclib() {
    let mut rng = fastrand::Rng::with_seed(8);
    for _ in 0..2000 {
        let (lat, lon) = (180.0 * rng.f64() - 90.0, 360.0 * rng.f64() - 180.0);
        let size = 10f64.powf(-4.0 * rng.f64()) * 40.0;
        let count = rng.usize(1..9);
        let corners: Vec<_> = (0..count)
            .map(|i| {
                let angle = std::f64::consts::TAU * (i as f64 + 0.3 * rng.f64()) / count as f64;
                (
                    (lat + size * angle.sin()).clamp(-90.0, 90.0),
                    lon + size * angle.cos() * 2.0,
                )
            })
            .collect();
        let [ours, theirs] = polygons(&corners);
        assert!((ours[0] - theirs[0]).abs() < 0.5, "{corners:?}: {ours:?} {theirs:?}");
        assert!((ours[1] - theirs[1]).abs() < 1e-7, "{corners:?}: {ours:?} {theirs:?}");
    }
    // Around both poles, either way, and over the antimeridian.
    for corners in [
        vec![(80.0, 0.0), (80.0, 90.0), (80.0, 180.0), (80.0, -90.0)],
        vec![(80.0, 0.0), (80.0, -90.0), (80.0, 180.0), (80.0, 90.0)],
        vec![(-80.0, 10.0), (-80.0, 130.0), (-80.0, -110.0)],
        vec![(10.0, 170.0), (10.0, -170.0), (-10.0, -170.0), (-10.0, 170.0)],
        vec![(0.0, 0.0), (0.0, 90.0), (90.0, 0.0)],
        // Twice around, and edges over either pole.
        [0.0, 120.0, -120.0, 0.0, 120.0, -120.0].map(|lon| (60.0, lon)).to_vec(),
        [0.0, -120.0, 120.0, 0.0, -120.0, 120.0].map(|lon| (60.0, lon)).to_vec(),
        vec![(80.0, 0.0), (80.0, 180.0), (70.0, 90.0)],
        vec![(-80.0, 0.0), (-80.0, 180.0), (-70.0, 90.0)],
        vec![(70.0, 180.0), (80.0, 0.0), (70.0, 90.0)],
        vec![(-70.0, 180.0), (-80.0, 0.0), (-70.0, 90.0)],
        vec![(5.0, 5.0)],
        vec![],
    ] {
        let [ours, theirs] = polygons(&corners);
        assert!(
            (ours[0] - theirs[0]).abs() < 0.5 && (ours[1] - theirs[1]).abs() < 1e-7,
            "{corners:?}: {ours:?} {theirs:?}"
        );
    }
}

/// Random and hard pairs: uniform, near the antipode of the first, near it, near poles and equator.
fn pair(rng: &mut fastrand::Rng) -> [f64; 4] {
    let signed = |rng: &mut fastrand::Rng| 2.0 * rng.f64() - 1.0;
    let tiny = |rng: &mut fastrand::Rng| 10f64.powf(-12.0 * rng.f64()) * (2.0 * rng.f64() - 1.0);
    let lat = match rng.u8(0..6) {
        0 => tiny(rng),
        1 => 90.0 - tiny(rng).abs(),
        _ => signed(rng).asin().to_degrees(),
    };
    let lon = 180.0 * signed(rng);
    let (lat2, lon2) = match rng.u8(0..6) {
        0 | 1 => (-lat + tiny(rng), lon + 180.0 + tiny(rng)),
        2 => (lat + tiny(rng), lon + tiny(rng)),
        3 => (signed(rng).asin().to_degrees(), lon + 180.0 + tiny(rng)),
        _ => (signed(rng).asin().to_degrees(), 180.0 * signed(rng)),
    };
    [lat, lon, lat2.clamp(-90.0, 90.0), lon2]
}

/// The largest difference of a distance from GeographicLib's, and between which places.
fn against_geographiclib(pairs: u64, seed: u64) -> (f64, [f64; 4]) {
    let karney = Karney::<f64>::new(ellipsoid("wgs84")).unwrap();
    let wgs84 = Theirs::wgs84();
    let mut rng = fastrand::Rng::with_seed(seed);
    let mut worst = (0.0, [0.0; 4]);
    for _ in 0..pairs {
        let [lat1, lon1, lat2, lon2] = pair(&mut rng);
        let (from, to) = (LatLon::new(lat1, lon1).unwrap(), LatLon::new(lat2, lon2).unwrap());
        let theirs: f64 = wgs84.inverse(from.lat(), from.lon(), to.lat(), to.lon());
        let ways = [karney.solve(from, to).inverse, karney.inverse(from, to).unwrap()];
        let [one, other] = ways.map(|way| (way.distance - theirs).abs());
        let difference = if one > other { one } else { other };
        if difference.is_nan() || difference > worst.0 {
            worst = (difference, [from.lat(), from.lon(), to.lat(), to.lon()]);
        }
    }
    worst
}

#[test]
fn distances_are_those_of_geographiclib() {
    let (difference, places) = against_geographiclib(200_000, 1);
    assert!(difference < 2e-8, "{difference:e} at {places:?}");
}

/// `cargo test --release --test geodesic -- --ignored --nocapture`: some minutes on two cores.
#[test]
#[ignore = "10⁸ pairs"]
fn distances_are_those_of_geographiclib_ten_to_the_eight() {
    let all = testkit::parallel::map(0..1000, |seed| against_geographiclib(100_000, seed));
    let worst = all
        .into_iter()
        .reduce(|a, b| if a.0 >= b.0 || a.0.is_nan() { a } else { b });
    let (difference, places) = worst.unwrap();
    println!("largest difference from GeographicLib: {difference:e} m at {places:?}");
    assert!(difference < 2e-8, "{difference:e} at {places:?}");
}

/// GeographicLib's GeodSolve82, and wherever else: between coincident places nothing is scaled.
#[test]
fn the_scales_between_coincident_places_are_one() {
    fn scales<T: Scalar>() {
        let karney = Karney::<T>::new(Ellipsoid::WGS84).unwrap();
        for lat in [0.0, 20.001, -45.0, 89.9, 90.0] {
            let here = LatLon::new(T::of(lat), T::of(7.0)).unwrap();
            let whole = karney.solve(here, here);
            let found = [whole.scale12, whole.scale21, whole.reduced_length, whole.arc].map(Into::into);
            assert_eq!(found, [1.0, 1.0, 0.0, 0.0], "{lat} in {}", T::NAME);
        }
    }
    scales::<f64>();
    scales::<f32>();
}
