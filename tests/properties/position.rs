//! Places, directions, points in Earth axes, local frames and latitudes: against formulas in twice the digits, and there and back.

use core::f64::consts::{FRAC_PI_2, PI};

use terrella::latitude::Conversion;
use terrella::{Aer, Ecef, Ellipsoid, Enu, Geodetic, Latitude, LocalFrame, Ned};
use testkit::maximum;

use testkit::bytes::Bytes;
use testkit::double::{Double, of, sin_cos_degrees};
use testkit::nearest::searched;
use testkit::properties;
use testkit::scalar::{Scalar, steps};
use testkit::table::claim;
use testkit::vector::{apart, excess, length};

properties! { to_direction to_lat_lon to_ecef to_geodetic nearest frames pointing latitudes_close latitudes_grow latitudes_are_true }

/// |computed − exact| of vectors.
fn miss<T: Scalar>(computed: [T; 3], exact: [Double; 3]) -> f64 {
    length(core::array::from_fn(|i| {
        let difference = of(computed[i].into()) - exact[i];
        difference.high
    }))
}

/// A place's unit vector.
fn to_direction<T: Scalar>(bytes: &mut Bytes<'_>) {
    let place = bytes.place::<T>();
    let ((sin, cos), (sin_lon, cos_lon)) = (sin_cos_degrees(place.lat().into()), sin_cos_degrees(place.lon().into()));
    let direction = place.to_direction();
    let error = miss(direction.to_array(), [cos * cos_lon, cos * sin_lon, sin]);
    assert!(
        error <= claim("LatLon to Direction")[T::CLAIM],
        "{} {place:?}: {direction:?}, {error:e}",
        T::NAME
    );
    assert!(excess(direction.to_array().map(Into::into)).abs() <= 4.0 * T::EPSILON.into());
}

/// An angle in degrees by sine and cosine but for a common factor: its error in units of its last place.
fn ulps_of_angle<T: Scalar>(degrees: T, sin: Double, cos: Double) -> f64 {
    let size = degrees.abs();
    let (s, c) = sin_cos_degrees(degrees.into());
    // The sine of what is missing.
    let missing = (sin * c - cos * s) / (sin * sin + cos * cos).sqrt();
    let ulp = size.above().into() - size.into();
    missing.high.abs().to_degrees() / ulp
}

/// A direction's latitude and longitude.
fn to_lat_lon<T: Scalar>(bytes: &mut Bytes<'_>) {
    let direction = bytes.direction::<T>();
    let place = direction.to_lat_lon();
    let [x, y, z] = direction.to_array().map(|v| of(v.into()));
    let context = || format!("{} {direction:?}: {place:?}", T::NAME);
    assert!(
        place.lat().into().abs() <= 90.0 && place.lon().into().abs() <= 180.0,
        "{}",
        context()
    );
    let across = (x * x + y * y).sqrt();
    // Products of smaller numbers are lost, here and there; and those of the smallest have fewer digits.
    let least = if T::NAME == "f32" { 1e-18 } else { 1e-140 };
    let allowed = [
        claim("Direction to LatLon")[T::CLAIM],
        claim("math::atan2_degrees")[T::CLAIM],
    ];
    for ((angle, sin, cos), allowed) in [(place.lat(), z, across), (place.lon(), y, x)].into_iter().zip(allowed) {
        if maximum(sin.high.abs(), cos.high.abs()) > least
            && (sin.high.abs() > least || angle == T::ZERO)
            && cos.high.abs() > 0.0
        {
            let error = ulps_of_angle(angle, sin, cos);
            assert!(
                error <= allowed || angle == T::ZERO && sin.high.abs() <= least,
                "{}: {error} ulp",
                context()
            );
        }
    }
}

/// A height: near the ground, up to the satellites, or any number.
fn height<T: Scalar>(bytes: &mut Bytes<'_>) -> T {
    match bytes.byte() % 8 {
        0..=3 => bytes.within(1e5),
        4..=6 => bytes.within(5e7),
        _ => bytes.finite(),
    }
}

/// The point at a latitude, longitude and height.
fn exact<T: Scalar>(ellipsoid: Ellipsoid<T>, place: Geodetic<T>) -> [Double; 3] {
    let (a, f, height) = (
        of(ellipsoid.a().into()),
        of(ellipsoid.f().into()),
        of(place.height().into()),
    );
    let ((sin, cos), (sin_lon, cos_lon)) = (sin_cos_degrees(place.lat().into()), sin_cos_degrees(place.lon().into()));
    let squeeze = (of(1.0) - f) * (of(1.0) - f);
    let radius = a / (cos * cos + squeeze * sin * sin).sqrt();
    let level = (radius + height) * cos;
    [level * cos_lon, level * sin_lon, (squeeze * radius + height) * sin]
}

/// What is claimed of a point on the Earth so far from its surface, in metres, and its part of the distance from the centre beyond.
fn claimed<T: Scalar>(name: &str, height: f64) -> f64 {
    let near = claim(&format!(
        "{name} below 100 km{}",
        if name.ends_with("geodetic") {
            ", down to the centre"
        } else {
            ""
        }
    ));
    let far = claim(&format!("{name} to 50 000 km"));
    if height.abs() <= 1e5 {
        near[T::CLAIM]
    } else {
        far[T::CLAIM] * maximum(height.abs() / 5e7, 1.0)
    }
}

/// How much more than on the Earth is let pass on an ellipsoid whose radii of curvature are larger.
fn elsewhere<T: Scalar>(ellipsoid: Ellipsoid<T>) -> f64 {
    let curved = (1.0 - ellipsoid.f().into()).powi(2);
    if ellipsoid == Ellipsoid::WGS84 {
        1.0
    } else {
        3.0 * maximum(curved, 1.0 / curved)
    }
}

/// A place's point in Earth axes.
fn to_ecef<T: Scalar>(bytes: &mut Bytes<'_>) {
    let ellipsoid = bytes.ellipsoid::<T>(-1.0, 0.5);
    let (place, height) = (bytes.place(), height::<T>(bytes));
    if height.into().abs() > 1e30 {
        return; // what twice the digits of f64 split does not overflow
    }
    let position = Geodetic::new(place, height).unwrap();
    let point = ellipsoid.to_ecef(position);
    let error = miss(point.to_array(), exact(ellipsoid, position));
    let allowed = claimed::<T>("Ellipsoid::to_ecef", height.into()) * elsewhere(ellipsoid);
    assert!(
        error <= allowed,
        "{} {ellipsoid:?} {position:?}: {point:?}, {error:e}",
        T::NAME
    );
}

/// A point: by its place, near the centre, or anywhere.
fn point<T: Scalar>(bytes: &mut Bytes<'_>, ellipsoid: Ellipsoid<T>) -> Ecef<T> {
    let size = match bytes.byte() % 4 {
        0 => {
            let (place, height) = (bytes.place(), height::<T>(bytes));
            return ellipsoid.to_ecef(Geodetic::new(place, height).unwrap());
        }
        1 => 6.4e4,
        2 => 1e7,
        _ => 5e7,
    };
    Ecef::new(bytes.within(size), bytes.within(size), bytes.within(size)).unwrap()
}

/// A point's place leads back to the point.
fn to_geodetic<T: Scalar>(bytes: &mut Bytes<'_>) {
    let ellipsoid = bytes.ellipsoid::<T>(-1.0, 0.5);
    let point = if bytes.byte() % 8 == 7 {
        Ecef::new(bytes.finite(), bytes.finite(), bytes.finite()).unwrap()
    } else {
        point(bytes, ellipsoid)
    };
    let position = ellipsoid.to_geodetic(point);
    let context = || format!("{} {ellipsoid:?} {point:?}: {position:?}", T::NAME);
    let (lat, lon, height) = (position.lat().into(), position.lon().into(), position.height().into());
    assert!(
        lat.abs() <= 90.0 && lon.abs() <= 180.0 && height.is_finite(),
        "{}",
        context()
    );
    if height.abs() > 1e30 {
        return;
    }
    let error = miss(point.to_array(), exact(ellipsoid, position));
    // Within the Earth the place on the ground errs as one on it.
    let allowed = claimed::<T>("Ellipsoid::to_geodetic", maximum(height, 0.0)) * elsewhere(ellipsoid);
    assert!(error <= allowed, "{}, {error:e}", context());
}

/// No other point of the ellipsoid is nearer than the one found.
fn nearest<T: Scalar>(bytes: &mut Bytes<'_>) {
    let f = match bytes.byte() % 4 {
        0 | 1 => bytes.within::<T>(0.5),
        2 => T::of(0.99) * bytes.within::<T>(1.0).abs(),
        _ => T::of(-99.0) * bytes.within::<T>(1.0).abs(),
    };
    let ellipsoid = Ellipsoid::<T>::new(T::of(6.4e6), f).unwrap();
    let (a, b): (f64, f64) = (ellipsoid.a().into(), ellipsoid.b().into());
    let reach = a * maximum(ellipsoid.e2().into().abs(), 1e-4);
    let size = bytes.choice(&[reach, 10.0 * reach, a, 8.0 * a]);
    let point = Ecef::new(bytes.within::<T>(size), bytes.within(size), bytes.within(size)).unwrap();
    let [x, y, z] = point.to_array().map(Into::<f64>::into);
    let found = ellipsoid.to_geodetic(point);
    let height: f64 = found.height().into();
    let rho = x.hypot(y);
    let least = searched(a, b, rho, z);
    let curved = maximum(a * a / b, b * b / a);
    let digits = if T::NAME == "f32" { 2.5 } else { 1e-8 };
    let allowed = digits * maximum(least, curved) / a;
    let context = || format!("{} {ellipsoid:?} {point:?}: {found:?}, {least}", T::NAME);
    assert!((height.abs() - least).abs() <= allowed, "{}", context());
    let inside = (rho / a).powi(2) + (z / b).powi(2) < 1.0;
    assert!(height.abs() <= allowed || (height < 0.0) == inside, "{}", context());
    let foot = ellipsoid
        .to_ecef(Geodetic::from(found.lat_lon()))
        .to_array()
        .map(Into::<f64>::into);
    let far = length([x - foot[0], y - foot[1], z - foot[2]]);
    assert!((far - least).abs() <= 2.0 * allowed, "{}, the foot {far}", context());
}

fn components<T: Scalar>(enu: Enu<T>) -> [f64; 3] {
    [enu.east, enu.north, enu.up].map(Into::into)
}

/// What is seen from an origin of the Earth is where it is: vectors and points come back, and both ways to a position agree.
fn frames<T: Scalar>(bytes: &mut Bytes<'_>) {
    let earth = Ellipsoid::<T>::WGS84;
    let origin = Geodetic::new(bytes.place(), bytes.within::<T>(1e5)).unwrap();
    let frame = LocalFrame::new(earth, origin);
    let size = bytes.choice(&[1.0, 1e3, 1e5, 1e7]);
    let enu = Enu {
        east: bytes.within::<T>(size),
        north: bytes.within(size),
        up: bytes.within(size),
    };
    let epsilon: f64 = T::EPSILON.into();
    // Not its square root, which underflows.
    let range = 2.0
        * components(enu)
            .iter()
            .fold(0.0_f64, |largest, v| maximum(largest, v.abs()));
    let context = || format!("{} {origin:?} {enu:?}", T::NAME);
    let back = frame.vector_to_enu(frame.vector_from_enu(enu));
    // Not below the smallest normal number, whose products have no digits.
    let least = 1e3 * T::SMALLEST_NORMAL.into();
    assert!(
        apart(components(back), components(enu)) <= 6.0 * epsilon * range + least,
        "{}: {back:?}",
        context()
    );
    let point = frame.from_enu(enu).unwrap();
    assert_eq!(frame.from_ned(Ned::from(enu)), Ok(point), "{}", context());
    let seen = frame.to_enu(point);
    let allowed = 2.0 * epsilon * (range + 6.5e6);
    assert!(
        apart(components(seen), components(enu)) <= allowed,
        "{}: {seen:?}",
        context()
    );
    // The position of what is there, by angles and through Earth axes.
    let target = earth.to_geodetic(point);
    let direct = frame.geodetic_to_enu(target);
    let [one, two] = [7e-9, 2.0];
    let claimed = if T::NAME == "f32" { two } else { one };
    let rounding = claim("Ellipsoid::to_geodetic to 50 000 km")[T::CLAIM];
    assert!(
        apart(components(direct), components(seen)) <= claimed + rounding + 4.0 * epsilon * range,
        "{}: {target:?} {direct:?} {seen:?}",
        context()
    );
    // And back: by angles, and their differences from the origin.
    let there = frame.enu_to_geodetic(enu).unwrap();
    let through = apart(
        earth.to_ecef(there).to_array().map(Into::into),
        point.to_array().map(Into::into),
    );
    assert!(
        through <= claimed + rounding + 4.0 * epsilon * range,
        "{}: {there:?} {target:?}",
        context()
    );
    let back = frame.offset_to_enu(frame.enu_to_offset(enu).unwrap());
    // Deep in the Earth the way is through Earth axes.
    let deep = target.height() < T::of(-3e6);
    let both = claim("LocalFrame::geodetic_to_enu, relative to the distance")[T::CLAIM]
        + claim("LocalFrame::enu_to_offset, relative to the distance")[T::CLAIM];
    // Squares of shorter vectors have no digits.
    let short = 1e3 * T::SMALLEST_NORMAL.into().sqrt();
    let allowed = both * if deep { range + 1.3e7 } else { range } + short;
    assert!(
        apart(components(back), components(enu)) <= allowed,
        "{}: {back:?}",
        context()
    );
}

/// Azimuth, elevation and range of a vector of any size, and back.
fn pointing<T: Scalar>(bytes: &mut Bytes<'_>) {
    let enu = Enu::<T> {
        east: bytes.finite(),
        north: bytes.finite(),
        up: bytes.finite(),
    };
    let aer = Aer::from(enu);
    let context = || format!("{} {enu:?}: {aer:?}", T::NAME);
    let (azimuth, elevation, range) = (aer.azimuth.into(), aer.elevation.into(), aer.range.into());
    assert!(
        azimuth.abs() <= 180.0 && elevation.abs() <= 90.0 && range >= 0.0,
        "{}",
        context()
    );
    let exact = components(enu);
    let largest = exact.iter().fold(0.0_f64, |largest, v| maximum(largest, v.abs()));
    let ends = [T::SMALLEST_NORMAL.into() * 1e3, T::LARGEST.into() * 0.25];
    if largest < ends[0] || largest > ends[1] {
        return;
    }
    let back = components(Enu::from(aer)).map(|v| v / largest);
    let expected = exact.map(|v| v / largest);
    assert!(
        apart(back, expected) <= 8.0 * T::EPSILON.into() * length(expected),
        "{}: {back:?}",
        context()
    );
}

/// A conversion on an ellipsoid that all latitudes hold for, and how flat that is.
fn conversion<T: Scalar>(bytes: &mut Bytes<'_>) -> (Ellipsoid<T>, Latitude, Latitude) {
    let ellipsoid = bytes.ellipsoid(-1.0 / 150.0, 0.1);
    (ellipsoid, bytes.choice(Latitude::ALL), bytes.choice(Latitude::ALL))
}

/// The largest error claimed of a conversion to an angle, in radians.
fn claimed_angle<T: Scalar>(from: Latitude) -> f64 {
    let to_geodetic = if from == Latitude::Isometric {
        "geodetic latitude of an isometric one"
    } else {
        "geodetic latitude of another"
    };
    claim("latitude of a geodetic one")[T::CLAIM] + claim(to_geodetic)[T::CLAIM]
}

/// From one latitude to another and back; a latitude of the other hemisphere goes to that one's.
fn latitudes_close<T: Scalar>(bytes: &mut Bytes<'_>) {
    let (ellipsoid, from, to) = conversion::<T>(bytes);
    let there = Conversion::new(ellipsoid, from, to).unwrap();
    let back = Conversion::new(ellipsoid, to, from).unwrap();
    let isometric = from == Latitude::Isometric;
    let quarter = FRAC_PI_2;
    let in_degrees = bytes.flag();
    let value = if isometric {
        // Beyond, the other is a right angle.
        bytes.within::<T>(if T::NAME == "f32" { 14.0 } else { 33.0 })
    } else if in_degrees {
        bytes.within(90.0)
    } else {
        bytes.within(quarter)
    };
    let convert = |conversion: &Conversion<T>, value| {
        let result = if in_degrees {
            conversion.degrees(value)
        } else {
            conversion.radians(value)
        };
        result.unwrap_or_else(|why| panic!("{} {ellipsoid:?} {from} {to} {value:?}: {why}", T::NAME))
    };
    let limit = if in_degrees { 90.0 } else { quarter + T::EPSILON.into() };
    let result = convert(&there, value);
    let context = || format!("{} {ellipsoid:?} {from} {value:?} to {to}: {result:?}", T::NAME);
    assert!(
        to == Latitude::Isometric || result.into().abs() <= limit,
        "{}",
        context()
    );
    assert_eq!(convert(&there, -value), -result, "{}", context());
    if result.into().is_infinite() {
        return;
    }
    let again = convert(&back, result);
    let radian = if in_degrees && !isometric { PI / 180.0 } else { 1.0 };
    let error = (again.into() - value.into()).abs() * radian;
    // A step of the one is one of up to (1 − f)^±2 of the other.
    let squeeze = (1.0 - ellipsoid.f().into()).powi(2);
    let mut allowed = (claimed_angle::<T>(from) + claimed_angle::<T>(to)) * maximum(squeeze, 1.0 / squeeze);
    if isometric {
        // By the slope, the secant of the latitude.
        allowed = (allowed + 0.5 * T::EPSILON.into()) * value.into().cosh() + T::EPSILON.into() * value.into().abs();
    }
    if to == Latitude::Isometric && !isometric {
        allowed += 4.0 * T::EPSILON.into();
    }
    assert!(error <= allowed, "{}, back {again:?}, {error:e}", context());
}

/// A greater latitude stays one, but for the rounding of neighbours.
fn latitudes_grow<T: Scalar>(bytes: &mut Bytes<'_>) {
    let (ellipsoid, from, to) = conversion::<T>(bytes);
    let conversion = Conversion::new(ellipsoid, from, to).unwrap();
    let (a, b) = {
        let a = bytes.within::<T>(90.0);
        let b = if bytes.flag() {
            bytes.within(90.0)
        } else {
            steps(a, bytes.between(8))
        };
        let right = T::of(90.0);
        (a, if b.abs() > right { right } else { b })
    };
    let (low, high) = if a < b { (a, b) } else { (b, a) };
    let [x, y] = [low, high].map(|value| conversion.degrees(value).unwrap());
    if x.into().is_infinite() || y.into().is_infinite() {
        assert!(x <= y, "{from} to {to}: {low:?} to {x:?}, {high:?} to {y:?}");
        return;
    }
    let slack = if to == Latitude::Isometric {
        4.0 * T::EPSILON.into() * (1.0 + y.into().abs())
    } else {
        (2.0 * claimed_angle::<T>(from)).to_degrees()
    };
    assert!(
        y.into() >= x.into() - slack,
        "{} {ellipsoid:?} {from} to {to}: {low:?} to {x:?}, {high:?} to {y:?}",
        T::NAME
    );
}

/// The latitude in radians by its textbook formula, in `f64`.
fn textbook(e2: f64, kind: Latitude, phi: f64) -> f64 {
    let (sin, cos) = phi.sin_cos();
    let e = e2.abs().sqrt();
    // e·atanh(e sin φ) of an oblate ellipsoid, −e·atan(e sin φ) of a prolate one.
    let swell = |sin: f64| {
        if e2 > 0.0 {
            e * (e * sin).atanh()
        } else {
            -e * (e * sin).atan()
        }
    };
    let q = |sin: f64| {
        let over = if e2 == 0.0 { sin } else { swell(sin) / e2 };
        (1.0 - e2) * (sin / (1.0 - e2 * sin * sin) + over)
    };
    match kind {
        Latitude::Geodetic => phi,
        Latitude::Geocentric => ((1.0 - e2) * sin).atan2(cos),
        Latitude::Parametric => ((1.0 - e2).sqrt() * sin).atan2(cos),
        Latitude::Conformal => {
            // tan χ = τ√(1 + σ²) − σ√(1 + τ²), σ = sinh(e atanh(e sin φ))
            let (tan, sigma) = (sin / cos, swell(sin).sinh());
            (tan * (1.0 + sigma * sigma).sqrt() - sigma * (1.0 + tan * tan).sqrt()).atan()
        }
        Latitude::Authalic => (q(sin) / q(1.0)).asin(),
        Latitude::Rectifying => {
            let whole = meridian(e2, FRAC_PI_2);
            meridian(e2, phi) / whole * FRAC_PI_2
        }
        Latitude::Isometric => (sin / cos).asinh() - swell(sin),
    }
}

/// ∫(1 − e² sin²φ)^(−3/2) dφ, by Gauss's quadrature with five points in each of eight parts.
fn meridian(e2: f64, phi: f64) -> f64 {
    let nodes = [
        (0.0, 128.0 / 225.0),
        (0.538_469_310_105_683_1, 0.478_628_670_499_366_47),
        (0.906_179_845_938_664, 0.236_926_885_056_189_08),
    ];
    let part = phi / 16.0;
    let value = |phi: f64| (1.0 - e2 * phi.sin().powi(2)).powf(-1.5);
    let sum = (0..8).map(|i| {
        let middle = part * f64::from(2 * i + 1);
        let pairs = nodes.map(|(x, weight)| {
            let both = value(middle + x * part) + value(middle - x * part);
            weight * if x == 0.0 { 0.5 * both } else { both }
        });
        pairs.iter().sum::<f64>()
    });
    part * sum.sum::<f64>()
}

/// The latitudes of a geodetic one are the textbook's, as far as its formulas keep their digits.
fn latitudes_are_true<T: Scalar>(bytes: &mut Bytes<'_>) {
    let ellipsoid = bytes.ellipsoid::<T>(-1.0 / 150.0, 0.1);
    let kind = bytes.choice(Latitude::ALL);
    let phi = bytes.within::<T>(FRAC_PI_2);
    let there = Conversion::new(ellipsoid, Latitude::Geodetic, kind).unwrap();
    let f: f64 = ellipsoid.f().into();
    let found: f64 = there.radians(phi).unwrap().into();
    let exact: f64 = phi.into();
    if f.abs() < 1e-6 || exact.abs() > 1.5 {
        return; // there the textbook loses its digits
    }
    let expected = textbook(f * (2.0 - f), kind, exact);
    let claimed = if kind == Latitude::Isometric {
        claim("isometric latitude, relative to 1 or more")[T::CLAIM] * maximum(expected.abs(), 1.0)
    } else {
        claim("latitude of a geodetic one")[T::CLAIM]
    };
    // asin q is the worst of them.
    let textbook = 8e-16 / exact.cos();
    assert!(
        (found - expected).abs() <= claimed + textbook,
        "{} {ellipsoid:?} {kind} of {phi:?}: {found:?} {expected:?}",
        T::NAME
    );
}

#[cfg(test)]
#[test]
fn a_pole_is_one_place() {
    let earth = Ellipsoid::<f64>::WGS84;
    let pole = terrella::LatLon::new(90.0, 77.0).unwrap();
    let [x, y, z] = exact(earth, pole.into());
    assert_eq!((x.high, y.high), (0.0, 0.0));
    assert!((z.high - earth.b()).abs() < 1e-9);
}
