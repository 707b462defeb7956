//! Laws of the room `route`.

use terrella::LatLon;
use terrella::geodesic::GeodesicError;
use terrella::route::{Rhumb, heading};
use terrella::geodesic::{Geodesic, GreatCircle, Karney};
use terrella::route::{Closest, Legs, Reach, TangentPlane, Track};
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
}
