use super::decay::smooth;
use super::profile::projection;
use super::{CubeProjection, Face, from_gnomonic, newton};
use crate::Real;
use crate::math::{Polynomial, repeat};

projection! {
    Balanced "balanced" {
        title: "Balanced",
        also: "",
        summary: "The balanced cube: a short polynomial map with little texture oversize.",
        idea: "A polynomial with three coefficients, found by minimax search, so that cells differ as little \
            as possible both in area and in the ratio of their sides. The way to the sphere takes ten \
            multiplications and additions for each coordinate, and one square root.",
        origin: "Made for terrella: the texture oversize of Dimitrijević, Lambers & Rančić (2016), eq. \
            3.9, is 1.405 where their best projection has 2.",
        choose: "Take it for little texture memory at little cost; [`Compact`](super::Compact) has less (1.355), at \
            more cost. For equal areas take [`Vertex`](super::Vertex). For speed from the sphere to the cube \
            take [`S2Quadratic`](super::S2Quadratic) (79 instructions instead of 240, but texture oversize \
            2.105 instead of 1.405).",
        keeps: None,
        area_ratio: 1.488,
        aspect_ratio: 1.403,
        oversize: 1.405,
        deformation: 31.1,
        forward: Iteration, error [2.4e-16, 1.3e-7], instructions [240, 190];
        inverse: Algebraic, error [2.7e-16, 1.5e-7], instructions [63, 62];
        tiles: smooth(0.77, 2.02),
    }
}

const B: Polynomial<3, 3> = Polynomial::rounded([-0.22, 0.09, -0.11]);

/// The factor 1 + p(b₀ + p(b₁ + b₂q)) of a coordinate, and the parts its derivatives share.
struct Factor<T> {
    /// b₀ + p(b₁ + b₂q).
    a: T,
    /// p(b₁ + b₂q).
    c: T,
    value: T,
}

impl<T: Real> Factor<T> {
    #[inline(always)]
    fn new(p: T, q: T) -> Self {
        let [b0, b1, b2] = T::all(&B);
        let c = p * (b1 + b2 * q);
        let a = b0 + c;
        Self {
            a,
            c,
            value: T::ONE + p * a,
        }
    }
}

impl CubeProjection for Balanced {
    #[inline(always)]
    fn forward<T: Real>(&self, _: Face, [right, up, outward]: [T; 3]) -> [T; 2] {
        let (u, v) = (right / outward, up / outward);
        let (pu, pv) = (T::ONE - u * u, T::ONE - v * v);
        let two = T::of(2.0);
        // The guess is within 9e-6. After one and two steps of Newton's method the error is at most 5e-11 and
        // 2e-16.
        let start =
            |w: T, p: T, q: T| w * (T::ONE + p * (T::of(0.134_319) + p * (T::of(0.036_938) + T::of(0.111_502) * q)));
        let (mut x, mut y) = (start(u, pu, pv), start(v, pv, pu));
        repeat!(T::steps(3, 2), {
            let (xx, yy) = (x * x, y * y);
            let (p, q) = (T::ONE - xx, T::ONE - yy);
            let (fx, fy) = (Factor::new(p, q), Factor::new(q, p));
            let twist = T::of(-2.0 * B.f64[2]) * (x * y);
            let (ux, uy) = (fx.value - two * xx * (fx.a + fx.c), twist * p * p);
            let (vx, vy) = (twist * q * q, fy.value - two * yy * (fy.a + fy.c));
            let (du, dv) = (u - x * fx.value, v - y * fy.value);
            let [dx, dy] = newton([[ux, uy], [vx, vy]], [du, dv]);
            (x, y) = (x + dx, y + dy);
        });
        [x.signed_like(u), y.signed_like(v)]
    }

    #[inline(always)]
    fn inverse<T: Real>(&self, _: Face, [x, y]: [T; 2]) -> [T; 3] {
        let (p, q) = (T::ONE - x * x, T::ONE - y * y);
        from_gnomonic([x * Factor::new(p, q).value, y * Factor::new(q, p).value])
    }
}
