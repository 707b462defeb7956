//! The haversine formula, and where it is weak.

use terrella::geodesic::{Geodesic, GreatCircle, Haversine};
use testkit::Worst;

use crate::sample::{place, signed};
use testkit::truth::Scalar;

/// The largest error in radians, by [`GreatCircle`] in `f64`, over pairs whose angle is short of the antipode by this many degrees or more;
/// relative to the distance, if wished.
fn worst<T: Scalar>((low, high): (f64, f64), relative: bool) -> f64 {
    let (sphere, reference) = (Haversine::<T>::new(T::ONE).unwrap(), GreatCircle::new(1.0).unwrap());
    let mut rng = fastrand::Rng::with_seed(8);
    let mut worst = Worst::default();
    for _ in 0..300_000 {
        let (lat, lon) = (signed(&mut rng).asin().to_degrees(), 180.0 * signed(&mut rng));
        let back = reference
            .direct(
                place(-lat, lon + 180.0),
                180.0 * signed(&mut rng),
                (low + (high - low) * rng.f64()).to_radians(),
            )
            .unwrap();
        let [lat1, lon1] = [lat, lon].map(T::of);
        let [lat2, lon2] = [back.position.lat(), back.position.lon()].map(T::of);
        let computed = sphere.inverse(place(lat1, lon1), place(lat2, lon2)).unwrap().distance;
        let (from, to) = (place(lat1.into(), lon1.into()), place(lat2.into(), lon2.into()));
        let truth = reference.inverse(from, to).unwrap().distance;
        worst.add((computed.into() - truth).abs() / if relative { truth } else { 1.0 });
    }
    worst.value()
}

#[test]
fn the_table_holds() {
    let table = [
        ((90.0, 180.0), [1.0e-15, 5.0e-7]),
        ((10.0, 11.0), [6.7e-15, 3.6e-6]),
        ((1.0, 1.1), [6.7e-14, 3.6e-5]),
        ((0.1, 0.11), [6.6e-13, 3.9e-4]),
        ((0.0, 1e-4), [4.3e-8, 1.0e-3]),
    ];
    let mut over = false;
    for (band, claimed) in table {
        let relative = band.1 == 180.0;
        let measured = [worst::<f64>(band, relative), worst::<f32>(band, relative)];
        println!("{band:?}: {measured:?} of {claimed:?}");
        over |= !(measured[0] <= claimed[0] && measured[1] <= claimed[1]);
    }
    assert!(!over);
}
