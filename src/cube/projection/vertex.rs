use super::decay::creased;
use super::profile::{Kept, projection};
use super::{CubeProjection, Face, normalise};
use crate::Real;
use crate::math::{VERTEX_T, VERTEX_TAU, select};

projection! {
    Vertex "vertex" {
        title: "Vertex",
        also: "vertex-oriented equal-area cube",
        summary: "The vertex equal-area cube: equal-area in closed form both ways, with small creases.",
        idea: "It is made like the quadrilateralized cube, but its triangles are sliced from the corners of \
            the cube instead of the centres of the faces. All cells have the same area. A line bends by at \
            most 5° where it crosses from one triangle to another (a crease).",
        origin: "The slice-and-dice method of van Leeuwen & Strebe (2006), applied to the 48 triangles of \
            the cube.",
        choose: "Take it for equal areas: no other projection here has them with less distortion. Where \
            areas may vary, [`Balanced`](super::Balanced) has less texture oversize (1.405 instead of 2.035) \
            and costs less to the sphere (63 instructions instead of 180).",
        keeps: Some(Kept::Areas),
        area_ratio: 1.000,
        aspect_ratio: 2.035,
        oversize: 2.035,
        deformation: 20.3,
        forward: Polynomial, error [5.0e-16, 2.7e-7], instructions [200, 180];
        inverse: Polynomial, error [4.2e-16, 2.4e-7], instructions [180, 160];
        tiles: creased(0.199, 0.58),
    }
}

const SQRT_3: f64 = 1.732_050_807_568_877_2;
const TAN_PI_8: f64 = core::f64::consts::SQRT_2 - 1.0;

// In the octant 0 ≤ y ≤ x: a great circle from the corner V through the point P meets the midline at D;
// r = |VP|/|VD| (chords) is 1 − y, and t is the share of the triangle's area on the midline's side of VD.
impl CubeProjection for Vertex {
    const KEEPS_AREAS: bool = true;

    #[inline(always)]
    fn forward<T: Real>(&self, _: Face, [right, up, outward]: [T; 3]) -> [T; 2] {
        let steep = up.abs() > right.abs();
        let x = select(steep, up, right).abs();
        let y = select(steep, right, up).abs();
        let z = outward;
        // D is along (x − y, 0, z − y): the same differences as in |V × P|, exact near the corner.
        let (dx, dz) = (x - y, z - y);
        let d = dx / select(dz == T::ZERO, T::ONE, dz);
        let tau = d * T::of(1.0 + core::f64::consts::SQRT_2) / (T::ONE + (T::ONE + d * d).sqrt());
        let t = unit(tau, tau.polynomial(&VERTEX_T));

        // 1 − V·P = |V × P|²/(ρ(ρ + S/√3)) with ρ the length, S the sum of components; |V × P| = |V × D|.
        let third = T::of(1.0 / SQRT_3);
        let rho = (x * x + y * y + z * z).sqrt();
        let rho_d = (dx * dx + dz * dz).sqrt();
        let s_d = dx + dz;
        let above = rho * (rho + (x + y + z) * third);
        let r = (rho_d * (rho_d + s_d * third) / above).sqrt();
        // y = 1 − r from 1 − r², every term of which has the factor y.
        let w = T::of(2.0) * (x + z) - y;
        let rest = w + (T::of(3.0) * rho + s_d * w / (rho + rho_d)) * third;
        // Each coordinate as what has the smaller error: near the corner as its distance from 1.
        let half = T::of(0.5);
        let short = select(r < half, T::ONE - r, y * rest / (above * (T::ONE + r)));
        let long = select(t > half, T::ONE - r * (T::ONE - t), short + r * t);
        let [a, b] = select(steep, [short, long], [long, short]);
        [a.copysign(right), b.copysign(up)]
    }

    #[inline(always)]
    fn inverse<T: Real>(&self, _: Face, [px, py]: [T; 2]) -> [T; 3] {
        let steep = py.abs() > px.abs();
        let x = select(steep, py, px).abs();
        let y = select(steep, px, py).abs();
        let r = T::ONE - y;
        let t = (x - y) / select(r == T::ZERO, T::ONE, r);
        let tau = unit(t, t.polynomial(&VERTEX_TAU));
        // tan ξ from tan(ξ/2)/tan(π/8), exact at the edge; D = (sin ξ, 0, cos ξ).
        let beside = T::ONE + T::of(TAN_PI_8 / 2.0) * (T::ONE - tau * tau);
        let inverse = T::ONE / (tau * tau + beside * beside).sqrt();
        let (sin, cos) = (tau * inverse, beside * inverse);

        let third = T::of(1.0 / SQRT_3);
        let g = T::ONE - (sin + cos) * third;
        let h = r * r * g;
        let below = T::of(2.0) - g;
        let root = (below * (T::of(2.0) - h)).sqrt();
        let sum = below + root;
        let shared = T::ONE / (below * sum);
        // P = κD + cV, and c has the factor y.
        let kappa = r * (root * (sum * shared));
        let bend = r * (T::ONE - g) * g * (T::ONE + r) * (below * shared);
        let c = third * y * (T::ONE + r * g - bend);
        let long = kappa * sin + c;
        let [a, b] = select(steep, [c, long], [long, c]);
        normalise([a.copysign(px), b.copysign(py), kappa * cos + c])
    }
}

/// A function that fixes 0 and 1, from the polynomial p in f(x) = x + x(1 − x)p(x).
#[inline(always)]
fn unit<T: Real>(x: T, p: T) -> T {
    x + x * (T::ONE - x) * p
}
