use super::decay::smooth;
use super::profile::projection;
use super::{CubeProjection, Face, from_gnomonic, newton};
use crate::Real;
use crate::math::{Polynomial, repeat};

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
            [`Balanced`](super::Balanced) (texture oversize 1.405 instead of 2.298).",
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

/// Coefficients of 1, Y, Y², Y³, Y⁴, X, XY³, X²Y, X²Y² and X⁵, where X = x² and Y = y².
const C: Polynomial<10, 10> = Polynomial::rounded([
    -0.2766, 0.034, -0.1908, 0.4685, -0.1989, -0.0954, 0.0235, -0.2125, 0.1374, -0.0137,
]);

/// Coefficients of 1 − u² and 1 − v² in a first guess at x/u, fitted for the least largest error.
const START: Polynomial<5, 5> = Polynomial::rounded([0.2082, -0.0184, 0.1168, 0.2047, -0.1406]);

/// The polynomial P of X and Y.
#[inline(always)]
fn polynomial<T: Real>(x: T, y: T) -> T {
    let [c00, c01, c02, c03, c04, c10, c13, c21, c22, c50] = T::all(&C);
    let (xx, yy) = (x * x, y * y);
    let free = c00 + c01 * y + yy * (c02 + c03 * y + c04 * yy);
    free + x * (c10 + c13 * (y * yy)) + xx * (y * (c21 + c22 * y) + c50 * (x * xx))
}

/// Its derivatives by X and by Y.
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

impl CubeProjection for Even {
    #[inline(always)]
    fn forward<T: Real>(&self, _: Face, [right, up, outward]: [T; 3]) -> [T; 2] {
        let (u, v) = (right / outward, up / outward);
        let (pu, pv) = (T::ONE - u * u, T::ONE - v * v);
        let two = T::of(2.0);
        // The guess is within 2.7e-3. After one, two and three steps of Newton's method the error is at most
        // 7e-6, 4e-11 and 2e-16.
        let [c00, c10, c01, c11, c02] = T::all(&START);
        let start = |w: T, p: T, q: T| w * (T::ONE + p * (c00 + c10 * p + q * (c01 + c11 * p + c02 * q)));
        let (mut x, mut y) = (start(u, pu, pv), start(v, pv, pu));
        repeat!(T::steps(3, 2), {
            let (xx, yy) = (x * x, y * y);
            let (p, q) = (T::ONE - xx, T::ONE - yy);
            let (a, b) = (polynomial(xx, yy), polynomial(yy, xx));
            let ([ax, ay], [by, bx]) = (slopes(xx, yy), slopes(yy, xx));
            let (fx, fy) = (T::ONE + p * a, T::ONE + q * b);
            let twist = two * (x * y);
            let (ux, uy) = (fx + two * xx * (p * ax - a), twist * p * ay);
            let (vx, vy) = (twist * q * bx, fy + two * yy * (q * by - b));
            let (du, dv) = (u - x * fx, v - y * fy);
            let [dx, dy] = newton([[ux, uy], [vx, vy]], [du, dv]);
            (x, y) = (x + dx, y + dy);
        });
        [x.signed_like(u), y.signed_like(v)]
    }

    #[inline(always)]
    fn inverse<T: Real>(&self, _: Face, [x, y]: [T; 2]) -> [T; 3] {
        let (xx, yy) = (x * x, y * y);
        let u = x * (T::ONE + (T::ONE - xx) * polynomial(xx, yy));
        let v = y * (T::ONE + (T::ONE - yy) * polynomial(yy, xx));
        from_gnomonic([u, v])
    }
}
