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
        let c2 = T::of(C2);
        [right, up].map(|v| {
            let u = v / outward;
            u * ((T::ONE + c2) / (T::ONE + c2 * (u * u))).sqrt()
        })
    }

    #[inline(always)]
    fn inverse<T: Real>(&self, _: Face, point: [T; 2]) -> [T; 3] {
        from_gnomonic(point.map(|x| x / (T::ONE + T::of(C2) * (T::ONE - x * x)).sqrt()))
    }
}
