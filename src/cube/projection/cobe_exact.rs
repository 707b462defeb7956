use super::decay::smooth;
use super::profile::projection;
use super::{CubeProjection, Face, QuadCube};
use crate::Real;

projection! {
    CobeExact "cobe-exact" {
        title: "COBE, exact",
        also: "",
        summary: "The COBE sky cube with the exact inverse of its published forward polynomial.",
        idea: "The polynomial to the cube is COBE’s. To the sphere, Newton’s method solves that same \
            polynomial, so that a point that is projected and unprojected comes back to its place.",
        origin: "COBE’s published polynomial.",
        choose: "Take it for COBE’s cells where a round trip must be exact; [`Cobe`](super::Cobe) has the \
            published polynomial to the sphere. [`CobeRefit`](super::CobeRefit) has areas that vary less \
            (1.023 to 1 instead of 1.230 to 1). For nearly equal areas at less cost take \
            [`Algebraic`](super::Algebraic) (areas vary 1.268 to 1; 50 instructions to the sphere instead of \
            720).",
        keeps: None,
        area_ratio: 1.230,
        aspect_ratio: 2.383,
        oversize: 2.383,
        deformation: 31.1,
        forward: Polynomial, error [2.0e-16, 1.0e-7], instructions [110, 110];
        inverse: Iteration, error [2.8e-16, 1.5e-7], instructions [720, 600];
        tiles: smooth(2.24, 17.6),
    }
}

impl CubeProjection for CobeExact {
    #[inline(always)]
    fn forward<T: Real>(&self, face: Face, local: [T; 3]) -> [T; 2] {
        QuadCube::COBE.forward(face, local)
    }

    #[inline(always)]
    fn inverse<T: Real>(&self, face: Face, point: [T; 2]) -> [T; 3] {
        QuadCube::COBE.inverse(face, point)
    }
}
