use super::decay::smooth;
use super::profile::projection;
use super::{CubeProjection, Face, QuadCube, from_gnomonic};
use crate::Real;
use crate::math::Polynomial;

projection! {
    CobeRefit "cobe-refit" {
        title: "COBE, refitted",
        also: "",
        summary: "Zucker & Higashi’s refit of COBE’s polynomial, with areas within 2.3 %.",
        idea: "The polynomial to the sphere has COBE’s form and six coefficients, fitted so that all cells \
            have almost the same area, without a crease. To the cube, Newton’s method solves that polynomial; \
            it starts from the one that was fitted to lead back, which misses by up to 1.7e-3.",
        origin: "Zucker & Higashi, Cube-to-sphere projections for procedural texturing and beyond (Journal of \
            Computer Graphics Techniques 7(2), 2018), after COBE’s. Their polynomial to the sphere is the \
            map; their second one is only a start here.",
        choose: "Take it for areas that are nearly equal (1.023 to 1) without a crease, at a low cost to the \
            sphere. For exactly equal areas take [`Vertex`](super::Vertex), which has less distortion too (ω \
            20.3° instead of 31.1°) and small creases; where areas may vary more, \
            [`Balanced`](super::Balanced) has less texture oversize (1.405 instead of 2.817).",
        keeps: None,
        area_ratio: 1.023,
        aspect_ratio: 2.817,
        oversize: 2.817,
        deformation: 31.1,
        forward: Iteration, error [2.0e-16, 1.1e-7], instructions [390, 290];
        inverse: Polynomial, error [2.6e-16, 1.4e-7], instructions [80, 78];
        tiles: smooth(0.906, 1.236),
    }
}

/// (α + (1 − α)x² + (1 − x²)((a + by² + cx²)x² + (d + ey²)y²))x of the paper, in COBE's form.
const fn refit([alpha, a, b, c, d, e]: [f64; 6]) -> QuadCube {
    QuadCube(Polynomial::rounded([
        alpha,
        d + e + b,
        d + e,
        a + c,
        -e,
        0.0,
        0.0,
        0.0,
        0.0,
        0.0,
        c,
        0.0,
    ]))
}

const TO_SPHERE: QuadCube = refit([
    0.723_951_234_952, -0.094_118_008_582_4, 0.040_912_598_118_7, -0.062_327_269_088_1, 0.027_592_248_090_2,
    0.034_221_702_697_9,
]);

const TO_CUBE: QuadCube = refit([
    1.377_381_983_85, -0.212_853_382_041, 0.094_125_968_487_7, 0.069_353_268_533_3, -0.117_847_692_949,
    0.010_798_919_718_1,
]);

impl CubeProjection for CobeRefit {
    #[inline(always)]
    fn forward<T: Real>(&self, _: Face, [right, up, outward]: [T; 3]) -> [T; 2] {
        let point = [right / outward, up / outward];
        TO_SPHERE.solve(point, TO_CUBE.apply(point.map(T::plain)), [3, 2])
    }

    #[inline(always)]
    fn inverse<T: Real>(&self, _: Face, point: [T; 2]) -> [T; 3] {
        from_gnomonic(TO_SPHERE.apply(point))
    }
}
