//! Fences, arcs and corridors.

use terrella::geodesic::{Area, Geodesic, GreatCircle, Karney};
use terrella::route::{Arc, Corridor, EdgeCrossing, Fence, Planar, Side};
use terrella::{Ellipsoid, LatLon};

use testkit::bytes::Bytes;
use testkit::properties;
use testkit::scalar::Scalar;

properties! { fences plane_fences arcs corridors }

/// Corners anywhere, near each other, on one meridian and on opposite ones, at poles, repeated.
fn ring<T: Scalar>(bytes: &mut Bytes<'_>) -> Vec<LatLon<T>> {
    let count = bytes.byte() % 7;
    let mut ring: Vec<LatLon<T>> = Vec::new();
    for _ in 0..count {
        let corner = match (bytes.byte() % 8, ring.last()) {
            (0..=2, Some(&last)) => bytes.place_about(last, false),
            (3, Some(&last)) => bytes.place_about(last, true),
            (4, Some(&last)) => LatLon::new(bytes.within(90.0), last.lon()).unwrap(),
            (5, Some(_)) => ring[usize::from(bytes.byte()) % ring.len()],
            (6, _) => LatLon::new(T::of(if bytes.flag() { 90.0 } else { -90.0 }), bytes.within(180.0)).unwrap(),
            _ => bytes.place(),
        };
        ring.push(corner);
    }
    ring
}

/// Never inside by one and outside by the other.
fn agree(one: Side, two: Side) -> bool {
    one == two || one == Side::Edge || two == Side::Edge
}

fn opposite(side: Side) -> Side {
    match side {
        Side::Inside => Side::Outside,
        Side::Outside => Side::Inside,
        Side::Edge => Side::Edge,
    }
}

/// Whichever corner comes first and whichever way the ring runs, places are on the same side, and corners on the edge;
/// what is not to the left is to the right.
fn laws<T: Scalar, G: EdgeCrossing<T>>(ground: &G, ring: &[G::Place], place: G::Place, halves: bool, context: &str) {
    let mut back = ring.to_vec();
    back.reverse();
    let mut turned = ring.to_vec();
    turned.rotate_left(ring.len() / 2);
    let side = |ring: &[G::Place]| Fence::new(ground, &[ring]).side(place);
    let here = side(ring);
    if !halves {
        assert!(agree(here, side(&turned)), "{context}");
        assert!(agree(here, side(&back)), "{context}");
    }
    for &corner in ring {
        assert_eq!(Fence::new(ground, &[ring]).side(corner), Side::Edge, "{context}");
    }
    // A ring twice, and with itself as a hole.
    let rings = [ring, ring];
    let twice = Fence::new(ground, &rings);
    assert!(twice.side(place) != Side::Inside, "{context}");
    let left = Fence::to_the_left(ground, &[ring]).side(place);
    assert!(agree(left, here) || agree(left, opposite(here)), "{context}");
}

fn fences<T: Scalar>(bytes: &mut Bytes<'_>) {
    let ring = ring::<T>(bytes);
    let place = match (bytes.byte() % 3, ring.first()) {
        (0, Some(&corner)) => bytes.place_about(corner, false),
        _ => bytes.place(),
    };
    let ellipsoid: Ellipsoid<T> = if bytes.flag() {
        Ellipsoid::WGS84
    } else {
        bytes.ellipsoid(-0.1, 0.1)
    };
    let context = format!("{} {ellipsoid:?} {ring:?} {place:?}", T::NAME);
    laws(
        &Karney::new(ellipsoid).unwrap(),
        &ring,
        place,
        halves(ellipsoid, &ring),
        &context,
    );
    let sphere = GreatCircle::new(ellipsoid.a()).unwrap();
    let round = Ellipsoid::sphere(ellipsoid.a()).unwrap();
    laws(&sphere, &ring, place, halves(round, &ring), &context);
    let distance: f64 = Fence::new(&sphere, &[&ring]).distance(place).into();
    assert!(!distance.is_nan(), "{context}");
}

/// Whether both sides of a ring are nearly equal: rounding takes one. Or whether the ring is another one backwards:
/// between nearly opposite places rounding takes one of two shortest lines.
fn halves<T: Scalar>(ellipsoid: Ellipsoid<T>, ring: &[LatLon<T>]) -> bool {
    let next = ring.iter().skip(1).chain(ring.first());
    let right = T::of(90.0);
    let opposite = |from: LatLon<T>, to: LatLon<T>| {
        let turn = (from.lon() - to.lon()).abs() - T::of(180.0);
        (from.lat() + to.lat()).abs() < T::ONE && (from.lat().abs() == right || turn.abs() < T::of(20.0))
    };
    if ring.iter().zip(next).any(|(&from, &to)| opposite(from, to)) {
        return true;
    }
    let area = Area::new(ellipsoid).unwrap();
    let mut polygon = area.polygon();
    ring.iter().for_each(|&corner| polygon.add(corner));
    let [left, right]: [f64; 2] = [polygon.left_area(), polygon.right_area()].map(Into::into);
    let nearly = [1e-6, 1e-2][T::CLAIM];
    (left - right).abs() < nearly * (left + right)
}

fn plane_fences<T: Scalar>(bytes: &mut Bytes<'_>) {
    let plane = Planar::about(Ellipsoid::<T>::WGS84, bytes.place()).unwrap();
    let kind = bytes.byte() % 3;
    let mut point = || match kind {
        0 => [(); 2].map(|()| bytes.anything::<T>()),
        1 => [(); 2].map(|()| bytes.within(1e5)),
        _ => [(); 2].map(|()| T::of(f64::from(bytes.between(4)))),
    };
    let (ring, place) = ([(); 5].map(|()| point()), point());
    if kind == 0 {
        // Any numbers: an answer.
        let fence = Fence::to_the_left(&plane, &[&ring]).distance(place);
        let _ = (fence, Fence::new(&plane, &[&ring]).side(place));
        return;
    }
    laws(&plane, &ring, place, false, &format!("{} {ring:?} {place:?}", T::NAME));
}

/// Any numbers are an arc or refused; its places are at the radius, and distances along it come back.
fn arcs<T: Scalar>(bytes: &mut Bytes<'_>) {
    let earth = Karney::<T>::new(Ellipsoid::WGS84).unwrap();
    let (centre, other) = (bytes.place(), bytes.place());
    let [radius, azimuth, sweep] = if bytes.flag() {
        [(); 3].map(|()| bytes.anything())
    } else {
        [bytes.within::<T>(9e6).abs(), bytes.within(360.0), bytes.within(360.0)]
    };
    let Ok(arc) = Arc::new(&earth, centre, radius, azimuth, sweep) else {
        return;
    };
    let context = || format!("{} {centre:?} {radius:?} {azimuth:?} {sweep:?}", T::NAME);
    let size: f64 = radius.into();
    let rounding = [2e-8, 5.0 + 2e-6 * size][T::CLAIM];
    let length: f64 = arc.length().into();
    assert!(
        length >= 0.0 && length <= 6.3 * size + rounding,
        "{} {length}",
        context()
    );
    for place in [arc.start(), arc.end(), arc.at(T::of(0.5 * length)).unwrap().position] {
        let apart: f64 = earth.distance(centre, place).unwrap().into();
        assert!((apart - size).abs() <= rounding, "{} {apart}", context());
    }
    let distance: f64 = arc.distance(other).into();
    assert!(distance >= 0.0, "{} {distance}", context());
    let _ = (arc.cross_track(other), arc.abeam(other), arc.at(bytes.anything()));
    if let Ok(corners) = arc.corners(T::of(size * 1e-4)) {
        assert!((1..=300).contains(&corners.count()), "{}", context());
    }
}

/// Any line has an outline with an end.
fn corridors<T: Scalar>(bytes: &mut Bytes<'_>) {
    let earth = Karney::<T>::new(Ellipsoid::WGS84).unwrap();
    let line = ring(bytes);
    let width = bytes.within::<T>(6e5).abs();
    let tolerance = width * T::of(0.01);
    let Ok(corridor) = Corridor::new(&earth, &line, width, tolerance) else {
        return;
    };
    let count = corridor.outline().count();
    assert_eq!(count == 0, line.is_empty(), "{line:?} {width:?}");
    assert!(count <= 500 * line.len(), "{} {line:?} {width:?}: {count}", T::NAME);
    for corner in corridor.leg(usize::from(bytes.byte() % 8)) {
        assert!(corner.lat().abs() <= T::of(90.0));
    }
}
