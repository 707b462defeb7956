use super::decay::smooth;
use super::profile::{Kept, projection};
use super::{CubeProjection, Face, from_gnomonic};
use crate::Real;

projection! {
    #[doc(alias = "gnomonic")]
    #[doc(alias = "TSC")]
    Tangential "tangential" {
        title: "Tangential",
        also: "gnomonic cube, TSC",
        summary: "The tangential (gnomonic) cube, TSC: x = u, where u is a coordinate of the point on the \
            circumscribed cube.",
        idea: "A ray from the centre of the sphere carries each point straight onto a cube around it. Great \
            circles become straight lines. A cell in the middle of a face covers five times the area of a \
            cell in a corner.",
        origin: "It is the cube map of graphics hardware and TSC of the FITS standard; Dimitrijević, \
            Lambers & Rančić (2016), §4.1.",
        choose: "Take it where great circles must be straight lines, or where cost counts most: it is the \
            cheapest projection. Where cells should be of similar size, take \
            [`S2Quadratic`](super::S2Quadratic) (areas vary 2.097 to 1 instead of 5.196 to 1) or \
            [`Adjusted`](super::Adjusted) (1.414 to 1).",
        keeps: Some(Kept::GreatCircles),
        area_ratio: 5.196,
        aspect_ratio: 2.000,
        oversize: 4.500,
        deformation: 31.1,
        forward: Algebraic, error [1.2e-16, 6.0e-8], instructions [70, 67];
        inverse: Algebraic, error [2.7e-16, 1.5e-7], instructions [41, 39];
        tiles: smooth(1.27, 1.85),
    }
}

impl CubeProjection for Tangential {
    #[inline(always)]
    fn forward<T: Real>(&self, _: Face, [right, up, outward]: [T; 3]) -> [T; 2] {
        [right / outward, up / outward]
    }

    #[inline(always)]
    fn inverse<T: Real>(&self, _: Face, point: [T; 2]) -> [T; 3] {
        from_gnomonic(point)
    }
}
