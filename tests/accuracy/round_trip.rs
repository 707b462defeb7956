//! Latitude and longitude to a direction or a place on the cube, and back.

use terrella::cube::{CubeMap, Face, FacePoint, Projection};
use terrella::{Ellipsoid, LatLon, Shift};
use testkit::Worst;

use testkit::table::hold;
use testkit::truth::Scalar;

/// A number in [−1, 1] of any magnitude down to 1e-16.
fn tiny(rng: &mut fastrand::Rng) -> f64 {
    10f64.powf(-16.0 * rng.f64()) * signed(rng)
}

fn signed(rng: &mut fastrand::Rng) -> f64 {
    2.0 * rng.f64() - 1.0
}

/// A number near ±1.
fn nearly_one(rng: &mut fastrand::Rng) -> f64 {
    (1.0 - tiny(rng).abs()).copysign(signed(rng))
}

/// A place on the Earth: four in ten anywhere, the others near poles, equator, antimeridian, and the faces' edges, corners,
/// diagonals and centres.
fn place(rng: &mut fastrand::Rng, map: &CubeMap<f64, Projection>) -> [f64; 2] {
    match rng.u8(0..10) {
        0..4 => [signed(rng).asin().to_degrees(), 180.0 * signed(rng)],
        4 => [90.0 * nearly_one(rng), 180.0 * signed(rng)],
        5 => [90.0 * tiny(rng), 180.0 * signed(rng)],
        6 => [90.0 * signed(rng), 180.0 * nearly_one(rng)],
        7 => [90.0 * signed(rng), 45.0 * f64::from(rng.i32(-4..=4)) * nearly_one(rng)],
        _ => {
            let (x, y) = match rng.u8(0..5) {
                0 => (nearly_one(rng), signed(rng)),
                1 => (signed(rng), nearly_one(rng)),
                2 => (nearly_one(rng), nearly_one(rng)),
                3 => {
                    let x = signed(rng);
                    (x, x * nearly_one(rng))
                }
                _ => (tiny(rng), tiny(rng)),
            };
            let point = map.unproject(FacePoint::new(Face::ALL[rng.usize(0..6)], x, y).unwrap());
            [point.lat(), point.lon()]
        }
    }
}

/// Metres on the Earth between two places that are nearly the same.
fn metres<T: Scalar>(a: LatLon<T>, b: LatLon<T>) -> f64 {
    let lat = b.lat().into() - a.lat().into();
    let lon = (b.lon().into() - a.lon().into() + 540.0).rem_euclid(360.0) - 180.0;
    6_378_137.0 * lat.hypot(lon * a.lat().into().to_radians().cos()).to_radians()
}

/// The largest displacement of a number of points.
fn worst<T: Scalar>(projection: Projection, shift: Shift, points: usize, round: fn(f64) -> T) -> f64 {
    let places = CubeMap::new(Ellipsoid::<f64>::WGS84, shift, projection).unwrap();
    let map = CubeMap::new(Ellipsoid::<T>::WGS84, shift, projection).unwrap();
    let mut rng = fastrand::Rng::with_seed(3);
    let mut worst = Worst::default();
    for _ in 0..points {
        let [lat, lon] = place(&mut rng, &places).map(round);
        let there = LatLon::new(lat, lon).unwrap();
        worst.add(metres(there, map.unproject(map.project(there))));
    }
    worst.value()
}

/// Every projection that closes (COBE's published pair does not) with every shift.
fn round_trips(points: usize) {
    let closing = Projection::ALL
        .iter()
        .filter(|&&projection| projection != Projection::Cobe);
    let cases: Vec<_> = closing.flat_map(|&p| Shift::ALL.iter().map(move |&s| (p, s))).collect();
    let measure = |&(p, s): &_| {
        (
            p,
            s,
            [
                worst::<f64>(p, s, points, |v| v),
                worst::<f32>(p, s, points, |v| v as f32),
            ],
        )
    };
    let measured = testkit::parallel::map(&cases, measure);
    for (projection, shift, [double, single]) in &measured {
        println!("{projection} {shift}: {:.2} nm, {single:.2} m", double * 1e9);
    }
    let largest = |i: usize| Worst::of(measured.iter().map(|(_, _, errors)| errors[i]));
    hold(
        "LatLon to FacePoint and back, any projection and shift",
        [largest(0), largest(1)],
    );
}

#[test]
fn cube_round_trips() {
    round_trips(10_000);
}

/// `cargo test --release --test accuracy -- --ignored --nocapture`: some minutes on two cores.
#[test]
#[ignore = "10⁷ points for every projection and shift"]
fn cube_round_trips_ten_million() {
    round_trips(10_000_000);
}
