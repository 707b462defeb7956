use super::decay::decay;
use super::profile::{Kept, projection};
use super::{CubeProjection, Face, normalise};
use crate::Real;
use crate::math::conformal::{
    CENTRE_TO_PLANE, CENTRE_TO_SPHERE, TO_PLANE, TO_PLANE_SCALE, TO_PLANE_UNSCALE, TO_SPHERE, TO_SPHERE_SCALE,
};
use crate::math::{Complex, POWER_IM, POWER_RE, ROOT_IM, ROOT_RE, cbrt, select};

projection! {
    Conformal "conformal" {
        title: "Conformal",
        also: "",
        summary: "The conformal cube: it keeps angles everywhere except at the eight corners, where the \
            scale is 0.",
        idea: "Small shapes keep their shape. At each corner, a power series turns the 120° of a face on the \
            sphere into the 90° of a square. Near a corner, the distance from the corner on the face grows \
            with the ¾th power of the distance on the sphere. So a rounding of 1.1e-16 rad on the sphere \
            becomes 1e-12 in x and y there: this is a property of the map, whatever program computes it.",
        origin: "Rančić, Purser & Mesinger (1996), for models of ocean and atmosphere; the MIT general \
            circulation model computes on it.",
        choose: "Take it where angles matter. Cells shrink to nothing at the corners. \
            [`Vertex`](super::Vertex) has cells of equal area, with an angular deformation of at most 20.3°, \
            at less than half of the cost (200 instructions to the cube instead of 550).",
        keeps: Some(Kept::Angles),
        area_ratio: infinite,
        aspect_ratio: 1.000,
        oversize: infinite,
        deformation: 0.0,
        forward: Series, error [5.7e-16, 3.1e-7], instructions [550, 420];
        inverse: Series, error [5.0e-16, 2.7e-7], instructions [500, 400];
        tiles: [decay(0.211, 4, 0.35), decay(0.144, 4, 0.4)],
    }
}

const SQRT_3: f64 = 1.732_050_807_568_877_2;

// About the nearest corner, with w the stereographic coordinate of the sphere (the next corner at 1) and z
// the face's (its edge as unit), z = w^¾·S(w³)/I; the powers are polynomials of one real variable, S and the
// reverse are series.
impl CubeProjection for Conformal {
    #[inline(always)]
    fn forward<T: Real>(&self, _: Face, [right, up, outward]: [T; 3]) -> [T; 2] {
        let steep = up.abs() > right.abs();
        let major = select(steep, up, right).abs();
        let minor = select(steep, right, up).abs();
        // In the corner's 60° sector, w = ρ(1 + ik/√3)·e^(i30°). The differences are exact near the corner;
        // k = −1 is the edge.
        let sector = outward - minor;
        let safe = select(sector == T::ZERO, T::ONE, sector);
        let k = ((outward - major) - (major - minor)) / safe;
        let from_edge = T::of(2.0) * (outward - major) / safe;
        // The length is 1 + excess.
        let excess = T::of(0.5) * (minor * minor + major * major + outward * outward - T::ONE);
        let root_3 = T::of(SQRT_3);
        let rho = sector * T::of(TO_PLANE_SCALE) / (root_3 + (root_3 * excess + (minor + major + outward)));
        let size = (rho * rho.sqrt()).sqrt();
        let bend = size * (k * k.polynomial(&POWER_RE));
        let power = Complex {
            re: size + bend,
            im: size * (from_edge * k.polynomial(&POWER_IM)),
        };
        let w = Complex {
            re: T::ONE,
            im: k * T::of(1.0 / SQRT_3),
        } * (rho * T::of(TO_PLANE_UNSCALE));
        let cube = (w * w * w).times_i();
        let rest = power * (cube * cube.polynomial(&TO_PLANE));
        // 1 − 2z, the large parts first: near the midline their difference is exact.
        let short = (T::ONE - size) - (bend + rest.re);
        let short = select(minor == T::ZERO, short.vanish(), short);
        let long = T::ONE - (power.im + rest.im);
        let [x, y] = select(steep, [short, long], [long, short]);

        // Within 0.35 of the centre its own series keeps the relative precision.
        let zeta = Complex { re: right, im: up } * (T::ONE / (T::ONE + (excess + outward)));
        let square = zeta * zeta;
        let [cx, cy] = (zeta * (square * square).polynomial(&CENTRE_TO_PLANE)).parts();
        let central = zeta.norm() < T::of(0.02);
        [
            select(central, cx.signed_like(right), x.copysign(right)),
            select(central, cy.signed_like(up), y.copysign(up)),
        ]
    }

    #[inline(always)]
    fn inverse<T: Real>(&self, _: Face, [x, y]: [T; 2]) -> [T; 3] {
        let steep = y.abs() > x.abs();
        let half = T::of(0.5);
        let p = half * (T::ONE - select(steep, x, y).abs());
        let q = half * (T::ONE - select(steep, y, x).abs());
        // At the corner p = q = 0, and the product with p settles what the root of 0 is.
        let safe = select(p == T::ZERO, T::ONE, p);
        let t = q / safe;
        let tt = t * t;
        let size = p * cbrt(safe * T::of(TO_SPHERE_SCALE));
        let power = Complex {
            re: size * (T::ONE + tt * tt.polynomial(&ROOT_RE)),
            im: size * (t * tt.polynomial(&ROOT_IM)),
        };
        let z = Complex { re: p, im: q };
        let square = z * z;
        let fourth = square * square;
        let w = power + power * (fourth * fourth.polynomial(&TO_SPHERE));
        // Stereographic projection back, about the corner.
        let two = T::of(2.0);
        let center = two - w.norm();
        let slant = T::of(2.0 * SQRT_3) * w.im;
        let minor = center - T::of(4.0) * w.re;
        let minor = select(p == half, minor.vanish(), minor);
        let edge = center + two * w.re;
        let [right, up] = select(steep, [minor, edge - slant], [edge - slant, minor]);

        let z = Complex { re: x, im: y };
        let square = z * z;
        let zeta = z * (square * square).polynomial(&CENTRE_TO_SPHERE);
        let local = select(
            z.norm() < T::of(0.14),
            [
                (two * zeta.re).signed_like(x),
                (two * zeta.im).signed_like(y),
                T::ONE - zeta.norm(),
            ],
            [right.copysign(x), up.copysign(y), edge + slant],
        );
        normalise(local)
    }
}
