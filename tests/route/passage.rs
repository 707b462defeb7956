//! What a line passes, against truth of 25 digits, and its points.

use terrella::geodesic::{Karney, Line};
use terrella::route::{InvalidStep, Segment};
use terrella::{Ellipsoid, InvalidLatLon, LatLon};
use testkit::Worst;
use testkit::truth::{Scalar, Truth};

use crate::intersection::ellipsoid;

fn degrees_apart(a: f64, b: f64) -> f64 {
    let gap = (a - b).abs() % 360.0;
    testkit::minimum(gap, 360.0 - gap)
}

/// Latitude of the vertex, its distance, parallels, meridians, unrolled longitudes.
fn passages<T: Scalar>(claims: [f64; 5]) {
    let truth = Truth::read("passages");
    let mut worst = [Worst::default(); 5];
    let mut never = 0;
    for row in truth.exact_in::<T>(&["lat1", "lon1", "azi1", "lat2", "lon2"]) {
        let karney = Karney::<T>::new(ellipsoid(row)).unwrap();
        let start = LatLon::new(row.input("lat1"), row.input("lon1")).unwrap();
        let line = karney.line(start, row.input("azi1")).unwrap();
        let degree = 111.7e3;
        let top = line.northernmost();
        worst[0].add(row.error("top_lat", top.point.position.lat()) * degree);
        // The nearer the line is to the equator, the less it says where it is northernmost.
        let sharp = row.value("sin0") * (1.0 - row.value("sin0").powi(2)).sqrt();
        // A vertex behind the start by no more than rounding is the start: its latitude is the right one, too.
        if top.distance > T::ZERO {
            worst[1].add(row.error("top_s", top.distance) * sharp);
            let turn = degrees_apart(top.point.position.lon().into(), row.value("top_lon"));
            worst[1].add(turn * row.value("top_lat").to_radians().cos() * degree * sharp);
        }
        let narrow = |lat: &str| row.value(lat).to_radians().cos() * degree;
        let met = line.meets_parallel(row.input("lat2")).unwrap();
        let expected = row.value("parallel_s");
        assert_eq!(met[0].is_some(), !expected.is_nan(), "{met:?} {expected}");
        if let [Some(first), Some(second)] = met {
            assert!(first.distance <= second.distance && first.point.position.lat() == row.input("lat2"));
            let slope = row.value("parallel_cos").abs();
            worst[2].add(row.error("parallel_s", first.distance) * slope);
            let turn = degrees_apart(first.point.position.lon().into(), row.value("parallel_lon"));
            worst[2].add(turn * narrow("lat2") * slope);
        } else {
            never += 1;
        }
        let met = line.meets_meridian(row.input("lon2")).unwrap();
        let slope = row.value("meridian_sin").abs();
        worst[3].add(row.error("meridian_s", met.distance) * slope);
        worst[3].add(row.error("meridian_lat", met.point.position.lat()) * degree * slope);
        assert_eq!(met.point.position.lon(), row.input("lon2"));
        let [lat, lon] = line.unrolled(T::of(1e8)).unwrap();
        worst[4].add(row.error("unrolled", lon) * Into::<f64>::into(lat).to_radians().cos() * degree);
    }
    assert!(never > 3);
    for ((claim, worst), what) in claims
        .into_iter()
        .zip(worst)
        .zip(["top", "its distance", "parallel", "meridian", "far"])
    {
        println!("{what}: {worst:?}");
        assert!(worst.value() <= claim, "{what}: {worst:?} > {claim}");
    }
}

#[test]
fn passages_are_where_they_are_claimed() {
    passages::<f64>([3e-9, 2e-8, 2e-8, 2e-8, 6e-8]);
}

#[test]
fn passages_are_where_they_are_claimed_in_f32() {
    passages::<f32>([1.0, 12.0, 12.0, 12.0, 30.0]);
}

fn line(karney: &Karney<f64>, [lat, lon, azimuth]: [f64; 3]) -> Line<f64> {
    karney.line(LatLon::new(lat, lon).unwrap(), azimuth).unwrap()
}

#[test]
fn special_lines_have_their_passages() {
    let karney = Karney::new(Ellipsoid::<f64>::WGS84).unwrap();
    let quarter = 10_001_965.729_312_7;
    // A meridian: the pole, its own meridian at the start, any other at the pole ahead.
    let meridian = line(&karney, [0.0, 10.0, 0.0]);
    let top = meridian.northernmost();
    assert!(
        top.point.position.lat() == 90.0 && (top.distance - quarter).abs() < 1e-7,
        "{top:?}"
    );
    assert!((meridian.southernmost().distance - 3.0 * quarter).abs() < 1e-6);
    assert_eq!(meridian.meets_meridian(10.0).unwrap().distance, 0.0);
    for lon in [-170.0, 190.0, 0.0] {
        let met = meridian.meets_meridian(lon).unwrap();
        assert_eq!((met.point.position.lat(), met.distance), (90.0, top.distance), "{lon}");
    }
    let south = line(&karney, [30.0, 10.0, 180.0]).meets_meridian(50.0).unwrap();
    assert_eq!(south.point.position.lat(), -90.0);
    // The pole as a parallel is met by meridians alone.
    assert!(meridian.meets_parallel(90.0).unwrap()[0].is_some_and(|met| (met.distance - quarter).abs() < 1e-7));
    assert_eq!(line(&karney, [0.0, 10.0, 1e-3]).meets_parallel(90.0), Ok([None, None]));
    // The equator.
    let equator = line(&karney, [0.0, 10.0, 90.0]);
    assert_eq!(equator.northernmost().distance, 0.0);
    assert!(equator.meets_parallel(0.0).unwrap()[0].is_some_and(|met| met.distance == 0.0));
    assert_eq!(equator.meets_parallel(1e-9), Ok([None, None]));
    let degree = std::f64::consts::PI / 180.0 * 6_378_137.0;
    assert!((equator.meets_meridian(-10.0).unwrap().distance - 340.0 * degree).abs() < 1e-7);
    let west = line(&karney, [0.0, 10.0, -90.0]).meets_meridian(-10.0).unwrap();
    assert!((west.distance - 20.0 * degree).abs() < 1e-7);
    // From the vertex: at the start, not a circuit later; the parallel is touched.
    for azimuth in [90.0, -90.0] {
        let vertex = line(&karney, [47.3, 10.0, azimuth]);
        assert_eq!(vertex.northernmost().distance, 0.0);
        let [met, none] = vertex.meets_parallel(47.3).unwrap();
        assert!(met.is_some_and(|met| met.distance == 0.0) && none.is_none());
        let [met, none] = vertex.meets_parallel(-47.3).unwrap();
        assert!(met.is_some_and(|met| (met.distance - 2.0 * quarter).abs() < 1e5) && none.is_none());
    }
    // From the pole.
    let polar = line(&karney, [90.0, 10.0, 30.0]);
    assert!(polar.northernmost().distance < 1e-9);
    assert_eq!(polar.meets_parallel(91.0), Err(InvalidLatLon::Latitude(91.0)));
    assert!(matches!(
        polar.meets_meridian(f64::NAN),
        Err(InvalidLatLon::Longitude(_))
    ));
}

#[test]
fn segments_pass_what_lies_on_them() {
    let karney = Karney::new(Ellipsoid::<f64>::WGS84).unwrap();
    let segment =
        |[a, b, c, d]: [f64; 4]| Segment::new(&karney, LatLon::new(a, b).unwrap(), LatLon::new(c, d).unwrap());
    let flight = segment([40.0, 170.0, 40.0, -100.0]);
    let top = flight.northernmost();
    assert!(top.point.position.lat() > 49.0 && (top.distance - flight.length() / 2.0).abs() < 1e-6);
    assert_eq!(flight.southernmost().point.position.lat(), 40.0);
    assert_eq!(flight.meets_parallel(48.0).unwrap().iter().flatten().count(), 2);
    assert_eq!(flight.meets_parallel(39.0).unwrap(), [None, None]);
    assert!(flight.meets_meridian(180.0).unwrap().is_some() && flight.meets_meridian(0.0).unwrap().is_none());
    // Of the two places of the line, only the second is ahead of the start of a rising leg.
    let rising = segment([10.0, 0.0, 60.0, 40.0]);
    let met = rising.meets_parallel(30.0).unwrap();
    assert!(met[0].is_some_and(|met| met.distance < rising.length()) && met[1].is_none());
    assert_eq!(rising.northernmost().point.position, LatLon::new(60.0, 40.0).unwrap());
}

#[test]
fn waypoints_begin_and_end_at_the_places() {
    fn evenly<T: Scalar>() {
        let karney = Karney::new(Ellipsoid::<T>::WGS84).unwrap();
        let [from, to] = [(10.0, 170.0), (-20.0, -150.0)].map(|(a, b)| LatLon::new(T::of(a), T::of(b)).unwrap());
        let segment = Segment::new(&karney, from, to);
        for count in [1, 2, 7, 1000] {
            let points: Vec<_> = segment.parts(count).collect();
            assert_eq!(
                (points.len(), segment.parts(count).len()),
                (count as usize + 1, count as usize + 1)
            );
            assert_eq!(
                (points[0].point.position, points[count as usize].point.position),
                (from, to)
            );
            // A step that is a whole part of the length makes no rest.
            let step = segment.length() / T::whole(count.into());
            assert_eq!(segment.waypoints(step).unwrap().len(), count as usize + 1, "{count}");
        }
        assert_eq!(segment.fraction(T::ONE).unwrap().position, to);
        let nothing = Segment::new(&karney, from, from);
        assert_eq!(nothing.waypoints(T::ONE).unwrap().count(), 1);
        assert_eq!(
            (nothing.parts(5).count(), nothing.densified(T::ONE).unwrap().count()),
            (1, 1)
        );
        assert_eq!(
            segment.waypoints(T::ZERO).err(),
            Some(InvalidStep::NotPositive(T::ZERO))
        );
        assert_eq!(
            segment.waypoints(T::of(0.1)).err(),
            Some(InvalidStep::TooSmall(T::of(0.1)))
        );
        assert!(segment.chords(T::of(f64::NAN)).is_err() && segment.densified(T::of(1e-3)).is_err());
    }
    evenly::<f64>();
    evenly::<f32>();
    let error = InvalidStep::NotPositive(-1.0).to_string();
    assert_eq!(error, "-1.0 is not a positive number of metres");
}

/// How far a place is from a segment, by bisection of the distance's slope near a guess.
fn beside(karney: &Karney<f64>, segment: &Segment<f64>, place: LatLon<f64>, near: f64, width: f64) -> f64 {
    let gap = |s: f64| Segment::new(karney, segment.line().at(s).unwrap().position, place).length();
    let (mut low, mut high) = (
        testkit::maximum(near - width, 0.0),
        testkit::minimum(near + width, segment.length()),
    );
    for _ in 0..60 {
        let (a, b) = (low + (high - low) / 3.0, high - (high - low) / 3.0);
        if gap(a) < gap(b) { high = b } else { low = a }
    }
    gap((low + high) / 2.0)
}

/// Lines that are straight in latitude and longitude, and chords in space, stay within the tolerance.
#[test]
fn dense_lines_keep_the_tolerance() {
    let karney = Karney::new(Ellipsoid::<f64>::WGS84).unwrap();
    let mut rng = fastrand::Rng::with_seed(4);
    let mut share = Worst::default();
    let mut chords = Worst::default();
    for k in 0..12 {
        let mut place = || LatLon::new(89.9 * (2.0 * rng.f64() - 1.0), 360.0 * rng.f64() - 180.0).unwrap();
        let segment = Segment::new(&karney, place(), place());
        let tolerance = [500.0, 3e3, 3e4][k % 3];
        let points: Vec<_> = segment.densified(tolerance).unwrap().collect();
        let starts: Vec<_> = points
            .iter()
            .map(|&[lat, lon]| LatLon::new(lat, lon).unwrap())
            .collect();
        assert_eq!(
            [starts[0], *starts.last().unwrap()].map(|p| p.lat()),
            segment.ends().map(|p| p.lat())
        );
        let mut along = 0.0;
        for (ends, corners) in points.windows(2).zip(starts.windows(2)) {
            let length = Segment::new(&karney, corners[0], corners[1]).length();
            for part in [0.1, 0.3, 0.5, 0.7, 0.9] {
                let at = |i: usize| ends[0][i] + (ends[1][i] - ends[0][i]) * part;
                let on_map = LatLon::new(at(0), at(1)).unwrap();
                share.add(beside(&karney, &segment, on_map, along + length * part, length) / tolerance);
            }
            along += length;
        }
        let parts: Vec<_> = segment.chords(tolerance).unwrap().collect();
        for pair in parts.windows(2) {
            let ecef = |s: f64| {
                let point = terrella::Geodetic::new(segment.line().at(s).unwrap().position, 0.0).unwrap();
                let point = Ellipsoid::WGS84.to_ecef(point);
                [point.x(), point.y(), point.z()]
            };
            let [a, m, b] = [
                pair[0].distance,
                (pair[0].distance + pair[1].distance) / 2.0,
                pair[1].distance,
            ]
            .map(ecef);
            let middle: f64 = (0..3).map(|i| (m[i] - (a[i] + b[i]) / 2.0).powi(2)).sum();
            chords.add(middle.sqrt() / tolerance);
        }
    }
    println!("{share:?} {chords:?}");
    assert!(share.value() <= 1.0, "{share:?}");
    assert!(chords.value() <= 1.0 && chords.value() > 0.9, "{chords:?}");
}
