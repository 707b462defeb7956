use super::decay::smooth;
use super::profile::projection;
use super::{CubeProjection, Face, normalise};
use crate::Real;
use crate::math::{max, min, repeat};

projection! {
    #[doc(alias = "OSC")]
    Outerra "outerra" {
        title: "Outerra",
        also: "OSC",
        summary: "Outerra’s cube, OSC: the direction of (x, y, 1 + M(1 − x²)(1 − y²)), M = (√2 − 1)/2.",
        idea: "The flat face is first raised like a cushion, and each point of the cushion is then \
            projected straight onto the sphere. Cells are almost as wide as they are high.",
        origin: "The planet engine Outerra; Dimitrijević, Lambers & Rančić (2016), §4.3.",
        choose: "Take it to exchange data with Outerra. [`Square`](super::Square) has the same aspect ratio \
            (1.013), and its areas vary less (2.229 to 1 instead of 3.566 to 1), but its way to the cube \
            costs twice as much (360 instructions instead of 180).",
        keeps: None,
        area_ratio: 3.566,
        aspect_ratio: 1.013,
        oversize: 3.088,
        deformation: 31.1,
        forward: Iteration, error [2.5e-16, 1.4e-7], instructions [180, 160];
        inverse: Algebraic, error [3.0e-16, 1.6e-7], instructions [58, 55];
        tiles: smooth(0.88, 0.81),
    }
}

const M: f64 = 0.207_106_781_186_547_52;

impl CubeProjection for Outerra {
    #[inline(always)]
    fn forward<T: Real>(&self, _: Face, [right, up, outward]: [T; 3]) -> [T; 2] {
        let u = right / outward;
        let v = up / outward;
        let (uu, vv) = (u * u, v * v);
        let m = T::of(M);
        // (x, y) = k(u, v), where k is the root of k = 1 + M(1 − k²u²)(1 − k²v²) in [1, 1 + M] (Algorithm 1,
        // scaled by Z).
        let mut k = T::ONE + m * ((T::ONE - uu) * (T::ONE - vv));
        repeat!(T::steps(4, 3), {
            let p = T::ONE - k * k * uu;
            let q = T::ONE - k * k * vv;
            let slope = T::ONE + T::of(2.0) * m * k * (uu * q + vv * p);
            k -= (k - T::ONE - m * (p * q)) / slope;
        });
        // Where k is at a bound it is k itself that is kept, and with it a derivative.
        let k = max(T::ONE, min(T::ONE + m, k));
        [k * u, k * v]
    }

    #[inline(always)]
    fn inverse<T: Real>(&self, _: Face, [x, y]: [T; 2]) -> [T; 3] {
        let bulge = T::of(M) * ((T::ONE - x * x) * (T::ONE - y * y));
        normalise([x, y, T::ONE + bulge])
    }
}
