//! From east, north and up back to latitude, longitude and height, and their differences from the origin.

use fastrand::Rng;
use terrella::frame::{GeodeticOffset, InvalidEnu};
use terrella::{Aer, Ellipsoid, Enu, Geodetic, LocalFrame, Ned};

use testkit::Worst;

use crate::{ELLIPSOIDS, ellipsoid, geodetic, length};
use testkit::table::hold;
use testkit::truth::{Row, Scalar, Truth};

const INPUTS: [&str; 6] = ["lat1", "lon1", "h1", "east", "north", "up"];

fn components<T: Scalar>(enu: Enu<T>) -> [f64; 3] {
    [enu.east, enu.north, enu.up].map(Into::into)
}

/// A difference of longitudes without whole turns.
fn turned(difference: f64) -> f64 {
    difference - 360.0 * (difference / 360.0).round()
}

/// Metres northward and eastward in a degree where a row leads.
fn degree<T: Scalar>(row: Row<'_>, ellipsoid: Ellipsoid<T>) -> [f64; 2] {
    let (a, e2): (f64, f64) = (ellipsoid.a().into(), ellipsoid.e2().into());
    let (sin, cos) = row.value("lat").to_radians().sin_cos();
    let w2 = 1.0 - e2 * sin * sin;
    let across = a / w2.sqrt();
    let along = across * (1.0 - e2) / w2;
    let h = row.value("h");
    [(along + h).to_radians(), ((across + h) * cos).to_radians()]
}

/// Half of the last place of a number of this size.
fn half_ulp<T: Scalar>(value: f64) -> f64 {
    0.5 * testkit::maximum(value.abs(), 1e-30).log2().floor().exp2() * T::EPSILON.into()
}

#[derive(Default)]
struct Errors {
    /// Of the offset, over the distance.
    offset: Worst,
    /// Of the position beyond the nearest that the scalar has, over the distance, and in metres within 10 km.
    beyond: Worst,
    near: Worst,
    /// From the offset to the vector it came of, over the distance.
    back: Worst,
}

fn measured<T: Scalar>(name: &str) -> [f64; 4] {
    let truth = Truth::read("enu_reverse");
    let ellipsoid = ellipsoid::<T>(name);
    let mut worst = Errors::default();
    let rows = truth.exact_in::<T>(&INPUTS);
    for row in rows.into_iter().filter(|row| row.text("ellipsoid") == name) {
        let [lat, lon, h, east, north, up] = INPUTS.map(|column| row.input::<T>(column));
        let frame = LocalFrame::new(ellipsoid, geodetic(lat, lon, h));
        let enu = Enu { east, north, up };
        let distance = length(&components(enu));
        let scale = degree(row, ellipsoid);

        let offset = frame.enu_to_offset(enu).unwrap();
        let errors = [
            row.error("dlat", offset.lat) * scale[0],
            turned(row.deviation("dlon", offset.lon)) * scale[1],
            row.error("dh", offset.height),
        ];
        worst.offset.add(length(&errors) / distance);
        let back = components(frame.offset_to_enu(offset));
        let apart = length(&[0, 1, 2].map(|at| back[at] - components(enu)[at]));
        worst.back.add(apart / distance);

        let there = frame.enu_to_geodetic(enu).unwrap();
        let beyond = [
            (row.error("lat", there.lat()) - half_ulp::<T>(row.value("lat"))) * scale[0],
            (turned(row.deviation("lon", there.lon())).abs() - half_ulp::<T>(row.value("lon"))) * scale[1],
            row.error("h", there.height()) - half_ulp::<T>(row.value("h")),
        ]
        .map(|beyond| testkit::maximum(beyond, 0.0));
        worst.beyond.add(length(&beyond) / distance);
        if distance <= 1.01e4 {
            worst.near.add(length(&beyond));
        }
    }
    let worst = [worst.offset, worst.back, worst.beyond, worst.near].map(Worst::value);
    println!("{} {name} {worst:?}", T::NAME);
    worst
}

#[test]
fn ways_back_are_as_accurate_as_claimed() {
    for name in ELLIPSOIDS {
        let (double, single) = (measured::<f64>(name), measured::<f32>(name));
        hold(
            "LocalFrame::enu_to_offset, relative to the distance",
            [double[0], single[0]],
        );
        for (measured, claimed) in double.into_iter().zip([6e-16, 9e-16, 4e-16, 2e-12]) {
            assert!(measured <= claimed, "f64 {name}: {measured:e} {claimed:e}");
        }
        for (measured, claimed) in single.into_iter().zip([1.7e-7, 1.7e-7, 7e-8, 2.5e-4]) {
            assert!(measured <= claimed, "f32 {name}: {measured:e} {claimed:e}");
        }
    }
}

/// Origins where something is special, and vectors that lead over a pole, over ±180°, up, down and nowhere.
fn special<T: Scalar>() {
    let numbers = |lat: f64, lon: f64, h: f64, [east, north, up]: [f64; 3]| {
        let frame = LocalFrame::new(Ellipsoid::<T>::WGS84, geodetic(T::of(lat), T::of(lon), T::of(h)));
        let enu = Enu {
            east: T::of(east),
            north: T::of(north),
            up: T::of(up),
        };
        let there = frame.enu_to_geodetic(enu).unwrap();
        assert_eq!(frame.ned_to_geodetic(Ned::from(enu)), Ok(there));
        assert_eq!(
            frame.aer_to_geodetic(Aer::from(enu)),
            frame.enu_to_geodetic(Aer::from(enu).into())
        );
        [there.lat(), there.lon(), there.height()].map(Into::<f64>::into)
    };
    for (lat, lon) in [
        (90.0, 0.0),
        (-90.0, 30.0),
        (0.0, 180.0),
        (0.0, -180.0),
        (45.0, -180.0),
        (90.0, 180.0),
    ] {
        // Where it is, up and down.
        for up in [-10e3, 0.0, 100.0, 100e3, 1e8] {
            assert_eq!(
                numbers(lat, lon, 50.0, [0.0, 0.0, up]),
                [lat, lon, T::of(50.0 + up).into()],
                "{lat} {lon} {up}"
            );
        }
    }
    // From the pole along the meridian 180° away; from next to it over it.
    let [lat, lon, _] = numbers(90.0, 10.0, 0.0, [0.0, 1e5, 0.0]);
    assert!(lat < 89.2 && lon == -170.0, "{lat} {lon}");
    let [lat, lon, _] = numbers(90.0, 10.0, 0.0, [0.0, -1e5, 0.0]);
    assert!(lat < 89.2 && lon == 10.0, "{lat} {lon}");
    let [lat, lon, _] = numbers(89.75, 10.0, 0.0, [0.0, 1e5, 0.0]);
    assert!((lat - 89.35).abs() < 0.01 && lon == -170.0, "{lat} {lon}");
    // Over ±180°, and back.
    let [lat, lon, _] = numbers(0.0, 180.0, 0.0, [1e4, 0.0, 0.0]);
    assert!(lat == 0.0 && (lon + 179.910_2).abs() < 1e-3, "{lon}");
    let [_, lon, _] = numbers(0.0, -180.0, 0.0, [-1e4, 0.0, 0.0]);
    assert!((lon - 179.910_2).abs() < 1e-3, "{lon}");
    // A metre over ±180°, where the difference of single longitudes is all rounding: the curvature is not lost.
    let frame = LocalFrame::new(Ellipsoid::<T>::WGS84, geodetic(T::of(0.0), T::of(-180.0), T::of(0.0)));
    let beside = T::of(f64::from(180.0_f32.next_down()));
    let seen = frame.geodetic_to_enu(geodetic(T::of(0.0), beside, T::of(0.0)));
    let (east, up): (f64, f64) = (seen.east.into(), seen.up.into());
    assert!(
        (east + 1.698_65).abs() < 1e-4 && (up / (east * east / 12_756_274.0) + 1.0).abs() < 1e-3,
        "{seen:?}"
    );
    // navtypes, enu2lla at the date line: 10 m south of (20, 180).
    let [lat, lon, h] = numbers(20.0, 180.0, 0.0, [0.0, -10.0, 0.0]);
    assert!(
        (lat - 19.999_909_66).abs() < 1e-6 && lon == 180.0 && h.abs() < 1e-5,
        "{lat} {lon} {h}"
    );
}

#[test]
fn poles_and_the_date_line_are_like_other_places() {
    special::<f64>();
    special::<f32>();
}

#[test]
fn offsets_of_a_field_keep_millimetres_in_single_precision() {
    let mut rng = Rng::with_seed(4);
    for _ in 0..100_000 {
        let mut part = |size: f64| (size * (2.0 * rng.f64() - 1.0)) as f32;
        let frame = LocalFrame::new(Ellipsoid::WGS84, geodetic(part(85.0), part(180.0), part(9e3)));
        let enu = Enu {
            east: part(6e3),
            north: part(6e3),
            up: part(5e3),
        };
        let back = frame.offset_to_enu(frame.enu_to_offset(enu).unwrap());
        let (one, two) = (components(enu), components(back));
        let apart = length(&[0, 1, 2].map(|at| one[at] - two[at]));
        assert!(apart <= 1.5e-3, "{enu:?} {back:?}: {apart}");
    }
}

/// A point on either side of where the way through Earth axes takes over is in one place.
fn continuous<T: Scalar>(allowed: f64) {
    let mut rng = Rng::with_seed(5);
    let earth = Ellipsoid::<T>::WGS84;
    for _ in 0..20_000 {
        let mut part = |size: f64| T::of(size * (2.0 * rng.f64() - 1.0));
        let frame = LocalFrame::new(earth, geodetic(part(90.0), part(180.0), part(1e5)));
        let far = T::of([3.25e6, 6.4e9][usize::from(part(1.0) > T::ZERO)]);
        let scale = part(0.1) + T::ONE;
        let enu = Enu {
            east: part(1e6),
            north: part(1e6),
            up: if far < T::of(1e7) { -far * scale } else { far * scale },
        };
        let there = frame.enu_to_geodetic(enu).unwrap();
        let through = earth.to_geodetic(frame.from_enu(enu).unwrap());
        let [one, two] = [there, through].map(|place: Geodetic<T>| earth.to_ecef(place));
        let apart = crate::distance(one, two) / length(&components(enu));
        assert!(apart <= allowed, "{enu:?} {there:?} {through:?}: {apart:e}");
        let offset = frame.enu_to_offset(enu).unwrap();
        let back = components(frame.offset_to_enu(offset));
        let apart = length(&[0, 1, 2].map(|at| back[at] - components(enu)[at])) / length(&components(enu));
        assert!(apart <= allowed, "{enu:?} {offset:?}: {apart:e}");
    }
}

#[test]
fn deep_and_far_points_are_where_earth_axes_have_them() {
    continuous::<f64>(4e-15);
    continuous::<f32>(1.5e-6);
}

/// Any numbers at all are a position, or refused with themselves.
#[test]
fn past_the_middle_of_the_earth_is_the_other_pole() {
    for pole in [90.0_f32, -90.0] {
        let origin = Geodetic::new(terrella::LatLon::new(pole, 50.749_645).unwrap(), 46_145.14).unwrap();
        let frame = LocalFrame::new(Ellipsoid::WGS84, origin);
        for (east, north) in [
            (6.681_711_5e-30, 4.983_406_7e-35),
            (-1e-9, 1e-9),
            (0.0, -0.0),
            (1e-3, -1e-3),
        ] {
            let down = Enu { east, north, up: -1e7 };
            let there = frame.enu_to_geodetic(down).unwrap();
            assert_eq!(there.lat(), -pole, "{down:?} {there:?}");
        }
    }
}

fn any<T: Scalar>(values: &[T]) {
    for origin in [
        (0.0, 0.0, 0.0),
        (90.0, 180.0, 1e5),
        (-45.0, -180.0, -6.4e6),
        (30.0, 10.0, 1e30),
    ] {
        let origin = geodetic(T::of(origin.0), T::of(origin.1), T::of(origin.2));
        for name in ELLIPSOIDS {
            let frame = LocalFrame::new(ellipsoid::<T>(name), origin);
            for &east in values {
                for &north in values {
                    for &up in values {
                        let enu = Enu { east, north, up };
                        let finite = [east, north, up].iter().all(|v| v.is_finite());
                        match frame.enu_to_geodetic(enu) {
                            Ok(there) => {
                                assert!(there.lat().abs() <= T::of(90.0) && there.lon().abs() <= T::of(180.0));
                                assert!(finite && there.height().is_finite(), "{enu:?} {there:?}");
                                let GeodeticOffset { lat, lon, height } = frame.enu_to_offset(enu).unwrap();
                                assert!(
                                    lat.abs() <= T::of(180.0) && lon.abs() <= T::of(180.0),
                                    "{enu:?} {lat} {lon}"
                                );
                                assert!(height.is_finite() || up.abs() > T::of(1e30), "{enu:?} {height}");
                            }
                            Err(InvalidEnu {
                                east: e,
                                north: n,
                                up: u,
                            }) => {
                                let same =
                                    |a: T, b: T| a == b || (a.partial_cmp(&a).is_none() && b.partial_cmp(&b).is_none());
                                assert!(same(e, east) && same(n, north) && same(u, up));
                                assert!(!finite || [east, north, up].iter().any(|v| v.abs() > T::of(1e30)));
                                assert!(frame.enu_to_offset(enu).is_err());
                            }
                        }
                    }
                }
            }
        }
    }
}

#[test]
fn any_vector_is_a_position_or_refused() {
    let values = [
        0.0,
        -0.0,
        5e-324,
        1e-200,
        1.0,
        -6.4e6,
        1e17,
        -1e200,
        f64::MAX,
        f64::INFINITY,
        f64::NAN,
    ];
    any(&values);
    let values = [
        0.0,
        -0.0,
        1e-45,
        1.0,
        -6.4e6,
        1e17,
        -3e36,
        f32::MAX,
        f32::NEG_INFINITY,
        f32::NAN,
    ];
    any(&values);
    let frame = LocalFrame::new(Ellipsoid::<f64>::WGS84, geodetic(0.0, 0.0, 0.0));
    let aer = Aer {
        azimuth: 0.0,
        elevation: 0.0,
        range: f64::INFINITY,
    };
    let refused = frame.aer_to_geodetic(aer).unwrap_err();
    assert_eq!(refused.north, f64::INFINITY);
    let nowhere = InvalidEnu {
        east: 1.0,
        north: f64::NAN,
        up: 0.0,
    };
    assert_eq!(nowhere.to_string(), "(1.0, NaN, 0.0) east, north, up is not finite");
}

/// Single precision next to double, which is held to the truth: both ways at all distances, with many origins next to the poles and ±180°.
fn single_next_to_double(count: u32, seed: u64) {
    let mut rng = Rng::with_seed(seed);
    let [mut offsets, mut there, mut beyond, mut near] = [Worst::default(); 4];
    for _ in 0..count {
        let sign = if rng.bool() { 1.0 } else { -1.0 };
        let lat = match rng.u8(0..6) {
            0 => sign * (90.0 - 10_f64.powf(1.0 - 6.0 * rng.f64())),
            1 => sign * 90.0,
            _ => 180.0 * rng.f64() - 90.0,
        } as f32;
        let lon = match rng.u8(0..4) {
            0 => sign * (180.0 - 1e-2 * rng.f64()),
            _ => 360.0 * rng.f64() - 180.0,
        } as f32;
        let height = (rng.f64() * 110e3 - 10e3) as f32;
        let size = 10_f64.powf(8.0 * rng.f64());
        let mut part = || (size * (2.0 * rng.f64() - 1.0)) as f32;
        let enu = Enu {
            east: part(),
            north: part(),
            up: part(),
        };
        let long = Enu {
            east: f64::from(enu.east),
            north: f64::from(enu.north),
            up: f64::from(enu.up),
        };
        let distance = length(&components(enu));
        let frame = LocalFrame::new(Ellipsoid::<f32>::WGS84, geodetic(lat, lon, height));
        let earth = Ellipsoid::new(f64::from(frame.ellipsoid().a()), f64::from(frame.ellipsoid().f())).unwrap();
        let origin = geodetic(f64::from(lat), f64::from(lon), f64::from(height));
        let exact = LocalFrame::new(earth, origin);
        let truth = exact.enu_to_offset(long).unwrap();
        let place = exact.enu_to_geodetic(long).unwrap();
        if place.height() < -3e6 {
            continue;
        }
        let radius = earth.a() + place.height();
        let scale = [
            radius.to_radians(),
            (radius * place.lat().to_radians().cos()).to_radians(),
            1.0,
        ];

        let offset = frame.enu_to_offset(enu).unwrap();
        let errors = [
            f64::from(offset.lat) - truth.lat,
            turned(f64::from(offset.lon) - truth.lon),
            f64::from(offset.height) - truth.height,
        ];
        offsets.add(length(&[0, 1, 2].map(|at| errors[at] * scale[at])) / distance);

        let found = frame.enu_to_geodetic(enu).unwrap();
        let errors = [
            f64::from(found.lat()) - place.lat(),
            turned(f64::from(found.lon()) - place.lon()),
            f64::from(found.height()) - place.height(),
        ];
        let nearest = [place.lat(), place.lon(), place.height()].map(rounding);
        let over = [0, 1, 2].map(|at| testkit::maximum((errors[at].abs() - nearest[at]) * scale[at], 0.0));
        beyond.add(length(&over) / distance);
        if distance < 1e4 {
            near.add(length(&over));
        }

        let seen = components(frame.geodetic_to_enu(found));
        let position = geodetic(
            f64::from(found.lat()),
            f64::from(found.lon()),
            f64::from(found.height()),
        );
        let truth = components(exact.geodetic_to_enu(position));
        let apart = length(&[0, 1, 2].map(|at| seen[at] - truth[at]));
        if length(&truth) > 0.0 {
            there.add(apart / length(&truth));
        }
    }
    let [offsets, there, beyond, near] = [offsets, there, beyond, near].map(Worst::value);
    println!("offset {offsets:.2e}, there {there:.2e}, beyond the nearest {beyond:.2e}, within 10 km {near:.2e} m");
    assert!(offsets <= 1.7e-7 && there <= 1e-7 && beyond <= 7e-8 && near <= 2.5e-4);
}

/// By how much single precision rounds a number.
fn rounding(value: f64) -> f64 {
    (f64::from(value as f32) - value).abs()
}

#[test]
fn single_precision_is_as_accurate_as_claimed() {
    single_next_to_double(50_000, 6);
}

#[test]
#[ignore = "ten million: cargo test --release --test frames -- --ignored --nocapture ten_million"]
fn ten_million_ways_back() {
    single_next_to_double(10_000_000, 7);
}
