//! `GeodeticSeries` against the exact conversion, on a dense grid.

use terrella::{Ellipsoid, GeodeticSeries};
use testkit::Worst;
use testkit::truth::Scalar;

use crate::{ecef, geodetic, length};

/// The largest displacement and error of height of each order, from −0.5 km to 100 km.
fn worst<T: Scalar>(ellipsoid: Ellipsoid<T>) -> [[f64; 2]; 3] {
    let exact = Ellipsoid::<f64>::new(ellipsoid.a().into(), ellipsoid.f().into()).unwrap();
    let series = GeodeticSeries::new(ellipsoid);
    let mut worst = [[Worst::default(); 2]; 3];
    for i in 0..=360 {
        for j in 0..=72 {
            for k in 0..=10 {
                let (lat, lon) = (
                    f64::from(i) * 0.5 - 90.0,
                    f64::from(j) * 5.0 - 180.0 + 0.01 * f64::from(k),
                );
                let height = -500.0 + 10_050.0 * f64::from(k);
                let place = geodetic(lat, if lon > 180.0 { 180.0 } else { lon }, height);
                let p = exact.to_ecef(place).to_array().map(T::of);
                let at = p.map(Into::into);
                let truth = exact.to_geodetic(ecef(at[0], at[1], at[2]));
                let p = ecef(p[0], p[1], p[2]);
                let found = [series.second_order(p), series.third_order(p), series.fourth_order(p)];
                for (worst, found) in worst.iter_mut().zip(found) {
                    let found = geodetic(found.lat().into(), found.lon().into(), found.height().into());
                    let there = exact.to_ecef(found).to_array();
                    worst[0].add(length(&[0, 1, 2].map(|i| there[i] - at[i])));
                    worst[1].add((found.height() - truth.height()).abs());
                }
            }
        }
    }
    worst.map(|order| order.map(Worst::value))
}

#[test]
fn the_series_are_as_accurate_as_claimed() {
    let hold = |found: [[f64; 2]; 3], claimed: [[f64; 2]; 3]| {
        println!("{found:?}");
        for (found, claimed) in found.as_flattened().iter().zip(claimed.as_flattened()) {
            assert!(found <= claimed, "{found:e} m, claimed {claimed:e} m");
        }
    };
    hold(
        worst::<f64>(Ellipsoid::WGS84),
        [[0.4, 6e-4], [2.5e-3, 3e-6], [1e-7, 1.5e-8]],
    );
    hold(worst::<f32>(Ellipsoid::WGS84), [[1.3, 0.7]; 3]);
    hold(
        worst::<f64>(Ellipsoid::MARS),
        [[1.2, 2.6e-3], [0.011, 2.2e-5], [1.1e-6, 2e-7]],
    );
}

/// Where the series do not hold, the exact conversion is taken.
#[test]
fn elsewhere_it_is_exact() {
    let flat = Ellipsoid::<f64>::new(1.0, 0.5).unwrap();
    for (ellipsoid, [x, y, z]) in [
        (Ellipsoid::WGS84, [0.0, 0.0, 0.0]),
        (Ellipsoid::WGS84, [1e3, 1e3, 1e3]),
        (Ellipsoid::WGS84, [1e-200, 0.0, 0.0]),
        (Ellipsoid::WGS84, [0.0, 0.0, 7e6]),
        (Ellipsoid::WGS84, [f64::MAX, 0.0, f64::MAX]),
        (flat, [0.5, 0.0, 0.5]),
    ] {
        let (series, point) = (GeodeticSeries::new(ellipsoid), ecef(x, y, z));
        let exact = ellipsoid.to_geodetic(point);
        for found in [
            series.second_order(point),
            series.third_order(point),
            series.fourth_order(point),
        ] {
            assert_eq!(found, exact, "{point:?}");
        }
    }
}

#[test]
fn axes_and_signs_are_kept() {
    let series = GeodeticSeries::new(Ellipsoid::<f64>::WGS84);
    for convert in [
        GeodeticSeries::second_order,
        GeodeticSeries::third_order,
        GeodeticSeries::fourth_order,
    ] {
        let at = |x, y, z| {
            let place = convert(&series, ecef(x, y, z));
            (place.lat(), place.lon())
        };
        assert_eq!(at(7e6, 0.0, 0.0), (0.0, 0.0));
        assert_eq!(at(0.0, -7e6, 0.0), (0.0, -90.0));
        assert_eq!(at(-7e6, -0.0, 0.0), (0.0, -180.0));
        assert_eq!(at(0.0, 0.0, -7e6), (-90.0, 0.0));
        let (north, south) = (at(3e6, 2e6, 5e6), at(3e6, -2e6, -5e6));
        assert_eq!(north, (-south.0, -south.1));
    }
}
