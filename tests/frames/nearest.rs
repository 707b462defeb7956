//! The point found is the nearest: no other of the ellipsoid is nearer, wherever one starts.

use terrella::{Ellipsoid, Geodetic};
use testkit::maximum;

use crate::{ecef, length};
use testkit::nearest::searched;
use testkit::truth::Scalar;

fn check<T: Scalar>(flattening: f64, tolerance: f64) {
    let e = Ellipsoid::<T>::new(T::of(6.4e6), T::of(flattening)).unwrap();
    let (a, b): (f64, f64) = (e.a().into(), e.b().into());
    let reach = a * maximum(e.e2().into().abs(), 1e-4);
    // The largest radius of curvature.
    let curved = maximum(a * a / b, b * b / a);
    let mut random = fastrand::Rng::with_seed(7);
    for _ in 0..4000 {
        // About the evolute, between it and the surface, outside.
        let scale = [reach, 10.0 * reach, a, 8.0 * a][random.usize(..4)];
        let part = |random: &mut fastrand::Rng| T::of(scale * 2.0 * (random.f64() - 0.5) * random.f64());
        let p = ecef(part(&mut random), part(&mut random), part(&mut random));
        let [x, y, z]: [f64; 3] = p.to_array().map(Into::into);
        let rho = length(&[x, y]);
        let found = e.to_geodetic(p);
        let height: f64 = found.height().into();
        let nearest = searched(a, b, rho, z);
        let tolerance = tolerance * maximum(nearest, curved) / a;
        assert!(
            (height.abs() - nearest).abs() <= tolerance,
            "f = {flattening}: {p:?}: {height} {nearest}"
        );
        let inside = (rho / a).powi(2) + (z / b).powi(2) < 1.0;
        assert!(height.abs() <= tolerance || (height < 0.0) == inside, "{p:?}: {height}");
        // The foot is that far as well.
        let foot = e.to_ecef(Geodetic::from(found.lat_lon()));
        let to_foot = crate::distance(p, foot);
        assert!(
            (to_foot - nearest).abs() <= 2.0 * tolerance,
            "f = {flattening}: {p:?}: {to_foot} {nearest}"
        );
    }
}

#[test]
fn no_other_point_is_nearer() {
    for f in [
        0.9,
        0.99,
        -9.0,
        -99.0,
        1.0 / 298.257,
        0.0,
        -1.0 / 150.0,
        0.1,
        -0.1,
        0.3,
        0.5,
        -0.5,
        -1.0,
        1e-6,
        -1e-6,
        1e-12,
    ] {
        check::<f64>(f, 1e-8);
        check::<f32>(f, 2.5);
    }
}
