//! Rays and lines of sight: against heights along them.

use fastrand::Rng;
use terrella::terrain::Camera;
use terrella::{Ecef, Ellipsoid, Geodetic, LatLon, Meeting, Ray};
use testkit::Worst;

const EARTH: Ellipsoid = Ellipsoid::WGS84;

fn place(rng: &mut Rng, height: f64) -> Geodetic {
    let place = LatLon::new(180.0 * rng.f64() - 90.0, 360.0 * rng.f64() - 180.0).unwrap();
    Geodetic::new(place, height).unwrap()
}

/// The height where a ray enters is the one asked for, also if the ray only grazes the surface.
#[test]
fn rays_meet_the_height() {
    let mut rng = Rng::with_seed(51);
    let mut worst = [Worst::default(); 2];
    for _ in 0..20_000 {
        let high = 10_f64.powf(1.0 + 6.0 * rng.f64());
        let eye = place(&mut rng, 10_000.0 + high);
        let height = if rng.bool() { 0.0 } else { 9000.0 * rng.f64() - 400.0 };
        let lat = (eye.lat() + 60.0 * (rng.f64() - 0.5)).clamp(-90.0, 90.0);
        let below = LatLon::new(lat, eye.lon() + 60.0 * (rng.f64() - 0.5)).unwrap();
        let target = EARTH.to_ecef(Geodetic::new(below, height).unwrap());
        let ray = Ray::through(EARTH.to_ecef(eye), target).unwrap();
        let Meeting::Enters(distance) = EARTH.meet(&ray, height) else {
            continue;
        };
        let there = EARTH.to_geodetic(ray.at(distance));
        let normal = there.lat_lon().to_direction().to_array();
        let steep: f64 = normal.iter().zip(ray.direction().to_array()).map(|(a, b)| -a * b).sum();
        if steep > 0.05 {
            worst[usize::from(height != 0.0)].add((there.height() - height).abs());
        }
    }
    assert!(worst.iter().all(|worst| worst.value() <= 1e-8), "{worst:?}");
}

#[test]
fn rays_miss_touch_and_leave() {
    let at = |x, y, z| Ecef::new(x, y, z).unwrap();
    let (a, b) = (EARTH.a(), EARTH.b());
    let along_y = |x, z| Ray::new(at(x, -1e7, z), [0.0, 3.0, 0.0]).unwrap();
    assert_eq!(EARTH.meet(&along_y(a, 0.0), 0.0), Meeting::Touches(1e7));
    assert_eq!(EARTH.meet(&along_y(0.0, b), 0.0), Meeting::Touches(1e7));
    assert_eq!(EARTH.meet(&along_y(a + 1e-3, 0.0), 0.0), Meeting::Misses);
    assert!(matches!(EARTH.meet(&along_y(a + 1e-3, 0.0), 1.0), Meeting::Enters(_)));
    assert_eq!(EARTH.meet(&along_y(0.0, 0.0), 0.0), Meeting::Enters(1e7 - a));
    // Away from the Earth; from its centre; from the ground up and down; to a place that is no surface.
    let away = Ray::new(at(0.0, -1e7, 0.0), [0.0, -1.0, 0.0]).unwrap();
    assert_eq!(EARTH.meet(&away, 0.0), Meeting::Misses);
    let out = Ray::new(at(0.0, 0.0, 0.0), [0.0, 0.0, 2.0]).unwrap();
    assert_eq!(EARTH.meet(&out, 0.0), Meeting::Leaves(b));
    let up = Ray::new(at(a, 0.0, 0.0), [1.0, 0.0, 0.0]).unwrap();
    assert_eq!(EARTH.meet(&up, 0.0), Meeting::Leaves(0.0));
    let down = Ray::new(at(a, 0.0, 0.0), [-1.0, 0.0, 0.0]).unwrap();
    assert_eq!(EARTH.meet(&down, 0.0), Meeting::Leaves(2.0 * a));
    assert_eq!(EARTH.meet(&down, -7e6), Meeting::Misses);
    assert_eq!(EARTH.meet(&down, f64::NAN), Meeting::Misses);
    assert!(Ray::through(at(1.0, 2.0, 3.0), at(1.0, 2.0, 3.0)).is_err());
}

#[test]
fn the_lowest_place_of_a_line_is_found() {
    let mut rng = Rng::with_seed(52);
    let mut worst = Worst::default();
    for _ in 0..5000 {
        let [high, other] = [(); 2].map(|()| 10_f64.powf(6.0 * rng.f64()));
        let from = place(&mut rng, high);
        let lat = (from.lat() + 40.0 * (rng.f64() - 0.5)).clamp(-90.0, 90.0);
        let to = LatLon::new(lat, from.lon() + 40.0 * (rng.f64() - 0.5)).unwrap();
        let [from, to] = [from, Geodetic::new(to, other).unwrap()].map(|place| EARTH.to_ecef(place));
        let ends = [from, to].map(Ecef::to_array);
        let height = |part: f64| {
            let [x, y, z] = [0, 1, 2].map(|n| ends[0][n] + part * (ends[1][n] - ends[0][n]));
            EARTH.to_geodetic(Ecef::new(x, y, z).unwrap()).height()
        };
        let (mut low, mut high) = (0.0, 1.0);
        for _ in 0..80 {
            let third = (high - low) / 3.0;
            if height(low + third) < height(high - third) {
                high -= third;
            } else {
                low += third;
            }
        }
        let lowest = [low, 0.0, 1.0]
            .map(height)
            .into_iter()
            .reduce(testkit::minimum)
            .unwrap();
        worst.add((EARTH.clearance(from, to) - lowest).abs());
    }
    assert!(worst.value() <= 4e-9, "{worst:?}");
}

/// The ray of a pixel leads back to the pixel, with any perspective and any parallel matrix.
#[test]
fn rays_of_a_camera_lead_back() {
    let mut rng = Rng::with_seed(53);
    let mut worst = Worst::default();
    for case in 0..5000 {
        let high = 1e6 * rng.f64();
        let eye = EARTH.to_ecef(place(&mut rng, high));
        let mut matrix = [[(); 4]; 4].map(|row| row.map(|()| 2.0 * rng.f64() - 1.0));
        if case % 2 == 0 {
            matrix[3] = [0.0, 0.0, 0.0, 1.0];
        }
        let camera = Camera::new(eye, matrix, [1000.0, 800.0]).unwrap();
        let [right, above] = [500.0, 400.0].map(|half| half * (2.0 * rng.f64() - 1.0));
        let ray = camera.ray([right, above]).unwrap();
        let far = 10.0 + 1000.0 * rng.f64();
        if let Some([x, y]) = camera.pixel(ray.at(far)) {
            worst.add((x - right).hypot(y - above));
        }
    }
    assert!(worst.value() <= 0.01, "{worst:?}");
    let camera = Camera::new(Ecef::new(7e6, 0.0, 0.0).unwrap(), [[0.0; 4]; 4], [1.0, 1.0]).unwrap();
    assert_eq!(camera.ray([0.0, 0.0]), None);
    assert_eq!(camera.ray([f64::NAN, 0.0]), None);
}
