//! From `f32` to `f64` and back, and radians.

use core::f32::consts as single;
use core::f64::consts as double;

use terrella::cube::{Face, FacePoint};
use terrella::frame::GeodeticOffset;
use terrella::{Aer, Direction, Ecef, Enu, Geodetic, InvalidLatLon, LatLon, Ned};

#[test]
fn single_precision_comes_back() {
    let mut rng = fastrand::Rng::with_seed(62);
    for _ in 0..10_000 {
        let mut signed = |scale: f32| scale * (2.0 * rng.f32() - 1.0);
        let place = LatLon::new(signed(90.0), signed(180.0)).unwrap();
        assert_eq!(LatLon::<f64>::from(place).to_f32(), place);
        let position = Geodetic::new(place, signed(1e30)).unwrap();
        assert_eq!(Geodetic::<f64>::from(position).to_f32(), position);
        let ecef = Ecef::new(signed(7e6), signed(7e6), signed(7e6)).unwrap();
        assert_eq!(Ecef::<f64>::from(ecef).to_f32(), ecef);
        let enu = Enu {
            east: signed(1e3),
            north: signed(1e-30),
            up: signed(1e30),
        };
        assert_eq!(Enu::<f64>::from(enu).to_f32(), enu);
        assert_eq!(Ned::<f64>::from(Ned::<f32>::from(enu)).to_f32(), Ned::from(enu));
        assert_eq!(Aer::<f64>::from(Aer::<f32>::from(enu)).to_f32(), Aer::from(enu));
        let offset = GeodeticOffset {
            lat: signed(1.0),
            lon: signed(1.0),
            height: signed(1.0),
        };
        assert_eq!(GeodeticOffset::<f64>::from(offset).to_f32(), offset);
        let point = FacePoint::new(Face::Back, signed(1.0), signed(1.0)).unwrap();
        assert_eq!(FacePoint::<f64>::from(point).to_f32(), point);
    }
}

#[test]
fn rounding_stays_in_range() {
    let place = LatLon::new(90.0_f64.next_down(), -(180.0_f64.next_down()))
        .unwrap()
        .to_f32();
    assert_eq!(place, LatLon::new(90.0, -180.0).unwrap());
    assert_eq!(
        Ecef::new(1e300, -1e300, 1e-300).unwrap().to_f32().to_array(),
        [f32::MAX, f32::MIN, 0.0]
    );
    let high = Geodetic::new(LatLon::default(), 1e300).unwrap().to_f32();
    assert_eq!(high.height(), f32::MAX);
    assert_eq!(
        FacePoint::new(Face::Top, 1.0_f64.next_down(), -1.0)
            .unwrap()
            .to_f32()
            .x(),
        1.0
    );
}

/// A rounded direction is one that `new` keeps as it is, and a widened one is.
#[test]
fn directions_stay_unit_vectors() {
    let mut rng = fastrand::Rng::with_seed(63);
    for _ in 0..100_000 {
        let [x, y, z] = [(); 3].map(|()| 2.0 * rng.f64() - 1.0);
        let exact = Direction::new(x, y, z).unwrap();
        let rounded = exact.to_f32();
        let [x, y, z] = rounded.to_array();
        assert_eq!(Direction::new(x, y, z), Ok(rounded));
        let [p, q, r] = exact.to_array();
        let apart = [(p, x), (q, y), (r, z)].map(|(exact, rounded)| exact - f64::from(rounded));
        assert!(apart.iter().map(|part| part * part).sum::<f64>().sqrt() < 6e-8);

        let wide = Direction::<f64>::from(rounded);
        let [p, q, r] = wide.to_array();
        assert_eq!(Direction::new(p, q, r), Ok(wide));
        let [x, y, z] = [x, y, z].map(f64::from);
        let cross = [q * z - r * y, r * x - p * z, p * y - q * x];
        assert!(cross.iter().map(|part| part * part).sum::<f64>().sqrt() < 3e-16);
    }
}

#[test]
fn right_angles_in_radians() {
    let place = LatLon::from_radians(double::FRAC_PI_2, double::PI);
    assert_eq!(place, LatLon::new(90.0, 180.0));
    let place = LatLon::from_radians(-single::FRAC_PI_2, -single::PI);
    assert_eq!(place, LatLon::new(-90.0, -180.0));
    for (degrees, radians) in [
        (30.0, double::FRAC_PI_6),
        (45.0, double::FRAC_PI_4),
        (60.0, double::FRAC_PI_3),
    ] {
        let place = LatLon::new(degrees, degrees).unwrap();
        assert_eq!(place.to_radians(), (radians, radians));
    }
    for (degrees, radians) in [
        (30.0, single::FRAC_PI_6),
        (45.0, single::FRAC_PI_4),
        (90.0, single::FRAC_PI_2),
    ] {
        let place = LatLon::new(degrees, degrees).unwrap();
        assert_eq!(place.to_radians(), (radians, radians));
    }
    let beyond = single::FRAC_PI_2.next_up();
    assert!(matches!(LatLon::from_radians(beyond, 0.0), Err(InvalidLatLon::Latitude(lat)) if lat > 90.0));
    assert!(matches!(
        LatLon::from_radians(0.0, f64::MAX),
        Err(InvalidLatLon::Longitude(_))
    ));
    assert!(LatLon::from_radians(0.0, f64::NAN).is_err());
    // Zero keeps its sign, and the smallest numbers are numbers.
    assert!(LatLon::from_radians(-0.0, 0.0_f64).unwrap().lat().is_sign_negative());
    assert_eq!(LatLon::from_radians(5e-324, 0.0).unwrap().lat(), 57.0 * 5e-324);
}

/// In single precision every double is the truth.
#[test]
fn radians_of_single_precision() {
    let mut rng = fastrand::Rng::with_seed(64);
    let mut worst = testkit::Worst::default();
    for _ in 0..300_000 {
        let angle = single::PI * (2.0 * rng.f32() - 1.0) * 2_f32.powi(-rng.i32(0..20));
        let degrees = LatLon::from_radians(0.0, angle).unwrap().lon();
        worst.add(ulps(degrees, f64::from(angle) * (180.0 / double::PI)));
        let (_, radians) = LatLon::new(0.0, degrees).unwrap().to_radians();
        worst.add(ulps(radians, f64::from(degrees) * (double::PI / 180.0)));
    }
    assert!(worst.value() <= 0.51, "{}", worst.value());
}

fn ulps(rounded: f32, exact: f64) -> f64 {
    let near = exact.abs() as f32;
    (f64::from(rounded) - exact).abs() / f64::from(near.next_up() - near)
}
