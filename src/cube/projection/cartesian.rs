use super::{CubeProjection, Face};
use crate::Real;
use crate::math::max;

/// Nowell's "Cartesian" cube, KSC: X = x√(½ − y²/6), Y = y√(½ − x²/6).
///
/// Dimitrijević, Lambers & Rančić (2016) §4.6. Aspect ratio 3, area ratio 4/3.
///
/// Written in p = 1 − x², q = 1 − y², so that components that agree on an edge agree to the last bit, and in gnomonic coordinates
/// in the forward direction, where the printed 4.14 cancels.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Cartesian;

impl CubeProjection for Cartesian {
    #[inline(always)]
    fn forward<T: Real>(&self, _: Face, [right, up, outward]: [T; 3]) -> [T; 2] {
        let (u, v) = (right / outward, up / outward);
        let (uu, vv) = (u * u, v * v);
        let sum = T::of(3.0) + uu + vv;
        let product = T::of(4.0) * u * v;
        let root = max((sum - product) * (sum + product), T::ZERO).sqrt();
        let coordinate = |w: T, ww: T| {
            let denominator = sum + T::of(4.0) * ww + root;
            w * (T::of(12.0) / denominator).sqrt()
        };
        [coordinate(u, uu), coordinate(v, vv)]
    }

    #[inline(always)]
    fn inverse<T: Real>(&self, _: Face, [x, y]: [T; 2]) -> [T; 3] {
        let (half, third) = (T::of(0.5), T::of(1.0 / 3.0));
        let p = T::ONE - x * x;
        let q = T::ONE - y * y;
        [
            x * ((T::ONE + half * q) * third).sqrt(),
            y * ((T::ONE + half * p) * third).sqrt(),
            ((T::ONE + (half * (p + q) + p * q)) * third).sqrt(),
        ]
    }
}
