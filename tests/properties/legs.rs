//! Closest points of legs, polylines and rings.

use terrella::geodesic::{Geodesic, GreatCircle, Karney};
use terrella::route::{Closest, Legs, Reach, TangentPlane, Track};
use terrella::{Ellipsoid, LatLon};

use testkit::bytes::Bytes;
use testkit::properties;
use testkit::scalar::Scalar;

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
