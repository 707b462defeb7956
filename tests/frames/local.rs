//! East, north, up; north, east, down; azimuth, elevation, range.

use terrella::{Aer, Ellipsoid, Enu, LocalFrame, Ned};
use testkit::{Worst, minimum};

use crate::{distance, geodetic, length};
use testkit::table::hold;
use testkit::truth::{Row, Scalar, Truth, ulps_between};

const POSITIONS: [&str; 6] = ["lat1", "lon1", "h1", "lat2", "lon2", "h2"];

fn components<T: Scalar>(enu: Enu<T>) -> [f64; 3] {
    [enu.east, enu.north, enu.up].map(Into::into)
}

fn error<T: Scalar>(row: Row<'_>, enu: Enu<T>) -> f64 {
    length(&[
        row.error("east", enu.east),
        row.error("north", enu.north),
        row.error("up", enu.up),
    ])
}

/// The largest error of `geodetic_to_enu`, relative to the distance and in metres within 10 km; of `to_enu` in metres.
fn worst<T: Scalar>() -> [f64; 3] {
    let truth = Truth::read("enu_wgs84");
    let mut worst = [Worst::default(); 3];
    for row in truth.exact_in::<T>(&POSITIONS) {
        let [lat1, lon1, h1, lat2, lon2, h2] = POSITIONS.map(|column| row.input::<T>(column));
        let frame = LocalFrame::new(Ellipsoid::WGS84, geodetic(lat1, lon1, h1));
        let target = geodetic(lat2, lon2, h2);
        let direct = error(row, frame.geodetic_to_enu(target));
        let range = row.value("range");
        if range > 0.0 {
            worst[0].add(direct / range);
        } else {
            assert_eq!(direct, 0.0);
        }
        if range < 1e4 {
            worst[1].add(direct);
        }
        let through_earth_axes = error(row, frame.to_enu(Ellipsoid::WGS84.to_ecef(target)));
        worst[2].add(through_earth_axes);
    }
    println!("{} {worst:?}", T::NAME);
    worst.map(Worst::value)
}

#[test]
fn frames_are_as_accurate_as_claimed() {
    let (double, single) = (worst::<f64>(), worst::<f32>());
    hold(
        "LocalFrame::geodetic_to_enu, relative to the distance",
        [double[0], single[0]],
    );
    for (measured, claimed) in double.into_iter().zip([6e-16, 5e-12, 7e-9]) {
        assert!(measured <= claimed, "f64: {measured:e} {claimed:e}");
    }
    for (measured, claimed) in single.into_iter().zip([1e-7, 8e-4, 2.0]) {
        assert!(measured <= claimed, "f32: {measured:e} {claimed:e}");
    }
}

/// The largest error of an azimuth and elevation, as an angle on the sky in degrees, and of a range, in ulp.
fn pointing<T: Scalar>() -> [f64; 2] {
    let truth = Truth::read("enu_wgs84");
    let mut worst = [Worst::default(); 2];
    for row in truth.exact_in::<T>(&POSITIONS) {
        let [lat1, lon1, h1, lat2, lon2, h2] = POSITIONS.map(|column| row.input::<T>(column));
        let frame = LocalFrame::new(Ellipsoid::WGS84, geodetic(lat1, lon1, h1));
        let aer = frame.geodetic_to_aer(geodetic(lat2, lon2, h2));
        let turn = row.error("azimuth", aer.azimuth);
        let turn = minimum(turn, (turn - 360.0).abs()) * row.value("elevation").to_radians().cos();
        worst[0].add(length(&[turn, row.error("elevation", aer.elevation)]));
        worst[1].add(row.ulps("range", aer.range));
    }
    println!("{} {worst:?}", T::NAME);
    worst.map(Worst::value)
}

#[test]
fn pointing_is_as_accurate_as_claimed() {
    let [angle, range] = pointing::<f64>();
    assert!(angle <= 3e-14 && range <= 3.0, "{angle:e} {range}");
    let [angle, range] = pointing::<f32>();
    assert!(angle <= 1.4e-5 && range <= 3.0, "{angle:e} {range}");
}

fn random_frame<T: Scalar>(random: &mut fastrand::Rng) -> LocalFrame<T> {
    let mut part = |size: f64| T::of(size * (2.0 * random.f64() - 1.0));
    LocalFrame::new(Ellipsoid::WGS84, geodetic(part(90.0), part(180.0), part(1e4)))
}

fn orthonormal<T: Scalar>() {
    let mut random = fastrand::Rng::with_seed(3);
    let tolerance = 4.0 * T::EPSILON.into();
    for _ in 0..1000 {
        let frame = random_frame::<T>(&mut random);
        let axes = [frame.east(), frame.north(), frame.up()].map(|d| d.to_array().map(Into::<f64>::into));
        for i in 0..3 {
            for j in 0..3 {
                let product: f64 = (0..3).map(|k| axes[i][k] * axes[j][k]).sum();
                assert!((product - f64::from(i == j)).abs() <= tolerance, "{axes:?}");
            }
        }
        // East × north = up.
        let [e, n, u] = axes;
        let cross = [
            e[1] * n[2] - e[2] * n[1],
            e[2] * n[0] - e[0] * n[2],
            e[0] * n[1] - e[1] * n[0],
        ];
        assert!((0..3).all(|k| (cross[k] - u[k]).abs() <= tolerance));
        // The axes themselves, turned.
        let east = components(frame.vector_to_enu(frame.east().to_array()));
        assert!(length(&[east[0] - 1.0, east[1], east[2]]) <= tolerance);
        let up = frame.vector_from_enu(Enu {
            east: T::ZERO,
            north: T::ZERO,
            up: T::ONE,
        });
        assert_eq!(up.map(Into::<f64>::into), axes[2]);
    }
}

#[test]
fn axes_are_orthonormal_and_right_handed() {
    orthonormal::<f64>();
    orthonormal::<f32>();
}

fn there_and_back<T: Scalar>() {
    let mut random = fastrand::Rng::with_seed(5);
    let eps: f64 = T::EPSILON.into();
    for _ in 0..10_000 {
        let frame = random_frame::<T>(&mut random);
        let size = 10_f64.powf(random.f64() * 8.0);
        let mut part = || T::of(size * (2.0 * random.f64() - 1.0));
        let enu = Enu {
            east: part(),
            north: part(),
            up: part(),
        };
        let range = length(&components(enu));
        let same = |other: Enu<T>, tolerance: f64| {
            let (one, two) = (components(enu), components(other));
            let error = length(&[0, 1, 2].map(|i| one[i] - two[i]));
            assert!(error <= tolerance, "{enu:?} {other:?}: {error:e} > {tolerance:e}");
        };
        assert_eq!(Enu::from(Ned::from(enu)), enu);
        same(Enu::from(Aer::from(enu)), 8.0 * eps * range);
        let [x, y, z] = frame.vector_from_enu(enu);
        same(frame.vector_to_enu([x, y, z]), 6.0 * eps * range);
        let point = frame.from_enu(enu).unwrap();
        same(frame.to_enu(point), 2.0 * eps * (range + 6.4e6));
        assert_eq!(frame.from_ned(enu.into()).unwrap(), point);
        assert_eq!(frame.to_ned(point), frame.to_enu(point).into());
        assert!(distance(frame.from_aer(enu.into()).unwrap(), point) <= 8.0 * eps * (range + 6.4e6));
        assert_eq!(frame.to_aer(point), frame.to_enu(point).into());
    }
}

#[test]
fn positions_and_vectors_come_back() {
    there_and_back::<f64>();
    there_and_back::<f32>();
}

/// `Aer` of an `Enu` and `vector_to_enu` in `f32`, against `f64`.
#[test]
fn single_precision_is_within_the_claimed_places() {
    let mut random = fastrand::Rng::with_seed(9);
    let mut worst = [Worst::default(); 4];
    for _ in 0..100_000 {
        let mut part = || (10_f64.powf(random.f64() * 6.0) * (2.0 * random.f64() - 1.0)) as f32;
        let (east, north, up) = (part(), part(), part());
        let single = Aer::from(Enu { east, north, up });
        let double = Aer::from(Enu {
            east: f64::from(east),
            north: f64::from(north),
            up: f64::from(up),
        });
        let pairs = [
            (single.azimuth, double.azimuth),
            (single.elevation, double.elevation),
            (single.range, double.range),
        ];
        for (worst, (single, double)) in worst.iter_mut().zip(pairs) {
            worst.add(ulps_between(single, double));
        }
        let (lat, lon) = (180.0 * random.f32() - 90.0, 360.0 * random.f32() - 180.0);
        let single = LocalFrame::new(Ellipsoid::WGS84, geodetic(lat, lon, 0.0)).vector_to_enu([east, north, up]);
        let frame = LocalFrame::new(Ellipsoid::WGS84, geodetic(f64::from(lat), f64::from(lon), 0.0));
        let double = frame.vector_to_enu([east, north, up].map(f64::from));
        let (one, two) = (components(single), components(double));
        worst[3].add(length(&[0, 1, 2].map(|i| one[i] - two[i])) / length(&two));
    }
    let worst = worst.map(Worst::value);
    println!("{worst:?}");
    assert!(
        worst[0] <= 1.0 && worst[1] <= 2.0 && worst[2] <= 1.5 && worst[3] <= 2.5e-7,
        "{worst:?}"
    );
}

#[test]
fn origin_zenith_and_compass_points() {
    let aer = |east, north, up| Aer::<f64>::from(Enu { east, north, up });
    let is = |azimuth, elevation, range| Aer {
        azimuth,
        elevation,
        range,
    };
    for zero in [0.0, -0.0] {
        assert_eq!(aer(zero, -0.0, zero), is(0.0, 0.0, 0.0));
        assert_eq!(aer(zero, -0.0, 5.0), is(0.0, 90.0, 5.0));
        assert_eq!(aer(-0.0, zero, -5.0), is(0.0, -90.0, 5.0));
        assert_eq!(aer(zero, -2.0, zero), is(180.0, 0.0, 2.0));
    }
    assert_eq!(aer(2.0, 0.0, 0.0), is(90.0, 0.0, 2.0));
    assert_eq!(aer(-1.0, 1.0, 0.0).azimuth, -45.0);
    assert_eq!(aer(3e300, 4e300, 0.0).range, 5e300);
    assert!((aer(3e-300, 4e-300, 0.0).range / 5e-300 - 1.0).abs() < 3e-16);
    assert_eq!(aer(5e-324, -5e-324, 0.0).azimuth, 135.0);
    assert_eq!(Enu::from(is(-90.0, 30.0, 2.0)).up, 1.0);
}

#[test]
fn what_is_not_finite_is_refused() {
    let frame = LocalFrame::new(Ellipsoid::<f64>::WGS84, geodetic(10.0, 20.0, 30.0));
    assert!(
        frame
            .from_enu(Enu {
                east: f64::NAN,
                north: 0.0,
                up: 0.0
            })
            .is_err()
    );
    assert!(
        frame
            .from_ned(Ned {
                north: 0.0,
                east: 0.0,
                down: f64::INFINITY
            })
            .is_err()
    );
    assert!(
        frame
            .from_aer(Aer {
                azimuth: 1e300,
                elevation: 0.0,
                range: 1.0
            })
            .is_err()
    );
    assert_eq!(frame.from_enu(Enu::default()), Ok(frame.origin_ecef()));
    assert_eq!(frame.to_enu(frame.origin_ecef()), Enu::default());
    assert_eq!(frame.geodetic_to_enu(frame.origin()), Enu::default());
}

/// Far and near: the range and the elevation of vectors whose squares leave the scalar, in `f32` from 10¹⁸ m on.
#[test]
fn ranges_at_the_ends_of_the_scalar() {
    fn check<T: Scalar>(sizes: &[f64]) {
        for &size in sizes {
            let of = |v: f64| T::of(v * size);
            let seen = Aer::from(Enu {
                east: T::ZERO,
                north: of(3.0),
                up: of(4.0),
            });
            let expected = 5.0 * of(1.0).into();
            assert!(
                (seen.range.into() / expected - 1.0).abs() <= 2.0 * T::EPSILON.into(),
                "{size:e}: {seen:?}"
            );
            // Nearly straight down: the small component has its digits too.
            let seen = Aer::from(Enu {
                east: T::ZERO,
                north: of(3e-5),
                up: of(-1.0),
            });
            let elevation = 3e-5f64.atan().to_degrees() - 90.0;
            assert!(
                (seen.elevation.into() - elevation).abs() <= 90.0 * T::EPSILON.into(),
                "{size:e}: {seen:?}"
            );
        }
    }
    check::<f32>(&[1e-30, 1e-20, 1.1e-18, 1e-12, 1.0, 1e17, 2.3e18, 1e30, 6e37]);
    check::<f64>(&[1e-290, 1e-160, 3.1e-151, 1e-136, 1.0, 1e150, 1e200, 1e307]);
}
