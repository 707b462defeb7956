use super::decay::smooth;
use super::profile::projection;
use super::{CubeProjection, Face, from_gnomonic};
use crate::Real;
use crate::math::repeat;

projection! {
    Polynomial5 "polynomial-5" {
        title: "Polynomial of degree 5",
        also: "",
        summary: "Zucker & Higashi’s polynomial: u = 0.7456x + 0.1305x³ + 0.1239x⁵ in each coordinate.",
        idea: "An odd polynomial leads from the cube to the sphere. The other way Newton’s method solves it.",
        origin: "Zucker & Higashi (2018), Cube-to-sphere projections for procedural texturing and beyond, \
            JCGT 7(2).",
        choose: "Take it to agree with programs that use it. [`Algebraic`](super::Algebraic) costs less toward the \
            cube and varies less, in area (1.268 to 1 instead of 1.283 to 1) and in texture oversize (2.712 \
            instead of 2.776).",
        keeps: None,
        area_ratio: 1.283,
        aspect_ratio: 2.776,
        oversize: 2.776,
        deformation: 31.1,
        forward: Polynomial, error [1.9e-16, 1.1e-7], instructions [150, 130];
        inverse: Polynomial, error [2.7e-16, 1.4e-7], instructions [55, 53];
        tiles: smooth(0.94, 2.46),
    }
}

// u = x − x(1 − x²)(A + Bx²): the published coefficients add to 1, so that the edge is exact.
const A: f64 = 0.254_441_284_407;
const B: f64 = 0.123_894_434_214;

impl CubeProjection for Polynomial5 {
    #[inline(always)]
    fn forward<T: Real>(&self, _: Face, [right, up, outward]: [T; 3]) -> [T; 2] {
        [coordinate(right / outward), coordinate(up / outward)]
    }

    #[inline(always)]
    fn inverse<T: Real>(&self, _: Face, [x, y]: [T; 2]) -> [T; 3] {
        // A zero keeps its sign: it may be what tells longitude −180 from 180.
        from_gnomonic([gnomonic(x).signed_like(x), gnomonic(y).signed_like(y)])
    }
}

#[inline(always)]
fn gnomonic<T: Real>(x: T) -> T {
    let square = x * x;
    x - x * ((T::ONE - square) * (T::of(A) + T::of(B) * square))
}

#[inline(always)]
fn coordinate<T: Real>(u: T) -> T {
    let of = T::of;
    let lack = T::ONE - u * u;
    // Within 3.7e-4; after one, two steps of Newton's method 2e-7, 6e-14.
    let mut x = u + u * lack * (of(0.209_44) + lack * (of(0.110_52) + of(0.0254) * lack));
    repeat!(T::steps(3, 2), {
        let square = x * x;
        let slope = of(1.0 - A) + square * (of(3.0 * (A - B)) + of(5.0 * B) * square);
        x += (u - gnomonic(x)) / slope;
    });
    x.signed_like(u)
}
