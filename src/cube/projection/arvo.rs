use super::decay::smooth;
use super::profile::{Kept, projection};
use super::{CubeProjection, Face, Faces, from_gnomonic};
use crate::Real;
use crate::math::{UNICUBE_U, UNICUBE_X, odd_unit};

projection! {
    Arvo "arvo" {
        title: "Arvo",
        also: "",
        summary: "Arvo’s equal-area cube, smooth inside the faces, which disagree along four of the twelve \
            edges.",
        idea: "The area of the face from x = 0 to x is in proportion to x, which is that of the unicube; \
            between two near lines of equal x the area is in proportion to y. So areas are kept, in closed \
            form and without a crease inside a face. But x and y differ, and an edge that is x = ±1 on one \
            face and y = ±1 on the next is divided in two ways. Here those are the four between the top or \
            bottom and the left or right face; no way of turning the faces leaves none.",
        origin: "Arvo, Stratified sampling of 2-manifolds (SIGGRAPH 2001 course notes), for one face; on the \
            cube in Zucker & Higashi (2018).",
        choose: "Take it to spread samples evenly over the sphere. For tiles and textures, which must meet \
            along edges, take [`Vertex`](super::Vertex): its areas are equal too, its faces agree, and it \
            has less distortion (ω 20.3° instead of 36.4°).",
        keeps: Some(Kept::Areas),
        area_ratio: 1.000,
        aspect_ratio: 3.000,
        oversize: 3.000,
        deformation: 36.4,
        forward: Polynomial, error [3.7e-16, 2.0e-7], instructions [130, 120];
        inverse: Polynomial, error [2.6e-16, 1.4e-7], instructions [100, 89];
        tiles: smooth(1.035, 1.67),
    }
}

// In the paper u = √2·t/√(1 − t²) with t = tan(πx/6): that is the unicube’s u. And cos(πx/3) is 1/(1 + u²).
impl CubeProjection for Arvo {
    const KEEPS_AREAS: bool = true;

    #[inline(always)]
    fn faces(&self) -> Faces {
        Faces::Apart
    }

    #[inline(always)]
    fn forward<T: Real>(&self, _: Face, [right, up, outward]: [T; 3]) -> [T; 2] {
        let (u, v) = (right / outward, up / outward);
        let w = T::ONE + u * u;
        [odd_unit(u, &UNICUBE_X), v * ((w + T::ONE) / (w + v * v)).sqrt()]
    }

    #[inline(always)]
    fn inverse<T: Real>(&self, _: Face, [x, y]: [T; 2]) -> [T; 3] {
        let u = odd_unit(x, &UNICUBE_U);
        let w = T::ONE + u * u;
        from_gnomonic([u, y * (w / (w + (T::ONE - y * y))).sqrt()])
    }
}
