use super::decay::smooth;
use super::profile::projection;
use super::{CubeProjection, Face, Faces, at_edge, from_gnomonic};
use crate::Real;
use crate::math::{ADJUSTED_U, ADJUSTED_X, odd_unit, select};

projection! {
    #[doc(alias = "HEC")]
    HybridEquiAngular "hybrid-equi-angular" {
        title: "Hybrid equi-angular",
        also: "hybrid equi-angular cubemap, HEC",
        summary: "The hybrid equi-angular cube of video coding, HEC: x = 4/π·atan u, and on the side faces v \
            = y/(1 + 0.4(1 − x²)(1 − y²)).",
        idea: "The top and the bottom are those of the adjusted cube. On a side face x is too, and lines of \
            equal y are nearer to parallels. Along all edges the faces agree. The areas of a side face alone \
            vary by 1.875 to 1.",
        origin: "Proposed for panoramic video in H.266 (VVC): HEC of the reference software 360Lib; a \
            member of the generalized cubemap of H.274. Without the padding that 360Lib adds to faces.",
        choose: "Take it to read and write video that was made with it. [`Balanced`](super::Balanced) has \
            less texture oversize (1.405 instead of 2.546) and less distortion (ω 31.1° instead of 40.7°).",
        keeps: None,
        area_ratio: 2.041,
        aspect_ratio: 2.546,
        oversize: 2.546,
        deformation: 40.7,
        forward: Polynomial, error [1.9e-16, 1.0e-7], instructions [180, 150];
        inverse: Polynomial, error [2.6e-16, 1.4e-7], instructions [120, 88];
        tiles: smooth(0.79, 1.5),
    }
}

impl CubeProjection for HybridEquiAngular {
    #[inline(always)]
    fn faces(&self) -> Faces {
        Faces::SideAndPolar
    }

    #[inline(always)]
    fn forward<T: Real>(&self, face: Face, [right, up, outward]: [T; 3]) -> [T; 2] {
        let (one, two) = (T::ONE, T::of(2.0));
        let (u, v) = (right / outward, up / outward);
        let x = odd_unit(u, &ADJUSTED_X);
        // v(1 + a(1 − y²)) = y, solved without a difference: y = s(v + va). The form y = v + sva(1 − vy) rounds
        // once where a or 1 − v is small.
        let a = T::of(0.4) * (one - x * x);
        let high = v * (one + a);
        let s = two / (one + (one + T::of(4.0) * a * v * high).sqrt());
        let y = at_edge(v + s * v * a * (one - v * (s * high)), up, outward);
        [x, select(face.is_polar(), odd_unit(v, &ADJUSTED_X), y)]
    }

    #[inline(always)]
    fn inverse<T: Real>(&self, face: Face, [x, y]: [T; 2]) -> [T; 3] {
        let one = T::ONE;
        let v = y / (one + T::of(0.4) * ((one - x * x) * (one - y * y)));
        let along = |x: T| odd_unit(x, &ADJUSTED_U);
        from_gnomonic([along(x), select(face.is_polar(), along(y), v)])
    }
}
