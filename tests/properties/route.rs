//! Laws of the room `route`.

use terrella::LatLon;
use terrella::geodesic::GeodesicError;
use terrella::route::{Rhumb, heading};
use terrella::geodesic::{Geodesic, GreatCircle, Karney};
use terrella::route::{Closest, Legs, Reach, TangentPlane, Track};
use terrella::geodesic::{Area, Geodesic, GreatCircle, Karney};
use terrella::route::{Arc, Corridor, EdgeCrossing, Fence, Planar, Side};
use terrella::{Ellipsoid, LatLon};

use testkit::bytes::Bytes;
use testkit::properties;
use testkit::scalar::Scalar;

properties!(rhumb_inverse rhumb_direct rhumb_any headings);

fn double<T: Scalar>(value: T) -> f64 {
    value.into()
}

/// The way back is the same line; the mirror's is the mirrored one; a meridian's length is no longer than
/// any.
fn rhumb_inverse<T: Scalar>(bytes: &mut Bytes<'_>) {
    let rhumb = Rhumb::<T>::new(bytes.ellipsoid(-0.1, 0.1)).unwrap();
    let (from, to) = bytes.pair::<T>();
    let line = rhumb.inverse(from, to);
    let context = || format!("{} {:?} {from:?} {to:?} {line:?}", T::NAME, rhumb.ellipsoid());
    assert!(
        line.distance.is_finite() && line.azimuth.is_finite() && line.area.is_finite(),
        "{}",
        context()
    );
    assert!(
        line.distance >= T::ZERO && line.azimuth.abs() <= T::of(180.0),
        "{}",
        context()
    );
    let back = rhumb.inverse(to, from);
    assert_eq!(back.distance.bits(), line.distance.bits(), "{}", context());
    assert_eq!(double(back.area), -double(line.area), "{}", context());
    let south = |place: LatLon<T>| LatLon::new(-place.lat(), place.lon()).unwrap();
    let mirrored = rhumb.inverse(south(from), south(to));
    assert_eq!(mirrored.distance.bits(), line.distance.bits(), "{}", context());
    assert_eq!(double(mirrored.area), -double(line.area), "{}", context());
    let along = rhumb.distance(from, LatLon::new(to.lat(), from.lon()).unwrap());
    assert!(
        double(along) <= double(line.distance) * (1.0 + 4.0 * double(T::EPSILON)),
        "{}",
        context()
    );
}

/// A line arrives where the inverse problem says, away from poles, if it did not turn too far.
fn rhumb_direct<T: Scalar>(bytes: &mut Bytes<'_>) {
    let ellipsoid = bytes.ellipsoid::<T>(-0.1, 0.1);
    let rhumb = Rhumb::<T>::new(ellipsoid).unwrap();
    let (from, to) = bytes.pair::<T>();
    let line = rhumb.line_between(from, to);
    let context = || {
        format!(
            "{} {:?} {from:?} {to:?} {:?}",
            T::NAME,
            rhumb.ellipsoid(),
            line.at(line.length())
        )
    };
    let Ok(end) = line.at(line.length()) else {
        // Only by a rounding, beyond a pole.
        assert!(to.lat().abs() > T::of(89.9), "{}", context());
        return;
    };
    let lat = double(to.lat());
    let north = double(end.position.lat()) - lat;
    let rounding = 360.0 * double(T::EPSILON);
    assert!(north.abs() <= 4.0 * rounding, "{} {north:e}", context());
    // About a pole a rounding of the latitude turns the line.
    if from.lat().abs() < T::of(89.0) && lat.abs() < 89.0 {
        let turn = (double(end.longitude) - double(to.lon())).rem_euclid(360.0);
        let east = testkit::minimum(turn, 360.0 - turn) * lat.to_radians().cos();
        assert!(east <= 8.0 * rounding, "{} {east:e}", context());
    }
}

/// Any numbers at all: a place, or what is wrong; and the limit is one.
fn rhumb_any<T: Scalar>(bytes: &mut Bytes<'_>) {
    let rhumb = Rhumb::<T>::new(bytes.ellipsoid(-0.1, 0.1)).unwrap();
    let from = bytes.place::<T>();
    let [azimuth, distance] = [bytes.anything::<T>(), bytes.anything()];
    let context = || format!("{} {:?} {from:?} {azimuth:?} {distance:?}", T::NAME, rhumb.ellipsoid());
    match rhumb.direct(from, azimuth, distance) {
        Ok(end) => {
            let place = end.position;
            assert!(
                place.lat().abs() <= T::of(90.0) && place.lon().abs() <= T::of(180.0),
                "{}",
                context()
            );
            assert!(end.longitude.is_finite(), "{}", context());
        }
        Err(GeodesicError::Azimuth(refused)) => {
            assert!(
                !azimuth.is_finite() && refused.bits() == azimuth.bits(),
                "{}",
                context()
            );
        }
        Err(GeodesicError::Distance(refused)) => {
            assert!(
                !distance.is_finite() && refused.bits() == distance.bits(),
                "{}",
                context()
            );
        }
        Err(GeodesicError::TooFar {
            distance: refused,
            limit,
        }) => {
            assert!(
                refused.bits() == distance.bits() && limit.is_finite(),
                "{} {limit:?}",
                context()
            );
        }
        Err(other) => panic!("{} {other:?}", context()),
    }
}

/// Wraps are in their intervals, and agree up to whole turns; differences have opposite signs.
fn headings<T: Scalar>(bytes: &mut Bytes<'_>) {
    let [a, b] = [bytes.anything::<T>(), bytes.anything()];
    let [circle, half] = [heading::to_circle(a), heading::to_half_circles(a)];
    let turn = heading::difference(a, b);
    let context = || format!("{} {a:?} {b:?} {circle:?} {half:?} {turn:?}", T::NAME);
    if !a.is_finite() {
        assert!(
            [circle, half, turn].iter().all(|value| !value.is_finite()),
            "{}",
            context()
        );
        return;
    }
    assert!(circle >= T::ZERO && circle < T::of(360.0), "{}", context());
    assert!(half >= T::of(-180.0) && half < T::of(180.0), "{}", context());
    assert_eq!(heading::to_half_circles(half).bits(), half.bits(), "{}", context());
    let apart = heading::difference(circle, half).abs();
    assert!(double(apart) <= 180.0 * double(T::EPSILON), "{}", context());
    if b.is_finite() {
        assert!(turn.abs() <= T::of(180.0), "{}", context());
        let back = heading::difference(b, a);
        assert!(
            double(back) == -double(turn) || turn.abs() == T::of(180.0),
            "{}",
            context()
        );
        assert!(
            heading::mean(&[a, b]).is_ok_and(|mean| mean >= T::ZERO && mean < T::of(360.0))
                || turn.abs() > T::of(179.9)
        );
    } else {
        assert!(heading::mean(&[a, b]).is_err());
    }
}
properties! { closest_on_ellipsoid closest_on_sphere closest_in_plane closest_of_path }

/// A place: anywhere, next to an end of a leg or to the antipode of one.
fn beside<T: Scalar>(bytes: &mut Bytes<'_>, (start, end): (LatLon<T>, LatLon<T>)) -> LatLon<T> {
    match bytes.byte() % 6 {
        0 | 1 => bytes.place(),
        2 => bytes.place_about(start, false),
        3 => bytes.place_about(end, false),
        4 => bytes.place_about(start, true),
        _ => bytes.place_about(end, true),
    }
}

/// What is true of any leg of a surface, in which distances between places are known to a rounding.
fn leg_laws<T: Scalar, S: Legs<T> + Geodesic<T>>(
    surface: &S,
    ship: LatLon<T>,
    (start, end): (LatLon<T>, LatLon<T>),
    rounding: f64,
) {
    let context = || format!("{} {ship:?} {start:?} {end:?}", T::NAME);
    let double = |x: T| -> f64 { x.into() };
    let apart = |a, b| double(surface.distance(a, b).unwrap());
    let leg = surface.leg(start, end);
    let length = surface.length(&leg);
    let Closest {
        distance,
        position,
        along,
        reach,
    } = surface.closest_on(&leg, ship);
    assert!(
        distance >= T::ZERO && along >= T::ZERO && along <= length,
        "{}",
        context()
    );
    assert!(
        (apart(ship, position) - double(distance)).abs() <= rounding,
        "{}",
        context()
    );
    assert!(apart(start, position) <= double(along) + rounding, "{}", context());
    for end in [start, end] {
        assert!(double(distance) <= apart(ship, end) + rounding, "{}", context());
    }
    match reach {
        Reach::BeforeStart => assert!(along == T::ZERO && position == start, "{}", context()),
        Reach::PastEnd => assert!(along == length && position == end, "{}", context()),
        Reach::Within => (),
    }
    assert!(surface.at_least(ship, start, end) <= distance, "{}", context());
    // Two lines may be as short, and the one back another: on these ellipsoids from 0.9 of half a circuit on, as
    // both sides of the equator.
    if double(length) < 1.75e7 {
        let back = surface.closest(ship, end, start);
        assert!(
            (double(back.distance) - double(distance)).abs() <= rounding,
            "{} {back:?}",
            context()
        );
    }
    let Track { across, along } = surface.track_beside(&leg, ship);
    assert!(across.is_finite() && along.is_finite(), "{}", context());
    if double(length) < 1e7 && double(distance) < 5e6 {
        assert!(
            double(across.abs()) <= double(distance) + rounding,
            "{} {across:?}",
            context()
        );
    }
}

fn closest_on_ellipsoid<T: Scalar>(bytes: &mut Bytes<'_>) {
    let surface = Karney::new(bytes.ellipsoid::<T>(-1.0 / 9.0, 0.1)).unwrap();
    let pair = bytes.pair();
    let ship = beside(bytes, pair);
    leg_laws(&surface, ship, pair, [1e-7, 64.0][T::CLAIM]);
}

fn closest_on_sphere<T: Scalar>(bytes: &mut Bytes<'_>) {
    let surface = GreatCircle::new(T::of(6.371e6)).unwrap();
    let pair = bytes.pair();
    let ship = beside(bytes, pair);
    leg_laws(&surface, ship, pair, [5e-8, 32.0][T::CLAIM]);
}

/// Any offsets have an answer; near ones that of the ellipsoid.
fn closest_in_plane<T: Scalar>(bytes: &mut Bytes<'_>) {
    let origin = bytes.place::<T>();
    let plane = TangentPlane::local(Ellipsoid::WGS84, origin).unwrap();
    let pair = bytes.pair();
    let ship = beside(bytes, pair);
    let is_place = |place: LatLon<T>| place.lat().abs() <= T::of(90.0) && place.lon().abs() <= T::of(180.0);
    for place in [ship, pair.0, pair.1] {
        let closest = plane.closest(place, pair.0, pair.1);
        assert!(
            closest.distance >= T::ZERO && closest.distance.is_finite() && closest.along.is_finite(),
            "{closest:?}"
        );
        assert!(is_place(closest.position), "{closest:?}");
        let track = plane.track(place, pair.0, pair.1);
        assert!(track.across.is_finite() && track.along.is_finite(), "{track:?}");
    }
    let near: LatLon<f64> = LatLon::new(bytes.within(80.0), bytes.within(180.0)).unwrap();
    let mut offset = || LatLon::<T>::new(T::of(0.02 * bytes.even()), T::of(0.02 * bytes.even())).unwrap();
    let offsets = [offset(), offset(), offset()];
    let origin = LatLon::<T>::new(T::of(near.lat()), T::of(near.lon())).unwrap();
    let whole = |offset: LatLon<T>| {
        let sum = |origin: T, offset: T| Into::<f64>::into(origin) + Into::<f64>::into(offset);
        LatLon::new(sum(origin.lat(), offset.lat()), sum(origin.lon(), offset.lon())).unwrap()
    };
    let [ship, start, end] = offsets;
    let plane = TangentPlane::local(Ellipsoid::WGS84, origin).unwrap();
    let found: f64 = plane.closest(ship, start, end).distance.into();
    let earth = Karney::new(Ellipsoid::WGS84).unwrap();
    let truth = earth.closest(whole(ship), whole(start), whole(end)).distance;
    assert!(
        (found - truth).abs() <= [1e-5, 5e-3][T::CLAIM],
        "{origin:?} {offsets:?}: {found} {truth}"
    );
}

/// Of all legs it is the first that is closest.
fn closest_of_path<T: Scalar>(bytes: &mut Bytes<'_>) {
    let earth = Karney::new(bytes.ellipsoid::<T>(-1.0 / 9.0, 0.1)).unwrap();
    let (a, b) = bytes.pair();
    let path = [a, b, beside(bytes, (a, b)), bytes.place()];
    let ship = beside(bytes, (a, b));
    let legs = [(0, 1), (1, 2), (2, 3), (3, 0)].map(|(from, to)| earth.closest(ship, path[from], path[to]));
    let first = |legs: &[Closest<T>]| {
        let legs = legs.iter().copied().enumerate();
        legs.reduce(|best, next| if next.1.distance < best.1.distance { next } else { best })
    };
    let open = earth.closest_of_path(ship, path).map(|on| (on.leg, on.closest));
    let ring = earth.closest_of_ring(ship, path).map(|on| (on.leg, on.closest));
    assert_eq!((open, ring), (first(&legs[..3]), first(&legs)), "{path:?} {ship:?}");
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
