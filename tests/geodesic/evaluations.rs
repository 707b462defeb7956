//! How often the longitude is computed: a worse start or a worse step has the same distance in the end, but later.

use terrella::geodesic::Karney;
use terrella::{Ellipsoid, LatLon};

use crate::sample::{even, place, signed};
use testkit::truth::Scalar;

type Pair = fn(&mut fastrand::Rng) -> [f64; 4];

/// Anywhere; within so many degrees of the antipode; there, too, of opposite latitudes.
const KINDS: [Pair; 6] = [
    |rng| {
        let ((lat1, lon1), (lat2, lon2)) = (even(rng), even(rng));
        [lat1, lon1, lat2, lon2]
    },
    |rng| near(rng, 20.0),
    |rng| near(rng, 2.0),
    |rng| near(rng, 0.5),
    |rng| near(rng, 0.01),
    |rng| {
        let lat = even(rng).0;
        [lat, 0.0, -lat, 180.0 - rng.f64()]
    },
];

fn near(rng: &mut fastrand::Rng, within: f64) -> [f64; 4] {
    let lat = even(rng).0 * (1.0 - within / 90.0);
    [lat, 0.0, -lat + within * signed(rng), 180.0 - within * rng.f64()]
}

/// For each kind of pairs the mean number of evaluations is at most this, and the largest.
fn hold<T: Scalar>(what: &str, means: [f64; 6], most: usize, evaluations: impl Fn(LatLon<T>, LatLon<T>) -> usize) {
    for (kind, limit) in KINDS.iter().zip(means) {
        let mut rng = fastrand::Rng::with_seed(8);
        let counts: Vec<usize> = (0..10_000)
            .map(|_| {
                let [lat1, lon1, lat2, lon2] = kind(&mut rng).map(T::of);
                evaluations(place(lat1, lon1), place(lat2, lon2))
            })
            .collect();
        let mean = counts.iter().sum::<usize>() as f64 / counts.len() as f64;
        println!("{what} {}: {mean} {:?}", T::NAME, counts.iter().max());
        assert!(mean <= limit, "{what} {}: {mean} evaluations of {limit}", T::NAME);
        assert!(
            counts.iter().all(|count| *count <= most),
            "{what} {}: over {most}",
            T::NAME
        );
    }
}

fn karney<T: Scalar>(f: f64, means: [f64; 6], most: usize) {
    let method = Karney::<T>::new(Ellipsoid::new(T::of(6.4e6), T::of(f)).unwrap()).unwrap();
    hold(&format!("karney {f}"), means, most, |from, to| {
        method.solve(from, to).evaluations
    });
}

#[test]
fn karney_needs_as_few_as_it_says() {
    karney::<f64>(1.0 / 298.257_223_563, [3.01, 3.04, 2.97, 2.95, 2.07, 2.88], 14);
    karney::<f32>(1.0 / 298.257_223_563, [2.00, 2.00, 1.97, 1.95, 1.06, 2.02], 11);
    karney::<f64>(0.1, [4.44, 3.83, 3.15, 3.00, 2.71, 3.00], 6);
    karney::<f32>(0.1, [3.36, 2.78, 2.02, 2.00, 1.93, 2.00], 5);
    karney::<f64>(-1.0 / 150.0, [3.03, 3.67, 4.66, 4.24, 3.05, 3.01], 10);
    karney::<f32>(-1.0 / 150.0, [2.01, 2.27, 2.94, 2.71, 2.03, 2.01], 7);
}
