//! Which side of a fence a place is on: against edges of 40 digits, against dense rings in Earth axes, and the cases
//! that other programs have had reports of.

use fastrand::Rng;
use geographiclib_rs::{DirectGeodesic, Geodesic as Theirs, InverseGeodesic};
use terrella::geodesic::{Geodesic, GreatCircle, Karney, PlanarArea};
use terrella::route::{EdgeCrossing, Fence, Planar, Side};
use terrella::{Ellipsoid, Geodetic, LatLon};
use testkit::Worst;
use testkit::truth::{Scalar, Truth};

fn at(lat: f64, lon: f64) -> LatLon<f64> {
    LatLon::new(lat, lon).unwrap()
}

fn ring(corners: &[(f64, f64)]) -> Vec<LatLon<f64>> {
    corners.iter().map(|&(lat, lon)| at(lat, lon)).collect()
}

fn earth() -> Karney<f64> {
    Karney::new(Ellipsoid::WGS84).unwrap()
}

fn sphere() -> GreatCircle<f64> {
    GreatCircle::new(6_371_000.0).unwrap()
}

fn side<G: EdgeCrossing<f64, Place = LatLon<f64>>>(ground: &G, ring: &[LatLon<f64>], place: LatLon<f64>) -> Side {
    Fence::new(ground, &[ring]).side(place)
}

/// Corners in each order, and from each corner on.
fn turned<V: Copy>(ring: &[V]) -> impl Iterator<Item = Vec<V>> {
    (0..2 * ring.len()).map(|i| {
        let mut turned = ring.to_vec();
        turned.rotate_left(i / 2);
        if i % 2 == 1 {
            turned.reverse();
        }
        turned
    })
}

#[test]
fn beside_edges_of_forty_digits() {
    let truth = Truth::read("fence");
    let corners = ["lat1", "lon1", "lat2", "lon2", "lat3", "lon3"];
    let earth = earth();
    let mut counts = [0; 3];
    for row in truth.exact_in::<f64>(&corners) {
        let place = |lat, lon| at(row.value(lat), row.value(lon));
        let ring = [place("lat1", "lon1"), place("lat2", "lon2"), place("lat3", "lon3")];
        let here = place("lat", "lon");
        let offset = row.value("offset");
        let (expected, kind) = match offset {
            0.0 => (Side::Edge, 0),
            _ if offset > 0.0 => (Side::Inside, 1),
            _ => (Side::Outside, 2),
        };
        counts[kind] += 1;
        for ring in turned(&ring) {
            assert_eq!(
                side(&earth, &ring, here),
                expected,
                "{} {ring:?} {here:?} {offset}",
                row.text("class")
            );
        }
    }
    assert!(counts.into_iter().all(|count| count >= 40), "{counts:?}");
}

/// Reports of other programs, with the answers on the ellipsoid.
#[test]
fn reports() {
    let (earth, sphere) = (earth(), sphere());
    let check = |corners: &[(f64, f64)], places: &[(f64, f64, Side)]| {
        for ring in turned(&ring(corners)) {
            for &(lat, lon, expected) in places {
                assert_eq!(side(&earth, &ring, at(lat, lon)), expected, "{ring:?} {lat} {lon}");
                assert_eq!(
                    side(&sphere, &ring, at(lat, lon)),
                    expected,
                    "sphere {ring:?} {lat} {lon}"
                );
            }
        }
    };
    use Side::{Edge, Inside, Outside};
    // turf-inside #13, geojson-js-utils #28, geolib #38: across ±180°.
    check(
        &[(-1.0, 179.0), (-1.0, -179.0), (1.0, -179.0), (1.0, 179.0)],
        &[
            (0.5, 179.5, Inside),
            (-0.5, -179.5, Inside),
            (0.0, 180.0, Inside),
            (0.0, -180.0, Inside),
            (0.0, 178.9, Outside),
            (0.0, 0.0, Outside),
            (1.0, 179.0, Edge),
            (0.0, 179.0, Edge),
        ],
    );
    // turf #2568: a box that is less wide across ±180°.
    check(
        &[(42.2, 85.2), (42.2, -173.0), (7.5, -173.0), (7.5, 85.2)],
        &[(13.0, 122.0, Inside), (13.0, 0.0, Outside), (13.0, -172.0, Outside)],
    );
    // Boost.Geometry #1279: corners at the south pole, with two longitudes.
    check(
        &[
            (-90.0, 75.0),
            (-6.0, 75.0),
            (-2.0, 78.0),
            (-2.0, 92.0),
            (-12.0, 107.0),
            (-12.0, 114.5),
            (-14.136_944_444_444_444, 115.142_222_222_222_23),
            (-23.396_944_444_444_443, 126.058_888_888_888_89),
            (-21.2025, 131.84),
            (-21.499_722_222_222_225, 136.328_888_888_888_88),
            (-26.225_277_777_777_777, 138.39),
            (-29.0, 146.533_333_333_333_33),
            (-33.430_402_526_669_5, 151.970_694_083_691),
            (-35.316_388_888_888_88, 152.930_555_555_555_54),
            (-38.188_611_111_111_11, 150.320_555_555_555_56),
            (-45.0, 150.0),
            (-45.0, 163.0),
            (-90.0, 163.0),
        ],
        &[
            (-46.025_000_000_000_1, 119.0, Inside),
            (-89.999, 100.0, Inside),
            (-89.999, 74.0, Outside),
            (-89.999, -100.0, Outside),
            (-46.0, 157.0, Inside),
            (-44.0, 157.0, Outside),
            (-90.0, 0.0, Edge),
        ],
    );
    // turf #2287: on a diagonal edge, as near as numbers come to it, and corners.
    let diagonal = ring(&[(0.0, 0.0), (0.0, 1.0), (1.0, 2.0), (1.0, 1.0)]);
    let line = earth.inverse(diagonal[1], diagonal[2]).unwrap();
    let middle = earth
        .direct(diagonal[1], line.azimuth1, line.distance / 2.0)
        .unwrap()
        .position;
    assert_eq!(side(&earth, &diagonal, middle), Edge);
    for &corner in &diagonal {
        assert_eq!(side(&earth, &diagonal, corner), Edge);
    }
    // PX4 #28759: a leg of 20 km along 47° N bulges by 8.4 m.
    let east = 20_000.0 / 76_000.0;
    let leg = ring(&[(47.0, 8.0), (47.0, 8.0 + east), (46.9, 8.0 + east), (46.9, 8.0)]);
    let metres = |north: f64| at(47.0 + north / 111_170.0, 8.0 + east / 2.0);
    for (north, expected) in [(8.0, Inside), (8.3, Inside), (8.6, Outside), (9.0, Outside)] {
        assert_eq!(side(&earth, &leg, metres(north)), expected, "{north}");
    }
}

#[test]
fn rings_of_poles_meridians_and_the_equator() {
    use Side::{Edge, Inside, Outside};
    let (earth, sphere) = (earth(), sphere());
    let check = |corners: &[(f64, f64)], places: &[(f64, f64, Side)]| {
        for ring in turned(&ring(corners)) {
            for &(lat, lon, expected) in places {
                assert_eq!(side(&earth, &ring, at(lat, lon)), expected, "{ring:?} {lat} {lon}");
                assert_eq!(
                    side(&sphere, &ring, at(lat, lon)),
                    expected,
                    "sphere {ring:?} {lat} {lon}"
                );
            }
        }
    };
    for sign in [1.0, -1.0] {
        // Round a pole.
        check(
            &[(sign * 70.0, 0.0), (sign * 70.0, 120.0), (sign * 70.0, -120.0)],
            &[
                (sign * 90.0, 0.0, Inside),
                (sign * 90.0, 77.0, Inside),
                (sign * 80.0, 60.0, Inside),
                (sign * 75.0, 60.0, Outside),
                (sign * 69.0, 0.0, Outside),
                (sign * -90.0, 0.0, Outside),
                (sign * 70.0, 0.0, Edge),
                (0.0, 10.0, Outside),
            ],
        );
        // An edge over the pole.
        check(
            &[(sign * 80.0, 0.0), (sign * 80.0, 180.0), (sign * 60.0, 90.0)],
            &[
                (sign * 85.0, 90.0, Inside),
                (sign * 85.0, -90.0, Outside),
                (sign * 85.0, 0.0, Edge),
                (sign * 85.0, 180.0, Edge),
                (sign * 85.0, -180.0, Edge),
                (sign * 90.0, 45.0, Edge),
                (sign * -85.0, 90.0, Outside),
                (sign * -90.0, 0.0, Outside),
            ],
        );
        // A corner at the pole, given once; an octant.
        check(
            &[(0.0, 0.0), (0.0, 90.0), (sign * 90.0, 0.0)],
            &[
                (sign * 45.0, 45.0, Inside),
                (sign * 1e-6, 45.0, Inside),
                (sign * -1e-6, 45.0, Outside),
                (sign * 45.0, -45.0, Outside),
                (sign * 45.0, 135.0, Outside),
                (0.0, 45.0, Edge),
                (0.0, 135.0, Outside),
                (0.0, -45.0, Outside),
                (sign * 30.0, 0.0, Edge),
                (sign * 30.0, 90.0, Edge),
                (sign * 30.0, 180.0, Outside),
                (sign * 90.0, 180.0, Edge),
                (sign * -90.0, 0.0, Outside),
            ],
        );
        // A lune between meridians of opposite poles.
        check(
            &[(sign * 90.0, 10.0), (0.0, 10.0), (sign * -90.0, 10.0), (0.0, 50.0)],
            &[
                (0.0, 30.0, Inside),
                (sign * 89.0, 30.0, Inside),
                (sign * -89.0, 30.0, Inside),
                (0.0, 9.0, Outside),
                (0.0, 51.0, Outside),
                (0.0, -150.0, Outside),
                (60.0, 10.0, Edge),
                (-60.0, 50.0, Edge),
            ],
        );
    }
    // Repeated corners, and an edge there and back.
    check(
        &[
            (0.0, 0.0),
            (0.0, 0.0),
            (0.0, 10.0),
            (0.0, 20.0),
            (0.0, 10.0),
            (10.0, 10.0),
            (10.0, 0.0),
            (10.0, 0.0),
        ],
        &[
            (5.0, 5.0, Inside),
            (5.0, 15.0, Outside),
            (-5.0, 15.0, Outside),
            (0.0, 15.0, Edge),
            (5.0, 10.0, Edge),
            (5.0, -1.0, Outside),
        ],
    );
    // Two squares that touch at a corner.
    check(
        &[
            (0.0, 0.0),
            (5.0, 5.0),
            (10.0, 0.0),
            (10.0, 10.0),
            (5.0, 5.0),
            (0.0, 10.0),
        ],
        &[
            (1.0, 5.0, Inside),
            (9.0, 5.0, Inside),
            (5.0, 4.0, Outside),
            (5.0, 6.0, Outside),
            (5.0, 5.0, Edge),
        ],
    );
    // One corner and two corners.
    check(
        &[(5.0, 5.0)],
        &[
            (5.0, 5.0, Edge),
            (5.0, 6.0, Outside),
            (6.0, 5.0, Outside),
            (-5.0, -175.0, Outside),
        ],
    );
    check(
        &[(5.0, 5.0), (5.0, 50.0)],
        &[
            (5.0, 5.0, Edge),
            (0.0, 20.0, Outside),
            (20.0, 20.0, Outside),
            (-5.0, -175.0, Outside),
        ],
    );
    let nothing: [&[LatLon<f64>]; 0] = [];
    assert_eq!(Fence::new(&earth, &nothing).side(at(0.0, 0.0)), Outside);
    let none: [&[LatLon<f64>]; 1] = [&[]];
    assert_eq!(Fence::new(&earth, &none).side(at(0.0, 0.0)), Outside);
}

/// Of two equal halves the one to the left is inside, and of more than half the smaller side, unless the left one is
/// asked for.
#[test]
fn halves_and_more() {
    use Side::{Edge, Inside, Outside};
    let (earth, sphere) = (earth(), sphere());
    let equator = ring(&[(0.0, 0.0), (0.0, 120.0), (0.0, -120.0)]);
    let meridian = ring(&[(0.0, 0.0), (90.0, 0.0), (0.0, 180.0), (-90.0, 180.0)]);
    let back = |ring: &[LatLon<f64>]| ring.iter().rev().copied().collect::<Vec<_>>();
    let sides = |ring: &[LatLon<f64>], place| [side(&earth, ring, place), side(&sphere, ring, place)];
    for (lat, lon) in [(10.0, 0.0), (90.0, 0.0), (1e-6, 77.0)] {
        assert_eq!(sides(&equator, at(lat, lon)), [Inside; 2]);
        assert_eq!(sides(&equator, at(-lat, lon)), [Outside; 2]);
        assert_eq!(sides(&back(&equator), at(lat, lon)), [Outside; 2]);
        assert_eq!(sides(&back(&equator), at(-lat, lon)), [Inside; 2]);
    }
    for (lat, lon) in [(10.0, 90.0), (-80.0, 1.0), (0.0, 179.0)] {
        assert_eq!(sides(&meridian, at(lat, -lon)), [Inside; 2], "{lat} {lon}");
        assert_eq!(sides(&meridian, at(lat, lon)), [Outside; 2], "{lat} {lon}");
        assert_eq!(sides(&back(&meridian), at(lat, lon)), [Inside; 2]);
        assert_eq!(sides(&back(&meridian), at(lat, -lon)), [Outside; 2]);
    }
    assert_eq!(sides(&meridian, at(90.0, 33.0)), [Edge; 2]);
    let wide = ring(&[(-10.0, 0.0), (-10.0, 120.0), (-10.0, -120.0)]);
    let narrow = ring(&[(-10.0, 0.0), (10.0, 0.0), (10.0, 1.0), (-10.0, 1.0)]);
    for ring in [wide, narrow] {
        let rings = [ring.as_slice()];
        let other = back(&ring);
        let others = [other.as_slice()];
        let (small, left) = (Fence::new(&earth, &rings), Fence::to_the_left(&earth, &rings));
        let right = Fence::to_the_left(&earth, &others);
        let mut rng = Rng::with_seed(3);
        let mut inside = 0;
        for _ in 0..4000 {
            let place = anywhere(&mut rng);
            let opposite = match left.side(place) {
                Inside => Outside,
                Outside => Inside,
                Edge => Edge,
            };
            assert_eq!(right.side(place), opposite);
            assert!([small.side(place), opposite].contains(&left.side(place)) || small.side(place) == opposite);
            inside += i32::from(small.side(place) == Inside);
        }
        assert!(inside < 2000, "{ring:?} {inside}");
    }
}

/// Even-odd: a hole, a hole in it, a ring that lies on the other side of the Earth.
#[test]
fn rings_in_rings() {
    let earth = earth();
    let square = |lat: f64, lon: f64, half: f64| {
        ring(&[
            (lat - half, lon - half),
            (lat - half, lon + half),
            (lat + half, lon + half),
            (lat + half, lon - half),
        ])
    };
    let rings = [
        square(50.0, 10.0, 8.0),
        square(50.0, 10.0, 4.0),
        square(50.0, 10.0, 1.0),
        square(-50.0, -170.0, 2.0),
    ];
    let rings: Vec<&[LatLon<f64>]> = rings.iter().map(Vec::as_slice).collect();
    let fence = Fence::new(&earth, &rings);
    for (lat, lon, expected) in [
        (50.0, 10.0, Side::Inside),
        (52.0, 10.0, Side::Outside),
        (56.0, 10.0, Side::Inside),
        (59.0, 10.0, Side::Outside),
        (-50.0, -170.0, Side::Inside),
        (-50.0, 10.0, Side::Outside),
        (51.0, 9.0, Side::Edge),
        (51.0, 11.0, Side::Edge),
    ] {
        assert_eq!(fence.side(at(lat, lon)), expected, "{lat} {lon}");
        assert_eq!(fence.contains(at(lat, lon)), expected != Side::Outside);
    }
}

fn anywhere(rng: &mut Rng) -> LatLon<f64> {
    let sine: f64 = 2.0 * rng.f64() - 1.0;
    at(sine.asin().to_degrees(), 360.0 * rng.f64() - 180.0)
}

type Vector = [f64; 3];

fn dot(a: Vector, b: Vector) -> f64 {
    (0..3).map(|i| a[i] * b[i]).sum()
}

fn cross(a: Vector, b: Vector) -> Vector {
    [
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    ]
}

/// The direction of a place from the centre of the Earth.
fn geocentric(lat: f64, lon: f64) -> Vector {
    let ecef = Ellipsoid::WGS84
        .to_ecef(Geodetic::new(at(lat, lon), 0.0).unwrap())
        .to_array();
    ecef.map(|x| x / dot(ecef, ecef).sqrt())
}

/// Edges in parts of 50 km at most, by the geodesics of GeographicLib.
fn dense(theirs: &Theirs, ring: &[LatLon<f64>]) -> Vec<Vector> {
    let mut points = Vec::new();
    for (i, from) in ring.iter().enumerate() {
        let to = ring[(i + 1) % ring.len()];
        let (length, azimuth, _, _): (f64, f64, f64, f64) = theirs.inverse(from.lat(), from.lon(), to.lat(), to.lon());
        let parts = testkit::maximum((length / 50_000.0).ceil(), 1.0);
        for part in 0..parts as u32 {
            let (lat, lon): (f64, f64) =
                theirs.direct(from.lat(), from.lon(), azimuth, length * f64::from(part) / parts);
            points.push(geocentric(lat, lon));
        }
    }
    points
}

/// How often the arc from one direction to another crosses a ring of short arcs; nothing if it is too close to tell.
fn crossings(points: &[Vector], from: Vector, to: Vector) -> Option<u32> {
    let normal = cross(from, to);
    let mut count = 0;
    for (i, &a) in points.iter().enumerate() {
        let b = points[(i + 1) % points.len()];
        let (one, two) = (dot(normal, a), dot(normal, b));
        if one.abs() < 1e-9 || two.abs() < 1e-9 {
            return None;
        }
        if (one > 0.0) == (two > 0.0) {
            continue;
        }
        let across = cross(a, b);
        let (start, end) = (dot(across, from), dot(across, to));
        // Within some centimetres of the edge.
        let length = dot(across, across).sqrt();
        let [start, end] = [start, end].map(|side| side / length);
        if start.abs() < 1e-8 || end.abs() < 1e-8 {
            return None;
        }
        // The crossing is on the arc's half of the great circle.
        let middle: Vector = std::array::from_fn(|k| a[k] + b[k]);
        let towards: Vector = std::array::from_fn(|k| from[k] + to[k]);
        count += u32::from((start > 0.0) != (end > 0.0) && dot(middle, towards) > 0.0);
    }
    Some(count)
}

/// Corners that are anywhere, near each other, on the same meridian or on the opposite one, at poles.
fn any_ring(rng: &mut Rng) -> Vec<LatLon<f64>> {
    let count = rng.usize(3..9);
    let size = 10f64.powf(-3.0 * rng.f64()) * 90.0;
    let middle = anywhere(rng);
    let global = rng.u8(0..3) == 0;
    let mut ring: Vec<LatLon<f64>> = Vec::new();
    while ring.len() < count {
        let next = match rng.u8(0..12) {
            0 if !ring.is_empty() => {
                let last = ring[ring.len() - 1];
                at(anywhere(rng).lat(), last.lon())
            }
            1 if global && !ring.is_empty() => {
                let last = ring[ring.len() - 1];
                at(anywhere(rng).lat(), last.lon() + 180.0)
            }
            2 if global => at(90.0 * f64::from(rng.i8(-1..=1)), 10.0 * f64::from(rng.i8(-18..=18))),
            3 if !ring.is_empty() => ring[rng.usize(0..ring.len())],
            _ if global => anywhere(rng),
            _ => {
                let lat = (middle.lat() + size * (2.0 * rng.f64() - 1.0)).clamp(-90.0, 90.0);
                at(
                    lat,
                    middle.lon() + size * (2.0 * rng.f64() - 1.0) / middle.lat().to_radians().cos(),
                )
            }
        };
        ring.push(next);
    }
    ring
}

fn near_a_ring(rng: &mut Rng, ring: &[LatLon<f64>]) -> LatLon<f64> {
    if rng.bool() {
        return anywhere(rng);
    }
    let (one, two) = (ring[rng.usize(0..ring.len())], ring[rng.usize(0..ring.len())]);
    let lat = one.lat() + (two.lat() - one.lat()) * rng.f64() + 0.3 * (rng.f64() - 0.5);
    at(lat.clamp(-90.0, 90.0), one.lon() + (two.lon() - one.lon()) * rng.f64())
}

fn single(place: LatLon<f64>) -> LatLon<f32> {
    LatLon::new(place.lat() as f32, place.lon() as f32).unwrap()
}

/// Two places are on the same side if a way between them crosses the ring an even number of times, in `f32` too.
#[test]
fn ways_between_places_cross_dense_rings() {
    let (earth, earth32) = (earth(), Karney::new(Ellipsoid::WGS84).unwrap());
    let theirs = Theirs::wgs84();
    let mut rng = Rng::with_seed(7);
    let (mut compared, mut odd) = (0, 0);
    for _ in 0..300 {
        // Corners that f32 has too.
        let ring32: Vec<LatLon<f32>> = any_ring(&mut rng).into_iter().map(single).collect();
        let double = |place: LatLon<f32>| at(place.lat().into(), place.lon().into());
        let ring: Vec<_> = ring32.iter().copied().map(double).collect();
        let points = dense(&theirs, &ring);
        let (rings, rings32) = ([ring.as_slice()], [ring32.as_slice()]);
        let (fence, fence32) = (Fence::new(&earth, &rings), Fence::new(&earth32, &rings32));
        for _ in 0..20 {
            let [one, two] = [(); 2].map(|()| single(near_a_ring(&mut rng, &ring)));
            let [a, b] = [double(one), double(two)];
            let [from, to] = [a, b].map(|place| geocentric(place.lat(), place.lon()));
            if dot(from, to) < -0.5 {
                continue;
            }
            let Some(count) = crossings(&points, from, to) else {
                continue;
            };
            let sides = [fence.side(a), fence.side(b)];
            assert_eq!(
                sides[0] != sides[1],
                count % 2 == 1,
                "{ring:?} {a:?} {b:?} {sides:?} {count}"
            );
            let sides32 = [fence32.side(one), fence32.side(two)];
            let near = |i: usize| sides32[i] == Side::Edge;
            assert!(
                near(0) || near(1) || (sides32[0] != sides32[1]) == (count % 2 == 1),
                "f32 {ring:?} {a:?} {b:?}"
            );
            compared += 1;
            odd += count % 2;
        }
    }
    assert!(compared > 2000 && odd > 300, "{compared} {odd}");
}

/// The share of places inside is that of the area.
#[test]
fn inside_is_the_smaller_side() {
    let earth = earth();
    let area = terrella::geodesic::Area::new(Ellipsoid::WGS84).unwrap();
    let whole = 510_065_621_724_088.44_f64;
    let mut rng = Rng::with_seed(8);
    let mut tried = 0;
    while tried < 60 {
        // Round a place, anywhere, to beyond the opposite side.
        let middle = anywhere(&mut rng);
        let size = 1.9e7 * rng.f64();
        let corners: Vec<_> = (0..12)
            .map(|i| {
                earth
                    .direct(middle, -30.0 * f64::from(i), size * (0.9 + 0.1 * rng.f64()))
                    .unwrap()
                    .position
            })
            .collect();
        let mut polygon = area.polygon();
        corners.iter().for_each(|&corner| polygon.add(corner));
        let share = polygon.area().abs() / whole;
        let counter_clockwise = polygon.area() > 0.0;
        if size > 1.2e7 && size < 1.4e7 {
            continue;
        }
        tried += 1;
        let rings = [corners.as_slice()];
        let (small, left) = (Fence::new(&earth, &rings), Fence::to_the_left(&earth, &rings));
        let mut inside = 0;
        for _ in 0..1000 {
            let place = anywhere(&mut rng);
            let side = small.side(place);
            inside += u32::from(side == Side::Inside);
            assert_eq!(left.side(place) == side, counter_clockwise, "{corners:?} {place:?}");
        }
        let apart = (f64::from(inside) / 1000.0 - share).abs();
        assert!(share <= 0.5 && apart < 0.07, "{corners:?}: {inside} {share}");
    }
}

/// A polygon as Planimeter has it holds the same places whichever method measures its edges.
#[test]
fn ellipsoid_and_sphere_agree_far_from_edges() {
    let sphere = GreatCircle::new(6_378_137.0).unwrap();
    let round = Karney::new(Ellipsoid::sphere(6_378_137.0).unwrap()).unwrap();
    let mut rng = Rng::with_seed(9);
    let mut compared = 0;
    for _ in 0..2000 {
        let ring = any_ring(&mut rng);
        let rings = [ring.as_slice()];
        let fences = (Fence::new(&sphere, &rings), Fence::new(&round, &rings));
        for _ in 0..10 {
            let place = near_a_ring(&mut rng, &ring);
            let sides = [fences.0.side(place), fences.1.side(place)];
            if sides.contains(&Side::Edge) {
                continue;
            }
            assert_eq!(sides[0], sides[1], "{ring:?} {place:?}");
            compared += 1;
        }
    }
    assert!(compared > 15_000, "{compared}");
}

/// On the plane, against whole numbers.
#[test]
fn plane_against_whole_numbers() {
    let plane = Planar::about(Ellipsoid::WGS84, LatLon::new(47.0_f32, 8.0).unwrap()).unwrap();
    let mut rng = Rng::with_seed(10);
    let mut counts = [0; 3];
    for _ in 0..20_000 {
        let most = *rng.choice(&[3, 10, 4000]).unwrap();
        let point = |rng: &mut Rng| [(); 2].map(|()| rng.i32(-most..=most));
        let ring: Vec<_> = (0..rng.usize(1..8)).map(|_| point(&mut rng)).collect();
        let place = point(&mut rng);
        let exact = whole_numbers(&ring, place);
        let metres = |point: [i32; 2]| point.map(|x| x as f32 / 2.0);
        let corners: Vec<_> = ring.iter().copied().map(metres).collect();
        let found = Fence::new(&plane, &[&corners]).side(metres(place));
        assert!(
            found == exact || (found == Side::Edge && most == 4000),
            "{ring:?} {place:?} {found:?} {exact:?}"
        );
        counts[usize::from(exact == Side::Edge) + 2 * usize::from(exact == Side::Inside)] += 1;
    }
    assert!(counts.into_iter().all(|count| count > 500), "{counts:?}");
}

fn whole_numbers(ring: &[[i32; 2]], [x, y]: [i32; 2]) -> Side {
    let mut inside = false;
    for (i, a) in ring.iter().enumerate() {
        let b = ring[(i + 1) % ring.len()];
        let [ax, ay, bx, by] = [a[0] - x, a[1] - y, b[0] - x, b[1] - y].map(i64::from);
        let area = ax * by - ay * bx;
        if area == 0 && ax * bx + ay * by <= 0 {
            return Side::Edge;
        }
        if (ax < 0) != (bx < 0) && (area < 0) == (ax < 0) {
            inside = !inside;
        }
    }
    if inside { Side::Inside } else { Side::Outside }
}

/// Places of the plane, and straight lines in it, against geodesics.
#[test]
fn plane_is_as_accurate_as_claimed() {
    let mut rng = Rng::with_seed(11);
    let earth = earth();
    for (reach, [double, single, bulge]) in [(5e3, [1e-5, 2e-3, 1e-3]), (5e4, [1e-2, 2e-2, 0.5])] {
        let mut worst = [Worst::default(); 3];
        for _ in 0..3000 {
            let origin = single_place(&mut rng);
            let home = at(origin.lat().into(), origin.lon().into());
            let plane = Planar::about(Ellipsoid::WGS84, home).unwrap();
            let plane32 = Planar::about(Ellipsoid::WGS84, origin).unwrap();
            let mut to = || {
                let place = earth
                    .direct(home, 360.0 * rng.f64(), reach * rng.f64().sqrt())
                    .unwrap()
                    .position;
                let way = earth.inverse(home, place).unwrap();
                let (sin, cos) = way.azimuth1.to_radians().sin_cos();
                (place, [way.distance * sin, way.distance * cos])
            };
            let apart = |a: [f64; 2], b: [f64; 2]| (a[0] - b[0]).hypot(a[1] - b[1]);
            let ((one, true1), (two, true2)) = (to(), to());
            worst[0].add(apart(plane.place(one), true1));
            let turn = |x: f64| x - 360.0 * (x / 360.0).round();
            let offset = LatLon::new((one.lat() - home.lat()) as f32, turn(one.lon() - home.lon()) as f32).unwrap();
            worst[1].add(apart(plane32.offset(offset).map(Into::into), true1));
            // The middle of an edge, from the straight line.
            let line = earth.inverse(one, two).unwrap();
            let middle = earth.direct(one, line.azimuth1, line.distance / 2.0).unwrap().position;
            let [x, y] = plane.place(middle);
            let [dx, dy] = [true2[0] - true1[0], true2[1] - true1[1]];
            worst[2].add(((x - true1[0]) * dy - (y - true1[1]) * dx).abs() / dx.hypot(dy));
        }
        println!("plane {reach}: {worst:?}");
        for (worst, claim) in worst.into_iter().zip([double, single, bulge]) {
            assert!(worst.value() <= claim, "{reach}: {worst:?} {claim}");
        }
    }
    assert!(PlanarArea::new(Ellipsoid::<f32>::WGS84).is_ok());
    assert!(Planar::about(Ellipsoid::new(1.0, 0.1).unwrap(), at(0.0, 0.0)).is_err());
}

fn single_place(rng: &mut Rng) -> LatLon<f32> {
    single(at(160.0 * rng.f64() - 80.0, 360.0 * rng.f64() - 180.0))
}

fn distances<T: Scalar>(worst: &mut Worst, rng: &mut Rng) {
    let plane = Planar::about(Ellipsoid::WGS84, LatLon::new(T::of(47.0), T::of(8.0)).unwrap()).unwrap();
    let point = |rng: &mut Rng| [(); 2].map(|()| T::of(10_000.0 * (rng.f64() - 0.5)));
    let ring: Vec<_> = (0..5).map(|_| point(rng)).collect();
    let place = point(rng);
    let fence = Fence::new(&plane, &[&ring]).distance(place);
    let double = |p: [T; 2]| p.map(Into::<f64>::into);
    let exact: Vec<_> = ring.iter().copied().map(double).collect();
    let [x, y] = double(place);
    let mut nearest = f64::INFINITY;
    for (i, a) in exact.iter().enumerate() {
        let b = exact[(i + 1) % exact.len()];
        let [dx, dy] = [b[0] - a[0], b[1] - a[1]];
        let part = (((x - a[0]) * dx + (y - a[1]) * dy) / (dx * dx + dy * dy)).clamp(0.0, 1.0);
        nearest = testkit::minimum(nearest, (a[0] + part * dx - x).hypot(a[1] + part * dy - y));
    }
    let found: f64 = fence.into();
    worst.add((found.abs() - nearest).abs());
    assert_eq!(found < 0.0, Fence::new(&plane, &[&ring]).side(place) == Side::Inside);
}

#[test]
fn distances_to_a_fence() {
    let (mut worst, mut worst32, mut rng) = (Worst::default(), Worst::default(), Rng::with_seed(12));
    for _ in 0..5000 {
        distances::<f64>(&mut worst, &mut rng);
        distances::<f32>(&mut worst32, &mut rng);
    }
    println!("{worst:?} {worst32:?}");
    assert!(worst.value() <= 4e-12 && worst32.value() <= 3e-3);
    // On the sphere: past the ends and beside.
    let sphere = sphere();
    let rings = [ring(&[(0.0, 0.0), (0.0, 10.0), (10.0, 10.0), (10.0, 0.0)])];
    let rings = [rings[0].as_slice()];
    let fence = Fence::new(&sphere, &rings);
    let degree = 6_371_000.0 * std::f64::consts::PI / 180.0;
    for (lat, lon, degrees) in [(1.0, 5.0, -1.0), (-2.0, 5.0, 2.0), (0.0, -3.0, 3.0), (0.0, 5.0, 0.0)] {
        let error = fence.distance(at(lat, lon)) - degrees * degree;
        assert!(error.abs() < 1e-3, "{lat} {lon} {error}");
    }
}

#[test]
fn sides_are_written() {
    let said = [Side::Inside, Side::Outside, Side::Edge].map(|side| side.to_string());
    assert_eq!(said, ["inside", "outside", "edge"]);
}
