//! Fences on the sphere against S2's crossings of edges.
#![allow(
    missing_docs, clippy::unwrap_used, clippy::expect_used, clippy::panic, clippy::indexing_slicing
)] // tests

use fastrand::Rng;
use s2::edge_crossings::edge_or_vertex_crossing;
use s2::latlng::LatLng;
use s2::point::Point;
use terrella::LatLon;
use terrella::geodesic::GreatCircle;
use terrella::route::{Fence, Side};

fn place(rng: &mut Rng) -> LatLon<f64> {
    let sine: f64 = 2.0 * rng.f64() - 1.0;
    LatLon::new(sine.asin().to_degrees(), 360.0 * rng.f64() - 180.0).unwrap()
}

fn point(place: LatLon<f64>) -> Point {
    LatLng::from_degrees(place.lat(), place.lon()).into()
}

/// Corners anywhere, or within some degrees of a place, which may be a pole or on the meridian of ±180°.
fn ring(rng: &mut Rng) -> Vec<LatLon<f64>> {
    let middle = match rng.u8(0..4) {
        0 => LatLon::new(*rng.choice(&[90.0, -90.0, 0.0]).unwrap(), 0.0).unwrap(),
        1 => LatLon::new(place(rng).lat(), 180.0).unwrap(),
        _ => place(rng),
    };
    let sphere = GreatCircle::new(1.0).unwrap();
    let size = if rng.bool() { 3.0 } else { 10f64.powf(-4.0 * rng.f64()) };
    (0..rng.usize(3..9))
        .map(|_| {
            let (azimuth, distance) = (360.0 * rng.f64(), size * rng.f64());
            terrella::geodesic::Geodesic::direct(&sphere, middle, azimuth, distance)
                .unwrap()
                .position
        })
        .collect()
}

/// Two places are on the same side if the way between them crosses the ring an even number of times.
#[test]
fn sides_change_where_ways_cross() {
    let sphere = GreatCircle::new(6_371_000.0).unwrap();
    let mut rng = Rng::with_seed(1);
    let (mut compared, mut odd) = (0, 0);
    for _ in 0..8_000 {
        let ring = ring(&mut rng);
        let corners: Vec<_> = ring.iter().copied().map(point).collect();
        let rings = [ring.as_slice()];
        let fence = Fence::new(&sphere, &rings);
        for _ in 0..5 {
            let near = |rng: &mut Rng| {
                let part = |rng: &mut Rng| ring[rng.usize(0..ring.len())];
                let (one, two) = (part(rng), part(rng));
                sphere.intermediate(one, two, rng.f64()).unwrap()
            };
            let [a, b] = [(); 2].map(|()| if rng.bool() { near(&mut rng) } else { place(&mut rng) });
            let sides = [fence.side(a), fence.side(b)];
            if sides.contains(&Side::Edge) {
                continue;
            }
            let (from, to) = (point(a), point(b));
            let next = corners.iter().cycle().skip(1);
            let crossings = corners.iter().zip(next);
            let count = crossings
                .filter(|(c, d)| edge_or_vertex_crossing(&from, &to, c, d))
                .count();
            assert_eq!(
                sides[0] != sides[1],
                count % 2 == 1,
                "{ring:?} {a:?} {b:?} {sides:?} {count}"
            );
            compared += 1;
            odd += count % 2;
        }
    }
    println!("{compared} ways, {odd} odd");
    assert!(compared > 15_000 && odd > 4_000, "{compared} {odd}");
}
