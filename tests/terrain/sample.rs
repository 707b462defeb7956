//! Random scalars, points and tiles, many of them near special cases.

use std::fmt::Debug;

use fastrand::Rng;
use terrella::Real;
use terrella::cube::FacePoint;
use terrella::terrain::Tile;
pub use testkit::tiles::{face, index, tile, tile_of};

/// A scalar under test.
pub trait Scalar: Real + Into<f64> + Debug {
    /// To what level the lines between tiles are exact.
    const EXACT: u8;
    /// From bits: any number at all.
    fn from_raw(bits: u64) -> Self;
}

impl Scalar for f32 {
    const EXACT: u8 = 25;
    fn from_raw(bits: u64) -> Self {
        Self::from_bits(bits as u32)
    }
}

impl Scalar for f64 {
    const EXACT: u8 = Tile::MAX_LEVEL;
    fn from_raw(bits: u64) -> Self {
        Self::from_bits(bits)
    }
}

/// A number in [−1, 1]: anywhere, next to a line between tiles, or so small that adding 1 would lose it.
pub fn coordinate<T: Scalar>(rng: &mut Rng) -> T {
    let sign = T::of(if rng.bool() { -1.0 } else { 1.0 });
    let line = T::of(f64::from(rng.u32(0..=1 << 12)) / 4096.0);
    let magnitude = match rng.u8(0..6) {
        0 => line,
        1 => line + T::of(rng.f64() * 1e-8),
        2 => T::of(10_f64.powf(-40.0 * rng.f64())),
        3 => T::ONE - T::EPSILON * T::of(f64::from(rng.u8(0..4)) * 0.5),
        _ => T::of(rng.f64()),
    };
    sign * if magnitude > T::ONE { T::ONE } else { magnitude }
}

pub fn point<T: Scalar>(rng: &mut Rng) -> FacePoint<T> {
    FacePoint::new(face(rng), coordinate(rng), coordinate(rng)).unwrap()
}
