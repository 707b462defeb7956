//! Auxiliary latitudes against the truth.

use terrella::latitude::{Conversion, Shifted};
use terrella::{Ellipsoid, LatLon, Latitude, Shift};
use testkit::{Worst, maximum};

use testkit::table::hold;
use testkit::truth::{Scalar, Truth};

const ELLIPSOIDS: [&str; 3] = ["wgs84", "oblate10", "prolate150"];

fn conversion<T: Scalar>(ellipsoid: &str, from: Latitude, to: Latitude) -> Conversion<T> {
    let ellipsoid = match ellipsoid {
        "wgs84" => Ellipsoid::WGS84,
        "oblate10" => Ellipsoid::new(T::of(6.4e6), T::of(0.1)).unwrap(),
        "prolate150" => Ellipsoid::new(T::of(6.4e6), T::of(-1.0 / 150.0)).unwrap(),
        other => panic!("no ellipsoid {other}"),
    };
    Conversion::new(ellipsoid, from, to).unwrap()
}

#[derive(Default)]
struct Errors {
    /// Of an angle from the geodetic latitude, in radians.
    angle: Worst,
    /// Of the isometric latitude, relative to it or to 1.
    isometric: Worst,
    /// Of any of them below 0.1 in its unit, in ulp.
    tiny: Worst,
    /// Of the geodetic latitude from any of them but the isometric, in radians.
    geodetic: Worst,
    /// Of the geodetic latitude from the isometric, in radians.
    of_isometric: Worst,
}

fn worst<T: Scalar>() -> Errors {
    let mut worst = Errors::default();
    for ellipsoid in ELLIPSOIDS {
        for (unit, radian) in [("deg", 1f64.to_radians()), ("rad", 1.0)] {
            let truth = Truth::read(&format!("auxlat_{ellipsoid}_{unit}"));
            for &to in &Latitude::ALL[1..] {
                let conversion = conversion::<T>(ellipsoid, Latitude::Geodetic, to);
                for row in truth.exact_in::<T>(&["phi"]) {
                    let phi = row.input("phi");
                    let value = if unit == "deg" {
                        conversion.degrees(phi)
                    } else {
                        conversion.radians(phi)
                    }
                    .unwrap();
                    let expected = row.value(to.name());
                    if expected.is_infinite() {
                        assert_eq!(value.into(), expected, "{ellipsoid} {to} {phi:?}");
                        continue;
                    }
                    let error = row.error(to.name(), value);
                    if to == Latitude::Isometric {
                        worst.isometric.add(error / maximum(expected.abs(), 1.0));
                    } else {
                        worst.angle.add(error * radian);
                    }
                    // Down to where products with the latitude become subnormal.
                    if (1e-290..0.1).contains(&expected.abs()) && expected.abs() > 1e20 * f64::from(f32::MIN_POSITIVE) {
                        worst.tiny.add(row.ulps(to.name(), value));
                    }
                }
            }
        }
        let truth = Truth::read(&format!("auxlat_inverse_{ellipsoid}_rad"));
        for row in truth.exact_in::<T>(&["value"]) {
            let from = row.text("kind").parse().unwrap();
            let conversion = conversion::<T>(ellipsoid, from, Latitude::Geodetic);
            let error = row.error("phi", conversion.radians(row.input("value")).unwrap());
            let worst = if from == Latitude::Isometric {
                &mut worst.of_isometric
            } else {
                &mut worst.geodetic
            };
            worst.add(error);
        }
    }
    worst
}

#[test]
fn latitudes_are_as_accurate_as_claimed() {
    let (double, single) = (worst::<f64>(), worst::<f32>());
    let hold = |what, of: fn(&Errors) -> Worst| hold(what, [of(&double).value(), of(&single).value()]);
    hold("latitude of a geodetic one", |errors| errors.angle);
    hold("geodetic latitude of another", |errors| errors.geodetic);
    hold("geodetic latitude of an isometric one", |errors| errors.of_isometric);
    hold("isometric latitude, relative to 1 or more", |errors| errors.isometric);
    hold("latitudes below 0.1, relative", |errors| errors.tiny);
}

#[test]
fn every_pair_closes() {
    for ellipsoid in ELLIPSOIDS {
        for &from in Latitude::ALL {
            for &to in Latitude::ALL {
                let (there, back) = (
                    conversion::<f64>(ellipsoid, from, to),
                    conversion::<f64>(ellipsoid, to, from),
                );
                for i in -30..=30_i32 {
                    let x = f64::from(i) * 0.05;
                    let y = back.radians(there.radians(x).unwrap()).unwrap();
                    assert!((y - x).abs() < 1e-15, "{ellipsoid} {from} {to} {x}: {y}");
                }
            }
        }
    }
}

/// The closed forms hold as far as they are offered.
#[test]
fn geocentric_and_parametric_at_the_extremes() {
    for f in [-1.0, 0.5] {
        let ellipsoid = Ellipsoid::new(1.0, f).unwrap();
        for (kind, ratio) in [
            (Latitude::Geocentric, (1.0 - f) * (1.0 - f)),
            (Latitude::Parametric, 1.0 - f),
        ] {
            let there = Conversion::new(ellipsoid, Latitude::Geodetic, kind).unwrap();
            let back = Conversion::new(ellipsoid, kind, Latitude::Geodetic).unwrap();
            for i in -89..=89_i32 {
                let phi = f64::from(i);
                let expected = (ratio * phi.to_radians().tan()).atan().to_degrees();
                let angle = there.degrees(phi).unwrap();
                assert!((angle - expected).abs() < 4e-14, "{kind} {f} {phi}: {angle} {expected}");
                assert!((back.degrees(angle).unwrap() - phi).abs() < 1e-13);
            }
        }
    }
}

/// Directions next to the flattenings where the series of small tangents end, 0.0198 and 0.0392, the largest that they serve.
fn turned<T: Scalar>(claim: f64) {
    for f in [0.0197, 0.0199, 0.039, 0.0394, -0.0201, -0.0406] {
        let ellipsoid = Ellipsoid::new(T::ONE, T::of(f)).unwrap();
        let f: f64 = ellipsoid.f().into();
        for (shift, ratio) in [(Shift::Geocentric, (1.0 - f) * (1.0 - f)), (Shift::Parametric, 1.0 - f)] {
            let shifted = Shifted::new(ellipsoid, shift).unwrap();
            for lat in (-89..90).map(|lat| T::of(f64::from(lat))) {
                let (sin, cos) = lat.into().to_radians().sin_cos();
                let direction = shifted.to_direction(LatLon::new(lat, T::ZERO).unwrap());
                let [x, _, z] = direction.to_array().map(Into::<f64>::into);
                let length = (ratio * sin).hypot(cos);
                let error = (x - cos / length).hypot(z - ratio * sin / length);
                let back = shifted.to_lat_lon(direction).lat().into() - lat.into();
                assert!(
                    error < claim && back.abs().to_radians() < 2.0 * claim,
                    "{} {shift} {f} {lat:?}: {error:e}, {back:e} degrees back",
                    T::NAME
                );
            }
        }
    }
}

#[test]
fn directions_of_the_largest_small_corrections() {
    turned::<f64>(4.5e-16);
    turned::<f32>(2.4e-7);
}
