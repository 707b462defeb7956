//! Scalars, and inputs of every kind: everywhere, on and next to edges, corners, diagonals and centres, and tiny.

use fastrand::Rng;
use terrella::Direction;
use terrella::cube::{Face, Projection};

use testkit::parallel;
pub use testkit::scalar::{Scalar, ulps};

/// Runs a check of a projection for all of them.
pub fn every_projection(check: impl Fn(Projection) + Sync) {
    parallel::for_each(Projection::ALL, |&projection| check(projection));
}

/// A number in [−1, 1).
pub fn signed(rng: &mut Rng) -> f64 {
    2.0 * rng.f64() - 1.0
}

/// A number in (0, 1], evenly distributed in its logarithm down to 1e-18.
pub fn small(rng: &mut Rng) -> f64 {
    10f64.powf(-18.0 * rng.f64())
}

/// Numbers in [−1, 1]: 0, 1, tiny ones, the neighbours of 1, and `random` of either sign from everywhere, next to 0 and next to 1.
pub fn coordinates<T: Scalar>(seed: u64, random: usize) -> Vec<T> {
    let mut rng = Rng::with_seed(seed);
    let one = T::ONE;
    let mut numbers = vec![
        T::ZERO,
        one,
        T::SMALLEST,
        T::SMALLEST_NORMAL,
        T::EPSILON,
        one.below(),
        one.below().below(),
        one - T::of(4.0) * T::EPSILON,
        T::of(0.25),
        T::of(0.5),
        T::of(1.0 / 3.0),
        T::of(2.0 / 3.0),
    ];
    for _ in 0..random.div_ceil(3) {
        numbers.extend([rng.f64(), small(&mut rng), 1.0 - small(&mut rng)].map(T::of));
    }
    numbers.into_iter().flat_map(|s| [s, -s]).collect()
}

/// Directions over the sphere, a good part of them where something could go wrong.
pub fn directions<T: Scalar>(seed: u64, count: usize) -> impl Iterator<Item = Direction<T>> {
    let mut rng = Rng::with_seed(seed);
    (0..count).map(move |i| {
        let rng = &mut rng;
        let (major, minor) = match i % 8 {
            0 => (rng.f64(), signed(rng)),
            1 => (1.0 - small(rng), signed(rng)),      // an edge
            2 => (1.0 - small(rng), 1.0 - small(rng)), // a corner
            3 => {
                let s = rng.f64();
                (s, s * (1.0 - small(rng))) // a diagonal
            }
            4 => (small(rng), small(rng)), // the centre
            5 => (rng.f64(), small(rng)),  // a midline
            6 => (rng.f64(), T::SMALLEST.into() * f64::from(rng.u8(0..5))),
            _ => (1.0, [1.0, 0.0, rng.f64(), T::SMALLEST.into()][rng.usize(0..4)]),
        };
        let sign = |v: f64, negative: bool| T::of(if negative { -v } else { v });
        let (a, b) = (sign(major, rng.bool()), sign(minor, rng.bool()));
        let (u, v) = if rng.bool() { (a, b) } else { (b, a) };
        let [x, y, z] = Face::ALL[rng.usize(0..6)].to_earth([u, v, T::ONE]);
        Direction::new(x, y, z).unwrap()
    })
}
