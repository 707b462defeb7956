use super::decay::smooth;
use super::profile::projection;
use super::{CubeProjection, Face, from_gnomonic};
use crate::Real;

projection! {
    Everitt "everitt" {
        title: "Everitt",
        also: "",
        summary: "Everitt’s cube: x = u(11 − 3|u|)/8 in each coordinate.",
        idea: "A parabola on either side of the midline of a face approximates the adjusted cube, as in S2. \
            Here the parabola leads from the sphere to the cube, so that this way takes no square root.",
        origin: "Everitt (2014), Projection cube maps, with e = 1.375.",
        choose: "Take it to agree with textures that were made with it. At about the same cost, \
            [`S2Quadratic`](super::S2Quadratic) has less texture oversize (2.105 instead of 2.420), and \
            [`Algebraic`](super::Algebraic) has areas that vary less (1.268 to 1 instead of 1.446 to 1).",
        keeps: None,
        area_ratio: 1.446,
        aspect_ratio: 2.420,
        oversize: 2.420,
        deformation: 31.1,
        forward: Algebraic, error [2.9e-16, 1.6e-7], instructions [73, 71];
        inverse: Algebraic, error [2.9e-16, 1.6e-7], instructions [49, 47];
        tiles: smooth(0.83, 0.96),
    }
}

const E: f64 = 1.375;

impl CubeProjection for Everitt {
    #[inline(always)]
    fn forward<T: Real>(&self, _: Face, [right, up, outward]: [T; 3]) -> [T; 2] {
        let coordinate = |u: T| u * (T::of(E) - T::of(E - 1.0) * u.abs());
        [coordinate(right / outward), coordinate(up / outward)]
    }

    #[inline(always)]
    fn inverse<T: Real>(&self, _: Face, [x, y]: [T; 2]) -> [T; 3] {
        // The smaller root, without the difference.
        let gnomonic = |x: T| {
            let discriminant = T::of(E * E) - T::of(4.0 * (E - 1.0)) * x.abs();
            x * T::of(2.0) / (T::of(E) + discriminant.sqrt())
        };
        from_gnomonic([gnomonic(x), gnomonic(y)])
    }
}
