//! There and back, on 10⁵ points from −10 km to 50 000 km.

use testkit::{Worst, minimum};

use crate::{ELLIPSOIDS, distance, ellipsoid, geodetic};
use testkit::truth::Scalar;

/// The largest distance after the way to latitude, longitude, height and back, below 100 km and above.
fn worst<T: Scalar>(name: &str) -> [f64; 2] {
    let e = ellipsoid::<T>(name);
    let mut random = fastrand::Rng::with_seed(11);
    let mut worst = [Worst::default(); 2];
    for i in 0..100_000 {
        let lat = (2.0 * random.f64() - 1.0).asin().to_degrees();
        let height = if i % 2 == 0 {
            1.1e5 * random.f64() - 1e4
        } else {
            minimum(10_f64.powf(5.0 + 2.7 * random.f64()), 5e7)
        };
        let p = e.to_ecef(geodetic(T::of(lat), T::of(360.0 * random.f64() - 180.0), T::of(height)));
        let error = distance(e.to_ecef(e.to_geodetic(p)), p);
        worst[i % 2].add(error);
    }
    println!("{name} {} {worst:?}", T::NAME);
    worst.map(Worst::value)
}

#[test]
fn points_come_back() {
    // The last is the flattest that a straight line serves.
    for name in ELLIPSOIDS.into_iter().chain(["mars", "oblate151"]) {
        let [near, far] = worst::<f64>(name);
        assert!(near < 4e-9 && far < 3e-8, "{name}: {near:e} {far:e}");
        let [near, far] = worst::<f32>(name);
        assert!(near < 2.0 && far < 16.0, "{name}: {near} {far}");
    }
}
