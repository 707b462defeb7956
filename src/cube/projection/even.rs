use super::decay::smooth;
use super::edge_keeping::{self, EdgeKeeping};
use super::profile::projection;
use super::{CubeProjection, Face};
use crate::Real;
use crate::math::Polynomial;

projection! {
    Even "even" {
        title: "Even",
        also: "",
        summary: "The even cube: a polynomial map whose areas differ by 1 in 1000, without a crease.",
        idea: "A polynomial with ten coefficients, found by minimax search: of those whose areas differ by at \
            most 1 in 1000, it has the least angular deformation on average. It is smooth on the whole face.",
        origin: "Made for terrella. The least area ratio of a published polynomial is 1.023 (Zucker & Higashi \
            2018).",
        choose: "Take it where areas have to be nearly equal and lines must not bend. For exactly equal areas \
            take [`Creaseless`](super::Creaseless), at three times the cost to the sphere, or \
            [`Vertex`](super::Vertex), which has creases. For the least texture memory take \
            [`Compact`](super::Compact) (texture oversize 1.355 instead of 2.298).",
        keeps: None,
        area_ratio: 1.001,
        aspect_ratio: 2.298,
        oversize: 2.298,
        deformation: 31.1,
        forward: Iteration, error [2.4e-16, 1.3e-7], instructions [400, 290];
        inverse: Algebraic, error [2.7e-16, 1.5e-7], instructions [80, 78];
        tiles: smooth(1.06, 2.24),
    }
}

/// Coefficients of 1, Y, Y², Y³, Y⁴, X, XY³, X²Y, X²Y² and X⁵.
const C: Polynomial<10, 10> = Polynomial::rounded([
    -0.2766, 0.034, -0.1908, 0.4685, -0.1989, -0.0954, 0.0235, -0.2125, 0.1374, -0.0137,
]);

impl EdgeKeeping for Even {
    // The guess is within 2.7e-3. After one, two and three steps of Newton's method the error is at most 7e-6,
    // 4e-11 and 2e-16.
    const START: Polynomial<5, 5> = Polynomial::rounded([0.2082, -0.0184, 0.1168, 0.2047, -0.1406]);

    #[inline(always)]
    fn polynomial<T: Real>(x: T, y: T) -> T {
        let [c00, c01, c02, c03, c04, c10, c13, c21, c22, c50] = T::all(&C);
        let (xx, yy) = (x * x, y * y);
        let free = c00 + c01 * y + yy * (c02 + c03 * y + c04 * yy);
        free + x * (c10 + c13 * (y * yy)) + xx * (y * (c21 + c22 * y) + c50 * (x * xx))
    }

    #[inline(always)]
    fn slopes<T: Real>(x: T, y: T) -> [T; 2] {
        let [_, c01, c02, c03, c04, c10, c13, c21, c22, c50] = T::all(&C);
        let (two, three, four, five) = (T::of(2.0), T::of(3.0), T::of(4.0), T::of(5.0));
        let (xx, yy) = (x * x, y * y);
        [
            c10 + c13 * (y * yy) + two * x * (y * (c21 + c22 * y)) + five * c50 * (xx * xx),
            c01 + two * c02 * y + yy * (three * c03 + four * c04 * y + three * c13 * x) + xx * (c21 + two * c22 * y),
        ]
    }
}

impl CubeProjection for Even {
    #[inline(always)]
    fn forward<T: Real>(&self, _: Face, vector: [T; 3]) -> [T; 2] {
        edge_keeping::forward::<Self, T>(vector)
    }

    #[inline(always)]
    fn inverse<T: Real>(&self, _: Face, point: [T; 2]) -> [T; 3] {
        edge_keeping::inverse::<Self, T>(point)
    }
}
