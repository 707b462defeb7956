use super::decay::smooth;
use super::profile::projection;
use super::{CubeProjection, Face, Faces, at_edge, from_gnomonic};
use crate::Real;
use crate::math::{atan2_eighth, tan};

projection! {
    Continuous "continuous" {
        title: "Continuous",
        also: "continuous cube mapping",
        summary: "The continuous cube: u = √2·tan(x·atan √½), and y in proportion to the angle along the \
            great circle of each x.",
        idea: "A line of equal x on a face is a great circle at right angles to the midline y = 0. Equal \
            steps of y on it are equal angles at the centre of the sphere, and so are equal steps of x along \
            the edges y = ±1. So x and y differ. All edges are divided alike, and faces agree there, whichever \
            way their x is.",
        origin: "Grimm & Niebruegge, Continuous cube mapping (Journal of Graphics Tools 12(4), 2007), for \
            environment maps; compared in Lambers’ survey of cube maps (2019).",
        choose: "Of the published projections here it has the least texture oversize (1.805). Take \
            [`Balanced`](super::Balanced) unless you need this one: its texture oversize is 1.405, its areas \
            vary less (1.488 to 1 instead of 2.084 to 1), x and y are alike, and it costs less.",
        keeps: None,
        area_ratio: 2.084,
        aspect_ratio: 1.414,
        oversize: 1.805,
        deformation: 31.1,
        forward: Trigonometric, error [3.9e-16, 2.1e-7], instructions [320, 280];
        inverse: Trigonometric, error [3.1e-16, 1.8e-7], instructions [250, 180];
        tiles: smooth(0.88, 0.78),
    }
}

// β is the angle from the equator of the face, y = 0, to the edge y = 1: tan β = 1/√(1 + u²). At u = 1 it is
// atan √½, and what is computed there is what y = 1 has for x, to the last bit: faces agree.
impl CubeProjection for Continuous {
    #[inline(always)]
    fn faces(&self) -> Faces {
        Faces::Oblong
    }

    #[inline(always)]
    fn forward<T: Real>(&self, _: Face, [right, up, outward]: [T; 3]) -> [T; 2] {
        let slope = T::of(0.5).sqrt();
        // √½ of the distance from the axis of y: outward where right is.
        let middle = ((right * right + outward * outward) * T::of(0.5)).sqrt();
        let across = atan2_eighth(right * slope, outward) / atan2_eighth(slope, T::ONE);
        let along = atan2_eighth(up * slope, middle) / atan2_eighth(slope, middle / outward);
        [at_edge(across, right, outward), at_edge(along, up, outward)]
    }

    #[inline(always)]
    fn inverse<T: Real>(&self, _: Face, [x, y]: [T; 2]) -> [T; 3] {
        let slope = T::of(0.5).sqrt();
        let share = atan2_eighth(slope, T::ONE);
        let u = tan(x * share) / tan(share);
        let beta = atan2_eighth(slope, ((u * u + T::ONE) * T::of(0.5)).sqrt());
        from_gnomonic([u, tan(y * beta) / tan(beta)])
    }
}
