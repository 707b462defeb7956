//! Closest points and tracks, against 25 digits, and cases of others' issues.

use fastrand::Rng;
use terrella::geodesic::{Geodesic, GreatCircle, Karney};
use terrella::route::{Legs, Reach, TangentPlane};
use terrella::{Ellipsoid, Geodetic, LatLon};
use testkit::Worst;
use testkit::truth::{Row, Scalar, Truth};

const INPUTS: [&str; 6] = ["lat", "lon", "lat1", "lon1", "lat2", "lon2"];

pub fn place<T: Scalar>(lat: T, lon: T) -> LatLon<T> {
    LatLon::new(lat, lon).unwrap()
}

fn planet<T: Scalar>(name: &str) -> Ellipsoid<T> {
    let of = |a, f| Ellipsoid::new(T::of(a), T::of(f)).unwrap();
    match name {
        "wgs84" => Ellipsoid::WGS84,
        "oblate10" => of(6.4e6, 0.1),
        "sphere" => of(6.371e6, 0.0),
        _ => of(6.4e6, -1.0 / 150.0),
    }
}

fn earth() -> Karney<f64> {
    Karney::new(Ellipsoid::WGS84).unwrap()
}

fn three<T: Scalar>(row: Row<'_>) -> [LatLon<T>; 3] {
    let [lat, lon, lat1, lon1, lat2, lon2] = INPUTS.map(|column| row.input(column));
    [place(lat, lon), place(lat1, lon1), place(lat2, lon2)]
}

/// How far a place is from the truth, in metres.
fn stray<T: Scalar>(row: Row<'_>, ellipsoid: &str, found: LatLon<T>) -> f64 {
    let ground = Geodetic::new(place(found.lat().into(), found.lon().into()), 0.0).unwrap();
    let found = planet::<f64>(ellipsoid).to_ecef(ground);
    let square = |column, at: f64| row.deviation(column, at).powi(2);
    (square("x", found.x()) + square("y", found.y()) + square("z", found.z())).sqrt()
}

/// Worst errors of distances, closest points and lengths along the leg; of across and along the line. Those
/// along are times the scale, as the cosine of the distance in radii is about.
fn errors<T: Scalar>(keep: impl Fn(&str, f64) -> bool) -> [f64; 5] {
    let truth = Truth::read("closest");
    let mut worst = [Worst::default(); 5];
    for row in truth.exact_in::<T>(&INPUTS) {
        let (name, distance) = (row.text("ellipsoid"), row.value("distance"));
        if !keep(name, distance) {
            continue;
        }
        let surface = Karney::new(planet::<T>(name)).unwrap();
        let [place, start, end] = three::<T>(row);
        let closest = surface.closest(place, start, end);
        let reach = match closest.reach {
            Reach::BeforeStart => "before",
            Reach::Within => "within",
            Reach::PastEnd => "past",
        };
        let scale = (distance / 6.4e6).cos().abs();
        worst[0].add(row.error("distance", closest.distance));
        worst[1].add(scale * stray(row, name, closest.position));
        worst[2].add(scale * row.error("along", closest.along));
        let along = row.value("along");
        assert!(
            reach == row.text("reach") || T::CLAIM == 1 && along.abs() < 100.0,
            "{closest:?} {along}"
        );
        if row.text("across_line") != "none" {
            let track = surface.track(place, start, end);
            let scale = (row.value("across_line") / 6.4e6).cos().abs();
            worst[3].add(row.error("across_line", track.across));
            worst[4].add(scale * row.error("along_line", track.along));
        }
    }
    worst.map(|worst| worst.value())
}

#[test]
fn on_the_ellipsoid_as_accurate_as_claimed() {
    let on_earth = |least: f64, most: f64| move |name: &str, at: f64| name == "wgs84" && at >= least && at < most;
    let other = |limit: f64| move |name: &str, at: f64| name != "wgs84" && name != "sphere" && at < limit;
    let hold = |errors: [f64; 5], claims: [f64; 5]| {
        println!("{errors:?}");
        assert!(
            errors.iter().zip(claims).all(|(error, claim)| *error <= claim),
            "{errors:?}"
        );
    };
    hold(errors::<f64>(on_earth(0.0, 1e7)), [1e-8; 5]);
    hold(errors::<f64>(on_earth(1e7, 3e7)), [1e-8, 1e-8, 1e-8, 1e-8, 1e-8]);
    // Flatter ones have azimuths within picometres at the other end: of a leg of 6 m this is 4e-12, seen from
    // 2000 km.
    hold(errors::<f64>(other(8e6)), [1e-8, 1e-5, 1e-5, 1e-8, 1e-5]);
    hold(errors::<f32>(on_earth(0.0, 1e7)), [4.0; 5]);
}

/// On a sphere both surfaces agree with the truth, and the great circle is the faster way.
#[test]
fn on_the_sphere_as_accurate_as_claimed() {
    fn worst<T: Scalar>() -> [f64; 4] {
        let sphere = GreatCircle::new(T::of(6_371_000.0)).unwrap();
        let truth = Truth::read("closest");
        let mut worst = [Worst::default(); 4];
        for row in truth.exact_in::<T>(&INPUTS) {
            if row.text("ellipsoid") != "sphere" {
                continue;
            }
            let [place, start, end] = three::<T>(row);
            let closest = sphere.closest(place, start, end);
            let scale = (row.value("distance") / 6_371_000.0).cos().abs();
            worst[0].add(row.error("distance", closest.distance));
            worst[1].add(scale * stray(row, "sphere", closest.position));
            worst[2].add(scale * row.error("along", closest.along));
            if row.text("across_line") != "none" {
                worst[3].add(row.error("across_line", sphere.track(place, start, end).across));
            }
        }
        worst.map(Worst::value)
    }
    let (double, single) = (worst::<f64>(), worst::<f32>());
    println!("{double:?} {single:?}");
    assert!(double.iter().all(|error| *error <= 1.4e-8) && single.iter().all(|error| *error <= 6.4));
}

#[test]
fn of_issues() {
    // phpgeo, issue 92: the distance to the circle was taken for that to a leg of 10 m.
    let leg = [
        place(55.984_670_000_751_47, 13.544_430_000_324_18),
        place(55.984_618_339_725_62, 13.544_295_002_187_091),
    ];
    let beside = place(55.976_093, 13.547_599);
    let sphere = GreatCircle::new(Ellipsoid::<f64>::WGS84.mean_radius()).unwrap();
    let closest = sphere.closest(beside, leg[0], leg[1]);
    assert_eq!(
        (format!("{:.3}", closest.distance), closest.reach),
        ("970.004".into(), Reach::PastEnd)
    );
    assert_eq!(format!("{:.2}", sphere.track(beside, leg[0], leg[1]).across), "-898.48");
    // Turf, issue 2934: an end on the other hemisphere.
    let (south, leg) = (place(-88.0, -45.0), [place(88.0, 25.0), place(-70.0, 25.0)]);
    let closest = sphere.closest(south, leg[0], leg[1]);
    assert_eq!(
        (format!("{:.3}", closest.distance), closest.position),
        ("2157568.256".into(), leg[1])
    );
    // PyGeodesy, issue 4: a circle has two points at right angles.
    let closest = sphere.closest(place(1.0, 0.0), place(0.0, 0.0), place(0.0, 1.0));
    assert!(closest.position.lon().abs() < 1e-12 && closest.position.lat() == 0.0);
    // On the ellipsoid they stand in the truth.
    let issues = Truth::read("closest")
        .exact_in::<f64>(&INPUTS)
        .iter()
        .filter(|row| row.text("class") == "issue")
        .count();
    assert_eq!(issues, 7);
}

/// From a place that is about a quarter of the way round from all points of a leg, the distance has several
/// minima.
#[test]
fn the_lowest_of_several_minima() {
    let earth = earth();
    // The pole of a meridian at the equator: 90° along the equator are longer than to a pole.
    let ship = place(0.0, 0.0);
    let leg = [place(10.0, 90.0), place(-89.0, 90.0)];
    let closest = earth.closest(ship, leg[0], leg[1]);
    assert_eq!((closest.position, closest.reach), (leg[1], Reach::PastEnd));
    let closest = earth.closest(ship, place(-10.0, 90.0), place(89.0, 90.0));
    assert_eq!(closest.position, place(89.0, 90.0));
    // Over a pole, where the minimum is within.
    let closest = earth.closest(ship, place(80.0, 90.0), place(80.0, -90.0));
    assert!(closest.position.lat() > 89.999 && closest.reach == Reach::Within);
    // Hidden between two points of a coarse sample, near the end: 2.8 mm less than from there.
    let ship = place(0.126_619_502_801_558_8, 101.473_288_523_597_06);
    let leg = [
        place(-76.670_268_444_486_84, 11.554_362_150_823_835),
        place(-48.232_969_155_716_83, 11.558_916_019_841_698),
    ];
    let closest = earth.closest(ship, leg[0], leg[1]);
    assert!((closest.distance - 10_013_506.686_011).abs() < 1e-5, "{closest:?}");
    // In all these cases, against a sample of a thousand points.
    let mut rng = Rng::with_seed(30);
    for _ in 0..60 {
        let start = place(180.0 * rng.f64() - 90.0, 360.0 * rng.f64());
        let length = 2e6 + 1.75e7 * rng.f64();
        let end = earth.direct(start, 360.0 * rng.f64(), length).unwrap().position;
        let leg = earth.leg(start, end);
        let way = earth.inverse(start, end).unwrap();
        let line = earth.line(start, way.azimuth1).unwrap();
        let middle = line.at(way.distance * rng.f64()).unwrap();
        let away = 1.001_874e7 * (1.0 - 0.004 * rng.f64());
        let ship = earth
            .direct(middle.position, middle.azimuth + 90.0, away)
            .unwrap()
            .position;
        let closest = earth.closest_on(&leg, ship);
        let heights = (0..=1000).map(|k| {
            let point = line.at(earth.length(&leg) * f64::from(k) / 1000.0).unwrap();
            earth.distance(ship, point.position).unwrap()
        });
        let lowest = heights.reduce(testkit::minimum).unwrap();
        assert!(closest.distance <= lowest + 1e-7, "{ship:?} {start:?} {end:?}");
        let here = earth.distance(ship, closest.position).unwrap();
        assert!((here - closest.distance).abs() < 2e-8);
    }
}

/// Ends that coincide, poles, antipodes, and places on the leg have an answer.
#[test]
fn degenerate_legs() {
    fn compare<T: Scalar, S: Legs<T>>(surface: &S, quarter: f64, rounding: f64) {
        let at = |lat: f64, lon: f64| place(T::of(lat), T::of(lon));
        let near = |a: T, b: f64| assert!((Into::<f64>::into(a) - b).abs() <= rounding, "{a:?} {b}");
        let here = at(10.0, 20.0);
        // The line of coincident ends leads to the north.
        let closest = surface.closest(at(10.0, 21.0), here, here);
        assert_eq!((closest.position, closest.along), (here, T::ZERO));
        let track = surface.track(at(10.5, 20.0), here, here);
        near(track.across, 0.0);
        assert!(track.along > T::of(5e4) && track.along < T::of(6e4));
        let on = surface.closest(here, here, here);
        assert_eq!((on.distance, on.reach), (T::ZERO, Reach::Within));
        // At an end the place is on the leg.
        for end in [here, at(12.0, 23.0)] {
            let on = surface.closest(end, here, at(12.0, 23.0));
            near(on.distance, 0.0);
        }
        // From pole to pole, and between antipodes on the equator: the line starts to the north.
        let closest = surface.closest(at(0.0, 20.0), at(-90.0, 20.0), at(90.0, 20.0));
        near(closest.along, quarter);
        near(closest.distance, 0.0);
        let closest = surface.closest(at(90.0, 5.0), at(0.0, 0.0), at(0.0, 180.0));
        near(closest.along, quarter);
        near(closest.distance, 0.0);
        let track = surface.track(at(0.0, 90.0), at(0.0, 0.0), at(90.0, 0.0));
        assert!((Into::<f64>::into(track.across) - quarter).abs() < 0.01 * quarter);
    }
    let quarter = earth().distance(place(0.0, 0.0), place(90.0, 0.0)).unwrap();
    compare::<f64, _>(&earth(), quarter, 1e-8);
    compare::<f32, _>(&Karney::new(Ellipsoid::WGS84).unwrap(), quarter, 4.0);
    let radius = 6.371e6;
    let quarter = radius * core::f64::consts::FRAC_PI_2;
    compare::<f64, _>(&GreatCircle::new(radius).unwrap(), quarter, 1e-8);
    compare::<f32, _>(&GreatCircle::new(6.371e6_f32).unwrap(), quarter, 4.0);
}

/// The plane about an origin against the ellipsoid in `f64`: worst errors of distance, closest point and
/// along, by the size of a fence in metres, its middle up to 20 km from the origin.
fn plane_errors<T: Scalar>(size: f64, lat: f64, rounds: usize) -> [f64; 4] {
    let mut rng = Rng::with_seed(7);
    let origin = place(T::of(lat), T::of(11.0));
    let plane = TangentPlane::local(Ellipsoid::<T>::WGS84, origin).unwrap();
    let earth = earth();
    let home: LatLon = place(origin.lat().into(), origin.lon().into());
    let mut worst = [Worst::default(); 4];
    for _ in 0..rounds {
        let middle = earth
            .direct(home, 360.0 * rng.f64(), 20_000.0 * rng.f64())
            .unwrap()
            .position;
        let mut offset = || {
            let place = earth
                .direct(middle, 360.0 * rng.f64(), 0.5 * size * rng.f64().sqrt())
                .unwrap()
                .position;
            let turn = place.lon() - home.lon();
            let turn = if turn > 180.0 {
                turn - 360.0
            } else if turn < -180.0 {
                turn + 360.0
            } else {
                turn
            };
            LatLon::new(T::of(place.lat() - home.lat()), T::of(turn)).unwrap()
        };
        let offsets = [offset(), offset(), offset()];
        // Where the rounded offsets are.
        let whole = |offset: LatLon<T>| {
            let (lat, lon): (f64, f64) = (offset.lat().into(), offset.lon().into());
            LatLon::new(home.lat() + lat, home.lon() + lon).unwrap()
        };
        let [ship, start, end] = offsets.map(whole);
        let (found, truth) = (
            plane.closest(offsets[0], offsets[1], offsets[2]),
            earth.closest(ship, start, end),
        );
        worst[0].add((found.distance.into() - truth.distance).abs());
        worst[1].add(earth.distance(whole(found.position), truth.position).unwrap());
        worst[2].add((found.along.into() - truth.along).abs());
        let (found, truth) = (
            plane.track(offsets[0], offsets[1], offsets[2]),
            earth.track(ship, start, end),
        );
        // The whole line of a short leg is not the plane's.
        if truth.along.abs() < size && earth.distance(start, end).unwrap() > 0.1 * size {
            worst[3].add((found.across.into() - truth.across).abs());
        }
    }
    worst.map(Worst::value)
}

#[test]
fn in_the_plane_as_accurate_as_claimed() {
    // As the documentation of `TangentPlane` has it: a fence's size, errors in f64 and f32 without the
    // place's own.
    let claims = [
        (100.0, 2e-9, 6e-5),
        (1e3, 3e-8, 6e-4),
        (5e3, 4e-6, 3e-3),
        (2e4, 2e-4, 1.5e-2),
        (1e5, 2.5e-2, 6e-2),
    ];
    for (size, double, single) in claims {
        for lat in [0.0, 45.0, 80.0, 89.7] {
            let [distance, position, along, across] = plane_errors::<f64>(size, lat, 200);
            let rounding = 2e-9;
            assert!(
                Worst::of([distance, position - rounding, along, across]) <= double,
                "{size} {lat}"
            );
            let [distance, position, along, across] = plane_errors::<f32>(size, lat, 400);
            let rounding = 2e-3;
            assert!(
                Worst::of([distance, position - rounding, along, across]) <= single,
                "{size} {lat}"
            );
        }
    }
}
