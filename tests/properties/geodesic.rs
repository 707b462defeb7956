//! Geodesics: GeographicLib's answers, the way there and back, and what swapping, mirroring and going round do.

use geographiclib_rs::{DirectGeodesic, Geodesic as Theirs, InverseGeodesic, PolygonArea, Winding};
use terrella::geodesic::{Area, Direct, Geodesic, GeodesicError, Inverse, Karney, Method, Surface};
use terrella::math::sin_cos_degrees;
use terrella::{Ellipsoid, LatLon};
use testkit::{maximum, minimum};

use testkit::bytes::Bytes;
use testkit::properties;
use testkit::scalar::{Scalar, same};
use testkit::table::claim;
use testkit::vector::{self, length};

properties! { inverse direct lengths area polygon methods_inverse methods_direct swapped_and_mirrored triangle }

/// The flattenings that [`Karney`] takes.
const FLATTENINGS: (f64, f64) = (-1.0 / 9.0, 0.1);

fn reference<T: Scalar>(ellipsoid: Ellipsoid<T>) -> Theirs {
    Theirs::new(ellipsoid.a().into(), ellipsoid.f().into())
}

/// GeographicLib's own error in metres, as its documentation says: its series are of order 6 for every flattening.
fn theirs<T: Scalar>(ellipsoid: Ellipsoid<T>) -> f64 {
    let table = [
        (0.0034, 15e-9),
        (0.01, 25e-9),
        (0.02, 30e-9),
        (0.05, 10e-6),
        (0.1, 1.5e-3),
        (0.2, 0.3),
    ];
    let f = ellipsoid.f().into().abs();
    table.into_iter().find(|(limit, _)| f < limit + 1e-6).unwrap().1
}

/// Whether GeographicLib's answer is one. On ellipsoids that are all but spheres it is NaN between the poles, and between opposite places
/// next to the equator, if prolate, up to 3 cm longer than the equator.
fn known<T: Scalar>(answer: f64, ellipsoid: Ellipsoid<T>, (from, to): (LatLon<T>, LatLon<T>)) -> bool {
    let beside = |place: LatLon<T>| place.lat().abs().into() < 1e-12;
    let lost = ellipsoid.f() < T::ZERO && answer > 2e7 && beside(from) && beside(to);
    !answer.is_nan() && !lost
}

/// GeographicLib's distance, or in place of it half way round that of places on the equator if these are within nanometres: GeographicLib
/// does not reach azimuths that are so near to 90°, and is up to 0.3 µm off, 50 µm for f = 1/20.
fn their_distance<T: Scalar>(answer: f64, ellipsoid: Ellipsoid<T>, (from, to): (LatLon<T>, LatLon<T>)) -> f64 {
    let ((lat1, lon1), (lat2, lon2)) = (coordinates(from), coordinates(to));
    if answer > 1e7 && maximum(lat1.abs(), lat2.abs()) < 1e-14 {
        reference(ellipsoid).inverse(0.0, lon1, 0.0, lon2)
    } else {
        answer
    }
}

fn coordinates<T: Scalar>(place: LatLon<T>) -> (f64, f64) {
    (place.lat().into(), place.lon().into())
}

/// The distance in metres between two places that are nearly the same: straight through the ellipsoid.
fn apart<T: Scalar>(ellipsoid: Ellipsoid<T>, found: LatLon<T>, expected: (f64, f64)) -> f64 {
    let (a, f): (f64, f64) = (ellipsoid.a().into(), ellipsoid.f().into());
    let point = |(lat, lon): (f64, f64)| {
        let ((sin, cos), (sin_lon, cos_lon)) = (lat.to_radians().sin_cos(), lon.to_radians().sin_cos());
        let radius = a / (1.0 - f * (2.0 - f) * sin * sin).sqrt();
        [
            radius * cos * cos_lon,
            radius * cos * sin_lon,
            radius * (1.0 - f).powi(2) * sin,
        ]
    };
    let (one, other) = (point(coordinates(found)), point(expected));
    length([one[0] - other[0], one[1] - other[1], one[2] - other[2]])
}

/// An error in metres claimed of Karney's method on the Earth and on other ellipsoids, in this scalar; what `f32` adds is in
/// proportion to the distance.
fn claimed<T: Scalar>(ellipsoid: Ellipsoid<T>, what: &str, elsewhere: &str, distance: f64) -> f64 {
    let earth = (ellipsoid.f().into() - 1.0 / 298.257_223_563).abs() < 1e-9;
    let claim = claim(if earth { what } else { elsewhere })[T::CLAIM];
    // Of the flattenings without a claim twice as much is let pass.
    let claim = if earth { claim } else { 2.0 * claim };
    claim + if T::NAME == "f32" { 1.5e-7 * distance } else { 0.0 }
}

const ELSEWHERE: &str = "Karney for f = 1/10 and −1/150";

/// A course in space, of a place and an azimuth.
fn course((lat, lon): (f64, f64), azimuth: f64) -> [f64; 3] {
    let ((sin, cos), (sin_lon, cos_lon)) = (sin_cos_degrees(lat), sin_cos_degrees(lon));
    let (east, north) = sin_cos_degrees(azimuth);
    [
        -north * sin * cos_lon - east * sin_lon,
        -north * sin * sin_lon + east * cos_lon,
        north * cos,
    ]
}

/// Distance and azimuths are in range, and the line that they describe leads from one place to the other, either way round, and arrives with
/// the other azimuth: to the other pole and to an antipode every line leads, so that the places alone would not tell.
fn leads<T: Scalar>(ellipsoid: Ellipsoid<T>, (from, to): (LatLon<T>, LatLon<T>), line: Inverse<T>, allowed: f64) {
    let reference = reference(ellipsoid);
    let [distance, azimuth1, azimuth2] = [line.distance, line.azimuth1, line.azimuth2].map(Into::<f64>::into);
    assert!(
        distance >= 0.0 && azimuth1.abs() <= 180.0 && azimuth2.abs() <= 180.0,
        "{} {from:?} {to:?}: {line:?}",
        T::NAME
    );
    let ((lat1, lon1), (lat2, lon2)) = (coordinates(from), coordinates(to));
    let end: (f64, f64, f64) = reference.direct(lat1, lon1, azimuth1, distance);
    let start: (f64, f64) = reference.direct(lat2, lon2, azimuth2, -distance);
    let (there, back) = (apart(ellipsoid, to, (end.0, end.1)), apart(ellipsoid, from, start));
    assert!(
        there <= allowed && back <= allowed,
        "{} {from:?} {to:?}: {line:?} leads {there:e} and {back:e} off, {allowed:e} allowed",
        T::NAME
    );
    let rounding = if T::NAME == "f32" { 3e-6 } else { 1e-14 };
    let turned = vector::apart(course((end.0, end.1), end.2), course((lat2, lon2), azimuth2));
    assert!(
        turned <= rounding + 4.0 * theirs(ellipsoid) / ellipsoid.b().into(),
        "{} {ellipsoid:?} {from:?} {to:?}: {line:?} arrives with {}, {turned:e} off",
        T::NAME,
        end.2
    );
}

/// What distances half way round the equator may be off besides in `f32`.
fn beside<T: Scalar>(ellipsoid: Ellipsoid<T>, [lat1, lat2]: [f64; 2], distance: f64) -> f64 {
    let equator = maximum(lat1.abs(), lat2.abs()) < 1e-4;
    let half_way = distance > 0.97 * core::f64::consts::PI * ellipsoid.b().into();
    if T::NAME == "f32" && equator && half_way {
        30.0
    } else {
        0.0
    }
}

/// Karney's inverse, one answer of both functions: GeographicLib's distance, and azimuths that lead there.
fn inverse<T: Scalar>(bytes: &mut Bytes<'_>) {
    let ellipsoid = bytes.ellipsoid::<T>(FLATTENINGS.0, FLATTENINGS.1);
    let (from, to) = bytes.pair::<T>();
    let karney = Karney::new(ellipsoid).unwrap();
    let ((lat1, lon1), (lat2, lon2)) = (coordinates(from), coordinates(to));
    let answer = reference(ellipsoid).inverse(lat1, lon1, lat2, lon2);
    let expected = their_distance(answer, ellipsoid, (from, to));
    if !known(expected, ellipsoid, (from, to)) {
        return;
    }
    let allowed = claimed(ellipsoid, "Karney inverse, distance", ELSEWHERE, expected);
    let beside = beside(ellipsoid, [lat1, lat2], expected);
    // The straight lines are not so far off.
    let straight = ellipsoid.f().into().abs() < 1.0 / 150.0;
    let aside = claimed(ellipsoid, "Karney inverse, azimuth times length", ELSEWHERE, 0.0);
    let line = karney.inverse(from, to).unwrap();
    let whole = karney.solve(from, to).inverse;
    assert!(
        same(line.distance, whole.distance)
            && same(line.azimuth1, whole.azimuth1)
            && same(line.azimuth2, whole.azimuth2),
        "{} {ellipsoid:?} {from:?} {to:?}: {line:?}, but {whole:?}",
        T::NAME
    );
    let allowed = allowed + if straight { 0.0 } else { beside };
    let error = (line.distance.into() - expected).abs();
    assert!(
        error <= allowed + theirs(ellipsoid),
        "{} {ellipsoid:?} {from:?} {to:?}: {line:?}, not {expected:?}: {error:e}",
        T::NAME
    );
    leads(ellipsoid, (from, to), line, allowed + aside + 2.0 * theirs(ellipsoid));
    if T::NAME == "f32" && expected < 1.5e5 && ellipsoid == Ellipsoid::WGS84 {
        let error = (karney.inverse(from, to).unwrap().distance.into() - expected).abs() / maximum(expected, 1.0);
        let allowed = claim("Karney inverse to 150 km, relative to 1 m or more")[1];
        assert!(error <= allowed, "{from:?} {to:?}: {error:e} of {expected:?}");
    }
}

/// A distance to go: up to half a circle, several circuits, or any number.
fn distance<T: Scalar>(bytes: &mut Bytes<'_>) -> T {
    match bytes.byte() % 8 {
        0..=4 => bytes.within(2e7),
        5 | 6 => bytes.within(4e8),
        _ => bytes.finite(),
    }
}

fn azimuth<T: Scalar>(bytes: &mut Bytes<'_>) -> T {
    if bytes.byte() % 8 == 7 {
        bytes.finite()
    } else {
        bytes.within(360.0)
    }
}

fn in_range<T: Scalar>(end: Direct<T>) -> bool {
    end.position.lat().into().abs() <= 90.0
        && end.position.lon().into().abs() <= 180.0
        && end.azimuth.into().abs() <= 180.0
}

/// Karney's direct, both ways of it: GeographicLib's place, and back again. What is too long is refused with its length.
fn direct<T: Scalar>(bytes: &mut Bytes<'_>) {
    let ellipsoid = bytes.ellipsoid::<T>(FLATTENINGS.0, FLATTENINGS.1);
    let (from, azimuth, distance) = (bytes.place::<T>(), azimuth::<T>(bytes), distance::<T>(bytes));
    let karney = Karney::new(ellipsoid).unwrap();
    let reference = reference(ellipsoid);
    let along = karney.line(from, azimuth).unwrap().at(distance);
    let there = karney.direct(from, azimuth, distance);
    let context = || {
        format!(
            "{} {ellipsoid:?} {from:?} {azimuth:?} {distance:?}: {there:?} {along:?}",
            T::NAME
        )
    };
    let (Ok(there), Ok(along)) = (there, along) else {
        let limit = ellipsoid.b().into() * if T::NAME == "f32" { 90.0 } else { 9e4 };
        let Err(
            why @ GeodesicError::TooFar {
                distance: refused,
                limit: longest,
            },
        ) = along
        else {
            panic!("{}", context());
        };
        let (far, longest) = (distance.into().abs(), longest.into());
        assert!(
            far >= longest && longest > limit && same(refused, distance) && there == Err(why),
            "{}",
            context()
        );
        return;
    };
    assert!(in_range(there), "{}", context());
    let far = distance.into().abs();
    if far > 4.1e8 {
        return;
    }
    let (lat, lon) = coordinates(from);
    // Theirs is reduced as ours is, exactly.
    let turned = azimuth.into() % 360.0;
    let expected: (f64, f64) = reference.direct(lat, lon, turned, distance.into());
    let once = far <= 4.1e7;
    let allowed = if once {
        claimed(ellipsoid, "Karney direct, position", ELSEWHERE, far)
    } else {
        claimed(
            ellipsoid,
            "Karney direct, position after several circuits",
            "Karney for f = 1/10 and −1/150, several circuits",
            far,
        )
    };
    let allowed = allowed + theirs(ellipsoid) * (2.0 + far / 1e7);
    for position in [there.position, along.position] {
        let error = apart(ellipsoid, position, expected);
        assert!(error <= allowed, "{}, {error:e} from {expected:?}", context());
    }
    let back = karney.direct(there.position, there.azimuth, -distance).unwrap();
    let error = apart(ellipsoid, from, coordinates(back.position));
    // The azimuth there rounds too, and turns the way back.
    assert!(error <= 3.0 * allowed, "{}, back at {back:?}, {error:e} off", context());
}

/// Reduced length and scales, where they are well-conditioned.
fn lengths<T: Scalar>(bytes: &mut Bytes<'_>) {
    let ellipsoid = bytes.ellipsoid::<T>(FLATTENINGS.0, FLATTENINGS.1);
    let (from, to) = bytes.pair::<T>();
    let solution = Karney::new(ellipsoid).unwrap().solve(from, to);
    let ((lat1, lon1), (lat2, lon2)) = (coordinates(from), coordinates(to));
    let expected: (f64, f64, f64, f64, f64, f64, f64) = reference(ellipsoid).inverse(lat1, lon1, lat2, lon2);
    let (s12, _, _, m12, scale12, scale21, a12) = expected;
    if !known(s12, ellipsoid, (from, to)) || s12 > 1e6 && m12 < 0.1 * s12 {
        return;
    }
    let context = || format!("{} {ellipsoid:?} {from:?} {to:?}: {solution:?} {expected:?}", T::NAME);
    let allowed = claimed(ellipsoid, "Karney inverse, reduced length", ELSEWHERE, s12) + theirs(ellipsoid);
    let error = (solution.reduced_length.into() - m12).abs();
    assert!(error <= allowed, "{}: {error:e}", context());
    let radians = allowed / minimum(ellipsoid.b().into(), ellipsoid.a().into());
    let arc = (solution.arc.into() - a12).abs().to_radians();
    assert!(arc <= 2.0 * radians, "{}: {arc:e} rad", context());
    for (found, expected) in [(solution.scale12, scale12), (solution.scale21, scale21)] {
        // A scale is a derivative, and errs by some of them.
        let error = (found.into() - expected).abs();
        assert!(error <= 4.0 * radians, "{}: {error:e}", context());
    }
}

/// The area under a line of the Earth, where it is well-conditioned.
fn area<T: Scalar>(bytes: &mut Bytes<'_>) {
    let earth = Ellipsoid::<T>::WGS84;
    let (from, to) = bytes.pair::<T>();
    let found: f64 = Area::new(earth).unwrap().under(from, to).into();
    let ((lat1, lon1), (lat2, lon2)) = (coordinates(from), coordinates(to));
    let expected: (f64, f64, f64, f64, f64, f64, f64, f64) = reference(earth).inverse(lat1, lon1, lat2, lon2);
    let (s12, _, _, m12, _, _, s, _) = expected;
    if s12 > 1e6 && m12 < 0.1 * s12 {
        return;
    }
    let claimed = if s12 < 1e6 {
        claim("Karney area under a line of less than 1000 km")
    } else {
        claim("Karney area under a line")
    };
    // Between opposite meridians theirs goes east, ours to the longitude it is given.
    let s = if opposite(from, to) == Some(-180.0) { -s } else { s };
    // Theirs is as good.
    let rounding = if T::NAME == "f32" { 5e-7 } else { 5e-16 } * s.abs();
    let allowed = claimed[T::CLAIM] + claimed[0] + rounding;
    let error = (found - s).abs();
    assert!(
        error <= allowed,
        "{} {from:?} {to:?}: {found:?} {s:?}: {error:e}",
        T::NAME
    );
}

/// The second longitude less the first, if that is 180° or −180° exactly.
fn opposite<T: Scalar>(from: LatLon<T>, to: LatLon<T>) -> Option<f64> {
    let ((_, lon1), (_, lon2)) = (coordinates(from), coordinates(to));
    let turn = lon2 - lon1;
    // Nothing is lost if both can be had from the other.
    (turn.abs() == 180.0 && lon1 + turn == lon2 && lon2 - turn == lon1).then_some(turn)
}

/// The next corner of a polygon: about a place, about the last one, about its antipode, on its meridian or on
/// the one opposite, at a pole.
fn corner<T: Scalar>(bytes: &mut Bytes<'_>, middle: LatLon<T>, last: LatLon<T>) -> LatLon<T> {
    let right = T::of(90.0);
    let (lat, lon) = match bytes.byte() % 8 {
        0..=2 => {
            let (north, east) = (bytes.within::<T>(20.0), bytes.within::<T>(40.0));
            (middle.lat() + north, middle.lon() + east)
        }
        3 => return bytes.place_about(last, false),
        4 => {
            let opposite = bytes.place_about(last, true);
            (bytes.within::<T>(90.0), opposite.lon())
        }
        5 => (bytes.within::<T>(90.0), last.lon()),
        6 => (if bytes.flag() { right } else { -right }, bytes.within::<T>(180.0)),
        _ => return bytes.place(),
    };
    let lat = if lat.abs() > right { right.copysign(lat) } else { lat };
    LatLon::new(lat, lon).unwrap()
}

/// A polygon, as GeographicLib has it, where no edge is ill-conditioned.
fn polygon<T: Scalar>(bytes: &mut Bytes<'_>) {
    let earth = Ellipsoid::<T>::WGS84;
    let area = Area::new(earth).unwrap();
    let mut ours = area.polygon();
    let reference = reference(earth);
    let mut theirs = PolygonArea::new(&reference, Winding::CounterClockwise);
    let middle = bytes.place::<T>();
    let mut corners: Vec<LatLon<T>> = Vec::new();
    for _ in 0..bytes.byte() % 8 {
        let last = corners.last().copied().unwrap_or(middle);
        let corner = corner(bytes, middle, last);
        // Of opposite places on the equator theirs does not see the sign of a zero, nor of what is rounded to
        // one.
        let beside = corner.lat().abs().into() < 1e-11;
        let corner = LatLon::new(if beside { T::ZERO } else { corner.lat() }, corner.lon()).unwrap();
        corners.push(corner);
        ours.add(corner);
        theirs.add_point(corner.lat().into(), corner.lon().into());
    }
    let ends = corners.iter().cycle().skip(1);
    let well_conditioned = corners.iter().zip(ends).all(|(&from, &to)| {
        let ((lat1, lon1), (lat2, lon2)) = (coordinates(from), coordinates(to));
        let lengths: (f64, f64, f64, f64, f64, f64, f64) = reference.inverse(lat1, lon1, lat2, lon2);
        let (s12, _, _, m12, ..) = lengths;
        // Of antipodes ours is the line that starts to the north; theirs rounds small latitudes to 7e-18°.
        s12 <= 1e6 || m12 >= 0.1 * s12 || opposite(from, to).is_some() && (lat1 + lat2).abs() > 1e-16
    });
    let (perimeter, signed, _) = theirs.compute(true);
    let (found, around): (f64, f64) = (ours.area().into(), ours.perimeter().into());
    let [single_area, single_length] = if T::NAME == "f32" {
        [4e7, 3.0 + 1.5e-7 * perimeter]
    } else {
        [0.0; 2]
    };
    let count = corners.len() as f64;
    let (allowed, allowed_around) = (count * (0.2 + single_area), count * (3e-8 + single_length));
    let context = || {
        format!(
            "{} {corners:?}: {found:?} {signed:?}, {around:?} {perimeter:?}",
            T::NAME
        )
    };
    let half = 0.5 * 510_065_621_724_088.44;
    assert!(found.abs() <= half * (1.0 + 1e-7), "{}", context());
    assert!((around - perimeter).abs() <= allowed_around, "{}", context());
    if well_conditioned {
        // What is a half of the ellipsoid but for rounding has either sign.
        let halves = found.abs() >= half - allowed && signed.abs() >= half - allowed;
        let error = if halves { 0.0 } else { (found - signed).abs() };
        assert!(error <= allowed, "{}", context());
    }
}

/// What a method claims of a line from a latitude on an ellipsoid: distance, azimuths and position.
fn claim_of<T: Scalar>(method: Method, ellipsoid: Ellipsoid<T>, lat: f64, distance: f64) -> Option<[f64; 3]> {
    let distance = distance.abs();
    let profile = method.profile();
    // Vincenty's holds for all ellipsoids that it takes.
    let anywhere = profile.surface == Surface::Sphere || method == Method::Vincenty;
    if !anywhere && ellipsoid != Ellipsoid::WGS84 {
        return None;
    }
    let row = profile.worst_errors(lat, distance)?;
    let added = row
        .single
        .map(|error| if T::NAME == "f32" { error.at(distance) } else { 0.0 });
    Some([0, 1, 2].map(|i| row.double[i].at(distance) + added[i]))
}

/// The least and the largest flattening that a method is asked about.
pub fn flattenings(method: Method) -> [f64; 2] {
    let [least, most] = method.profile().flattenings;
    [maximum(least, -1.0 / 60.0), minimum(most, 1.0 / 60.0)]
}

/// A method's ellipsoid: the sphere for those that know no other, the Earth's for Vincenty's.
fn method<T: Scalar>(bytes: &mut Bytes<'_>) -> (Method, Ellipsoid<T>) {
    let everywhere: Vec<Method> = Method::ALL
        .iter()
        .copied()
        .filter(|method| !method.needs_place())
        .collect();
    let method = bytes.choice(&everywhere);
    let spherical = method.profile().surface == Surface::Sphere;
    let [least, most] = flattenings(method);
    let ellipsoid = bytes.ellipsoid(least, most);
    (
        method,
        if spherical {
            Ellipsoid::sphere(T::of(6.4e6)).unwrap()
        } else {
            ellipsoid
        },
    )
}

/// The second azimuth of places that leave the first one open, which then is 0: coincident ones and the poles.
fn open_azimuth<T: Scalar>(from: LatLon<T>, to: LatLon<T>) -> Option<f64> {
    let ((lat1, lon1), (lat2, lon2)) = (coordinates(from), coordinates(to));
    let turn = lon2 - lon1;
    if lat1.abs() == 90.0 && lat2.abs() == 90.0 {
        Some(if lat2 > 0.0 { turn } else { -turn })
    } else {
        // Not by the difference, which rounds to 360° next to it.
        let same = lon1 == lon2 || lon1.abs() == 180.0 && lon2.abs() == 180.0;
        (lat1 == lat2 && same).then_some(0.0)
    }
}

/// Every method's distance and azimuths, as near to GeographicLib's as its documentation says.
fn methods_inverse<T: Scalar>(bytes: &mut Bytes<'_>) {
    let (method, ellipsoid) = method::<T>(bytes);
    let (from, to) = bytes.pair::<T>();
    let line = match method.on(ellipsoid).unwrap().inverse(from, to) {
        Ok(line) => line,
        Err(why) => {
            assert!(
                method == Method::Vincenty && why == GeodesicError::NotConverged(from, to),
                "{method} {}: {why}",
                T::NAME
            );
            let ((lat1, lon1), (lat2, lon2)) = (coordinates(from), coordinates(to));
            let distance: f64 = reference(ellipsoid).inverse(lat1, lon1, lat2, lon2);
            // Within 0.8° of the antipode.
            assert!(
                distance > 3.11 * ellipsoid.a().into(),
                "{} {from:?} {to:?}: {distance}",
                T::NAME
            );
            return;
        }
    };
    let [distance, azimuth1, azimuth2] = [line.distance, line.azimuth1, line.azimuth2].map(Into::<f64>::into);
    let context = || format!("{method} {} {ellipsoid:?} {from:?} {to:?}: {line:?}", T::NAME);
    // A plane has no other side.
    let is_plane = method.profile().surface == Surface::Local;
    let longest = if is_plane { f64::INFINITY } else { 2.1e7 };
    assert!(
        (0.0..=longest).contains(&distance) && azimuth1.abs() <= 180.0 && azimuth2.abs() <= 180.0,
        "{}",
        context()
    );
    let ((lat1, lon1), (lat2, lon2)) = (coordinates(from), coordinates(to));
    if let Some(open) = open_azimuth(from, to) {
        let turned = (azimuth2 - open).abs();
        let turned = if turned > 180.0 { (360.0 - turned).abs() } else { turned };
        let near = if lat1 == lat2 {
            distance == 0.0
        } else {
            // Bowring's is 1800 km short for f = −1/60.
            distance > 1.8e7
        };
        assert!(
            azimuth1 == 0.0 && turned < 2e-5 && near,
            "{}, not 0 and {open}",
            context()
        );
        return;
    }
    let expected: (f64, f64, f64, f64, f64) = reference(ellipsoid).inverse(lat1, lon1, lat2, lon2);
    let (answer, azi1, azi2, m12, _) = expected;
    let s12 = their_distance(answer, ellipsoid, (from, to));
    if !known(s12, ellipsoid, (from, to)) {
        return;
    }
    let Some([length, azimuth, _]) = claim_of(method, ellipsoid, lat1, s12) else {
        return;
    };
    let error = (distance - s12).abs();
    assert!(
        error <= length + theirs(ellipsoid),
        "{}, {expected:?}: {error:e}",
        context()
    );
    if method == Method::GreatCircle {
        leads(ellipsoid, (from, to), line, length + azimuth + 2.0 * theirs(ellipsoid));
    }
    // Next to opposite latitudes or longitudes there are two shortest lines, and either will do.
    let unsure = if T::NAME == "f32" { 1e-3 } else { 1e-9 };
    let turned = ((lon2 - lon1).abs() - 180.0).abs();
    if s12 > 1e7 && ((lat1 + lat2).abs() < unsure || turned < unsure) || s12 == 0.0 {
        return;
    }
    let turn = |found: f64, expected: f64| {
        let turn = (found - expected).abs();
        minimum(turn, (360.0 - turn).abs()).to_radians()
    };
    let error = maximum(turn(azimuth1, azi1), turn(azimuth2, azi2)) * m12.abs();
    assert!(
        error <= azimuth + theirs(ellipsoid),
        "{}, {expected:?}: {error:e}",
        context()
    );
}

/// Every method's place at the end of a line, as near to GeographicLib's as its documentation says.
fn methods_direct<T: Scalar>(bytes: &mut Bytes<'_>) {
    let (method, ellipsoid) = method::<T>(bytes);
    let (from, azimuth, distance) = (bytes.place::<T>(), azimuth::<T>(bytes), distance::<T>(bytes));
    let end = method.on(ellipsoid).unwrap().direct(from, azimuth, distance);
    let context = || {
        format!(
            "{method} {} {ellipsoid:?} {from:?} {azimuth:?} {distance:?}: {end:?}",
            T::NAME
        )
    };
    let end = match end {
        Ok(end) => end,
        Err(GeodesicError::TooFar {
            distance: refused,
            limit,
        }) => {
            let far = distance.into().abs();
            assert!(
                same(refused, distance) && far > 5e8 && far >= limit.into(),
                "{}",
                context()
            );
            return;
        }
        Err(_) => panic!("{}", context()),
    };
    assert!(in_range(end), "{}", context());
    if distance.into().abs() > 4.1e8 {
        return;
    }
    let (lat, lon) = coordinates(from);
    let Some([.., position]) = claim_of(method, ellipsoid, lat, distance.into()) else {
        return;
    };
    let reference = reference(ellipsoid);
    let expected: (f64, f64) = reference.direct(lat, lon, azimuth.into() % 360.0, distance.into());
    let error = apart(ellipsoid, end.position, expected);
    let circuits = 1.0 + distance.into().abs() / 2e7;
    assert!(
        error <= position + circuits * theirs(ellipsoid),
        "{}, {expected:?}: {error:e}",
        context()
    );
}

/// From there to here, from the other hemisphere, and the other way round the globe it is as far.
fn swapped_and_mirrored<T: Scalar>(bytes: &mut Bytes<'_>) {
    let ellipsoid = bytes.ellipsoid::<T>(FLATTENINGS.0, FLATTENINGS.1);
    let (from, to) = bytes.pair::<T>();
    let karney = Karney::new(ellipsoid).unwrap();
    let distance = |from: LatLon<T>, to: LatLon<T>| -> f64 { karney.inverse(from, to).unwrap().distance.into() };
    let moved = |place: LatLon<T>, north: T, east: T| LatLon::new(place.lat() * north, place.lon() * east).unwrap();
    let one = T::ONE;
    let straight = distance(from, to);
    let allowed = 2.0 * claimed(ellipsoid, "Karney inverse, distance", ELSEWHERE, straight);
    let images = [
        ("swapped", to, from),
        ("south for north", moved(from, -one, one), moved(to, -one, one)),
        ("west for east", moved(from, one, -one), moved(to, one, -one)),
        ("turned", moved(to, -one, -one), moved(from, -one, -one)),
    ];
    for (name, a, b) in images {
        let image = distance(a, b);
        assert!(
            (image - straight).abs() <= allowed,
            "{} {ellipsoid:?} {from:?} {to:?}, {name}: {straight:?} {image:?}",
            T::NAME
        );
    }
}

/// No way round by a third place is shorter.
fn triangle<T: Scalar>(bytes: &mut Bytes<'_>) {
    let ellipsoid = bytes.ellipsoid::<T>(FLATTENINGS.0, FLATTENINGS.1);
    let (from, to) = bytes.pair::<T>();
    let by = if bytes.flag() {
        bytes.place()
    } else {
        bytes.place_about(from, false)
    };
    let karney = Karney::new(ellipsoid).unwrap();
    let distance = |from, to| -> f64 { karney.inverse(from, to).unwrap().distance.into() };
    let (straight, round) = (distance(from, to), distance(from, by) + distance(by, to));
    let allowed = 2.0 * claimed(ellipsoid, "Karney inverse, distance", ELSEWHERE, straight);
    assert!(
        straight <= round + allowed,
        "{} {ellipsoid:?} {from:?} {to:?} by {by:?}: {straight:?} {round:?}",
        T::NAME
    );
}
