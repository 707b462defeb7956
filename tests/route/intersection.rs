//! Intersections against truth of 25 digits, and cases in which others went wrong.

use terrella::geodesic::{GeodesicError, Karney, Line};
use terrella::route::{Intersection, Intersections, Overlap, Segment};
use terrella::{Ellipsoid, LatLon};
use testkit::Worst;
use testkit::truth::{Row, Scalar, Truth};

pub fn ellipsoid<T: Scalar>(row: Row<'_>) -> Ellipsoid<T> {
    match row.text("ellipsoid") {
        "wgs84" => Ellipsoid::WGS84,
        "oblate" => Ellipsoid::new(T::of(6_378_137.0), T::of(0.1)).unwrap(),
        _ => Ellipsoid::new(T::of(6_378_137.0), T::of(-0.1)).unwrap(),
    }
}

fn place<T: Scalar>(lat: f64, lon: f64) -> LatLon<T> {
    LatLon::new(T::of(lat), T::of(lon)).unwrap()
}

fn apart<T: Scalar>(met: &Intersection<T>) -> f64 {
    let [x, y] = [met.displacement1, met.displacement2].map(Into::<f64>::into);
    x.abs() + y.abs()
}

/// Displacements are right to a claim in metres by distance, times the sine of the angle.
fn closest<T: Scalar>(claims: [(f64, f64); 2]) {
    let truth = Truth::read("intersect");
    let mut worst = [Worst::default(); 2];
    for row in truth.exact_in::<T>(&["lat1", "lon1", "azi1", "lat2", "lon2", "azi2"]) {
        let ellipsoid = ellipsoid::<T>(row);
        let karney = Karney::new(ellipsoid).unwrap();
        let line = |[lat, lon, azimuth]: [&str; 3]| {
            let place = LatLon::new(row.input(lat), row.input(lon)).unwrap();
            karney.line(place, row.input(azimuth)).unwrap()
        };
        let (one, other) = (line(["lat1", "lon1", "azi1"]), line(["lat2", "lon2", "azi2"]));
        let met = Intersections::new(ellipsoid).unwrap().closest(&one, &other);
        let sine = row.value("sine");
        if sine < 32.0 * T::EPSILON.into() {
            continue; // lines that the scalar cannot tell apart
        }
        assert_eq!(met.overlap, None);
        let errors = [row.error("x", met.displacement1), row.error("y", met.displacement2)];
        let north = row.error("lat", met.position.lat()) * 111.7e3;
        for error in errors.into_iter().chain([north]) {
            let far = row.value("x").abs() + row.value("y").abs() > 1e6;
            if worst[usize::from(far)].add(error * sine) {
                println!("{:?} {far} {:e} {met:?}", row.text("class"), error * sine);
            }
        }
    }
    for ((_, claim), worst) in claims.iter().zip(worst) {
        assert!(worst.value() <= *claim, "{worst:?} > {claim}");
    }
}

#[test]
fn closest_is_where_it_is_claimed() {
    closest::<f64>([(1e6, 1.5e-8), (2.1e7, 3e-8)]);
}

#[test]
fn closest_is_where_it_is_claimed_in_f32() {
    closest::<f32>([(1e6, 4.0), (2.1e7, 15.0)]);
}

fn earth() -> (Karney<f64>, Intersections<f64>) {
    (
        Karney::new(Ellipsoid::WGS84).unwrap(),
        Intersections::new(Ellipsoid::WGS84).unwrap(),
    )
}

/// A line's start, its point far along it and the direction there: the same line, either way.
#[test]
fn coincident_lines_are_told() {
    fn told<T: Scalar>(tolerance: f64) {
        let karney = Karney::new(Ellipsoid::<T>::WGS84).unwrap();
        let intersections = Intersections::new(Ellipsoid::<T>::WGS84).unwrap();
        for (lat, lon, azimuth) in [
            (0.0, 10.0, 90.0),
            (20.0, 5.0, 0.0),
            (-35.0, 170.0, 180.0),
            (30.0, 40.0, 50.0),
        ] {
            let line = karney.line(place::<T>(lat, lon), T::of(azimuth)).unwrap();
            let same = intersections.closest(&line, &line);
            assert_eq!(
                (same.overlap, apart(&same)),
                (Some(Overlap::Parallel), 0.0),
                "{lat} {lon}"
            );
            if azimuth == 50.0 {
                continue;
            }
            let there = line.at(T::of(3e6)).unwrap();
            for (turn, overlap, ahead) in [(0.0, Overlap::Parallel, -1.0), (180.0, Overlap::Antiparallel, 1.0)] {
                let other = karney.line(there.position, there.azimuth + T::of(turn)).unwrap();
                let met = intersections.closest(&line, &other);
                assert_eq!(met.overlap, Some(overlap), "{lat} {lon} {azimuth} {turn}");
                let [x, y] = [met.displacement1, met.displacement2].map(Into::<f64>::into);
                assert!(
                    (x - 1.5e6).abs() < tolerance && (y - ahead * 1.5e6).abs() < tolerance,
                    "{met:?}"
                );
            }
        }
    }
    told::<f64>(1e-7);
    told::<f32>(20.0);
}

/// GeographicLib's own test: segments of the equator, whose common part, or gap, has a middle.
#[test]
fn segments_of_the_equator_meet_in_the_middle_of_the_common_part() {
    let of_degrees = 180.0 / std::f64::consts::PI;
    let cases = [
        ([0.0, 40.0, -20.0, -10.0], None),
        ([0.0, 40.0, -10.0, 0.0], Some([0.0, 10.0])),
        ([0.0, 40.0, -8.0, 2.0], Some([1.0, 9.0])),
        ([0.0, 40.0, -2.0, 8.0], Some([4.0, 6.0])),
        ([0.0, 40.0, 0.0, 10.0], Some([5.0, 5.0])),
        ([0.0, 40.0, 2.0, 12.0], Some([7.0, 5.0])),
        ([0.0, 40.0, 15.0, 25.0], Some([20.0, 5.0])),
        ([0.0, 40.0, 30.0, 40.0], Some([35.0, 5.0])),
        ([0.0, 40.0, 38.0, 48.0], Some([39.0, 1.0])),
        ([0.0, 40.0, 40.0, 50.0], Some([40.0, 0.0])),
        ([0.0, 40.0, 50.0, 60.0], None),
        ([40.0, 0.0, -8.0, 2.0], Some([39.0, 9.0])),
        ([40.0, 0.0, 15.0, 25.0], Some([20.0, 5.0])),
        ([40.0, 0.0, 40.0, 50.0], Some([0.0, 0.0])),
        ([40.0, 0.0, 50.0, 60.0], None),
    ];
    for f in [-0.1, 0.0, 0.1] {
        let ellipsoid = Ellipsoid::new(of_degrees, f).unwrap();
        let (karney, intersections) = (Karney::new(ellipsoid).unwrap(), Intersections::new(ellipsoid).unwrap());
        for ([a, b, c, d], expected) in cases {
            let one = Segment::new(&karney, place(0.0, a), place(0.0, b));
            let other = Segment::new(&karney, place(0.0, c), place(0.0, d));
            for (one, other, swap) in [(&one, &other, false), (&other, &one, true)] {
                let met = intersections.of_segments(one, other);
                assert_eq!(met.is_some(), expected.is_some(), "{f} {a} {b} {c} {d}");
                let Some(met) = met else { continue };
                assert!(met.overlap.is_some());
                let mut at = [met.displacement1, met.displacement2];
                if swap {
                    at.reverse();
                }
                for (seen, expected) in at.iter().zip(expected.unwrap()) {
                    assert!((seen - expected).abs() < 1e-12, "{f} {a} {b} {c} {d} {at:?}");
                }
            }
        }
    }
}

/// Ends that are shared, or lie on the other segment, at any angle that the scalar can tell.
#[test]
fn touching_segments_intersect() {
    fn touch<T: Scalar>(smallest: f64, tolerance: f64) {
        let karney = Karney::new(Ellipsoid::<T>::WGS84).unwrap();
        let intersections = Intersections::new(Ellipsoid::<T>::WGS84).unwrap();
        let mut rng = fastrand::Rng::with_seed(8);
        for _ in 0..3000 {
            let lat = 178.0 * rng.f64() - 89.0;
            let start = place::<T>(lat, 360.0 * rng.f64() - 180.0);
            let azimuth = 360.0 * rng.f64() - 180.0;
            let length = 10_f64.powf(3.0 + 3.8 * rng.f64());
            let turn = 10_f64.powf(-rng.f64() * smallest) * if rng.bool() { 100.0 } else { -100.0 };
            let end = |from, azimuth, length| {
                let line = karney.line(from, T::of(azimuth)).unwrap();
                line.at(T::of(length)).unwrap()
            };
            let one = Segment::new(&karney, start, end(start, azimuth, length).position);
            let other = Segment::new(&karney, start, end(start, azimuth + turn, length / 2.0).position);
            let middle = one.midpoint();
            let beyond = end(middle.position, middle.azimuth.into() + turn, length / 3.0).position;
            let across = Segment::new(&karney, middle.position, beyond);
            for (other, at) in [(other, start), (across, middle.position)] {
                for (one, other) in [(&one, &other), (&other, &one)] {
                    let met = intersections.of_segments(one, other);
                    assert!(met.is_some(), "{start:?} {azimuth} {length} {turn}");
                    let reach = karney.line(at, T::ZERO).unwrap().at(T::ZERO).unwrap().position;
                    let gap = Segment::new(&karney, met.unwrap().position, reach).length();
                    let sine = turn.to_radians().sin().abs();
                    assert!(
                        Into::<f64>::into(gap) * sine <= tolerance,
                        "{start:?} {azimuth} {length} {turn} {gap}"
                    );
                }
            }
        }
    }
    touch::<f64>(5.0, 5e-8);
    touch::<f32>(1.0, 12.0);
}

#[test]
fn apart_segments_do_not_intersect() {
    let (karney, intersections) = earth();
    let segment = |[a, b, c, d]: [f64; 4]| Segment::new(&karney, place(a, b), place(c, d));
    let one = segment([0.0, 0.0, 0.0, 40.0]);
    // A millimetre above the end, beyond it, and on the far side.
    for other in [
        [1e-8, 40.0, 10.0, 40.0],
        [-1.0, 40.000_000_01, 1.0, 40.000_000_01],
        [-10.0, -160.0, 10.0, -160.0],
    ] {
        assert_eq!(intersections.of_segments(&one, &segment(other)), None, "{other:?}");
    }
    // A point is a segment, too.
    let point = segment([0.0, 20.0, 0.0, 20.0]);
    assert!(intersections.of_segments(&one, &point).is_some());
    assert!(intersections.of_segments(&point, &point).is_some());
    assert_eq!(intersections.of_segments(&one, &segment([1.0, 20.0, 1.0, 20.0])), None);
}

/// Two radials beyond the cut locus: Rittri on PROJ's list in February 2013.
#[test]
fn radials_from_one_place_meet_near_the_antipode() {
    let karney = Karney::new(Ellipsoid::WGS84).unwrap();
    let intersections = Intersections::new(Ellipsoid::WGS84).unwrap();
    let start = place::<f64>(0.0, 10.0);
    let met = intersections.next(start, 88.0, 92.0).unwrap();
    // They are mirror images: they meet on the equator, before the antipode.
    assert!(met.position.lat().abs() < 1e-12 && (met.displacement1 - met.displacement2).abs() < 1e-6);
    let back = karney.line(start, 88.0).unwrap().at(met.displacement1).unwrap();
    assert!((back.position.lon() - met.position.lon()).abs() < 1e-12);
    assert_eq!(
        intersections.next(start, f64::NAN, 0.0).unwrap_err().to_string(),
        "azimuth NaN is not finite"
    );
}

/// Lines that coincide meet next at the conjugate point: on the equator after πb.
#[test]
fn coincident_lines_meet_next_at_the_conjugate_point() {
    let (_, intersections) = earth();
    let met = intersections.next(place(0.0, 10.0), 90.0, -90.0).unwrap();
    let expected = std::f64::consts::PI * Ellipsoid::<f64>::WGS84.b();
    assert_eq!(met.overlap, Some(Overlap::Antiparallel));
    assert!((met.displacement1.abs() - expected).abs() < 1e-7 && met.displacement2 == -met.displacement1);
}

/// All intersections have points in common, none is there twice, rings come in order, and the closest is among them.
#[test]
fn all_within_a_distance() {
    let (_, intersections) = earth();
    let karney = Karney::new(Ellipsoid::WGS84).unwrap();
    let mut rng = fastrand::Rng::with_seed(5);
    let mut line = || -> Line<f64> {
        let start = place(180.0 * rng.f64() - 90.0, 360.0 * rng.f64() - 180.0);
        karney.line(start, 360.0 * rng.f64() - 180.0).unwrap()
    };
    for _ in 0..20 {
        let (one, other) = (line(), line());
        let all = intersections.within(&one, &other, 9e7).unwrap();
        let most = all.most();
        let found: Vec<_> = all.collect();
        assert!(found.len() as u64 <= most && found.len() > 15, "{} {most}", found.len());
        for (i, met) in found.iter().enumerate() {
            assert!(apart(met) <= 9e7);
            let there = other.at(met.displacement2).unwrap().position;
            assert!(Segment::new(&karney, met.position, there).length() < 1e-7);
            for before in &found[..i] {
                let gap =
                    (before.displacement1 - met.displacement1).abs() + (before.displacement2 - met.displacement2).abs();
                assert!(gap > 3.9e7, "{before:?} {met:?}");
            }
        }
        let closest = intersections.closest(&one, &other);
        assert!(found.iter().any(|met| (apart(met) - apart(&closest)).abs() < 1e-6));
        let fewer = intersections.within(&one, &other, 4e7).unwrap().count();
        assert_eq!(fewer, found.iter().filter(|met| apart(met) <= 4e7).count());
    }
}

#[test]
fn wrong_distances_are_refused() {
    let (karney, intersections) = earth();
    let line = karney.line(place(1.0, 2.0), 3.0).unwrap();
    let within = |distance| intersections.within(&line, &line, distance).map(|_| ());
    assert_eq!(within(-1.0), Err(GeodesicError::Distance(-1.0)));
    assert!(matches!(within(f64::NAN), Err(GeodesicError::Distance(_))));
    assert!(matches!(within(1e12), Err(GeodesicError::TooFar { .. })));
    assert!(matches!(
        intersections.closest_to(&line, &line, [0.0, f64::INFINITY]),
        Err(GeodesicError::Distance(_))
    ));
    assert!(Intersections::new(Ellipsoid::new(6.4e6, 0.2).unwrap()).is_err());
}
