//! Next to the equator, where differences of latitudes, and half way round azimuths, are below what numbers tell.

use terrella::Ellipsoid;
use terrella::geodesic::{Geodesic, Karney};
use testkit::minimum;

use crate::sample::place;

/// Opposite longitudes next to the equator, where what tells the azimuth is subnormal.
#[test]
fn it_answers_where_numbers_are_subnormal() {
    for f in [1.0 / 298.257_223_563, 1.0 / 170.0, 1e-3, 1e-6, 1e-9] {
        let single = Karney::new(Ellipsoid::new(6.4e6_f32, f as f32).unwrap()).unwrap();
        for (lat, lon) in [(1.561_251_1e-16, 8.178_91e-25), (1e-20, 8.178_91e-25), (1e-30, 1e-38)] {
            assert!(
                single.inverse(place(lat, lon), place(lat, 180.0)).is_ok(),
                "{f:e} {lat:e}"
            );
            let near = single.inverse(place(0.0, 0.0), place(lat, lon)).unwrap().distance;
            let north = f64::from(lat).to_radians() * 6.4e6;
            assert!(
                (f64::from(near) - north).abs() < 1e-12 + 0.04 * north,
                "{f:e} {lat:e}: {near:e}"
            );
        }
        let double = Karney::new(Ellipsoid::new(6.4e6, f).unwrap()).unwrap();
        for (lat, lon) in [(1e-160, 1e-160), (1e-200, 1e-150), (1e-300, 1e-300)] {
            assert!(
                double.inverse(place(lat, lon), place(lat, 180.0)).is_ok(),
                "{f:e} {lat:e}"
            );
        }
    }
}

/// A rest of the longitudes' difference that is far larger than latitudes next to the equator: their line was 6.7 km long, or NaN.
#[test]
fn places_next_to_the_equator_on_both_sides_of_the_180th_meridian() {
    for f in [1.0 / 298.257_223_563, -0.003_977_724_557_181_414, 1e-9] {
        let karney = Karney::new(Ellipsoid::<f64>::new(6.4e6, f).unwrap()).unwrap();
        for lat1 in [3e-14, 3e-30, 1.8e-39, 3.022_224_993_467_109_4e-57, 3e-99, 3e-200, 0.0] {
            for lat2 in [0.0, 2.37e-322, 1e-99, 1e-30, lat1] {
                let (from, to) = (place(lat1, 180.0), place(-lat2, -179.999_999_999_999_97));
                let [distance, exact] =
                    [karney.inverse(from, to).unwrap(), karney.solve(from, to).inverse].map(|way| way.distance);
                assert!(
                    distance < 8e-9 && (distance - exact).abs() < 1e-11,
                    "{f:e} {lat1:e} {lat2:e}: {distance:e}, {exact:e}"
                );
            }
        }
    }
}

/// Where the shortest line turns from the equator, next to it: the arc turns on digits of the azimuth that its sine does not have, and
/// the bracket was taken for narrow enough, 0.34 µm off.
#[test]
fn next_to_the_equator_where_the_line_leaves_it() {
    let karney = Karney::new(Ellipsoid::<f64>::WGS84).unwrap();
    let from = place(-3.802_189_603_447_914e-16, 133.986_035_638_785);
    let to = place(-2.604_281_682_330_787_3e-33, -46.617_474_095_695_265);
    for line in [karney.solve(from, to).inverse, karney.inverse(from, to).unwrap()] {
        assert!((line.distance - 19_970_325.946_458_112).abs() < 7e-9, "{line:?}");
    }
}

/// There, too: the bracket's steps did not reach azimuths that are so near to 90°, and it was 0.12 µm off, 18 µm for f = 1/20.
#[test]
fn nanometres_from_the_equator_count_as_nanometres() {
    for f in [1.0 / 298.257_223_563, 1.0 / 20.0, -1.0 / 20.0, 1e-3] {
        let karney = Karney::new(Ellipsoid::<f64>::new(6_378_137.0, f).unwrap()).unwrap();
        let leaves = 180.0 * (1.0 - f.abs());
        for lon in [-0.1, -1e-3, -7e-5, -1e-8, 1e-8, 3e-4, 0.1].map(|beyond| minimum(leaves + beyond, 180.0)) {
            let on = karney.solve(place(0.0, 0.0), place(0.0, lon)).inverse.distance;
            for exponent in (10..48).chain([100, 300]) {
                let lat = 7.0 * 10.0_f64.powi(-exponent);
                for (lat1, lat2) in [(lat, -lat * 1e-3), (-lat * 0.7, -lat), (lat * 1e-20, lat)] {
                    let beside = karney.solve(place(lat1, 0.0), place(lat2, lon)).inverse.distance;
                    assert!(
                        (beside - on).abs() < 1.2e-8 + 2.0 * 6.4e6 * lat.to_radians(),
                        "{f} {lon}: {lat1:e} {lat2:e}"
                    );
                }
            }
        }
    }
}

/// Where the shortest line leaves the equator, to the last digit of the longitude.
#[test]
fn the_equator_ends_where_it_does() {
    for f in [1.0 / 298.257_223_563, 1.0 / 170.0, 1.0 / 20.0, 0.1, 1e-3, 1e-6] {
        let karney = Karney::new(Ellipsoid::<f64>::new(6_378_137.0, f).unwrap()).unwrap();
        let leaves = 180.0 * (1.0 - f);
        for ulps in -20..=20 {
            let lon = leaves + f64::from(ulps) * leaves * 1.2e-16;
            let distance = karney.solve(place(0.0, 0.0), place(0.0, lon)).inverse.distance;
            let equator = 6_378_137.0 * lon.to_radians();
            assert!((distance - equator).abs() < 1.2e-8, "{f} {ulps}: {distance} {equator}");
        }
    }
}
