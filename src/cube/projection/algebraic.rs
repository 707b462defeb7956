use super::decay::smooth;
use super::profile::projection;
use super::{CubeProjection, Face, from_gnomonic};
use crate::Real;

projection! {
    Algebraic "algebraic" {
        title: "Algebraic",
        also: "",
        summary: "Lambers’ algebraic cube: u = x/√(1 + c²(1 − x²)) with c = 0.87.",
        idea: "It approximates the adjusted cube without a trigonometric function: one square root and one \
            division for each coordinate, both ways.",
        origin: "Lambers’ survey of cube maps for interactive graphics (2019).",
        choose: "Take it for nearly equal areas (1.268 to 1) at low cost in both directions. \
            [`Balanced`](super::Balanced) has less texture oversize (1.405 instead of 2.712), but costs \
            three times as much to the cube (240 instructions instead of 79).",
        keeps: None,
        area_ratio: 1.268,
        aspect_ratio: 2.712,
        oversize: 2.712,
        deformation: 31.1,
        forward: Algebraic, error [3.6e-16, 1.9e-7], instructions [79, 76];
        inverse: Algebraic, error [2.8e-16, 1.6e-7], instructions [50, 48];
        tiles: smooth(1.04, 1.03),
    }
}

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

// A quotient for each: one denominator for both costs digits in single precision.
#[inline(always)]
fn gnomonic<T: Real>(x: T) -> T {
    x / (T::ONE + T::of(C2) * (T::ONE - x * x)).sqrt()
}
