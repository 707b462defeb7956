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

/// Worst errors of distances, closest points and lengths along the leg; of across and along the line. Those along are
/// times the scale, as the cosine of the distance in radii is about.
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
        assert!(reach == row.text("reach") || T::CLAIM == 1 && along.abs() < 100.0, "{closest:?} {along}");
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
    let below = |limit: f64| move |name: &str, distance: f64| name == "wgs84" && distance < limit;
    let all = [
        errors::<f64>(below(1e7)),
        errors::<f64>(|name, distance| name == "wgs84" && distance >= 1e7),
        errors::<f64>(|name, _| name != "wgs84"),
    ];
    let single = [errors::<f32>(below(1e5)), errors::<f32>(below(1e7))];
    println!("{all:#?} {single:#?}");
}

#[test]
fn of_issues() {
    // phpgeo, issue 92: the distance to the circle was taken for that to a leg of 10 m.
    let leg = [place(55.984_670_000_751_47, 13.544_430_000_324_18), place(55.984_618_339_725_62, 13.544_295_002_187_091)];
    let beside = place(55.976_093, 13.547_599);
    for radius in [6_371_000.0, 6_371_008.8, 6_378_137.0] {
        let sphere = GreatCircle::new(radius).unwrap();
        println!("{:?} {:?}", sphere.closest(beside, leg[0], leg[1]), sphere.track(beside, leg[0], leg[1]));
        println!("{:?}", sphere.closest(place(-88.0, -45.0), place(88.0, 25.0), place(-70.0, 25.0)));
    }
    println!("{:?}", earth().closest(beside, leg[0], leg[1]));
}
