//! Rhumb lines against truth of 25 digits, and at poles and half circles.

use terrella::geodesic::GeodesicError;
use terrella::route::Rhumb;
use terrella::{Ellipsoid, LatLon, Real};
use testkit::Worst;
use testkit::truth::{Row, Scalar, Truth};

fn surface<T: Scalar>(row: Row<'_>) -> Rhumb<T> {
    let [a, f] = match row.text("ellipsoid") {
        "wgs84" => [6_378_137.0, 1.0 / 298.257_223_563],
        "oblate10" => [6.4e6, 0.1],
        "prolate150" => [6.4e6, -1.0 / 150.0],
        other => panic!("{other}"),
    };
    Rhumb::new(Ellipsoid::new(T::of(a), T::of(f)).unwrap()).unwrap()
}

fn place<T: Real>(lat: T, lon: T) -> LatLon<T> {
    LatLon::new(lat, lon).unwrap()
}

const HALF_OF_THE_EARTH: f64 = 2.55e14;

/// The largest errors of distance, azimuth times distance, and area; of lines below 1 km, relative ones.
fn inverse<T: Scalar>(claimed: [f64; 3], of_short: [f64; 2]) {
    let truth = Truth::read("rhumb_inverse");
    let mut worst = [(); 5].map(|()| Worst::default());
    for row in truth.exact_in::<T>(&["lat1", "lon1", "lat2", "lon2"]) {
        let rhumb = surface::<T>(row);
        let (from, to) = (
            place(row.input("lat1"), row.input("lon1")),
            place(row.input("lat2"), row.input("lon2")),
        );
        let line = rhumb.inverse(from, to);
        let distance = row.value("distance");
        let across = row.error("azimuth", line.azimuth).to_radians() * distance;
        let errors = [
            row.error("distance", line.distance),
            across,
            row.error("area", line.area) / HALF_OF_THE_EARTH,
        ];
        for (worst, error) in worst.iter_mut().zip(errors) {
            worst.add(error);
        }
        if distance > 0.0 && distance < 1000.0 {
            worst[3].add(errors[0] / distance);
            worst[4].add(across / distance);
        }
        assert_eq!(rhumb.distance(from, to), line.distance);
    }
    let worst = worst.map(|worst| worst.value());
    println!("{} {worst:?}", T::NAME);
    for (worst, claimed) in worst.into_iter().zip(claimed.into_iter().chain(of_short)) {
        assert!(worst <= claimed, "{worst:e} {claimed:e}");
    }
}

#[test]
fn inverse_is_as_accurate_as_claimed() {
    inverse::<f64>([9e-9, 9e-9, 5e-16], [1e-15, 1e-15]);
    inverse::<f32>([10.0, 7.0, 3e-7], [6e-7, 6e-7]);
}

fn direct<T: Scalar>(claimed: f64, of_area: f64) {
    let truth = Truth::read("rhumb_direct");
    let (mut worst, mut area) = (Worst::default(), Worst::default());
    for row in truth.exact_in::<T>(&["lat1", "lon1", "azimuth", "distance"]) {
        let from = place(row.input("lat1"), row.input("lon1"));
        let end = surface::<T>(row)
            .direct(from, row.input("azimuth"), row.input("distance"))
            .unwrap();
        let turned = row.value("turned");
        let lon: f64 = end.longitude.into();
        let start = row.value("lon1");
        // Whole turns aside, they agree in what is turned.
        let east = (lon - start - turned) * row.value("lat2").to_radians().cos();
        worst.add(row.error("lat2", end.position.lat()).hypot(east).to_radians() * 6.4e6);
        area.add(row.error("area", end.area) / testkit::maximum(HALF_OF_THE_EARTH, row.value("area").abs()));
        let wrapped: f64 = end.position.lon().into();
        let turns = (lon - wrapped) / 360.0;
        assert!(
            (turns - turns.round()).abs() <= 2.0 * T::EPSILON.into() * (1.0 + turns.abs()),
            "{lon} {wrapped}"
        );
    }
    let (worst, area) = (worst.value(), area.value());
    println!("{} {worst:e} {area:e}", T::NAME);
    assert!(worst <= claimed && area <= of_area, "{worst:e} {area:e}");
}

#[test]
fn direct_is_as_accurate_as_claimed() {
    direct::<f64>(5e-9, 2e-15);
    direct::<f32>(12.0, 1e-6);
}

fn earth() -> Rhumb<f64> {
    Rhumb::new(Ellipsoid::WGS84).unwrap()
}

/// `RhumbSolve -i -p 9` of GeographicLib 2.1.2; its longitudes of 180 go to the side of their sign.
#[test]
fn agrees_with_geographiclib() {
    for ([lat1, lon1, lat2, lon2], [azimuth, distance, area]) in [
        (
            [40.6, -73.8, 51.6, -0.5],
            [77.768_389_710_255_68, 5_771_083.383_328_028, 37_395_209_100_030.38],
        ),
        (
            [0.0, 0.0, 10.0, 180.0],
            [86.825_072_428_2, 19_966_834.131_55, 11_079_315_437_338.0],
        ),
        (
            [0.0, 0.0, 10.0, -180.0],
            [-86.825_072_428_2, 19_966_834.131_55, -11_079_315_437_338.0],
        ),
        (
            [0.0, 10.0, 10.0, -170.0],
            [-86.825_072_428_2, 19_966_834.131_55, -11_079_315_437_338.0],
        ),
        ([0.0, 0.0, 0.0, 90.0], [90.0, 10_018_754.171_394_62, 0.0]),
        (
            [60.0, 0.0, 60.0, 180.0],
            [90.0, 10_044_000.283_038_499, 110_308_480_173_570.2],
        ),
    ] {
        let line = earth().inverse(place(lat1, lon1), place(lat2, lon2));
        assert!((line.azimuth - azimuth).abs() < 1e-10, "{line:?}");
        assert!((line.distance - distance).abs() < 1e-5, "{line:?}");
        assert!((line.area - area).abs() < 1.0, "{line:?}");
    }
}

/// A tenth of the area between pole and equator belongs to 36 degrees of longitude.
#[test]
fn poles_follow_the_rules() {
    fn hold<T: Scalar>() {
        let rhumb = Rhumb::<T>::new(Ellipsoid::WGS84).unwrap();
        let at = |lat: f64, lon: f64| place(T::of(lat), T::of(lon));
        let quarter = rhumb.inverse(at(0.0, 7.0), at(90.0, 7.0)).distance;
        let tolerance = 4.0 * T::EPSILON.into();
        let near = |a: T, b: f64| (Into::<f64>::into(a) / b - 1.0).abs() <= tolerance;
        assert!(near(quarter, 10_001_965.729_312_72), "{quarter}");
        let tenth = 510_065_621_724_088.44 / 20.0;
        for (from, to, azimuth, distance, area) in [
            (at(0.0, 7.0), at(90.0, 43.0), 0.0, quarter, tenth),
            (at(90.0, 43.0), at(0.0, 7.0), 180.0, quarter, -tenth),
            (at(0.0, 7.0), at(-90.0, 43.0), 180.0, quarter, -tenth),
            (at(-90.0, 7.0), at(90.0, 43.0), 0.0, quarter + quarter, 0.0),
            (at(90.0, 7.0), at(-90.0, 43.0), 180.0, quarter + quarter, 0.0),
            (at(90.0, 7.0), at(90.0, 43.0), 0.0, T::ZERO, tenth),
            (at(-90.0, 7.0), at(-90.0, 43.0), 0.0, T::ZERO, -tenth),
            (at(30.0, 7.0), at(30.0, 7.0), 0.0, T::ZERO, 0.0),
            (at(0.0, 7.0), at(0.0, 7.0), 0.0, T::ZERO, 0.0),
        ] {
            let line = rhumb.inverse(from, to);
            assert_eq!(line.azimuth, T::of(azimuth), "{from} {to}");
            assert!(
                line.distance == distance || near(line.distance, distance.into()),
                "{from} {to} {line:?}"
            );
            assert!(
                line.area == T::of(area) || near(line.area, area),
                "{from} {to} {line:?}"
            );
        }
        // To the pole and no further; away from it on its own meridian.
        let end = rhumb.direct(at(0.0, 7.0), T::ZERO, quarter).unwrap().position;
        let short: f64 = (T::of(90.0) - end.lat()).into();
        assert!(
            (0.0..1e3 * tolerance).contains(&short) && end.lon() == T::of(7.0),
            "{end}"
        );
        let end = rhumb.direct(at(90.0, 7.0), T::of(135.0), quarter).unwrap();
        assert_eq!(end.longitude, T::of(7.0));
        let refused = rhumb.direct(at(0.0, 7.0), T::of(60.0), T::of(2.1e7)).unwrap_err();
        let GeodesicError::TooFar { distance, limit } = refused else {
            panic!("{refused}")
        };
        assert!(
            distance == T::of(2.1e7) && near(limit, 2.0 * 10_001_965.729_312_72),
            "{limit}"
        );
        let refused = rhumb.direct(at(0.0, 7.0), T::of(60.0), T::of(-2.1e7)).unwrap_err();
        let GeodesicError::TooFar { limit, .. } = refused else {
            panic!("{refused}")
        };
        assert!(near(limit, -2.0 * 10_001_965.729_312_72), "{limit}");
        assert!(rhumb.direct(at(90.0, 7.0), T::ZERO, T::of(100.0)).is_err());
    }
    hold::<f64>();
    hold::<f32>();
}

/// georust/geo, issue 1152: latitudes beyond a pole; erkir, issue 12: a midpoint beside both ends, on a line
/// that is nearly a parallel; turf, issue 770: a line over 180 degrees.
#[test]
fn what_went_wrong_elsewhere() {
    let rhumb = earth();
    for step in 0..1000 {
        let distance = f64::from(step) * 1e5;
        match rhumb.direct(place(0.0, 0.0), 45.0, distance) {
            Ok(end) => assert!(end.position.lat().abs() <= 90.0 && end.position.lon().abs() <= 180.0),
            Err(why) => assert!(distance > 14_144_000.0 && matches!(why, GeodesicError::TooFar { .. })),
        }
    }
    let [left, right] = [
        place(57.124_907_085_007_038, 11.000_396_816_127_818),
        place(57.124_907_085_007_429, 11.166_426_363_946_812),
    ];
    let line = rhumb.line_between(left, right);
    let middle = line.at(line.length() / 2.0).unwrap().position;
    assert!((middle.lon() - 11.083_411_590_037_315).abs() < 1e-12, "{middle}");
    let end = rhumb.direct(place(16.5, -179.5), -90.0, 1e5).unwrap();
    assert!(end.longitude < -180.0 && end.position.lon() > 179.5, "{end:?}");
    assert_eq!(end.position.lat(), 16.5);
}

/// Far round the axis: the longitude runs on, and is what the mean radius of the parallels says.
#[test]
fn longitudes_run_on() {
    let end = earth().direct(place(0.0, 170.0), 90.0, 1e9).unwrap();
    let turned = (1e9 / 6_378_137.0_f64).to_degrees();
    assert!((end.longitude - 170.0 - turned).abs() < 1e-11, "{end:?}");
    assert!((end.area).abs() == 0.0);
}

#[test]
fn a_line_ends_at_its_second_place() {
    let mut rng = fastrand::Rng::with_seed(20);
    let mut worst = Worst::default();
    for f in [1.0 / 298.257_223_563, 0.1, -1.0 / 9.0, 0.0] {
        let rhumb = Rhumb::new(Ellipsoid::new(6.4e6, f).unwrap()).unwrap();
        for _ in 0..2000 {
            let [from, to] = [(); 2].map(|()| place(180.0 * rng.f64() - 90.0, 360.0 * rng.f64() - 180.0));
            let line = rhumb.line_between(from, to);
            assert_eq!((line.start(), line.length()), (from, rhumb.distance(from, to)));
            let end = line.at(line.length()).unwrap();
            let east = (end.longitude - to.lon()).rem_euclid(360.0);
            let east = testkit::minimum(east, 360.0 - east) * to.lat().to_radians().cos();
            worst.add((end.position.lat() - to.lat()).hypot(east).to_radians() * 6.4e6);
            let there = rhumb.inverse(from, to);
            assert!((line.azimuth() - there.azimuth).abs() < 1e-13, "{from} {to} {there:?}");
            assert!((end.area - there.area).abs() < 1e3, "{from} {to} {end:?} {there:?}");
        }
    }
    let worst = worst.value();
    println!("{worst:e}");
    assert!(worst < 2e-8, "{worst:e}");
}

#[test]
fn flattenings_and_numbers_are_refused() {
    for f in [0.11, -0.12, 0.5] {
        let refused = Rhumb::new(Ellipsoid::new(1.0, f).unwrap()).unwrap_err();
        assert_eq!(refused.0, f);
    }
    let rhumb = earth();
    let here = place(1.0, 2.0);
    assert!(matches!(rhumb.direct(here, f64::NAN, 1.0), Err(GeodesicError::Azimuth(azimuth)) if azimuth.is_nan()));
    assert_eq!(
        rhumb.direct(here, 1.0, f64::INFINITY),
        Err(GeodesicError::Distance(f64::INFINITY))
    );
    assert_eq!(
        rhumb.line(here, f64::INFINITY).unwrap_err(),
        GeodesicError::Azimuth(f64::INFINITY)
    );
    assert!(
        rhumb
            .direct(here, 90.0, 1e308)
            .is_ok_and(|end| end.longitude.is_finite())
    );
    assert_eq!(rhumb.ellipsoid(), Ellipsoid::WGS84);
}
