//! Rhumb lines and headings.

use terrella::LatLon;
use terrella::geodesic::GeodesicError;
use terrella::route::{Rhumb, heading};
use testkit::bytes::Bytes;
use testkit::properties;
use testkit::scalar::Scalar;

properties! { rhumb_inverse rhumb_direct rhumb_any headings }

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
