use super::{CubeProjection, Face, from_gnomonic};
use crate::Real;

/// Lambers' algebraic cube (2019): u = x/√(1 + c²(1 − x²)) with c = 0.87.
///
/// Nearly the adjusted cube, without a transcendental function: area ratio 1.27.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Algebraic;

const C2: f64 = 0.87 * 0.87;

impl CubeProjection for Algebraic {
    #[inline(always)]
    fn forward<T: Real>(&self, _: Face, [right, up, outward]: [T; 3]) -> [T; 2] {
        [coordinate(right / outward), coordinate(up / outward)]
    }

    #[inline(always)]
    fn inverse<T: Real>(&self, _: Face, [x, y]: [T; 2]) -> [T; 3] {
        from_gnomonic([gnomonic(x), gnomonic(y)])
    }
}

#[inline(always)]
fn coordinate<T: Real>(u: T) -> T {
    let c2 = T::of(C2);
    u * ((T::ONE + c2) / (T::ONE + c2 * (u * u))).sqrt()
}

#[inline(always)]
fn gnomonic<T: Real>(x: T) -> T {
    x / (T::ONE + T::of(C2) * (T::ONE - x * x)).sqrt()
}
