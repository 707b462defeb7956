//! Every constructor, conversion and parser with anything at all: it refuses, with the value, or what it gives is what it says; and
//! behind it nothing is NaN.

use core::error::Error;
use core::fmt::{Debug, Display};
use core::str::FromStr;

use terrella::cube::{
    CubeMap, CubeProjection, Face, FacePoint, InvalidFace, InvalidFacePoint, InvalidNumbered, Numbering, Projection,
};
use terrella::distortion::{Ground, Singular};
use terrella::frame::InvalidEnu;
use terrella::geodesic::{
    AnyMethod, Area, Geodesic, GeodesicError, GreatCircle, Haversine, InvalidMethod, Karney, Method,
};
use terrella::latitude::{Conversion, InvalidLatitude, UnsupportedFlattening};
use terrella::{
    Direction, Ecef, Ellipsoid, Enu, Geodetic, InvalidDirection, InvalidEcef, InvalidEllipsoid, InvalidHeight,
    InvalidLatLon, LatLon, Latitude, LocalFrame, NAMED, Shift, Shifted,
};
use testkit::{maximum, minimum};

use super::geodesic::flattenings;
use testkit::bytes::Bytes;
use testkit::properties;
use testkit::scalar::{Scalar, same};
use testkit::vector::{cross, excess, length};

properties! {
    lat_lon direction near_unit face_point numbered geodetic ellipsoid flattening latitude names lines beyond_lat_lon
    beyond_direction beyond_face_point
}

/// An error's text says what is wrong in one line, the value included.
fn says(error: impl Error, value: impl Debug) {
    let text = error.to_string();
    assert!(
        !text.is_empty() && !text.contains('\n') && text == text.trim(),
        "{text:?}"
    );
    assert!(text.contains(&format!("{value:?}")), "{text:?} does not say {value:?}");
}

/// lon less the multiple of 360 that leaves it in [−180, 180], in whole numbers; 180 with the sign of lon.
fn wrapped(lon: f64) -> f64 {
    if lon.abs() <= 180.0 {
        return lon;
    }
    let bits = lon.to_bits();
    let exponent = ((bits >> 52) & 0x7FF) as i32 - 1075;
    let significand = u128::from(bits & ((1 << 52) - 1) | 1 << 52);
    // |lon| = significand · 2^exponent.
    let (rest, circle, unit) = if exponent >= 0 {
        let power = (0..exponent).fold(1, |power, _| power * 2 % 360);
        (significand % 360 * power % 360, 360, 1.0)
    } else {
        let circle = 360 << -exponent;
        (significand % circle, circle, 2f64.powi(exponent))
    };
    let signed = if rest > circle / 2 {
        -((circle - rest) as f64)
    } else {
        rest as f64
    };
    signed * unit * lon.signum()
}

/// Latitudes between the poles, and longitudes wrapped exactly.
fn lat_lon<T: Scalar>(bytes: &mut Bytes<'_>) {
    let (lat, lon) = (bytes.anything::<T>(), bytes.anything::<T>());
    let (exact_lat, exact_lon) = (lat.into(), lon.into());
    match LatLon::new(lat, lon) {
        Ok(place) => {
            assert!(exact_lat.abs() <= 90.0 && exact_lon.is_finite(), "{place:?}");
            assert!(same(place.lat(), lat), "{place:?}");
            assert_eq!(place.lon().into(), wrapped(exact_lon), "{lon:?}");
            assert!(exact_lon.abs() > 180.0 || same(place.lon(), lon), "{lon:?}");
        }
        Err(why @ InvalidLatLon::Latitude(refused)) => {
            assert!(
                (exact_lat.abs() > 90.0 || exact_lat.is_nan()) && same(refused, lat),
                "{why:?}"
            );
            says(why, lat);
        }
        Err(why @ InvalidLatLon::Longitude(refused)) => {
            let known = exact_lat.abs() <= 90.0 && !exact_lon.is_finite();
            assert!(known && same(refused, lon), "{why:?}");
            says(why, lon);
        }
    }
}

/// A vector scaled by a power of two to a largest component in [½, 2): exact.
fn scaled<T: Scalar>(v: [T; 3]) -> [f64; 3] {
    let v = v.map(Into::<f64>::into);
    let largest = v.iter().fold(0.0, |a: f64, b| maximum(a, b.abs()));
    let shift = -largest.log2().floor() as i32;
    // In two steps, as 2^1074 is no number.
    v.map(|c| c * 2f64.powi(shift / 2) * 2f64.powi(shift - shift / 2))
}

fn judge_direction<T: Scalar>([x, y, z]: [T; 3]) {
    let v = [x, y, z].map(Into::<f64>::into);
    let valid = v.iter().all(|c| c.is_finite()) && v != [0.0; 3];
    match Direction::new(x, y, z) {
        Ok(direction) => {
            assert!(valid, "{v:?}");
            let unit = direction.to_array();
            let epsilon = T::EPSILON.into();
            let exact = unit.map(Into::<f64>::into);
            // Half of 4 ε, within which a vector is kept as it is, and the rounding of its square.
            assert!(
                0.5 * excess(exact).abs() <= 2.75 * epsilon,
                "{v:?}: {unit:?} is no unit vector"
            );
            let v = scaled([x, y, z]);
            assert!(
                cross(exact, v) <= 2.0 * epsilon * length(v),
                "{v:?}: {unit:?} is elsewhere"
            );
            for i in 0..3 {
                assert_eq!(exact[i].is_sign_negative(), v[i].is_sign_negative(), "{v:?}: {unit:?}");
            }
            let [x, y, z] = unit;
            assert_eq!(Direction::new(x, y, z), Ok(direction), "{v:?}: {unit:?} is not kept");
        }
        Err(why) => {
            let InvalidDirection { x: rx, y: ry, z: rz } = why;
            assert!(!valid && same(rx, x) && same(ry, y) && same(rz, z), "{why:?}");
            says(why, y);
        }
    }
}

/// Vectors of any length.
fn direction<T: Scalar>(bytes: &mut Bytes<'_>) {
    judge_direction::<T>([bytes.anything(), bytes.anything(), bytes.anything()]);
}

/// Next to unit vectors, on both sides of where a vector is kept as it is.
fn near_unit<T: Scalar>(bytes: &mut Bytes<'_>) {
    let v = [bytes.even(), bytes.even(), bytes.even()];
    let stretch = 1.0 + 0.5 * f64::from(bytes.between(20)) * T::EPSILON.into();
    let length = length(v);
    judge_direction(v.map(|c| T::of(c / length * stretch)));
}

/// Points of the square.
fn face_point<T: Scalar>(bytes: &mut Bytes<'_>) {
    let index = bytes.byte();
    let (x, y) = (bytes.anything::<T>(), bytes.anything::<T>());
    let face = match Face::from_index(index) {
        Ok(face) => {
            assert!(index < 6 && face.index() == index && Face::ALL[usize::from(index)] == face);
            face
        }
        Err(why) => {
            assert!(index >= 6 && why == InvalidFace(index));
            says(why, index);
            Face::Front
        }
    };
    let valid = x.into().abs() <= 1.0 && y.into().abs() <= 1.0;
    match FacePoint::new(face, x, y) {
        Ok(p) => assert!(valid && p.face() == face && same(p.x(), x) && same(p.y(), y), "{p:?}"),
        Err(why) => {
            let InvalidFacePoint { x: rx, y: ry } = why;
            assert!(!valid && same(rx, x) && same(ry, y), "{why:?}");
            says(why, x);
        }
    }
}

/// Points of other people's faces, and back.
fn numbered<T: Scalar>(bytes: &mut Bytes<'_>) {
    let numbering = bytes.choice(&[Numbering::S2, Numbering::OpenGl, Numbering::Fits]);
    let (number, x, y) = (bytes.byte(), bytes.anything::<T>(), bytes.anything::<T>());
    let valid = x.into().abs() <= 1.0 && y.into().abs() <= 1.0;
    match numbering.from_point(number, x, y) {
        Ok(point) => {
            assert!(number < 6 && valid);
            assert_eq!(numbering.to_point(point), (number, x, y), "{numbering:?} {point:?}");
            assert_eq!(numbering.face(number), Ok(point.face()));
        }
        Err(why @ InvalidNumbered::Face(InvalidFace(refused))) => {
            assert!(number >= 6 && refused == number);
            says(why, number);
        }
        Err(why @ InvalidNumbered::Point(InvalidFacePoint { x: rx, y: ry })) => {
            assert!(number < 6 && !valid && same(rx, x) && same(ry, y), "{why:?}");
            says(why, y);
        }
    }
}

/// Heights and points that are finite.
fn geodetic<T: Scalar>(bytes: &mut Bytes<'_>) {
    let (place, height) = (bytes.place::<T>(), bytes.anything::<T>());
    match Geodetic::new(place, height) {
        Ok(position) => {
            assert!(height.is_finite() && same(position.height(), height) && position.lat_lon() == place);
            let (lat, lon) = (position.lat(), position.lon());
            assert!(same(lat, place.lat()) && same(lon, place.lon()));
        }
        Err(why @ InvalidHeight { height: refused }) => {
            assert!(!height.is_finite() && same(refused, height));
            says(why, height);
        }
    }
    let point = [bytes.anything::<T>(), bytes.anything(), bytes.anything()];
    let [x, y, z] = point;
    let finite = x.is_finite() && y.is_finite() && z.is_finite();
    let judge = |result: Result<Ecef<T>, InvalidEcef<T>>| match result {
        Ok(kept) => {
            let [a, b, c] = kept.to_array();
            assert!(finite && same(a, x) && same(b, y) && same(c, z), "{kept:?}");
        }
        Err(why) => {
            let InvalidEcef { x: a, y: b, z: c } = why;
            assert!(!finite && same(a, x) && same(b, y) && same(c, z), "{why:?}");
            says(why, z);
        }
    };
    judge(Ecef::new(x, y, z));
    // A frame's points are finite, or refused.
    let frame = LocalFrame::new(Ellipsoid::<T>::WGS84, place.into());
    let enu = Enu {
        east: x,
        north: y,
        up: z,
    };
    if let Ok(point) = frame.from_enu(enu) {
        assert!(
            finite && point.to_array().iter().all(|v| v.is_finite()),
            "{enu:?}: {point:?}"
        );
    }
    match frame.enu_to_geodetic(enu) {
        Ok(there) => {
            let (lat, lon) = (there.lat(), there.lon());
            assert!(
                lat.abs() <= T::of(90.0) && lon.abs() <= T::of(180.0),
                "{enu:?}: {there:?}"
            );
            assert!(finite && there.height().is_finite(), "{enu:?}: {there:?}");
        }
        Err(why @ InvalidEnu { east, north, up }) => {
            assert!(same(east, x) && same(north, y) && same(up, z), "{why:?}");
            assert!(!finite || frame.from_enu(enu).is_err(), "{why:?}");
            says(why, z);
        }
    }
}

/// Axes and flattenings in range, and constants of them that are numbers.
fn ellipsoid<T: Scalar>(bytes: &mut Bytes<'_>) {
    let (a, f) = (bytes.anything::<T>(), bytes.anything::<T>());
    let (axis, flattening) = (T::of(1e-15)..=T::of(1e15), T::of(-1000.0)..T::ONE);
    match Ellipsoid::new(a, f) {
        Ok(e) => {
            assert!(axis.contains(&a) && flattening.contains(&f));
            assert!(same(e.a(), a) && same(e.f(), f));
            let radii = [e.b(), e.mean_radius(), e.authalic_radius(), e.volumetric_radius()];
            assert!(radii.iter().all(|r| r.is_finite() && *r > T::ZERO), "{e:?}: {radii:?}");
            assert!([e.n(), e.e2(), e.ep2()].iter().all(|v| v.is_finite()), "{e:?}");
            // A mean radius is between the axes.
            let (a, b) = (a.into(), e.b().into());
            let slack = 1.0 + 4.0 * T::EPSILON.into();
            let between = |r: T| r.into() <= maximum(a, b) * slack && r.into() * slack >= minimum(a, b);
            assert!(radii.iter().all(|&r| between(r)), "{e:?}: {radii:?}");
        }
        Err(why @ InvalidEllipsoid::SemiMajorAxis(refused)) => {
            assert!(!axis.contains(&a) && same(refused, a), "{why:?}");
            says(why, a);
        }
        Err(why @ InvalidEllipsoid::Flattening(refused)) => {
            assert!(
                axis.contains(&a) && !flattening.contains(&f) && same(refused, f),
                "{why:?}"
            );
            says(why, f);
        }
    }
    let spheres = [
        Ellipsoid::sphere(a).map(|sphere| sphere.a()),
        GreatCircle::new(a).map(|sphere| sphere.radius()),
        Haversine::new(a).map(|_| a),
    ];
    for sphere in spheres {
        match sphere {
            Ok(radius) => assert!(axis.contains(&a) && same(radius, a)),
            Err(InvalidEllipsoid::SemiMajorAxis(refused)) => assert!(!axis.contains(&a) && same(refused, a)),
            Err(other) => panic!("{other:?}"),
        }
    }
}

/// Every formula's flattenings.
fn flattening<T: Scalar>(bytes: &mut Bytes<'_>) {
    let f = bytes.anything::<T>();
    let f = if bytes.flag() { f } else { f * T::of(1e-3) };
    let Ok(ellipsoid) = Ellipsoid::new(T::of(6.4e6), f) else {
        return;
    };
    let within = |low: f64, high: f64, room: f64| {
        let f: f64 = f.into();
        // On either side of a bound its rounding decides.
        if f >= low + room && f <= high - room {
            Some(true)
        } else if f < low - room || f > high + room {
            Some(false)
        } else {
            None
        }
    };
    let room = 1e-6;
    let judge = |what: &str, result: Result<(), UnsupportedFlattening<T>>, expected: Option<bool>| {
        assert!(
            expected.is_none_or(|expected| result.is_ok() == expected),
            "{what} {ellipsoid:?}: {result:?}"
        );
        if let Err(why) = result {
            assert!(same(why.0, f), "{what}: {why:?}");
            says(why, f);
        }
    };
    let series = within(-1.0 / 9.0, 0.1, room);
    for &shift in Shift::ALL {
        let expected = match shift {
            Shift::Geodetic => Some(true),
            Shift::Geocentric | Shift::Parametric => within(-1.0, 0.5, 0.0),
            _ => series,
        };
        judge(shift.name(), Shifted::new(ellipsoid, shift).map(|_| ()), expected);
        judge(
            shift.name(),
            CubeMap::new(ellipsoid, shift, Projection::Adjusted).map(|_| ()),
            expected,
        );
        judge(
            shift.name(),
            Conversion::new(ellipsoid, Latitude::Geodetic, shift.into()).map(|_| ()),
            expected,
        );
        judge(
            shift.name(),
            Conversion::new(ellipsoid, shift.into(), Latitude::Geodetic).map(|_| ()),
            expected,
        );
    }
    judge("karney", Karney::new(ellipsoid).map(|_| ()), series);
    judge("area", Area::new(ellipsoid).map(|_| ()), series);
    for &method in Method::ALL {
        let [least, most] = method.profile().flattenings;
        let expected = within(least, most, room);
        let place = LatLon::default();
        judge(
            method.name(),
            method.about(ellipsoid, place).map(|_: AnyMethod<T>| ()),
            expected,
        );
        match method.on(ellipsoid) {
            Err(InvalidMethod::PlaceNeeded(refused)) => assert!(method.needs_place() && refused == method),
            Err(InvalidMethod::Flattening(why)) => assert_eq!(Err(why), method.about(ellipsoid, place)),
            on => assert_eq!(on.ok(), method.about(ellipsoid, place).ok()),
        }
    }
}

/// Latitudes up to the poles, in degrees and in radians; isometric ones up to infinity.
fn latitude<T: Scalar>(bytes: &mut Bytes<'_>) {
    let ellipsoid = bytes.ellipsoid::<T>(-1.0 / 9.0, 0.1);
    let (from, to) = (bytes.choice(Latitude::ALL), bytes.choice(Latitude::ALL));
    let conversion = Conversion::new(ellipsoid, from, to).unwrap();
    let value = bytes.anything::<T>();
    let quarter = T::of(core::f64::consts::FRAC_PI_2);
    for (limit, result) in [
        (T::of(90.0), conversion.degrees(value)),
        (quarter, conversion.radians(value)),
    ] {
        let context = || format!("{} {ellipsoid:?} {from} {value:?} to {to}: {result:?}", T::NAME);
        let valid = if from == Latitude::Isometric {
            !value.into().is_nan()
        } else {
            value.abs() <= limit
        };
        match result {
            Ok(converted) => {
                assert!(valid && !converted.into().is_nan(), "{}", context());
                assert!(to == Latitude::Isometric || converted.abs() <= limit, "{}", context());
                let sign = T::ONE.copysign(value);
                assert_eq!(T::ONE.copysign(converted), sign, "{}", context());
            }
            Err(why @ InvalidLatitude(refused)) => {
                assert!(!valid && same(refused, value), "{}", context());
                says(why, value);
            }
        }
    }
}

/// A name reads back, and nothing else is one; what is refused is told what is known.
fn name<T: Copy + PartialEq + Debug + Display + FromStr<Err: Error>>(text: &str, all: &[T]) {
    let known = all.iter().find(|kind| kind.to_string() == text);
    match (text.parse::<T>(), known) {
        (Ok(parsed), Some(&kind)) => assert_eq!(parsed, kind),
        (Err(why), None) => {
            let words = why.to_string();
            assert!(
                all.iter()
                    .all(|kind| words.split([' ', ',']).any(|word| word == kind.to_string())),
                "{words}"
            );
        }
        (parsed, known) => panic!("{text:?}: {:?} {known:?}", parsed.is_ok()),
    }
}

/// Text, and names with a letter changed, or not.
fn names<T: Scalar>(bytes: &mut Bytes<'_>) {
    let mut all: Vec<String> = NAMED.iter().map(ToString::to_string).collect();
    all.extend(Projection::ALL.iter().map(ToString::to_string));
    all.extend(Shift::ALL.iter().map(ToString::to_string));
    all.extend(Latitude::ALL.iter().map(ToString::to_string));
    all.extend(Method::ALL.iter().map(ToString::to_string));
    let mut letters = if bytes.flag() {
        all[usize::from(bytes.byte()) % all.len()].clone().into_bytes()
    } else {
        bytes.word().to_le_bytes().to_vec()
    };
    if bytes.flag() {
        let at = usize::from(bytes.byte()) % letters.len();
        letters[at] = bytes.byte();
    }
    let text = String::from_utf8_lossy(&letters);
    name(&text, Projection::ALL);
    name(&text, Shift::ALL);
    name(&text, Latitude::ALL);
    name(&text, Method::ALL);
    assert_eq!(
        Ellipsoid::<T>::named(&text).is_ok(),
        NAMED.contains(&&*text),
        "{text:?}"
    );
}

/// Azimuths, distances and fractions.
fn lines<T: Scalar>(bytes: &mut Bytes<'_>) {
    let method = bytes.choice(Method::ALL);
    let [least, most] = flattenings(method);
    let ellipsoid = bytes.ellipsoid::<T>(least, most);
    let (from, to) = bytes.pair::<T>();
    let (azimuth, distance) = (bytes.anything::<T>(), bytes.anything::<T>());
    let solver = method.about(ellipsoid, from).unwrap();
    let end = solver.direct(from, azimuth, distance);
    let context = || {
        format!(
            "{method} {} {ellipsoid:?} {from:?} {azimuth:?} {distance:?}: {end:?}",
            T::NAME
        )
    };
    match end {
        Ok(end) => {
            assert!(azimuth.is_finite() && distance.is_finite(), "{}", context());
            let position = end.position;
            assert!(
                LatLon::new(position.lat(), position.lon()) == Ok(position),
                "{}",
                context()
            );
            assert!(end.azimuth.into().abs() <= 180.0, "{}", context());
        }
        Err(why @ GeodesicError::Azimuth(refused)) => {
            assert!(!azimuth.is_finite() && same(refused, azimuth), "{}", context());
            says(why, azimuth);
        }
        Err(why @ GeodesicError::Distance(refused)) => {
            assert!(
                azimuth.is_finite() && !distance.is_finite() && same(refused, distance),
                "{}",
                context()
            );
            says(why, distance);
        }
        Err(
            why @ GeodesicError::TooFar {
                distance: refused,
                limit,
            },
        ) => {
            // Too many circuits for some methods.
            let far = distance.into().abs();
            assert!(
                far > 5e8 && far >= limit.into() && same(refused, distance),
                "{}",
                context()
            );
            says(why, distance);
            says(why, limit);
        }
        Err(why) => panic!("{why}"),
    }
    let sphere = GreatCircle::new(T::of(6.4e6)).unwrap();
    match sphere.intermediate(from, to, distance) {
        Ok(place) => assert!(
            LatLon::new(place.lat(), place.lon()) == Ok(place),
            "{from:?} {to:?} {distance:?}"
        ),
        Err(why @ GeodesicError::Fraction(refused)) => {
            let far = distance.into().abs() > T::LARGEST.into() / 2.1e7;
            assert!(
                (far || !distance.is_finite()) && same(refused, distance),
                "{from:?} {to:?} {distance:?}"
            );
            says(why, distance);
        }
        Err(why) => panic!("{why}"),
    }
    let middle = sphere.midpoint(from, to);
    assert!(LatLon::new(middle.lat(), middle.lon()) == Ok(middle), "{from:?} {to:?}");
    let area = Area::new(ellipsoid).unwrap();
    let mut polygon = area.polygon();
    for corner in [from, to, bytes.place(), bytes.place()] {
        polygon.add(corner);
        // Half of the flattest ellipsoid here that is longer than wide.
        let (area, around) = (polygon.area().into(), polygon.perimeter().into());
        assert!(
            area.abs() <= 2.62e14 && (0.0..=9e7).contains(&around),
            "{corner:?}: {area} {around}"
        );
    }
}

/// What has passed the door of places is no NaN behind it.
fn beyond_lat_lon<T: Scalar>(bytes: &mut Bytes<'_>) {
    let Ok(place) = LatLon::new(bytes.anything::<T>(), bytes.anything()) else {
        return;
    };
    for &shift in Shift::ALL {
        let shifted = Shifted::new(Ellipsoid::<T>::WGS84, shift).unwrap();
        let direction = shifted.to_direction(place);
        assert!(
            excess(direction.to_array().map(Into::into)).abs() <= 8.0 * T::EPSILON.into(),
            "{place:?}"
        );
        let back = shifted.to_lat_lon(direction);
        assert!(
            LatLon::new(back.lat(), back.lon()) == Ok(back),
            "{shift} {place:?}: {back:?}"
        );
    }
}

/// What has passed the door of directions, too.
fn beyond_direction<T: Scalar>(bytes: &mut Bytes<'_>) {
    let Ok(direction) = Direction::new(bytes.anything::<T>(), bytes.anything(), bytes.anything()) else {
        return;
    };
    let place = direction.to_lat_lon();
    assert!(
        LatLon::new(place.lat(), place.lon()) == Ok(place),
        "{direction:?}: {place:?}"
    );
    for &projection in Projection::ALL {
        // Not `project`, whose bounds would hide a NaN.
        let face = projection.face(direction);
        let point = projection.forward(face, face.to_local(direction.to_array()));
        let limit = 1.0 + T::EPSILON.into();
        assert!(
            point.iter().all(|&c| c.into().abs() <= limit),
            "{projection} {direction:?}: {point:?}"
        );
    }
}

/// What has passed the door of faces, too: unit vectors, and derivatives that are numbers or refused.
fn beyond_face_point<T: Scalar>(bytes: &mut Bytes<'_>) {
    let Ok(point) = FacePoint::new(bytes.face(), bytes.anything::<T>(), bytes.anything()) else {
        return;
    };
    let shift = bytes.choice(Shift::ALL);
    for &projection in Projection::ALL {
        let unit = projection.unproject(point).to_array();
        assert!(
            excess(unit.map(Into::into)).abs() <= 6.0 * T::EPSILON.into(),
            "{projection} {point:?}: {unit:?}"
        );
        let map = CubeMap::new(Ellipsoid::<T>::WGS84, shift, projection).unwrap();
        match Ground::new(map).jacobian(point) {
            Ok(jacobian) => {
                let [least, most] = jacobian.extremes();
                let measures = [jacobian.width(), jacobian.height(), jacobian.area(), least, most];
                assert!(
                    measures.iter().all(|m| m.is_finite() && *m >= T::ZERO),
                    "{projection} {shift} {point:?}: {jacobian:?}"
                );
            }
            Err(Singular(refused)) => assert_eq!(refused, point),
        }
    }
}

#[cfg(test)]
#[test]
fn longitude_wraps_as_by_hand() {
    for (lon, expected) in [
        (180.0, 180.0),
        (-180.0, -180.0),
        (181.0, -179.0),
        (-181.0, 179.0),
        (359.5, -0.5),
        (360.0, 0.0),
        (540.0, 180.0),
        (-540.0, -180.0),
        (720.25, 0.25),
        (36_000_000_000_045.0, 45.0),
    ] {
        assert_eq!(LatLon::new(0.0, lon).unwrap().lon(), expected, "{lon}");
        assert_eq!(wrapped(lon), expected, "{lon}: the test itself");
    }
}
