//! `to_ecef` and `to_geodetic` against the truth: the largest error of every file, by height.

use testkit::{Worst, maximum, minimum};

use testkit::table;
use testkit::truth::{Row, Scalar, Truth};

use crate::{ecef, ellipsoid, geodetic, length};

const EARTH_AXES: [&str; 3] = ["X", "Y", "Z"];

/// Worst errors of the rows below 100 km, below 10 000 km and higher, in metres.
#[derive(Clone, Copy, Debug, Default)]
struct Bands([Worst; 3]);

impl Bands {
    fn add(&mut self, row: Row<'_>, error: f64) {
        let height = row.value("h");
        let band = usize::from(height >= 1e5) + usize::from(height >= 1e7);
        self.0[band].add(error);
    }

    fn values(self) -> [f64; 3] {
        self.0.map(Worst::value)
    }

    /// As many bands as there are claims.
    fn hold<const N: usize>(self, what: &str, claimed: [f64; N]) {
        let [low, middle, high] = self.values();
        println!("{what}: {low:.2e} {middle:.2e} {high:.2e}");
        for (measured, claimed) in [low, middle, high].into_iter().zip(claimed) {
            assert!(measured <= claimed, "{what}: {measured:e} m, claimed {claimed:e} m");
        }
    }
}

fn forward<T: Scalar, const N: usize>(name: &str, claimed: [f64; N], ulps: f64) -> [f64; 3] {
    let (mut worst, mut worst_ulps) = (Bands::default(), Worst::default());
    let truth = Truth::read(&format!("ecef_forward_{name}"));
    for row in truth.exact_in::<T>(&["lat", "lon", "h"]) {
        let position = geodetic::<T>(row.input("lat"), row.input("lon"), row.input("h"));
        let computed = ellipsoid(name).to_ecef(position).to_array();
        let errors = [0, 1, 2].map(|i| row.error(EARTH_AXES[i], computed[i]));
        worst.add(row, length(&errors));
        let radius = length(&EARTH_AXES.map(|column| row.value(column)));
        let ulp = radius.log2().floor().exp2() * T::EPSILON.into();
        worst_ulps.add(Worst::of(errors) / ulp);
    }
    let worst_ulps = worst_ulps.value();
    println!("{worst_ulps:.2} ulp of the radius");
    assert!(worst_ulps <= ulps, "{name}: {worst_ulps} ulp of the radius");
    worst.hold(&format!("forward {name} {}", T::NAME), claimed);
    worst.values()
}

/// The error of a height; one far smaller than its error is not compared digit by digit.
fn height_error<T: Scalar>(row: Row<'_>, height: T) -> f64 {
    let plain = (height.into() - row.value("h")).abs();
    minimum(
        row.error("h", height),
        if row.value("h").abs() < 1e-3 {
            plain
        } else {
            f64::INFINITY
        },
    )
}

/// `position`: the distance from the true latitude, longitude and height. `height`: that of the height alone.
/// `back`: from the point, after the way back.
fn reverse<T: Scalar>(name: &str, position: [f64; 3], height: [f64; 3], back: [f64; 3]) -> [f64; 3] {
    let mut worst = [Bands::default(); 3];
    let e = ellipsoid::<T>(name);
    let (a, e2): (f64, f64) = (e.a().into(), e.e2().into());
    let truth = Truth::read(&format!("ecef_reverse_{name}"));
    for row in truth.exact_in::<T>(&EARTH_AXES) {
        let [x, y, z] = EARTH_AXES.map(|column| row.input::<T>(column));
        let computed = e.to_geodetic(ecef(x, y, z));
        let lat = row.value("lat").to_radians();
        let w2 = 1.0 - e2 * lat.sin().powi(2);
        let across = a / w2.sqrt();
        let along = across * (1.0 - e2) / w2;
        let lon = row.error("lon", computed.lon());
        let errors = [
            row.error("lat", computed.lat()).to_radians() * (along + row.value("h")),
            minimum(lon, (lon - 360.0).abs()).to_radians() * (across + row.value("h")) * lat.cos(),
            height_error(row, computed.height()),
        ];
        let there = e.to_ecef(computed).to_array();
        worst[0].add(row, length(&errors));
        worst[1].add(row, errors[2]);
        worst[2].add(row, length(&[0, 1, 2].map(|i| row.error(EARTH_AXES[i], there[i]))));
    }
    let [worst_position, worst_height, worst_back] = worst;
    worst_position.hold(&format!("reverse {name} {}", T::NAME), position);
    worst_height.hold("  height", height);
    worst_back.hold("  there and back", back);
    worst_position.values()
}

/// Holds the rows of the table, near and far, with the Earth's errors in both scalars.
fn hold(what: &str, double: [f64; 3], single: [f64; 3]) {
    let far = |bands: [f64; 3]| maximum(bands[1], bands[2]);
    table::hold(&format!("{what} to 50 000 km"), [far(double), far(single)]);
}

#[test]
fn to_ecef_is_as_accurate_as_claimed() {
    let double = forward::<f64, _>("wgs84", [1.5e-9, 2.5e-9, 9e-9], 0.7);
    forward::<f64, _>("moon", [0.4e-9, 0.6e-9, 5e-9], 0.7);
    forward::<f64, _>("oblate10", [1.5e-9, 2e-9, 9e-9], 0.7);
    forward::<f64, _>("prolate150", [1.5e-9, 2e-9, 9e-9], 0.7);
    let single = forward::<f32, _>("wgs84", [0.5, 0.8, 3.0], 0.7);
    table::hold("Ellipsoid::to_ecef below 100 km", [double[0], single[0]]);
    hold("Ellipsoid::to_ecef", double, single);
    // No row so high on the Moon is exact in f32.
    forward::<f32, _>("moon", [0.5, 0.9], 0.7);
    for name in ["oblate10", "prolate150"] {
        forward::<f32, _>(name, [0.5, 0.9, 3.0], 0.7);
    }
}

#[test]
fn to_geodetic_is_as_accurate_as_claimed() {
    let double = reverse::<f64>(
        "wgs84",
        [2e-9, 2e-9, 8e-9],
        [1.1e-9, 1e-9, 4e-9],
        [2.5e-9, 3e-9, 1.3e-8],
    );
    reverse::<f64>("moon", [2e-9, 2e-9, 8e-9], [1.1e-9, 1e-9, 4e-9], [2.5e-9, 3e-9, 1.3e-8]);
    reverse::<f64>(
        "oblate10",
        [2e-9, 2e-9, 8e-9],
        [1.1e-9, 1e-9, 4e-9],
        [2.5e-9, 3e-9, 1.3e-8],
    );
    reverse::<f64>(
        "prolate150",
        [2e-9, 2e-9, 8e-9],
        [1.1e-9, 1e-9, 4e-9],
        [2.5e-9, 3e-9, 1.3e-8],
    );
    let single = reverse::<f32>("wgs84", [0.8, 0.8, 3.5], [0.2, 0.2, 2.0], [1.0, 1.0, 6.0]);
    table::hold(
        "Ellipsoid::to_geodetic below 100 km, down to the centre",
        [double[0], single[0]],
    );
    hold("Ellipsoid::to_geodetic", double, single);
}

/// Rows between the surface's −10 km and 100 km.
#[test]
fn heights_near_the_surface_keep_their_digits() {
    fn worst<T: Scalar>() -> f64 {
        let truth = Truth::read("ecef_reverse_wgs84");
        let rows = truth
            .exact_in::<T>(&EARTH_AXES)
            .into_iter()
            .filter(|row| row.value("h").abs() < 1e5);
        let errors = rows.map(|row| {
            let [x, y, z] = EARTH_AXES.map(|column| row.input::<T>(column));
            height_error(row, ellipsoid::<T>("wgs84").to_geodetic(ecef(x, y, z)).height())
        });
        Worst::of(errors)
    }
    let errors = [worst::<f64>(), worst::<f32>()];
    println!("{errors:?}");
    assert!(errors[0] <= 1e-11 && errors[1] <= 5e-3, "{errors:?}");
}
