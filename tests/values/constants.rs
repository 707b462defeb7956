//! Places as constants.

use terrella::{Ecef, LatLon};

const OSLO: LatLon = match LatLon::const_new(59.91, 10.75 - 360.0) {
    Ok(place) => place,
    Err(_) => panic!("out of range"),
};
const SINGLE: LatLon<f32> = OSLO.to_f32();
const LATITUDE: f32 = SINGLE.lat();

#[test]
fn a_constant_is_what_new_makes() {
    assert_eq!(LATITUDE, 59.91);
    assert_eq!(LatLon::new(59.91, 10.75 - 360.0), Ok(OSLO));
    let mut rng = fastrand::Rng::with_seed(65);
    let limits = [
        0.0,
        -0.0,
        90.0,
        180.0,
        360.0,
        540.0,
        f64::MAX,
        f64::INFINITY,
        f64::NAN,
        5e-324,
    ];
    for i in 0..100_000_usize {
        let drawn = |rng: &mut fastrand::Rng| match rng.usize(0..20) {
            limit @ 0..10 => limits[limit],
            limit @ 10..14 => -limits[limit - 10],
            _ => 10_f64.powf(rng.f64() * 4.0) * (2.0 * rng.f64() - 1.0),
        };
        let (lat, lon) = (drawn(&mut rng), drawn(&mut rng));
        let (constant, usual) = (LatLon::const_new(lat, lon), LatLon::new(lat, lon));
        let bits = |place: LatLon| [place.lat().to_bits(), place.lon().to_bits()];
        match (constant, usual) {
            (Ok(constant), Ok(usual)) => assert_eq!(bits(constant), bits(usual), "{i}: {lat} {lon}"),
            (Err(constant), Err(usual)) => assert_eq!(constant.to_string(), usual.to_string()),
            _ => panic!("{lat} {lon}"),
        }
    }
    assert_eq!(Ecef::<f64>::default().to_f32(), Ecef::default());
}
