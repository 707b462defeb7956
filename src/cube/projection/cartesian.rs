use super::decay::smooth;
use super::profile::projection;
use super::{CubeProjection, Face};
use crate::Real;
use crate::math::max;

projection! {
    #[doc(alias = "KSC")]
    Cartesian "cartesian" {
        title: "Cartesian",
        also: "Nowell’s cube, KSC",
        summary: "Nowell’s \"Cartesian\" cube, KSC: X = x√(½ − y²/6), Y = y√(½ − x²/6).",
        idea: "Each coordinate of a point on the cube is multiplied by a square root that contains the \
            squares of the other two, so that the squares of the three results add up to one.",
        origin: "Philip Nowell’s note on mapping a cube to a sphere (2005); Dimitrijević, Lambers & Rančić \
            (2016), §4.6.",
        choose: "Take it for agreement with data that was made with it. [`Algebraic`](super::Algebraic) is \
            slightly cheaper, with less texture oversize (2.712 instead of 3.000) and areas that vary less \
            (1.268 to 1 instead of 1.333 to 1).",
        keeps: None,
        area_ratio: 1.333,
        aspect_ratio: 3.000,
        oversize: 3.000,
        deformation: 31.1,
        forward: Algebraic, error [4.0e-16, 2.2e-7], instructions [98, 94];
        inverse: Algebraic, error [2.8e-16, 1.6e-7], instructions [53, 49];
        tiles: smooth(1.07, 2.29),
    }
}

// Written in p = 1 − x², q = 1 − y², so that components that agree on an edge agree to the last bit, and in
// gnomonic coordinates in the forward direction, where the paper's eq. 4.14 cancels.
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
