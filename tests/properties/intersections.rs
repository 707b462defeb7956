//! Intersections, and what a line passes.

use terrella::geodesic::Karney;
use terrella::route::{Intersections, Segment};

use testkit::bytes::Bytes;
use testkit::properties;
use testkit::scalar::Scalar;

properties! { intersections_are_on_both intersections_of_segments intersections_within passages waypoints }

fn double<T: Scalar>(value: T) -> f64 {
    value.into()
}

/// How many roundings two nearly coincident lines may be apart where they are said to meet. They meet anywhere, but should be
/// together there: 2600 roundings (4 µm on the Earth) were seen, and are a defect.
const COINCIDENT: f64 = 1e5;

/// An intersection is on both lines, but for rounding; lines in the other order have it in the other order; none from the
/// middle between them is farther than the closest can be.
fn intersections_are_on_both<T: Scalar>(bytes: &mut Bytes<'_>) {
    let ellipsoid = bytes.ellipsoid(-0.1, 0.1);
    let (karney, intersections) = (Karney::new(ellipsoid).unwrap(), Intersections::new(ellipsoid).unwrap());
    let (place1, place2) = bytes.pair::<T>();
    let azimuths = [(); 2].map(|()| bytes.within::<T>(360.0));
    let one = karney.line(place1, azimuths[0]).unwrap();
    let other = karney.line(place2, azimuths[1]).unwrap();
    let met = intersections.closest(&one, &other);
    let there = other.at(met.displacement2).unwrap();
    let here = one.at(met.displacement1).unwrap();
    assert_eq!(here.position, met.position);
    let a = double(ellipsoid.a());
    let gap = double(Segment::new(&karney, here.position, there.position).length()) / a;
    let epsilon = double(T::EPSILON);
    let angle = double(here.azimuth - there.azimuth).to_radians().sin().abs();
    let coincide = angle <= 1e4 * epsilon;
    assert!(
        gap <= if coincide { COINCIDENT } else { 40.0 } * epsilon,
        "{place1:?} {place2:?} {azimuths:?} {met:?}: {gap:e}"
    );
    let sum = |x: T, y: T| (double(x).abs() + double(y).abs()) / a;
    let closest = sum(met.displacement1, met.displacement2);
    assert!(closest <= 3.5, "{place1:?} {place2:?} {azimuths:?} {met:?}");
    let swapped = intersections.closest(&other, &one);
    // Next to a pole azimuths do not tell the angle.
    if !coincide && met.overlap.is_none() && swapped.overlap.is_none() {
        let other_way = sum(swapped.displacement1, swapped.displacement2);
        assert!(
            (other_way - closest).abs() <= 1e3 * epsilon / angle,
            "{met:?} {swapped:?}"
        );
    }
}

/// What two segments have in common is on both, whatever their order and direction.
fn intersections_of_segments<T: Scalar>(bytes: &mut Bytes<'_>) {
    let ellipsoid = bytes.ellipsoid(-0.1, 0.1);
    let (karney, intersections) = (Karney::new(ellipsoid).unwrap(), Intersections::new(ellipsoid).unwrap());
    let (a, b) = bytes.pair::<T>();
    let c = if bytes.flag() {
        bytes.place()
    } else {
        bytes.place_about(a, false)
    };
    let d = if bytes.flag() { a } else { bytes.place() };
    let (one, other) = (Segment::new(&karney, a, b), Segment::new(&karney, c, d));
    let met = intersections.of_segments(&one, &other);
    if let Some(met) = met {
        for (at, segment) in [(met.displacement1, &one), (met.displacement2, &other)] {
            assert!(at >= T::ZERO && at <= segment.length(), "{met:?} {segment:?}");
        }
        let here = one.line().at(met.displacement1).unwrap();
        let there = other.line().at(met.displacement2).unwrap();
        let gap = double(Segment::new(&karney, met.position, there.position).length()) / double(ellipsoid.a());
        let angle = double(here.azimuth - there.azimuth).to_radians().sin().abs();
        let epsilon = double(T::EPSILON);
        assert!(
            gap <= if angle <= 1e4 * epsilon { COINCIDENT } else { 1e3 } * epsilon,
            "{a:?} {b:?} {c:?} {d:?} {met:?} {gap:e}"
        );
    }
    // A shared end is in common.
    if d == a {
        assert!(met.is_some(), "{a:?} {b:?} {c:?}");
        assert!(intersections.of_segments(&other, &one).is_some(), "{a:?} {b:?} {c:?}");
    }
}

/// All that are found are near enough, no more than told, and none is found twice.
fn intersections_within<T: Scalar>(bytes: &mut Bytes<'_>) {
    let ellipsoid = bytes.ellipsoid(-0.1, 0.1);
    let (karney, intersections) = (Karney::new(ellipsoid).unwrap(), Intersections::new(ellipsoid).unwrap());
    let (place1, place2) = bytes.pair::<T>();
    let one = karney.line(place1, bytes.within(360.0)).unwrap();
    let other = karney.line(place2, bytes.within(360.0)).unwrap();
    let distance = ellipsoid.a() * bytes.within::<T>(12.0);
    let origin = [(); 2].map(|()| ellipsoid.a() * bytes.within::<T>(6.0));
    let Ok(all) = intersections.within_of(&one, &other, distance, origin) else {
        assert!(distance < T::ZERO);
        return;
    };
    let most = all.most();
    let found: Vec<_> = all.collect();
    assert!(found.len() as u64 <= most);
    for (i, met) in found.iter().enumerate() {
        let apart = |x: T, y: T| double(met.displacement1 - x).abs() + double(met.displacement2 - y).abs();
        assert!(apart(origin[0], origin[1]) <= double(distance) * (1.0 + 4.0 * double(T::EPSILON)));
        for before in &found[..i] {
            assert!(
                apart(before.displacement1, before.displacement2) > 1e-4 * double(ellipsoid.a()),
                "{before:?} {met:?}"
            );
        }
    }
}

/// What a line passes is ahead, less than a circuit, where it says; no point of the line is farther north.
fn passages<T: Scalar>(bytes: &mut Bytes<'_>) {
    let ellipsoid = bytes.ellipsoid(-0.1, 0.1);
    let karney = Karney::new(ellipsoid).unwrap();
    let (start, azimuth) = (bytes.place::<T>(), bytes.within::<T>(360.0));
    let line = karney.line(start, azimuth).unwrap();
    let circuit = 6.6 * 1.12 * double(ellipsoid.a());
    let epsilon = double(T::EPSILON);
    let (top, bottom) = (line.northernmost(), line.southernmost());
    let at = line.at(ellipsoid.a() * bytes.within::<T>(20.0)).unwrap().position;
    for lat in [start.lat(), at.lat()].map(double) {
        let (low, high) = (double(bottom.point.position.lat()), double(top.point.position.lat()));
        assert!(
            lat <= high + 400.0 * epsilon && lat >= low - 400.0 * epsilon,
            "{start:?} {azimuth} {lat} {low} {high}"
        );
    }
    let parallel = bytes.within::<T>(90.0);
    let met = line.meets_parallel(parallel).unwrap();
    let beyond = double(parallel) > double(top.point.position.lat()) + 400.0 * epsilon;
    assert!(!(beyond && met[0].is_some()), "{start:?} {azimuth} {parallel}");
    let meridian = line.meets_meridian(bytes.within(720.0)).unwrap();
    for passage in [Some(top), Some(bottom), Some(meridian), met[0], met[1]]
        .into_iter()
        .flatten()
    {
        let distance = double(passage.distance);
        assert!((0.0..=circuit).contains(&distance), "{start:?} {azimuth} {passage:?}");
        let there = line.at(passage.distance).unwrap().position;
        let gap = double(Segment::new(&karney, there, passage.point.position).length()) / double(ellipsoid.a());
        // A parallel that is nearly touched is met where the line is within rounding of it.
        assert!(gap <= 40.0 * epsilon.sqrt(), "{start:?} {azimuth} {passage:?} {gap:e}");
    }
    let [lat, lon] = line
        .unrolled(ellipsoid.a() * bytes.within::<T>(50.0))
        .unwrap()
        .map(double);
    assert!(lat.abs() <= 90.0 && lon.is_finite());
}

/// Points go from one end to the other, whatever the step.
fn waypoints<T: Scalar>(bytes: &mut Bytes<'_>) {
    let karney = Karney::new(bytes.ellipsoid(-0.1, 0.1)).unwrap();
    let (from, to) = bytes.pair::<T>();
    let segment = Segment::new(&karney, from, to);
    let step = segment.length() * bytes.within::<T>(1.0).abs();
    for points in [segment.waypoints(step), segment.chords(step)].into_iter().flatten() {
        let told = points.len();
        if told > 200 {
            continue;
        }
        let points: Vec<_> = points.collect();
        assert_eq!(points.len(), told);
        assert_eq!(
            (points[0].distance, points[told - 1].distance),
            (T::ZERO, segment.length())
        );
        assert!(
            points.is_sorted_by(|a, b| a.distance < b.distance),
            "{from:?} {to:?} {step}"
        );
    }
    if let Ok(points) = segment.densified(step) {
        let points: Vec<_> = points.take(300).collect();
        assert_eq!(points[0], [from.lat(), from.lon()]);
    }
    let any = bytes.anything::<T>();
    let _ = (
        segment.waypoints(any),
        segment.chords(any),
        segment.densified(any).map(|mut points| points.nth(3)),
    );
    let _ = (
        segment.fraction(any),
        segment.meets_parallel(any),
        segment.meets_meridian(any),
        segment.line().unrolled(any),
    );
}
