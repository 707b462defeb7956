//! Lines to, from and over a pole.

use terrella::Ellipsoid;
use terrella::geodesic::{Area, Geodesic, Karney};
use testkit::{Worst, maximum};

use crate::along::turned;
use crate::methods::methods;
use crate::sample::place;
use testkit::truth::Scalar;

/// A pole is one place, by whatever longitudes it is named.
fn pole<T: Scalar>() {
    for (name, method) in methods::<T>(1.0 / 298.0) {
        for lat in [90.0, -90.0] {
            for lon in [1.0, 60.0, 91.0, 150.0, 180.0] {
                let line = method
                    .inverse(place(T::of(lat), T::ZERO), place(T::of(lat), T::of(lon)))
                    .unwrap();
                // The cosine of a latitude is never 0 there, nor is the plane's parallel.
                assert!(line.distance.into() < 1e-9, "{name} {lat} {lon}: {line:?}");
            }
        }
    }
}

#[test]
fn a_pole_is_no_way_from_itself() {
    pole::<f64>();
    pole::<f32>();
}

/// Opposite longitudes all but a rounding: in `f32` a line passed the pole on the other side, and the area under it had the other sign.
#[test]
fn lines_pass_a_pole_on_their_side() {
    let (single, double) = (
        Area::new(Ellipsoid::<f32>::WGS84).unwrap(),
        Area::new(Ellipsoid::<f64>::WGS84).unwrap(),
    );
    for lat in [89.981_36_f32, 89.0, 80.0, 45.0, 1.0, -1.0, -89.0] {
        for lon in [-2.425_776_7e-9_f32, -1e-20, -1e-7, -1e-5] {
            let found = single.under(place(lat, 180.0), place(lat, lon));
            let expected = double.under(place(lat.into(), 180.0), place(lat.into(), lon.into()));
            let error = (f64::from(found) - expected).abs();
            assert!(error < 1e-6 * expected.abs(), "{lat} {lon:e}: {found:e}, {expected:e}");
        }
    }
}

fn next_to_a_pole<T: Scalar>(most: f64) {
    let karney = Karney::new(Ellipsoid::<T>::WGS84).unwrap();
    let mut rng = fastrand::Rng::with_seed(19);
    let error = Worst::of((0..20_000).map(|_| {
        // From a place next to a pole, however near, back to it.
        let near = (90.0 - 10.0_f64.powf(rng.f64() * 17.0 - 16.0)).copysign(rng.f64() - 0.5);
        let [lon, azimuth] = [0; 2].map(|_| T::of(rng.f64() * 360.0 - 180.0));
        let pole = place(T::of(near), lon);
        let start = karney.direct(pole, azimuth, T::of(rng.f64() * 2e7)).unwrap();
        let line = karney.inverse(start.position, pole).unwrap();
        let there = karney.direct(start.position, line.azimuth1, line.distance).unwrap();
        let back = karney.direct(there.position, there.azimuth, -line.distance).unwrap();
        karney.inverse(back.position, start.position).unwrap().distance.into()
    }));
    assert!(error < most, "{}: {error:e} m", T::NAME);
}

/// The azimuth counts from the meridian of the longitude that is given, though rounding turned that meridian.
#[test]
fn lines_that_end_next_to_a_pole_lead_back() {
    next_to_a_pole::<f64>(1e-8);
    next_to_a_pole::<f32>(4.0);
}

/// Along a meridian over a pole and down the other side, where a plane's latitude is beyond 90°.
fn over_a_pole<T: Scalar>() {
    for (name, method) in methods::<T>(1.0 / 298.257_223_563) {
        // A degree is 111.7 km there, 111.2 on a sphere.
        for (lat, azimuth, distance, beyond) in [
            (89.5, 0.0, 1e5, 0.395),
            (-89.5, 180.0, 1e5, 0.395),
            (89.5, 180.0, -1e5, 0.395),
        ] {
            let end = method
                .direct(place(T::of(lat), T::of(-30.0)), T::of(azimuth), T::of(distance))
                .unwrap();
            let (lat2, lon2) = (end.position.lat().into(), end.position.lon());
            let north = (lat2 - (90.0_f64 - beyond).copysign(lat)).abs().to_radians();
            let off = maximum(
                maximum(north, turned(lon2, 150.0)),
                turned(end.azimuth, 180.0 - azimuth),
            );
            assert!(off < 1e-4, "{name} {lat} {azimuth}: {end:?}");
        }
    }
}

#[test]
fn a_meridian_goes_on_beyond_the_pole() {
    over_a_pole::<f64>();
    over_a_pole::<f32>();
}
