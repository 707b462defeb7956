use super::decay::creased;
use super::profile::{Kept, projection};
use super::{CubeProjection, Face};
use crate::Real;
use crate::math::{QUAD_COS, QUAD_M, QUAD_SIN, max, min, odd_unit, select};

projection! {
    #[doc(alias = "QSC")]
    Quadrilateralized "quadrilateralized" {
        title: "Quadrilateralized",
        also: "QSC, Snyder’s cube",
        summary: "The quadrilateralized spherical cube, QSC: equal-area, with creases along the diagonals \
            of the faces.",
        idea: "The diagonals of a face cut it into four triangles. In each triangle, the area swept around \
            the centre of the face and the area outward from it stay in proportion, so that all cells have \
            the same area. The price is a crease along both diagonals: a line that crosses one bends there, \
            by more than 20° at the worst.",
        origin: "O’Neill & Laubscher (1976), after Chan & O’Neill (1975); the same map as those of Snyder \
            (1992) and of Roşca & Plonka (2011); QSC of the FITS standard and of PROJ; Dimitrijević, \
            Lambers & Rančić (2016), §4.5.",
        choose: "Take it for equal areas where data has to agree with PROJ or FITS. \
            [`Vertex`](super::Vertex) has equal areas with less distortion (ω 20.3° instead of 25.2°, aspect \
            ratio 2.035 instead of 2.370) and creases of at most 5°.",
        keeps: Some(Kept::Areas),
        area_ratio: 1.000,
        aspect_ratio: 2.370,
        oversize: 2.370,
        deformation: 25.2,
        forward: Polynomial, error [6.0e-16, 3.2e-7], instructions [160, 140];
        inverse: Polynomial, error [4.8e-16, 2.6e-7], instructions [120, 100];
        tiles: creased(0.285, 1.38),
    }
}

// With (X, Y) the longer and the shorter of a unit vector's right and up, and Q = √(2X² + Y²), the longer
// coordinate is √(Q(Q + X)/(1 + Z)), and the shorter is less by the factor m = 12/π·asin(Y/(√2(Q + X))).
// Back, (p, q) = √2(cos(πm/12), sin(πm/12)) − (1, 0) is along (X, Y), and X/Z is p/(1 − p) on the edge.
// Nothing cancels anywhere.
impl CubeProjection for Quadrilateralized {
    const KEEPS_AREAS: bool = true;

    #[inline(always)]
    fn forward<T: Real>(&self, _: Face, [right, up, outward]: [T; 3]) -> [T; 2] {
        // Of equals right is the larger one, as in the choice below: a derivative tells them apart.
        let (major, minor) = (max(up.abs(), right.abs()), min(right.abs(), up.abs()));
        // Squares of numbers below 1e-154 (1e-19 in f32) vanish: so near the centre is the centre.
        let square = major * major;
        let q = (square + square + minor * minor).sqrt();
        let sum = q + major;
        // The vector's length, which is 1 but for rounding.
        let half = T::of(0.5);
        let length = half + half * (right * right + up * up + outward * outward);
        let long = (q * sum * (T::ONE / (length * (length + outward)))).sqrt();
        // Edges and diagonals stay what they are.
        let long = select(major == outward, T::ONE + long.vanish(), long);
        let w = minor * T::of(2.732_050_807_568_877) / max(sum, T::pick(1e-300, 1e-37));
        let w = select(minor == major, T::ONE + w.vanish(), w);
        let short = long * odd_unit(w, &QUAD_M);
        // Each comparison chooses once: for two selects by one a processor without blends takes a branch.
        let x = select(up.abs() > right.abs(), short, long);
        let y = select(up.abs() == minor, short, long);
        [x.copysign(right), y.copysign(up)]
    }

    #[inline(always)]
    fn inverse<T: Real>(&self, _: Face, [x, y]: [T; 2]) -> [T; 3] {
        let (long, short) = (max(y.abs(), x.abs()), min(x.abs(), y.abs()));
        let m = short / select(long == T::ZERO, T::ONE, long);
        let mm = m * m;
        let inside = T::ONE - mm;
        // (√3 − 1)/2 and 1 less that, each with what its rounding lost.
        let corner = 0.366_025_403_784_438_65;
        let lost = T::pick(-5.335730122e-18, -1.425869795e-08);
        let bend = inside * mm.polynomial(&QUAD_COS);
        let p = T::of(corner) + (bend + lost);
        let q = m * (T::of(corner) + (inside * mm.polynomial(&QUAD_SIN) + lost));
        let scale = T::ONE / (T::of(1.0 - corner) - (bend + T::pick(5.017542111e-17, 1.554362444e-08)));
        // s is the outward component on the edge. There w is 0, so that outward and major agree to the last bit.
        let s = p * scale;
        let w = T::ONE - long * long;
        let outward = s + w * (T::ONE - s);
        let side = long * (T::ONE + w * (T::ONE - (p + p))).sqrt();
        let (major, minor) = (s * side, q * scale * side);
        let right = select(y.abs() > x.abs(), minor, major);
        let up = select(y.abs() == short, minor, major);
        [right.copysign(x), up.copysign(y), outward]
    }
}
