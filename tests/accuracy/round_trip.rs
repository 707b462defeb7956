//! LatLon → FacePoint → LatLon.

use rayon::prelude::*;
use terrella::cube::{CubeMap, CubeProjection, Face, FacePoint, Projection};
use terrella::{Ellipsoid, LatLon, Shift};

use crate::truth::Scalar;

/// Latitude and longitude, half of them where something could go wrong.
fn place(rng: &mut fastrand::Rng, map: &CubeMap<f64, Projection>) -> (f64, f64) {
    let signed = |rng: &mut fastrand::Rng| 2.0 * rng.f64() - 1.0;
    let close = |rng: &mut fastrand::Rng| 10f64.powf(-16.0 * rng.f64()) * signed(rng);
    match rng.u8(0..10) {
        0..4 => (signed(rng).asin().to_degrees(), 180.0 * signed(rng)),
        4 => (
            (90.0 - close(rng).abs() * 90.0).copysign(signed(rng)),
            180.0 * signed(rng),
        ),
        5 => (close(rng) * 90.0, 180.0 * signed(rng)),
        6 => (
            90.0 * signed(rng),
            (180.0 - close(rng).abs() * 180.0).copysign(signed(rng)),
        ),
        7 => (
            90.0 * signed(rng),
            45.0 * f64::from(rng.i32(-4..=4)) * (1.0 - close(rng).abs()),
        ),
        kind => {
            let face = Face::ALL[rng.usize(0..6)];
            let edge = (1.0 - close(rng).abs()).copysign(signed(rng));
            let (x, y) = match rng.u8(0..4) {
                0 => (edge, signed(rng)),
                1 => (edge, (1.0 - close(rng).abs()).copysign(signed(rng))),
                2 => {
                    let s = signed(rng);
                    (s, s * (1.0 - close(rng)))
                }
                _ => (close(rng), close(rng)),
            };
            let (x, y) = if kind == 8 { (x, y) } else { (y, x) };
            let p = map.unproject(FacePoint::new(face, x.clamp(-1.0, 1.0), y.clamp(-1.0, 1.0)).unwrap());
            (p.lat(), p.lon())
        }
    }
}

/// The largest displacement in metres.
fn worst<T: Scalar>(projection: Projection, shift: Shift, points: usize, lower: fn(f64) -> T) -> (f64, f64, f64) {
    let places = CubeMap::new(Ellipsoid::<f64>::wgs84(), shift, projection).unwrap();
    let map = CubeMap::new(Ellipsoid::<T>::wgs84(), shift, projection).unwrap();
    let mut rng = fastrand::Rng::with_seed(4);
    let mut worst = (0.0, 0.0, 0.0);
    for _ in 0..points {
        let (lat, lon) = place(&mut rng, &places);
        let there = LatLon::new(lower(lat), lower(lon)).unwrap();
        let back = map.unproject(map.project(there));
        let dlat = back.lat().into() - there.lat().into();
        let dlon = (back.lon().into() - there.lon().into() + 540.0).rem_euclid(360.0) - 180.0;
        let d = 6_378_137.0 * dlat.hypot(dlon * lat.to_radians().cos()).to_radians();
        if d > worst.0 || d.is_nan() {
            worst = (d, there.lat().into(), there.lon().into());
        }
    }
    worst
}

#[test]
fn round_trips() {
    let n: usize = std::env::var("N").ok().and_then(|s| s.parse().ok()).unwrap_or(20_000);
    let cases: Vec<_> = Projection::ALL
        .iter()
        .filter(|&&p| p != Projection::Cobe)
        .flat_map(|&p| Shift::ALL.iter().map(move |&s| (p, s)))
        .collect();
    let results: Vec<_> = cases
        .par_iter()
        .map(|&(p, s)| (p, s, worst::<f64>(p, s, n, |v| v), worst::<f32>(p, s, n, |v| v as f32)))
        .collect();
    for (p, s, d, f) in results {
        println!(
            "{p:18} {s:12} {:.2} nm ({:.4} {:.4}) {:.2} m ({:.4} {:.4})",
            d.0 * 1e9,
            d.1,
            d.2,
            f.0,
            f.1,
            f.2
        );
    }
}
