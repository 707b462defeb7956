use super::decay::smooth;
use super::profile::projection;
use super::{CubeProjection, Face, normalise};
use crate::Real;

projection! {
    #[doc(alias = "S2")]
    S2Quadratic "s2-quadratic" {
        title: "S2, quadratic",
        also: "",
        summary: "The quadratic cube of the S2 library: u = x(2 + |x|)/3 in each coordinate.",
        idea: "A parabola on either side of the midline of a face approximates the adjusted cube without a \
            trigonometric function.",
        origin: "The default projection of Google’s S2 library, and so of the spatial indexes of many \
            databases.",
        choose: "Take it to agree with S2, or for speed in both directions. Faces and axes are those of this \
            crate: [`Numbering`](crate::cube::Numbering) converts them to those of S2, and \
            [`Key::s2_leaf`](crate::terrain::Key::s2_leaf) gives S2’s own cell of a direction. \
            [`Algebraic`](super::Algebraic) costs about as much, and its areas vary less (1.268 to 1 instead of \
            2.097 to 1), but its texture oversize is larger (2.712 instead of 2.105).",
        keeps: None,
        area_ratio: 2.097,
        aspect_ratio: 2.081,
        oversize: 2.105,
        deformation: 31.1,
        forward: Algebraic, error [2.8e-16, 1.5e-7], instructions [79, 77];
        inverse: Algebraic, error [2.9e-16, 1.7e-7], instructions [55, 52];
        tiles: smooth(0.88, 1.52),
    }
}

impl CubeProjection for S2Quadratic {
    #[inline(always)]
    fn forward<T: Real>(&self, _: Face, [right, up, outward]: [T; 3]) -> [T; 2] {
        [coordinate(right / outward), coordinate(up / outward)]
    }

    #[inline(always)]
    fn inverse<T: Real>(&self, _: Face, [x, y]: [T; 2]) -> [T; 3] {
        let thrice = |x: T| x * (T::of(2.0) + x.abs());
        normalise([thrice(x), thrice(y), T::of(3.0)])
    }
}

/// √(1 + 3u) − 1 without the difference.
#[inline(always)]
fn coordinate<T: Real>(u: T) -> T {
    let three = T::of(3.0);
    three * u / (T::ONE + (T::ONE + three * u.abs()).sqrt())
}
