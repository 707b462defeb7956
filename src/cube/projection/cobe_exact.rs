use super::decay::smooth;
use super::profile::projection;
use super::{CubeProjection, Face, QuadCube};
use crate::Real;

projection! {
    CobeExact "cobe-exact" {
        title: "COBE, exact",
        also: "",
        summary: "The COBE sky cube with the exact inverse of its published forward polynomial.",
        idea: "COBE’s polynomial from the sphere to the cube. The way back solves that same polynomial by \
            Newton’s method, so that forth and back is the same point.",
        origin: "COBE’s published polynomial.",
        choose: "[`Cobe`](super::Cobe) has the published way back. Take it for COBE’s cells without its gap between the two directions. For nearly equal \
            areas at less cost, take [`Algebraic`](super::Algebraic).",
        keeps: None,
        area_ratio: 1.230,
        aspect_ratio: 2.383,
        oversize: 2.383,
        deformation: 31.1,
        forward: Polynomial, error [2.0e-16, 1.0e-7], instructions [110, 110];
        inverse: Iteration, error [2.8e-16, 1.5e-7], instructions [730, 600];
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
