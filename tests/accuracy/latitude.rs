//! Auxiliary latitudes against the truth.

use terrella::latitude::Conversion;
use terrella::{Ellipsoid, Latitude, Real};

use crate::table::hold;
use crate::truth::{Scalar, Truth};

const ELLIPSOIDS: [&str; 3] = ["wgs84", "oblate10", "prolate150"];

fn ellipsoid<T: Real>(name: &str) -> Ellipsoid<T> {
    match name {
        "wgs84" => Ellipsoid::wgs84(),
        "oblate10" => Ellipsoid::new(T::of(6.4e6), T::of(0.1)).unwrap(),
        _ => Ellipsoid::new(T::of(6.4e6), T::of(-1.0 / 150.0)).unwrap(),
    }
}

/// The largest error over all files: of angles in radians, and of the isometric latitude relative to it (or to 1).
fn worst<T: Scalar>() -> [f64; 4] {
    let mut worst = [0.0_f64; 4];
    for name in ELLIPSOIDS {
        for &to in &Latitude::ALL[1..] {
            let conversion = Conversion::new(ellipsoid::<T>(name), Latitude::Geodetic, to).unwrap();
            for (file, radian) in [
                (format!("auxlat_{name}_deg"), 1f64.to_radians()),
                (format!("auxlat_{name}_rad"), 1.0),
            ] {
                let truth = Truth::read(&file);
                for row in truth.exact_in::<T>(&["phi"]) {
                    let phi: T = row.input("phi");
                    let value = if radian == 1.0 {
                        conversion.radians(phi)
                    } else {
                        conversion.degrees(phi)
                    }
                    .unwrap();
                    let which = if to == Latitude::Isometric { 1 } else { 0 };
                    let error = if which == 1 && row.value("isometric").is_infinite() {
                        if value.into() == row.value("isometric") {
                            0.0
                        } else {
                            1e9
                        }
                    } else if which == 1 {
                        row.error(to.name(), value) / row.value("isometric").abs().max(1.0)
                    } else {
                        row.error(to.name(), value) * radian
                    };
                    if error > worst[which] && std::env::var("SHOW").is_ok() {
                        println!("{} {file} {to} {phi} {error}", T::NAME);
                    }
                    worst[which] = worst[which].max(error);
                    let tiny = row.value(to.name()).abs() < 0.1 && row.value("phi").abs() > 1e-290;
                    if tiny {
                        if row.value("phi").abs() > 1e-290 && row.ulps(to.name(), value) > 3.0 {
                            println!(
                                "TINY {} {to} {} {:?} {}",
                                T::NAME,
                                row.text("phi"),
                                value,
                                row.text(to.name())
                            );
                        }
                        worst[2] = worst[2].max(row.ulps(to.name(), value));
                    }
                }
            }
        }
        let truth = Truth::read(&format!("auxlat_inverse_{name}_rad"));
        for row in truth.exact_in::<T>(&["value"]) {
            let from: Latitude = row.text("kind").parse().unwrap();
            let conversion = Conversion::new(ellipsoid::<T>(name), from, Latitude::Geodetic).unwrap();
            let e = row.error("phi", conversion.radians(row.input::<T>("value")).unwrap());
            if e > worst[3] && std::env::var("SHOW").is_ok() {
                println!("{} {name} inverse {from} {} {e}", T::NAME, row.text("value"));
            }
            worst[3] = worst[3].max(e);
        }
    }
    worst
}

#[test]
fn latitudes() {
    let (d, s) = (worst::<f64>(), worst::<f32>());
    for (i, what) in ["latitude", "isometric", "tiny ulps", "inverse"].iter().enumerate() {
        hold(what, d[i], s[i]);
    }
}
