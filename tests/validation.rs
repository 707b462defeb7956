//! The doors: what a constructor, a parser or a conversion lets in, what it refuses, and what it says then.
//!
//! Behind the doors everything is total: no NaN comes out of what was let in.
#![allow(
    missing_docs, clippy::unwrap_used, clippy::expect_used, clippy::panic, clippy::indexing_slicing
)] // a test may fail loudly

use std::collections::BTreeSet;
use std::error::Error;
use std::fmt::{Debug, Display};
use std::str::FromStr;

use terrella::cube::{CubeMap, Face, FacePoint, InvalidFace, InvalidFacePoint, InvalidNumbered, Projection};
use terrella::geodesic::Method;
use terrella::latitude::{Conversion, InvalidLatitude, UnsupportedFlattening};
use terrella::{
    Direction, Dual, Ellipsoid, InvalidDirection, InvalidLatLon, LatLon, Latitude, NAMED, Real, Shift, Shifted,
};
use testkit::scalar::{Scalar, same};
use testkit::{maximum, minimum};

fn lengths<T: Scalar>() {
    let tiny = T::from_bits(1);
    let third = T::of(1.0 / 3.0f64.sqrt());
    for length in [T::LARGEST, T::SMALLEST_NORMAL, tiny, T::of(1e30), T::of(1e-30), T::ONE] {
        for sign in [T::ONE, -T::ONE] {
            let v = length * sign;
            let along = Direction::new(T::ZERO, v, T::ZERO).unwrap();
            assert_eq!(along.to_array(), [T::ZERO, sign, T::ZERO], "{v:?}");
            let [x, y, z] = Direction::new(v, v, v).unwrap().to_array();
            assert!(x == y && y == z, "{v:?}");
            assert!((x - third * sign).abs() <= T::EPSILON, "{v:?} {x:?}");
        }
    }
    // 3 : 4 : 5, exact at any power of two.
    for power in [-120, -60, -1, 0, 1, 60, 120] {
        let unit = T::of(2f64.powi(power));
        let direction = Direction::new(T::of(3.0) * unit, T::ZERO, T::of(-4.0) * unit).unwrap();
        assert_eq!(direction.to_array(), [T::of(0.6), T::ZERO, T::of(-0.8)], "2^{power}");
    }
}

#[test]
fn direction_at_the_ends_of_the_range() {
    lengths::<f64>();
    lengths::<f32>();
}

#[test]
fn face_takes_0_to_5() {
    for index in 0..=u8::MAX {
        match Face::from_index(index) {
            Ok(face) => assert!(index < 6 && face.index() == index && Face::ALL[usize::from(index)] == face),
            Err(InvalidFace(refused)) => assert!(index >= 6 && refused == index),
        }
    }
}

fn near(value: f64, truth: f64, relative: f64) {
    assert!(
        (value - truth).abs() <= relative * truth.abs(),
        "{value:e} is not {truth:e} within {relative:e}"
    );
}

/// The message holds all of this.
fn says(error: impl Error, values: &[&str]) {
    let text = one_line(error);
    for value in values {
        assert!(text.contains(value), "{text:?} does not say {value}");
    }
}

#[test]
fn wgs84_has_the_published_constants() {
    let e = Ellipsoid::<f64>::WGS84;
    let ulp = f64::EPSILON;
    near(e.b(), 6_356_752.314_245_179, ulp);
    near(e.e2(), 6.694_379_990_141_317_057_34e-3, ulp);
    near(e.ep2(), 6.739_496_742_276_434_954_78e-3, 2.0 * ulp);
    near(e.n(), 1.679_220_386_383_704_255_46e-3, 2.0 * ulp);
    let tenth_of_a_millimetre = |value: f64| (value * 1e4).round() / 1e4;
    assert_eq!(tenth_of_a_millimetre(e.mean_radius()), 6_371_008.771_4);
    assert_eq!(tenth_of_a_millimetre(e.authalic_radius()), 6_371_007.180_9);
    assert_eq!(tenth_of_a_millimetre(e.volumetric_radius()), 6_371_000.790_0);
}

#[test]
fn grs80_has_the_published_constants() {
    // Moritz (2000), Geodetic Reference System 1980.
    let e = Ellipsoid::<f64>::GRS80;
    near(e.b(), 6_356_752.314_1, 1e-11);
    near(e.e2(), 0.006_694_380_022_90, 1e-12);
    near(e.ep2(), 0.006_739_496_775_48, 1e-12);
    near(e.mean_radius(), 6_371_008.771_4, 2e-11);
    near(e.authalic_radius(), 6_371_007.181_0, 2e-11);
    near(e.volumetric_radius(), 6_371_000.790_0, 2e-11);
}

#[test]
fn single_precision_constants_are_those_of_double() {
    for &name in NAMED {
        let (e, truth) = (
            Ellipsoid::<f32>::named(name).unwrap(),
            Ellipsoid::<f64>::named(name).unwrap(),
        );
        // In terms of the flattening as rounded: that is what the value holds.
        let rounded = Ellipsoid::new(f64::from(e.a()), f64::from(e.f())).unwrap();
        let ulp = f64::from(f32::EPSILON);
        near(e.a().into(), truth.a(), ulp);
        near(e.f().into(), truth.f(), ulp);
        near(e.b().into(), rounded.b(), 2.0 * ulp);
        near(e.n().into(), rounded.n(), 2.0 * ulp);
        near(e.e2().into(), rounded.e2(), 2.0 * ulp);
        near(e.ep2().into(), rounded.ep2(), 4.0 * ulp);
        near(e.mean_radius().into(), rounded.mean_radius(), 2.0 * ulp);
        near(e.authalic_radius().into(), rounded.authalic_radius(), 2.0 * ulp);
        near(e.volumetric_radius().into(), rounded.volumetric_radius(), 2.0 * ulp);
    }
}

#[test]
fn a_sphere_has_one_radius() {
    for radius in [1.0, 1_737_400.0, 1e-15, 1e15] {
        let e = Ellipsoid::sphere(radius).unwrap();
        assert_eq!([e.f(), e.n(), e.e2(), e.ep2()], [0.0; 4]);
        assert_eq!([e.a(), e.b(), e.mean_radius(), e.authalic_radius()], [radius; 4]);
        near(e.volumetric_radius(), radius, f64::EPSILON);
    }
}

/// Against textbook forms other than the crate's, in a and b.
#[test]
fn derived_constants_of_oblate_and_prolate() {
    let mut rng = fastrand::Rng::with_seed(40);
    for i in 0..10_000 {
        let (a, f) = (
            10.0 + 90.0 * rng.f64(),
            if i % 2 == 0 { 0.9 * rng.f64() } else { -5.0 * rng.f64() },
        );
        let e = Ellipsoid::new(a, f).unwrap();
        let b = e.b();
        near(b, a - a * f, 1e-14);
        near(e.n() + 2.0, (a - b) / (a + b) + 2.0, 1e-14);
        near(e.e2() + 60.0, (a * a - b * b) / (a * a) + 60.0, 1e-14);
        near(e.ep2() + 200.0, (a * a - b * b) / (b * b) + 200.0, 1e-13);
        near(e.mean_radius(), (2.0 * a + b) / 3.0, 1e-14);
        near(e.volumetric_radius(), (a * a * b).cbrt(), 1e-14);
        // Half of 1/4π of the surface: πa²·(…) by the eccentricity of the meridian.
        let area = if a > b {
            let ecc = (1.0 - (b / a).powi(2)).sqrt();
            a * a + b * b * ecc.atanh() / ecc
        } else {
            let ecc = (1.0 - (a / b).powi(2)).sqrt();
            a * a + a * b * ecc.asin() / ecc
        };
        if f.abs() > 1e-3 {
            near(e.authalic_radius(), (area / 2.0).sqrt(), 1e-12);
        }
    }
}

fn radii_between_axes<T: Scalar>() {
    let mut rng = fastrand::Rng::with_seed(41);
    for i in 0..20_000 {
        let size = 10f64.powf(if i % 2 == 0 {
            -17.0 * rng.f64()
        } else {
            3.0 * rng.f64() - 3.0
        });
        let f = T::of(if rng.bool() { -size } else { minimum(size, 0.9999) });
        let e = Ellipsoid::new(T::of(6.4e6), f).unwrap();
        let (a, b) = (e.a().into(), e.b().into());
        let room = 1.0 + 4.0 * T::EPSILON.into();
        for radius in [e.mean_radius(), e.authalic_radius(), e.volumetric_radius()].map(Into::<f64>::into) {
            assert!(
                radius >= minimum(a, b) / room && radius <= maximum(a, b) * room,
                "{} {e:?}: {radius} is not between {a} and {b}",
                T::NAME
            );
        }
        assert!(e.n().into() * e.f().into() >= 0.0 && e.n().into().abs() < 1.0, "{e:?}");
    }
}

#[test]
fn radii_lie_between_the_axes() {
    radii_between_axes::<f64>();
    radii_between_axes::<f32>();
}

/// Against the EPSG dataset and the IAU's list.
#[test]
fn named_ellipsoids_are_the_published_ones() {
    let mut names = NAMED.iter();
    for row in include_str!("truth/ellipsoids.tsv")
        .lines()
        .filter(|row| !row.starts_with('#'))
    {
        let columns: Vec<&str> = row.split('\t').collect();
        let [name, code, _, a, metres, inverse, b] = columns[..] else {
            panic!("{row:?} has other columns")
        };
        assert_eq!(names.next(), Some(&name), "the lists have the same order");
        let e = Ellipsoid::<f64>::named(name).unwrap();
        let number = |text: &str| text.parse::<f64>().unwrap();
        let metres = number(metres);
        near(e.a(), number(a) * metres, 2.0 * f64::EPSILON);
        if inverse != "-" {
            assert_eq!(e.f(), 1.0 / number(inverse), "{name}");
        }
        if b != "-" {
            // Mars has been known by 1/f to ten digits.
            let digits = if code.starts_with("IAU") {
                1e-12
            } else {
                2.0 * f64::EPSILON
            };
            near(e.b(), number(b) * metres, digits);
        }
    }
    assert_eq!(names.next(), None, "a name without a source");
}

#[test]
fn named_ellipsoids_by_name() {
    assert_eq!(NAMED.len(), NAMED.iter().collect::<BTreeSet<_>>().len(), "a name twice");
    for &name in NAMED {
        let e: Ellipsoid = name.parse().unwrap();
        assert_eq!(Ellipsoid::new(e.a(), e.f()), Ok(e), "{name} would be refused");
        let single = Ellipsoid::new(f32::of(e.a()), f32::of(e.f())).unwrap();
        assert_eq!(Ellipsoid::named(name), Ok(single), "{name}");
        assert_eq!(e.to_f32(), single, "{name}");
        let (double, dual) = (e, Ellipsoid::<Dual<f64, 1>>::named(name).unwrap());
        let parts = |x: Dual<f64, 1>| (x.value(), x.slopes());
        assert_eq!(
            [parts(dual.a()), parts(dual.f())],
            [(double.a(), [0.0]), (double.f(), [0.0])]
        );
    }
    for unknown in ["", "WGS84", "wgs 84", "wgs84 ", "earth"] {
        let why = Ellipsoid::<f64>::named(unknown).unwrap_err();
        assert_eq!(why.name(), unknown);
        says(why, &[&format!("{unknown:?}"), "krassovsky1940"]);
    }
}

/// As many whole characters as 30 bytes hold; the rest is an ellipsis.
#[test]
fn an_unknown_name_is_kept_in_part() {
    let long = "æ".repeat(40);
    let why = long.parse::<Shift>().unwrap_err();
    assert_eq!(why.name(), "æ".repeat(15));
    says(why, &[&format!("\"{}\"…", "æ".repeat(15)), "authalic"]);
    let why = format!("x{long}").parse::<Shift>().unwrap_err();
    assert_eq!(why.name(), format!("x{}", "æ".repeat(14)));
    let exact = "x".repeat(30);
    says(exact.parse::<Shift>().unwrap_err(), &[&format!("{exact:?};")]);
}

#[test]
fn ellipsoids_from_other_numbers() {
    for &name in NAMED {
        let e: Ellipsoid = name.parse().unwrap();
        let from_axes = Ellipsoid::from_semi_axes(e.a(), e.b()).unwrap();
        assert_eq!(from_axes.a(), e.a());
        assert!((from_axes.f() - e.f()).abs() <= f64::EPSILON, "{name}");
        let from_inverse = Ellipsoid::from_inverse_flattening(e.a(), 1.0 / e.f()).unwrap();
        assert!((from_inverse.f() - e.f()).abs() <= f64::EPSILON * e.f(), "{name}");
        assert_eq!(Ellipsoid::from(e.to_f32()).to_f32(), e.to_f32());
    }
    let moon = Ellipsoid::sphere(1_737_400.0).unwrap();
    assert_eq!(Ellipsoid::from_inverse_flattening(1_737_400.0, f64::INFINITY), Ok(moon));
    let why = Ellipsoid::from_inverse_flattening(1_737_400.0, 0.0).unwrap_err();
    says(why, &["flattening", "inf"]);
    says(
        Ellipsoid::from_semi_axes(1.0, -0.5).unwrap_err(),
        &["flattening", "1.5"],
    );
    says(Ellipsoid::from_semi_axes(0.0, 1.0).unwrap_err(), &["axis", "0.0"]);
}

/// In a constant the same is refused, and an `f32` is no less flat than is allowed.
#[test]
fn constant_ellipsoids() {
    const MINE: Ellipsoid = match Ellipsoid::const_new(6_378_137.0, 1.0 / 298.257_223_563) {
        Ok(ellipsoid) => ellipsoid,
        Err(_) => panic!(),
    };
    const SINGLE: Ellipsoid<f32> = MINE.to_f32();
    assert_eq!((MINE, SINGLE), (Ellipsoid::WGS84, Ellipsoid::WGS84));
    let below = |x: f64| f64::from_bits(x.to_bits() - 1);
    for a in [1e-15, below(1e-15), 1e15, 1.1e15, -1.0, 0.0, f64::NAN, f64::INFINITY] {
        for f in [0.0, -1000.0, -1000.1, below(1.0), 1.0, f64::NAN, f64::NEG_INFINITY] {
            let (constant, new) = (Ellipsoid::const_new(a, f), Ellipsoid::new(a, f));
            assert_eq!(format!("{constant:?}"), format!("{new:?}"));
            if let Ok(e) = new {
                let single = e.to_f32();
                assert_eq!(Ellipsoid::new(single.a(), single.f()), Ok(single), "{e:?}");
            }
        }
    }
}

/// −1/9 to 1/10 for the series, −1 to ½ for the ratios of tangents, anything for the geodetic latitude.
fn flattenings<T: Scalar>(shift: Shift) {
    let (low, high) = match shift {
        Shift::Geodetic => (f64::NEG_INFINITY, 1.0),
        Shift::Geocentric | Shift::Parametric => (-1.0, 0.5),
        Shift::Authalic | Shift::Conformal | Shift::Rectifying => (-1.0 / 9.0, 0.1),
    };
    for f in [
        0.0,
        1e-3,
        -1e-3,
        0.0999,
        0.1,
        0.1001,
        0.4999,
        0.5,
        0.5001,
        0.99,
        -0.1111,
        -1.0 / 9.0,
        -0.1112,
        -0.9999,
        -1.0,
    ]
    .into_iter()
    .chain([-1.0001, -10.0, -1000.0])
    {
        let f = T::of(f);
        let ellipsoid = Ellipsoid::new(T::ONE, f).unwrap();
        let refusal = Err(UnsupportedFlattening(f));
        let accepted = f >= T::of(low) && f <= T::of(high);
        let context = || format!("{} {shift} f = {f:?}", T::NAME);
        let shifted = Shifted::new(ellipsoid, shift);
        let map = CubeMap::new(ellipsoid, shift, Projection::Adjusted);
        if accepted {
            let shifted = shifted.unwrap_or_else(|why| panic!("{}: {why}", context()));
            assert_eq!((shifted.ellipsoid(), shifted.shift()), (ellipsoid, shift));
            let map = map.unwrap_or_else(|why| panic!("{}: {why}", context()));
            assert_eq!((map.shifted(), map.projection()), (shifted, Projection::Adjusted));
        } else {
            assert_eq!(shifted.map(|_| ()), refusal, "{}", context());
            assert_eq!(map.map(|_| ()), refusal, "{}", context());
        }
        for (from, to) in [(Latitude::Geodetic, shift.into()), (shift.into(), Latitude::Geodetic)] {
            let conversion = Conversion::new(ellipsoid, from, to).map(|_| ());
            assert_eq!(conversion, if accepted { Ok(()) } else { refusal }, "{}", context());
        }
    }
}

#[test]
fn flattenings_beyond_a_formula_are_refused() {
    for &shift in Shift::ALL {
        flattenings::<f64>(shift);
        flattenings::<f32>(shift);
    }
    let flat = Ellipsoid::new(1.0, 0.2).unwrap();
    let isometric = |from, to| Conversion::new(flat, from, to).map(|_| ());
    assert_eq!(
        isometric(Latitude::Isometric, Latitude::Geodetic),
        Err(UnsupportedFlattening(0.2))
    );
    // One is a function of the other, whatever the ellipsoid.
    assert_eq!(isometric(Latitude::Isometric, Latitude::Conformal), Ok(()));
}

fn latitude_door<T: Scalar>() {
    let quarter = T::of(std::f64::consts::FRAC_PI_2);
    for &from in Latitude::ALL {
        for &to in Latitude::ALL {
            let conversion = Conversion::new(Ellipsoid::<T>::WGS84, from, to).unwrap();
            let isometric = from == Latitude::Isometric;
            let judge = |value: T, limit: T, result: Result<T, InvalidLatitude<T>>| {
                let valid = if isometric {
                    !value.into().is_nan()
                } else {
                    value.abs() <= limit
                };
                match result {
                    Ok(converted) => {
                        assert!(valid, "{from} {value:?} was taken");
                        assert!(!converted.into().is_nan(), "{from} {value:?} gave NaN for {to}");
                        assert!(
                            to == Latitude::Isometric || converted.abs() <= limit,
                            "{from} {value:?} gave {converted:?} for {to}"
                        );
                    }
                    Err(InvalidLatitude(refused)) => {
                        assert!(!valid && same(refused, value), "{from} {value:?} was refused");
                    }
                }
            };
            let mut values = [0.0, 1.0, 30.0, 45.0, 60.0, 1e-300, 1e30, f64::INFINITY, f64::NAN]
                .map(T::of)
                .to_vec();
            for limit in [T::of(90.0), quarter] {
                values.extend([limit, limit.above(), limit * T::of(0.5), limit - T::EPSILON]);
            }
            values.extend([T::SMALLEST_NORMAL, T::from_bits(1), T::LARGEST]);
            for value in values.iter().flat_map(|&v| [v, -v]) {
                judge(value, T::of(90.0), conversion.degrees(value));
                judge(value, quarter, conversion.radians(value));
            }
        }
    }
}

#[test]
fn latitudes_beyond_the_poles_are_refused() {
    latitude_door::<f64>();
    latitude_door::<f32>();
}

/// Each name reads back, no two are alike, and near misses are refused with the list of what is known.
fn names<T>(all: &[T], name: impl Fn(T) -> &'static str)
where
    T: Copy + PartialEq + Debug + Display + FromStr<Err: Error>,
{
    let mut seen = BTreeSet::new();
    for &kind in all {
        let own = name(kind);
        assert!(own.parse::<T>().is_ok_and(|parsed| parsed == kind), "{own}");
        assert_eq!(kind.to_string(), own);
        assert_eq!(format!("[{kind:>20}]"), format!("[{own:>20}]"), "width is ignored");
        assert!(seen.insert(own), "{own} twice");
        assert!(
            own.bytes()
                .all(|b| b.is_ascii_lowercase() || b.is_ascii_digit() || b == b'-'),
            "{own}"
        );
    }
    for wrong in [
        "",
        " ",
        "nonsense",
        &format!("{} ", all[0]),
        &all[0].to_string().to_uppercase(),
    ] {
        let Err(unknown) = wrong.parse::<T>() else {
            panic!("{wrong:?} was taken");
        };
        let text = one_line(unknown);
        for own in &seen {
            assert!(text.split([' ', ',']).any(|word| word == *own), "{text} lacks {own}");
        }
    }
}

#[test]
fn names_read_back() {
    names(Projection::ALL, Projection::name);
    names(Shift::ALL, Shift::name);
    names(Latitude::ALL, Latitude::name);
    for &shift in Shift::ALL {
        assert_eq!(Latitude::from(shift).name(), shift.name());
    }
    assert_eq!(Shift::default(), Shift::Authalic);
}

/// An error's text, after a look at its form.
fn one_line(error: impl Error) -> String {
    let text = error.to_string();
    assert!(!text.is_empty() && !text.contains('\n'), "{text:?}");
    assert_eq!(text, text.trim(), "blanks around {text:?}");
    assert!(error.source().is_none(), "{text}");
    text
}

#[test]
fn errors_say_the_value_in_one_line() {
    says(LatLon::new(-90.5, 0.0).unwrap_err(), &["latitude", "-90.5"]);
    says(LatLon::new(f32::NAN, 0.0).unwrap_err(), &["latitude", "NaN"]);
    says(LatLon::new(0.0, f64::INFINITY).unwrap_err(), &["longitude", "inf"]);
    says(Direction::new(0.0, -0.0, 0.0).unwrap_err(), &["0.0", "-0.0"]);
    says(
        Direction::new(1.5, f32::NAN, f32::NEG_INFINITY).unwrap_err(),
        &["1.5", "NaN", "-inf"],
    );
    says(Ellipsoid::new(-6.5, 0.0).unwrap_err(), &["axis", "-6.5"]);
    says(Ellipsoid::new(1.0, 1.25_f32).unwrap_err(), &["flattening", "1.25"]);
    says(Face::from_index(77).unwrap_err(), &["77"]);
    says(FacePoint::new(Face::Top, 1.5, -2e300).unwrap_err(), &["1.5", "-2e300"]);
    says(InvalidNumbered::<f64>::Face(InvalidFace(9)), &["9"]);
    says(
        InvalidNumbered::Point(InvalidFacePoint { x: 3.5, y: 4.5 }),
        &["3.5", "4.5"],
    );
    says(UnsupportedFlattening(0.75), &["0.75"]);
    says(InvalidLatitude(90.25), &["90.25"]);
    let name = "mercator";
    says(
        name.parse::<Projection>().unwrap_err(),
        &[name, "healpix", "s2-quadratic"],
    );
    says(name.parse::<Shift>().unwrap_err(), &[name, "authalic"]);
    says(name.parse::<Latitude>().unwrap_err(), &[name, "isometric"]);
    says(name.parse::<Method>().unwrap_err(), &[name, "vincenty"]);
}

fn exact_angles<T: Scalar>() {
    let place = |lat: i32, lon: i32| LatLon::new(T::of(f64::from(lat)), T::of(f64::from(lon))).unwrap();
    let back = |place: LatLon<T>| place.to_direction().to_lat_lon();
    let there = |lat, lon| {
        let there = place(lat, lon);
        (there, back(there), format!("{} {lat} {lon}", T::NAME))
    };
    // Sine and cosine of these are equal or 0, and the arc tangent is exact on axes and diagonals.
    for lon in (-180..=180).step_by(45) {
        let (place, back, context) = there(0, lon);
        assert_eq!(back, place, "{context}");
    }
    for lon in (-180..=180).step_by(90) {
        for lat in [-45, 0, 45] {
            let (place, back, context) = there(lat, lon);
            assert_eq!(back, place, "{context}");
        }
    }
    for lon in (-180..=180).step_by(15) {
        for lat in [-90, 90] {
            let (place, back, context) = there(lat, lon);
            assert_eq!(back.lat(), place.lat(), "{context}");
            assert_eq!(
                place.to_direction().to_array(),
                [T::ZERO, T::ZERO, T::of(f64::from(lat.signum()))],
                "{context}"
            );
        }
    }
    // The others within the rounding of the unit vector: an ulp of 90.
    let ulp = 64.0 * T::EPSILON.into();
    for lat in (-75..=75).step_by(15) {
        for lon in (-180..=180).step_by(15) {
            let (place, back, context) = there(lat, lon);
            let off = [back.lat() - place.lat(), back.lon() - place.lon()].map(|v| v.into().abs());
            assert!(off[0] <= ulp && off[1] <= ulp, "{context}: {back:?}");
        }
    }
}

#[test]
fn right_angles_and_their_halves_come_back_exactly() {
    exact_angles::<f64>();
    exact_angles::<f32>();
}

/// As documented: the longitude of a pole is 0 or ±180.
#[test]

fn a_pole_has_longitude_0_or_180() {
    for lat in [-90.0, 90.0] {
        for lon in [-180.0, -135.0, -90.0, -30.0, -0.0, 0.0, 45.0, 90.0, 120.0, 180.0] {
            let back = LatLon::new(lat, lon).unwrap().to_direction().to_lat_lon();
            assert!([0.0, 180.0].contains(&back.lon().abs()), "{lat} {lon} gave {back:?}");
        }
    }
    let pole = Direction::new(0.0, 0.0, 1.0_f32).unwrap().to_lat_lon();
    assert_eq!((pole.lat(), pole.lon()), (90.0, 0.0));
}

fn antimeridian<T: Scalar>() {
    let half_circle = T::of(180.0);
    for tenths in -899..=899 {
        let lat = T::of(f64::from(tenths) / 10.0);
        for lon in [-half_circle, half_circle] {
            let place = LatLon::new(lat, lon).unwrap();
            assert_eq!(place.lon(), lon, "kept by the door");
            assert_eq!(place.to_direction().to_lat_lon().lon(), lon, "{} {lat:?}", T::NAME);
            for &shift in Shift::ALL {
                for &projection in Projection::ALL {
                    let map = CubeMap::new(Ellipsoid::<T>::WGS84, shift, projection).unwrap();
                    let back = map.unproject(map.project(place)).lon();
                    assert_eq!(back, lon, "{projection} {shift} {}: {place:?}", T::NAME);
                }
            }
        }
    }
}

#[test]
fn proj_4214_longitude_minus_180() {
    antimeridian::<f64>();
    antimeridian::<f32>();
}

/// The cube's edges are at ±45° and ±135° of longitude: such points project to coordinate 1 and come back.
#[test]
fn proj_1157_points_on_the_edges_of_the_cube() {
    for &projection in Projection::ALL {
        let map = CubeMap::new(Ellipsoid::<f64>::WGS84, Shift::Geocentric, projection).unwrap();
        // COBE's published polynomials miss each other by 3e-4.
        let tolerance = if projection == Projection::Cobe { 0.05 } else { 1e-12 };
        for lon in [-135.0, -45.0, 45.0, 135.0] {
            for lat in -35..=35 {
                let place = LatLon::new(f64::from(lat), lon).unwrap();
                let point = map.project(place);
                // Cartesian is within an ulp of its edge.
                assert!(point.x().abs() > 1.0 - f64::EPSILON, "{projection} {place:?} {point:?}");
                let back = map.unproject(point);
                assert!(
                    (back.lat() - place.lat()).abs() < tolerance && (back.lon() - lon).abs() < 1e-13,
                    "{projection} {place:?} {back:?}"
                );
            }
        }
    }
}

/// Longitude and latitude in the wrong order gave NaN.
#[test]
fn georust_geo_1327_swapped_coordinates() {
    assert_eq!(LatLon::new(151.2, -33.9), Err(InvalidLatLon::Latitude(151.2)));
    assert_eq!(LatLon::new(-33.9, 151.2).map(LatLon::lon), Ok(151.2));
}

/// NaN at latitude ±45.
#[test]
fn geographiclib_js_3_latitude_45() {
    for lat in [-45.0, 45.0] {
        for &from in Latitude::ALL {
            for &to in Latitude::ALL {
                let conversion = Conversion::new(Ellipsoid::<f64>::WGS84, from, to).unwrap();
                let value = conversion.degrees(lat).unwrap();
                assert!(
                    value.signum() == lat.signum() && value.abs() <= 90.0,
                    "{from} {to} {value}"
                );
                if from != Latitude::Isometric && to != Latitude::Isometric {
                    assert!((value - lat).abs() < 0.25, "{from} {to} {value}");
                }
            }
        }
        for &projection in Projection::ALL {
            for &shift in Shift::ALL {
                let map = CubeMap::new(Ellipsoid::<f64>::WGS84, shift, projection).unwrap();
                for lon in (-180..=180).step_by(45).map(f64::from) {
                    let back = map.unproject(map.project(LatLon::new(lat, lon).unwrap()));
                    let tolerance = if projection == Projection::Cobe { 0.05 } else { 1e-12 };
                    assert!(
                        (back.lat() - lat).abs() < tolerance,
                        "{projection} {shift} {lon}: {back:?}"
                    );
                }
            }
        }
    }
}

/// The origin has no direction; a later step panicked on its NaN.
#[test]
fn sguaba_24_the_centre_of_the_earth() {
    assert_eq!(
        Direction::new(0.0, 0.0, 0.0),
        Err(InvalidDirection { x: 0.0, y: 0.0, z: 0.0 })
    );
}

/// Steps across the antimeridian.
#[test]
fn ardupilot_17840_past_180() {
    let mut lon = 179.5;
    let mut walked = Vec::new();
    for _ in 0..4 {
        lon = LatLon::new(10.0, lon + 0.25).unwrap().lon();
        walked.push(lon);
    }
    assert_eq!(walked, [179.75, 180.0, -179.75, -179.5]);
}

/// Positions next to the poles lost digits in Healpix.
#[test]
fn astropy_healpix_34_next_to_the_poles() {
    for &shift in Shift::ALL {
        let map = CubeMap::new(Ellipsoid::<f64>::WGS84, shift, Projection::Healpix).unwrap();
        for exponent in 0..=14 {
            for lon in (-180..=180).step_by(5).map(f64::from) {
                for sign in [-1.0, 1.0] {
                    let lat = sign * (90.0 - 10f64.powi(-exponent));
                    let back = map.unproject(map.project(LatLon::new(lat, lon).unwrap()));
                    let metres = 6_378_137.0 * std::f64::consts::PI / 180.0;
                    let turn = (back.lon() - lon + 540.0).rem_euclid(360.0) - 180.0;
                    let (north, east) = (back.lat() - lat, turn * lat.to_radians().cos());
                    assert!(north.hypot(east) * metres < 5e-9, "{shift} {lat} {lon}: {back:?}");
                }
            }
        }
    }
}

/// Healpix on the authalic latitude has equal areas on the ellipsoid: y of a side face is in proportion to the area of the
/// zone from the equator.
#[test]
fn healpix_geo_28_equal_areas_on_the_ellipsoid() {
    let ellipsoid = Ellipsoid::<f64>::WGS84;
    let e = ellipsoid.e2().sqrt();
    // 1/2πb² of the area between the equator and latitude φ.
    let zone = |lat: f64| {
        let s = lat.to_radians().sin();
        s / (1.0 - e * e * s * s) + (e * s).atanh() / e
    };
    let map = CubeMap::new(ellipsoid, Shift::Authalic, Projection::Healpix).unwrap();
    for tenths in -410..=410 {
        let lat = f64::from(tenths) / 10.0;
        let y = map.project(LatLon::new(lat, 20.0).unwrap()).y();
        let expected = 1.5 * zone(lat) / zone(90.0);
        assert!((y - expected).abs() < 1e-14, "{lat}: {y} is not {expected}");
    }
}
