use super::{CubeProjection, Face, normalise};
use crate::Real;
use crate::math::{max, min, repeat};

/// Outerra's cube, OSC: (x, y, 1 + M(1 − x²)(1 − y²)), M = (√2 − 1)/2, normalised.
///
/// The squarest texels of the classical maps, aspect ratio 1.013, for an area ratio of 3.57.
/// Dimitrijević, Lambers & Rančić (2016) §4.3.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Outerra;

const M: f64 = 0.207_106_781_186_547_52;

impl CubeProjection for Outerra {
    #[inline(always)]
    fn forward<T: Real>(&self, _: Face, [right, up, outward]: [T; 3]) -> [T; 2] {
        let u = right / outward;
        let v = up / outward;
        let (uu, vv) = (u * u, v * v);
        let m = T::of(M);
        // (x, y) = k(u, v) with k = 1 + M(1 − k²u²)(1 − k²v²), a root in [1, 1 + M] (Algorithm 1, scaled by Z).
        let mut k = T::ONE + m * ((T::ONE - uu) * (T::ONE - vv));
        repeat!(T::terms(4, 3), {
            let p = T::ONE - k * k * uu;
            let q = T::ONE - k * k * vv;
            let slope = T::ONE + T::of(2.0) * m * k * (uu * q + vv * p);
            k -= (k - T::ONE - m * (p * q)) / slope;
        });
        let k = max(min(k, T::ONE + m), T::ONE);
        [k * u, k * v]
    }

    #[inline(always)]
    fn inverse<T: Real>(&self, _: Face, [x, y]: [T; 2]) -> [T; 3] {
        let bulge = T::of(M) * ((T::ONE - x * x) * (T::ONE - y * y));
        normalise([x, y, T::ONE + bulge])
    }
}
