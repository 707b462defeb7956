//! A `LatLon` in degrees, minutes and seconds.

use terrella::{Dms, LatLon};

fn written(lat: f64, lon: f64, digits: u8) -> String {
    LatLon::new(lat, lon).unwrap().to_dms(digits).to_string()
}

#[test]
fn rounding_carries() {
    assert_eq!(written(59.999_999, 179.999_999_9, 0), "60°00′00″N 180°00′00″E");
    assert_eq!(written(59.999_999, -0.999_9, 1), "60°00′00.0″N 0°59′59.6″W");
    assert_eq!(written(-89.999_999_99, 29.983_333, 2), "90°00′00.00″S 29°59′00.00″E");
    assert_eq!(
        written(90.0, -180.0, 12),
        "90°00′00.000000000000″N 180°00′00.000000000000″W"
    );
}

#[test]
fn the_sign_of_zero_stays() {
    assert_eq!(written(-0.0, 0.0, 0), "0°00′00″S 0°00′00″E");
    assert_eq!(written(-1e-300, -f64::MIN_POSITIVE, 3), "0°00′00.000″S 0°00′00.000″W");
}

/// `GeographicLib` rounds 5.03125° and 5.09375°, which are 01′52.5″ and 05′37.5″, so.
#[test]
fn ties_go_to_even() {
    assert_eq!(written(5.031_25, 5.093_75, 0), "5°01′52″N 5°05′38″E");
    assert_eq!(written(5.031_25, -5.093_75, 1), "5°01′52.5″N 5°05′37.5″W");
}

#[test]
fn digits_beyond_the_most_are_so_many() {
    let place = LatLon::new(1.0 / 3.0, 0.0).unwrap();
    assert_eq!(place.to_dms(255), place.to_dms(Dms::MAX_DIGITS));
    assert_eq!(place.to_dms(255).lat.digits(), Dms::MAX_DIGITS);
}

/// Core's formatting of the exact value of x·3600 is the truth, where the product is exact: of multiples of 2⁻⁴⁰.
#[test]
fn decimals_are_those_of_the_exact_number() {
    let mut rng = fastrand::Rng::with_seed(61);
    for _ in 0..20_000 {
        let lat = rng.i64(-(90 << 30)..=90 << 30) as f64 / f64::from(1 << 30);
        let dms = LatLon::new(lat, 0.0).unwrap().to_dms(9).lat;
        let seconds = u64::from(dms.degrees()) * 3600 + u64::from(dms.minutes()) * 60 + u64::from(dms.seconds());
        let ours = format!("{seconds}.{:09}", dms.fraction());
        assert_eq!(ours, format!("{:.9}", (lat * 3600.0).abs()), "{lat}");
        assert_eq!(dms.is_negative(), lat < 0.0);
        let single = lat as f32;
        let dms = LatLon::new(single, 0.0).unwrap().to_dms(6).lat;
        let seconds = u64::from(dms.degrees()) * 3600 + u64::from(dms.minutes()) * 60 + u64::from(dms.seconds());
        let ours = format!("{seconds}.{:06}", dms.fraction());
        assert_eq!(ours, format!("{:.6}", (f64::from(single) * 3600.0).abs()), "{single}");
    }
}
