//! The geocentre, the axis, the plane of the equator, zeros of both signs, the smallest and the largest numbers.

use terrella::frame::{Aer, Enu};
use terrella::{Ecef, Ellipsoid, Geodetic, InvalidEcef, InvalidHeight, LatLon};
use testkit::maximum;

use crate::{ELLIPSOIDS, distance, ecef, ellipsoid, geodetic};
use testkit::truth::Scalar;

fn of<T: Scalar>(name: &str, x: f64, y: f64, z: f64) -> [f64; 3] {
    let p = ellipsoid::<T>(name).to_geodetic(ecef(T::of(x), T::of(y), T::of(z)));
    [p.lat().into(), p.lon().into(), p.height().into()]
}

fn near<T: Scalar>(computed: [f64; 3], [lat, lon, height]: [f64; 3]) {
    let eps = T::EPSILON.into();
    let good = (computed[0] - lat).abs() <= 90.0 * eps && (computed[1] - lon).abs() <= 180.0 * eps;
    assert!(
        good && (computed[2] - height).abs() <= eps * maximum(height.abs(), 6.4e6),
        "{computed:?} {lat} {lon} {height}"
    );
}

fn ties<T: Scalar>() {
    for name in ELLIPSOIDS {
        let e = ellipsoid::<T>(name);
        let (a, b): (f64, f64) = (e.a().into(), e.b().into());
        let centre = if name == "prolate150" {
            [0.0, 0.0, -a]
        } else {
            [90.0, 0.0, -b]
        };
        near::<T>(of::<T>(name, 0.0, 0.0, 0.0), centre);
        near::<T>(of::<T>(name, 0.0, 0.0, -0.0), centre);
        // The axis outside of the evolute.
        for z in [1e6, 6.3e6, 6.5e6, 5e7] {
            near::<T>(of::<T>(name, 0.0, 0.0, z), [90.0, 0.0, z - b]);
            near::<T>(of::<T>(name, 0.0, 0.0, -z), [-90.0, 0.0, z - b]);
        }
        // The plane of the equator outside of the evolute.
        for x in [2e6, 6.3e6, 6.5e6, 5e7] {
            near::<T>(of::<T>(name, x, 0.0, 0.0), [0.0, 0.0, x - a]);
            near::<T>(of::<T>(name, -x, 0.0, 0.0), [0.0, 180.0, x - a]);
            near::<T>(of::<T>(name, -x, -0.0, -0.0), [0.0, -180.0, x - a]);
            near::<T>(of::<T>(name, 0.0, -x, 0.0), [0.0, -90.0, x - a]);
        }
    }
    // Inside of the evolute: the northern foot, longitude 0.
    let foot = of::<T>("wgs84", 10_000.0, 0.0, 0.0);
    assert!(foot[0] > 76.0 && foot[0] < 77.0 && foot[1] == 0.0, "{foot:?}");
    assert_eq!(foot, of::<T>("wgs84", 10_000.0, 0.0, -0.0));
    let foot = of::<T>("prolate150", 0.0, 0.0, -10_000.0);
    assert!(foot[0] < -6.5 && foot[0] > -6.9 && foot[1] == 0.0, "{foot:?}");
}

#[test]
fn ties_go_where_the_documentation_says() {
    ties::<f64>();
    ties::<f32>();
}

/// Beside the axis and beside the equator, as near as numbers go and as far.
fn far_and_near<T: Scalar>(smallest: f64, largest: i32) {
    for name in ELLIPSOIDS {
        let e = ellipsoid::<T>(name);
        let (a, b): (f64, f64) = (e.a().into(), e.b().into());
        for power in 7..=largest {
            let far = 2.933_044 * 10_f64.powi(power);
            for tiny in [0.0, smallest, 6.592_815e-37, 1e-20, 1e-9] {
                near::<T>(of::<T>(name, tiny, 0.0, far), [90.0, 0.0, far - b]);
                near::<T>(
                    of::<T>(name, 0.0, -tiny, -far),
                    [-90.0, if tiny == 0.0 { 0.0 } else { -90.0 }, far - b],
                );
                near::<T>(of::<T>(name, far, tiny, tiny), [0.0, 0.0, far - a]);
            }
        }
    }
}

#[test]
fn the_axis_and_the_equator_at_every_distance() {
    far_and_near::<f64>(5e-324, 307);
    far_and_near::<f32>(1e-45, 37);
}

#[test]
fn a_sphere_keeps_directions() {
    let moon = Ellipsoid::<f64>::MOON;
    for scale in [1e-310, 1e-200, 1e-20, 1.0, 1e6, 1e20, 1e200] {
        let p = moon.to_geodetic(ecef(3.0 * scale, 4.0 * scale, 5.0 * scale));
        assert!(
            (p.lat() - 45.0).abs() < 1e-12 && (p.lon() - 53.130_102_354_155_98).abs() < 1e-12,
            "{scale:e} {p:?}"
        );
    }
}

/// All combinations of extreme coordinates give a latitude, a longitude and a finite height.
fn every_point<T: Scalar>(largest: f64, smallest: f64) {
    let values = [
        0.0,
        -0.0,
        smallest,
        -smallest,
        1e-30,
        1e-12,
        1.0,
        -42_697.0,
        6.4e6,
        1e12,
        -1e25,
        largest / 2.0,
        largest,
        -largest,
    ];
    let shapes = [
        (6.4e6, 0.003),
        (6.4e6, 0.0),
        (6.4e6, -0.01),
        (1.0, 0.1),
        (1.0, 0.9),
        (1.0, -5.0),
        (1e-15, 0.003),
        (1e15, 0.003),
        (1e-15, 1e-7),
    ];
    for (a, f) in shapes {
        let e = Ellipsoid::<T>::new(T::of(a), T::of(f)).unwrap();
        for x in values {
            for y in values {
                for z in values {
                    let p = e.to_geodetic(ecef(T::of(x), T::of(y), T::of(z)));
                    let checked =
                        LatLon::new(p.lat(), p.lon()).is_ok() && Geodetic::new(p.lat_lon(), p.height()).is_ok();
                    assert!(checked, "a = {a:e}, f = {f}: ({x:e}, {y:e}, {z:e}): {p:?}");
                    let back = e.to_ecef(p).to_array();
                    assert!(back.iter().all(|v| v.is_finite()), "{p:?}");
                }
            }
        }
    }
}

#[test]
fn every_finite_point_has_a_place() {
    every_point::<f64>(f64::MAX, 5e-324);
    every_point::<f32>(f32::MAX.into(), 1e-45);
}

/// Large and small planets are scaled copies.
#[test]
fn scale_does_not_matter() {
    for factor in [2_f64.powi(-70), 2_f64.powi(-40), 2_f64.powi(20), 2_f64.powi(27)] {
        let (e, scaled) = (
            Ellipsoid::new(6.4e6, 0.003).unwrap(),
            Ellipsoid::new(6.4e6 * factor, 0.003).unwrap(),
        );
        for (x, y, z) in [
            (6e6, 1e6, 2e6),
            (2e7, -1e6, 3e7),
            (1e4, 2e4, 1e3),
            (3.0, 4.0, -5.0),
            (1e6, 1e5, 4e5),
        ] {
            let one = e.to_geodetic(ecef(x, y, z));
            let two = scaled.to_geodetic(ecef(x * factor, y * factor, z * factor));
            assert!((one.lat() - two.lat()).abs() < 1e-12 && (one.lon() - two.lon()).abs() < 1e-13);
            assert!((one.height() - two.height() / factor).abs() < 1e-8);
        }
    }
}

#[test]
fn poles_have_any_longitude_and_one_point() {
    let e = Ellipsoid::<f64>::WGS84;
    for lon in [-180.0, -90.0, -0.0, 0.0, 33.3, 90.0, 180.0] {
        for lat in [-90.0, 90.0] {
            let p = e.to_ecef(geodetic(lat, lon, 12.5));
            assert_eq!([p.x().abs(), p.y().abs(), p.z().abs()], [0.0, 0.0, e.b() + 12.5]);
        }
    }
    // ±180 are one meridian.
    let [east, west] = [180.0, -180.0].map(|lon| e.to_ecef(geodetic(45.0, lon, 0.0)));
    assert_eq!(distance(east, west), 0.0);
}

#[test]
fn the_next_numbers_to_the_axis_and_the_equator_keep_their_angles() {
    let e = Ellipsoid::<f64>::WGS84;
    for tiny in [5e-324, 1e-300, 1e-100, 1e-9] {
        let p = e.to_geodetic(ecef(6.4e6, 0.0, tiny));
        let expected = (tiny / 6.4e6 / (1.0 - e.e2() * e.a() / 6.4e6)).to_degrees();
        assert!(
            (p.lat() - expected).abs() <= 1e-14 * expected + 5e-324,
            "{tiny:e} {p:?}"
        );
        let p = e.to_geodetic(ecef(-tiny, -tiny, 6.4e6));
        assert!(90.0 - p.lat() < 2e-14 && p.lon() == -135.0, "{tiny:e} {p:?}");
        let p = e.to_ecef(geodetic(tiny, tiny, 0.0));
        assert!(p.x() == e.a() && (p.y() - e.a() * tiny.to_radians()).abs() <= 1e-15 * p.y() + 5e-324);
    }
}

#[test]
fn refusals_carry_the_value() {
    let place = LatLon::new(1.0, 2.0).unwrap();
    assert_eq!(
        Geodetic::new(place, f64::INFINITY),
        Err(InvalidHeight { height: f64::INFINITY })
    );
    assert_eq!(
        Geodetic::new(place, f64::NAN).unwrap_err().to_string(),
        "height NaN is not finite"
    );
    let refused = Ecef::new(0.0, f64::NEG_INFINITY, 1.0).unwrap_err();
    assert_eq!(
        refused,
        InvalidEcef {
            x: 0.0,
            y: f64::NEG_INFINITY,
            z: 1.0
        }
    );
    assert_eq!(refused.to_string(), "(0.0, -inf, 1.0) is not a finite point");
}

fn no_number<T: Scalar>() {
    let nan = T::of(f64::NAN);
    for others in [T::ZERO, T::ONE] {
        for i in 0..3 {
            let mut given = [others; 3];
            given[i] = nan;
            let [east, north, up] = given;
            let aer = Aer::from(Enu { east, north, up });
            assert!(
                aer.range.into().is_nan() && aer.elevation.into().is_nan(),
                "{given:?}: {aer:?}"
            );
            assert!(i == 2 || aer.azimuth.into().is_nan(), "{given:?}: {aer:?}");
        }
    }
}

/// The azimuth of (NaN, 0) was 0.
#[test]
fn what_is_no_number_has_no_angles() {
    no_number::<f32>();
    no_number::<f64>();
}
