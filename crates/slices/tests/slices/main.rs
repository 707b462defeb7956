//! Over slices: the same bits as one by one, for every length and for special values, and all of them where some are refused.
#![allow(
    missing_docs, clippy::unwrap_used, clippy::expect_used, clippy::panic, clippy::indexing_slicing
)] // tests

mod area;
mod batch;
mod cube;
mod fence;
mod frame;
mod geodesic;
mod grid;
mod healpix;
mod intersection;
mod line;
mod polygon;
mod position;
mod refused;
mod rhumb;
mod route;
mod scene;
mod terrain;

use terrella::cube::Face;
use terrella::{Direction, Real};

/// Lengths about the ends of vectors, blocks and buffers; few under Miri, which takes a thousand times as long.
const LENGTHS: &[usize] = if cfg!(miri) {
    &[0, 1, 65]
} else {
    &[0, 1, 2, 3, 7, 8, 9, 31, 63, 64, 65, 127, 128, 129, 255, 256, 257, 600]
};
/// More than any length.
const ALL: usize = if cfg!(miri) { 70 } else { 700 };

trait Scalar: Real + Into<f64> {}
impl<T: Real + Into<f64>> Scalar for T {}

/// The bits, through `f64`, in which an `f32` is exact; every NaN is the same.
fn bits<T: Scalar>(values: &[T]) -> Vec<u64> {
    let bits = |value: f64| if value.is_nan() { f64::NAN } else { value }.to_bits();
    values.iter().map(|&value| bits(value.into())).collect()
}

/// A special value here and there, a random number in [−1, 1) elsewhere.
fn numbers<T: Scalar>(seed: u64, special: &[f64]) -> Vec<T> {
    let mut rng = fastrand::Rng::with_seed(seed);
    let mut number = || {
        if rng.u8(0..4) == 0 && !special.is_empty() {
            special[rng.usize(0..special.len())]
        } else {
            2.0 * rng.f64() - 1.0
        }
    };
    (0..ALL).map(|_| T::of(number())).collect()
}

fn scaled<T: Scalar>(values: &[T], factor: f64) -> Vec<T> {
    values.iter().map(|&value| value * T::of(factor)).collect()
}

const ENDS: &[f64] = &[0.0, -0.0, 1.0, -1.0, 0.5, -0.5, 1e-7, -1e-7, 1e-300, 0.999_999_9];

/// The parts of columns that are tried: from an offset, of a length.
fn parts() -> impl Iterator<Item = core::ops::Range<usize>> {
    LENGTHS.iter().enumerate().map(|(i, &length)| i..i + length)
}

/// A function over `I` columns to `O` columns.
type OverSlices<'a, T, const I: usize, const O: usize, R = ()> = dyn Fn([&[T]; I], [&mut [T]; O]) -> R + 'a;

/// Runs a batch on parts of the columns and compares it with what one by one gives.
fn compare<T: Scalar, const I: usize, const O: usize>(
    what: &str,
    columns: &[Vec<T>; I],
    one: &dyn Fn([T; I]) -> [T; O],
    batch: &OverSlices<'_, T, I, O>,
) {
    let mut expected: [Vec<T>; O] = [const { Vec::new() }; O];
    for i in 0..ALL {
        for (column, value) in expected.iter_mut().zip(one(columns.each_ref().map(|column| column[i]))) {
            column.push(value);
        }
    }
    for part in parts() {
        let mut found = [(); O].map(|()| vec![T::of(f64::NAN); part.len()]);
        batch(
            columns.each_ref().map(|column| &column[part.clone()]),
            found.each_mut().map(|column| &mut column[..]),
        );
        for (expected, found) in expected.iter().zip(&found) {
            assert_eq!(bits(found), bits(&expected[part.clone()]), "{what}, {part:?}");
        }
    }
}

fn number<T: Real>(face: Face) -> T {
    T::of(f64::from(face.index()))
}

/// Unit vectors, with special components.
fn directions<T: Scalar>() -> [Vec<T>; 3] {
    let [x, y, z] = [1, 2, 3].map(|seed| numbers::<T>(seed, ENDS));
    let mut units = [const { Vec::new() }; 3];
    for i in 0..ALL {
        let direction = Direction::new(x[i], y[i], z[i]).unwrap_or(Direction::new(T::ZERO, T::ZERO, -T::ONE).unwrap());
        // Twice, so that even the constructor takes it as it is.
        let [x, y, z] = direction.to_array();
        let direction = Direction::new(x, y, z).unwrap().to_array();
        for (column, value) in units.iter_mut().zip(direction) {
            column.push(value);
        }
    }
    units
}

fn places<T: Scalar>() -> [Vec<T>; 2] {
    [scaled(&numbers(4, ENDS), 90.0), scaled(&numbers(5, ENDS), 180.0)]
}

fn points<T: Scalar>() -> [Vec<T>; 3] {
    let mut rng = fastrand::Rng::with_seed(6);
    let faces = (0..ALL).map(|_| number(Face::ALL[rng.usize(0..6)])).collect();
    [faces, numbers(7, ENDS), numbers(8, ENDS)]
}

fn faces<T: Scalar>(numbers: &[T]) -> Vec<Face> {
    numbers
        .iter()
        .map(|&number| Face::from_index(number.into() as u8).unwrap())
        .collect()
}

fn store<T: Scalar>(faces: &[Face], column: &mut [T]) {
    for (slot, &face) in column.iter_mut().zip(faces) {
        *slot = number(face);
    }
}

/// Bytes in place of a column of numbers.
fn bytes<T: Scalar>(numbers: &[T]) -> Vec<u8> {
    numbers.iter().map(|&number| number.into() as u8).collect()
}

/// Pairs of places as latitude, longitude, latitude, longitude: anywhere, nearly coincident, nearly antipodal, on meridians and parallels.
fn pairs<T: Scalar>() -> [Vec<T>; 4] {
    let mut rng = fastrand::Rng::with_seed(31);
    let [lat, lon] = places::<T>();
    let tiny = |rng: &mut fastrand::Rng| T::of(10f64.powf(-12.0 * rng.f64()) * (2.0 * rng.f64() - 1.0));
    let mut other = [const { Vec::new() }; 2];
    for i in 0..ALL {
        let j = rng.usize(0..ALL);
        let (to_lat, to_lon) = match rng.u8(0..6) {
            0 => (lat[i] + tiny(&mut rng), lon[i] + tiny(&mut rng)),
            1 => (-lat[i] + tiny(&mut rng), lon[i] + T::of(180.0) + tiny(&mut rng)),
            2 => (lat[i], lon[i]),
            3 => (lat[j], lon[i]),
            _ => (lat[j], lon[j]),
        };
        let to_lat = if to_lat.abs() > T::of(90.0) { lat[i] } else { to_lat };
        other[0].push(to_lat);
        other[1].push(to_lon);
    }
    let [lat2, lon2] = other;
    [lat, lon, lat2, lon2]
}
