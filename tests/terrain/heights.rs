//! The error of heights along the sphere's normal, against the normals themselves.

use fastrand::Rng;
use terrella::terrain::lean;
use terrella::{Direction, Ellipsoid, Geodetic, LatLon, LocalFrame, Shift, Shifted};
use testkit::Worst;

/// From the point at the height along the ellipsoid's normal to the one along the sphere's, in the frame of the place.
fn truth(shifted: &Shifted<f64>, place: LatLon<f64>, height: f64) -> [f64; 3] {
    let up = place.to_direction().to_array();
    let sphere = shifted.to_direction(place).to_array();
    let apart = std::array::from_fn(|k| height * (sphere[k] - up[k]));
    let frame = LocalFrame::new(shifted.ellipsoid(), Geodetic::new(place, 0.0).unwrap());
    let enu = frame.vector_to_enu(apart);
    [enu.east, enu.north, enu.up]
}

#[test]
fn leaning_is_the_difference_of_the_normals() {
    let mut rng = Rng::with_seed(1);
    for ellipsoid in [
        Ellipsoid::WGS84,
        Ellipsoid::MOON,
        Ellipsoid::MARS,
        Ellipsoid::new(6.4e6, 0.1).unwrap(),
        Ellipsoid::new(6.4e6, -1.0 / 9.0).unwrap(),
    ] {
        for &shift in Shift::ALL {
            let Ok(shifted) = Shifted::new(ellipsoid, shift) else {
                continue;
            };
            let single = Ellipsoid::new(ellipsoid.a() as f32, ellipsoid.f() as f32).unwrap();
            let single = Shifted::new(single, shift).unwrap();
            for _ in 0..2000 {
                let (lat, lon) = (180.0 * rng.f64() - 90.0, 360.0 * rng.f64());
                let (lat, lon) = (f64::from(lat as f32), f64::from(lon as f32));
                let height = f64::from((20_000.0 * rng.f64() - 10_000.0) as f32);
                let place = LatLon::new(lat, lon).unwrap();
                let found = lean(&shifted, place, height);
                let expected = truth(&shifted, place, height);
                for (found, expected) in [found.east, found.north, found.up].into_iter().zip(expected) {
                    assert!(
                        (found - expected).abs() < 2e-11,
                        "{ellipsoid:?} {shift} {place:?} {found} {expected}"
                    );
                }
                let rough = lean(&single, LatLon::new(lat as f32, lon as f32).unwrap(), height as f32);
                let larger = found.north.abs();
                assert!(
                    (f64::from(rough.north) - found.north).abs() <= 3e-7 * larger + 1e-4,
                    "{shift} {place:?}"
                );
            }
        }
    }
}

#[test]
fn leaning_is_what_the_paper_shows() {
    let most = |shift| {
        let earth = Shifted::new(Ellipsoid::WGS84, shift).unwrap();
        Worst::of(
            (-900..=900)
                .map(|lat| lean(&earth, LatLon::new(f64::from(lat) / 10.0, 0.0).unwrap(), 1000.0))
                .map(|lean| lean.north.abs()),
        )
    };
    // 11.55′ and 7.70′ of the height.
    assert!(
        (most(Shift::Geocentric) - 3.3585).abs() < 1e-3,
        "{}",
        most(Shift::Geocentric)
    );
    assert!(
        (most(Shift::Authalic) - 2.2394).abs() < 1e-3,
        "{}",
        most(Shift::Authalic)
    );
    assert_eq!(most(Shift::Geodetic), 0.0);
    let north = Direction::new(0.0, 0.0, 1.0_f64).unwrap().to_lat_lon();
    let earth = Shifted::new(Ellipsoid::WGS84, Shift::Geocentric).unwrap();
    assert!(lean(&earth, north, 8000.0).north.abs() < 1e-12);
}
