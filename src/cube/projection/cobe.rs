use super::decay::smooth;
use super::profile::projection;
use super::{CobeExact, CubeProjection, Face, from_gnomonic};
use crate::Real;
use crate::math::Polynomial;

projection! {
    #[doc(alias = "CSC")]
    Cobe "cobe" {
        title: "COBE",
        also: "COBE sky cube, CSC",
        summary: "The COBE sky cube, CSC, as published: one polynomial to the cube, and another to the \
            sphere that is not its exact inverse.",
        idea: "The first polynomial, in the coordinates of the tangential cube, was fitted so that all cells \
            have almost the same area. The second was fitted to lead back. A point that is projected and \
            unprojected is off by up to 2.9e-4.",
        origin: "The sky maps of NASA’s Cosmic Background Explorer (1989 to 1993), after Chan & O’Neill \
            (1975); CSC of the FITS standard, Calabretta & Greisen (2002), §5.6.2; Dimitrijević, Lambers & \
            Rančić (2016), §4.4. The distortion is that of the published polynomial to the sphere.",
        choose: "Take it to read and write COBE data. [`CobeExact`](super::CobeExact) has the same \
            polynomial to the cube and leads back to the same point, for 720 instructions instead of 130. \
            For exactly equal areas take [`Quadrilateralized`](super::Quadrilateralized) or \
            [`Vertex`](super::Vertex).",
        keeps: None,
        area_ratio: 1.221,
        aspect_ratio: 2.366,
        oversize: 2.366,
        deformation: 31.1,
        forward: Polynomial, error [2.0e-16, 1.0e-7], instructions [110, 110];
        inverse: Polynomial, error [2.8e-16, 1.5e-7], instructions [130, 130];
        tiles: smooth(1.87, 9.30),
    }
}

/// Pᵢⱼ of the published inverse u = x + x(1 − x²)ΣPᵢⱼx²ⁱy²ʲ: row j, column i.
const P: [Polynomial<7, 7>; 7] = [
    Polynomial::rounded([
        -0.27292696, -0.07629969, -0.22797056, 0.54852384, -0.62930065, 0.25795794, 0.02584375,
    ]),
    Polynomial::rounded([
        -0.02819452, -0.01471565, 0.48051509, -1.74114454, 1.71547508, -0.53022337, 0.0,
    ]),
    Polynomial::rounded([0.27058160, -0.56800938, 0.30803317, 0.98938102, -0.83180469, 0.0, 0.0]),
    Polynomial::rounded([-0.60441560, 1.50880086, -0.93678576, 0.08693841, 0.0, 0.0, 0.0]),
    Polynomial::rounded([0.93412077, -1.41601920, 0.33887446, 0.0, 0.0, 0.0, 0.0]),
    Polynomial::rounded([-0.63915306, 0.52032238, 0.0, 0.0, 0.0, 0.0, 0.0]),
    Polynomial::rounded([0.14381585, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0]),
];

impl CubeProjection for Cobe {
    #[inline(always)]
    fn forward<T: Real>(&self, face: Face, local: [T; 3]) -> [T; 2] {
        CobeExact.forward(face, local)
    }

    #[inline(always)]
    fn inverse<T: Real>(&self, _: Face, [x, y]: [T; 2]) -> [T; 3] {
        let half = |x: T, y: T| {
            let (xx, yy) = (x * x, y * y);
            let mut sum = T::ZERO;
            for row in P.iter().rev() {
                let mut inner = T::ZERO;
                for c in T::all(row).into_iter().rev() {
                    inner = inner * xx + c;
                }
                sum = sum * yy + inner;
            }
            (x + x * (T::ONE - xx) * sum).signed_like(x)
        };
        from_gnomonic([half(x, y), half(y, x)])
    }
}
