//! Arcs and circles: their lengths against 22 digits, places along and beside them.

use fastrand::Rng;
use terrella::geodesic::{Area, Geodesic, GeodesicError, Karney};
use terrella::route::{Arc, InvalidArc, Turn};
use terrella::{Ellipsoid, LatLon};
use testkit::Worst;
use testkit::truth::{Scalar, Truth};

fn earth<T: Scalar>() -> Karney<T> {
    Karney::new(Ellipsoid::WGS84).unwrap()
}

fn at<T: Scalar>(lat: f64, lon: f64) -> LatLon<T> {
    LatLon::new(T::of(lat), T::of(lon)).unwrap()
}

#[test]
fn lengths_are_as_accurate_as_claimed() {
    let (truth, earth) = (Truth::read("arc"), earth());
    let mut worst = Worst::default();
    for row in truth.exact_in::<f64>(&["lat", "lon", "radius", "azimuth", "sweep"]) {
        let value = |column| row.value(column);
        let centre = at(value("lat"), value("lon"));
        for sign in [1.0, -1.0] {
            let start = value("azimuth") + if sign < 0.0 { value("sweep") } else { 0.0 };
            let arc = Arc::new(&earth, centre, value("radius"), start, sign * value("sweep")).unwrap();
            let length = arc.length();
            let end = if sign < 0.0 { arc.start() } else { arc.end() };
            let apart = earth.distance(end, at(value("lat2"), value("lon2"))).unwrap();
            // What the rounding of start + sweep turns at the start.
            let rounding = if sign < 0.0 { 1e-13 * value("radius") } else { 0.0 };
            assert!(apart <= 2e-8 + rounding, "{arc:?} {apart}");
            worst.add(row.error("length", length) / (2e-9 + 1e-15 * length));
        }
    }
    println!("arc length f64 {worst:?}");
    assert!(worst.value() <= 1.0, "{worst:?}");
}

#[test]
fn lengths_in_single_precision() {
    let (double, single) = (earth::<f64>(), earth::<f32>());
    let (mut rng, mut worst, mut beside) = (Rng::with_seed(1), Worst::default(), Worst::default());
    for _ in 0..2000 {
        let [lat, lon, azimuth, sweep] =
            [90.0, 180.0, 180.0, 360.0].map(|most| f64::from((most * (2.0 * rng.f64() - 1.0)) as f32));
        let radius = f64::from(10f32.powf(2.0 + 4.5 * rng.f32()));
        let of = |x: f64| x as f32;
        let arc = Arc::new(&single, at(lat, lon), of(radius), of(azimuth), of(sweep)).unwrap();
        let exact = Arc::new(&double, at(lat, lon), radius, azimuth, sweep).unwrap();
        worst.add((f64::from(arc.length()) / exact.length() - 1.0).abs());
        let end = arc.at(arc.length() / 2.0).unwrap().position;
        let end = at(end.lat().into(), end.lon().into());
        beside.add(exact.distance(end) / (7e-7 * radius + 1.0));
    }
    println!("arc length f32 {worst:?}, beside {beside:?}");
    assert!(worst.value() <= 1e-6 && beside.value() <= 1.0);
}

/// Along the arc distances add up, and places are on it.
#[test]
fn along_and_beside() {
    let earth = earth::<f64>();
    let (mut rng, mut worst) = (Rng::with_seed(2), Worst::default());
    for _ in 0..500 {
        let centre = at(180.0 * rng.f64() - 90.0, 360.0 * rng.f64() - 180.0);
        let radius = 10f64.powf(1.0 + 5.9 * rng.f64());
        let (azimuth, sweep) = (360.0 * rng.f64(), 720.0 * rng.f64() - 360.0);
        let arc = Arc::new(&earth, centre, radius, azimuth, sweep).unwrap();
        let (length, part) = (arc.length(), rng.f64());
        let there = arc.at(length * part).unwrap();
        let first = Arc::new(&earth, centre, radius, azimuth, {
            let way = earth.inverse(centre, there.position).unwrap();
            let turn = (way.azimuth1 - azimuth) * sweep.signum();
            sweep.signum() * turn.rem_euclid(360.0)
        });
        worst.add((first.unwrap().length() - length * part).abs() / (2e-8 + 1e-14 * length));
        assert!(arc.abeam(there.position) || !(1e-6..=1.0 - 1e-6).contains(&part));
        assert!(arc.distance(there.position) < 2e-8);
        // The azimuth of travel is that to a place a little farther.
        let step = radius * 1e-4;
        let part = testkit::minimum(part, 0.99);
        let there = arc.at(length * part).unwrap();
        let farther = arc.at(length * part + step).unwrap().position;
        let way = earth.inverse(there.position, farther).unwrap();
        let turn = (way.azimuth1 - there.azimuth + 540.0).rem_euclid(360.0) - 180.0;
        assert!(turn.abs() < 0.01, "{turn} {there:?} {farther:?}");
        assert!((way.distance - step).abs() < 1e-6 * step + 2e-8);
        // To the right is positive.
        let right = earth
            .direct(there.position, there.azimuth + 90.0, radius * 0.1)
            .unwrap()
            .position;
        assert!((arc.cross_track(right) - radius * 0.1).abs() < 3e-8, "{arc:?}");
        assert!((arc.distance(right) - radius * 0.1).abs() < 3e-8 || !arc.abeam(right));
        // Past an end it is the end that is near.
        if sweep.abs() < 300.0 {
            let past = arc.at(length + 0.1 * radius).unwrap().position;
            let to_end = earth.distance(past, arc.end()).unwrap();
            assert!((arc.distance(past) - to_end).abs() < 1e-8 && !arc.abeam(past));
        }
    }
    println!("along {worst:?}");
    assert!(worst.value() <= 1.0, "{worst:?}");
}

/// ARINC 424's RF: two fixes at a right angle from the centre, by either turn.
#[test]
fn legs_between_fixes() {
    let earth = earth::<f64>();
    let centre = at(47.2, 11.4);
    let [north, east] = [0.0, 90.0].map(|azimuth| earth.direct(centre, azimuth, 5_000.0).unwrap().position);
    for (turn, from, to, sweep) in [
        (Turn::Right, north, east, 90.0),
        (Turn::Left, north, east, -270.0),
        (Turn::Right, east, north, 270.0),
        (Turn::Left, east, north, -90.0),
        (Turn::Left, east, east, 0.0),
    ] {
        let leg = Arc::between(&earth, centre, 5_000.0, from, to, turn).unwrap();
        assert!((leg.sweep() - sweep).abs() < 1e-9, "{turn:?} {sweep} {}", leg.sweep());
        assert!(earth.distance(leg.start(), from).unwrap() < 1e-8 && earth.distance(leg.end(), to).unwrap() < 1e-8);
        assert_eq!((leg.centre(), leg.radius()), (centre, 5_000.0));
    }
}

#[test]
fn circles_keep_their_tolerance() {
    let earth = earth::<f64>();
    let area = Area::new(Ellipsoid::WGS84).unwrap();
    let mut rng = Rng::with_seed(3);
    for (radius, tolerance) in [(1e3, 1.0), (1e5, 10.0), (5e6, 1e3), (10.0, 100.0), (9e6, 5e4)] {
        for _ in 0..20 {
            let centre = at(180.0 * rng.f64() - 90.0, 360.0 * rng.f64() - 180.0);
            let circle = Arc::circle(&earth, centre, radius).unwrap();
            let corners: Vec<_> = circle.corners(tolerance).unwrap().collect();
            let mut polygon = area.polygon();
            corners.iter().for_each(|&corner| polygon.add(corner));
            assert!(polygon.area() > 0.0 && corners.len() >= 3);
            let mut worst = Worst::default();
            for (i, &from) in corners.iter().enumerate() {
                let line = earth.inverse(from, corners[(i + 1) % corners.len()]).unwrap();
                for part in [0.0, 0.25, 0.5, 0.75] {
                    let place = earth
                        .direct(from, line.azimuth1, line.distance * part)
                        .unwrap()
                        .position;
                    let inward = radius - earth.distance(centre, place).unwrap();
                    assert!(inward > -2e-8, "{inward}");
                    worst.add(inward);
                }
            }
            assert!(worst.value() <= tolerance, "{radius} {tolerance} {worst:?}");
            // Not many times as many as needed.
            assert!(
                radius > 1e6 || corners.len() <= 4 || worst.value() > 0.5 * tolerance,
                "{radius} {tolerance} {worst:?}"
            );
        }
    }
    let part = Arc::new(&earth, at(10.0, 20.0), 1e4, 30.0, 77.0).unwrap();
    let corners: Vec<_> = part.corners(1.0).unwrap().collect();
    assert_eq!(
        (corners.first(), corners.last()),
        (Some(&part.start()), Some(&part.end()))
    );
}

#[test]
fn what_is_no_arc_is_refused() {
    let (earth, centre) = (earth::<f64>(), at(0.0, 0.0));
    let refused = |radius, azimuth, sweep| Arc::new(&earth, centre, radius, azimuth, sweep).unwrap_err();
    for radius in [0.0, -1.0, 1e7, f64::INFINITY] {
        assert_eq!(refused(radius, 0.0, 1.0), InvalidArc::Radius(radius));
    }
    assert!(matches!(refused(f64::NAN, 0.0, 1.0), InvalidArc::Radius(_)));
    assert_eq!(refused(1.0, f64::INFINITY, 1.0), InvalidArc::Azimuth(f64::INFINITY));
    assert_eq!(refused(1.0, 0.0, 361.0), InvalidArc::Sweep(361.0));
    assert!(matches!(refused(1.0, 0.0, f64::NAN), InvalidArc::Sweep(_)));
    let circle = Arc::circle(&earth, centre, 1e3).unwrap();
    for tolerance in [0.0, -1.0, 1e-12, f64::INFINITY] {
        assert_eq!(circle.corners(tolerance).err(), Some(InvalidArc::Tolerance(tolerance)));
    }
    assert!(matches!(circle.at(f64::NAN), Err(GeodesicError::Distance(_))));
    assert!(matches!(circle.at(7e3), Err(GeodesicError::TooFar { .. })));
    let said = [
        InvalidArc::Radius(0.0).to_string(),
        InvalidArc::Azimuth(f64::NAN).to_string(),
        InvalidArc::Sweep(400.0).to_string(),
        InvalidArc::Tolerance(-1.0).to_string(),
    ];
    assert_eq!(
        said,
        [
            "radius 0.0 is not positive, or too long",
            "azimuth NaN is not finite",
            "sweep 400.0 is not in -360 to 360",
            "tolerance -1.0 is not positive, or too small"
        ]
    );
}
