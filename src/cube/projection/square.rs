use super::decay::smooth;
use super::profile::projection;
use super::{CubeProjection, Face, newton, normalise};
use crate::Real;
use crate::math::{Polynomial, repeat};

projection! {
    Square "square" {
        title: "Square",
        also: "",
        summary: "The square cube: texels as square as Outerra’s, with areas that vary less.",
        idea: "A polynomial map: the point (x, y) of a face has the direction (x·A(x, y), y·A(y, x), Z(x, \
            y)). The coefficients of A and Z were found by minimax search.",
        origin: "Made for terrella.",
        choose: "Take it for square texels: aspect ratio 1.013. For the least texture memory take \
            [`Balanced`](super::Balanced) (texture oversize 1.405 instead of 1.889, aspect ratio 1.403).",
        keeps: None,
        area_ratio: 2.229,
        aspect_ratio: 1.013,
        oversize: 1.889,
        deformation: 33.5,
        forward: Iteration, error [3.3e-16, 1.8e-7], instructions [360, 270];
        inverse: Algebraic, error [3.1e-16, 1.7e-7], instructions [89, 81];
        tiles: smooth(0.88, 2.28),
    }
}

const B02: f64 = -0.144_667_241_461_084_73;
const Z20: f64 = -0.047_355_554_762_899_11;
const Z21: f64 = 0.125_761_176_467_546_37;

/// Coefficients of 1 − u² and 1 − v² in a first guess at x/u, fitted for the least largest error.
const START: Polynomial<5, 5> = Polynomial::rounded([0.131_059, -0.025_651, -0.302_118, 0.126_894, 0.268_585]);

/// A, A with x and y exchanged, and Z, at p = 1 − x², q = 1 − y².
#[inline(always)]
fn factors<T: Real>([xx, yy]: [T; 2], [p, q]: [T; 2]) -> [T; 3] {
    let (b02, z20, z21) = (T::of(B02), T::of(Z20), T::of(Z21));
    // On an edge, where p or q is 0, Z is the same sum as the A of the coordinate across it.
    [
        T::ONE + (b02 * (p * (yy * yy)) + z20 * (q * q)),
        T::ONE + (b02 * (q * (xx * xx)) + z20 * (p * p)),
        T::ONE + (z20 * (p * p + q * q) + z21 * (p * q * (p + q))),
    ]
}

impl CubeProjection for Square {
    #[inline(always)]
    fn forward<T: Real>(&self, _: Face, [right, up, outward]: [T; 3]) -> [T; 2] {
        let (u, v) = (right / outward, up / outward);
        let (b02, z20, z21) = (T::of(B02), T::of(Z20), T::of(Z21));
        let (two, four) = (T::of(2.0), T::of(4.0));
        let (pu, pv) = (T::ONE - u * u, T::ONE - v * v);
        // The guess is within 2.1e-3. After one, two, three steps of Newton's method the error is at most
        // 2e-6, 2e-12, 4e-16.
        let [c00, c10, c01, c11, c02] = T::all(&START);
        let start = |w: T, p: T, q: T| w * (T::ONE + p * (c00 + c10 * p + q * (c01 + c11 * p + c02 * q)));
        let (mut x, mut y) = (start(u, pu, pv), start(v, pv, pu));
        repeat!(T::steps(3, 2), {
            let (xx, yy) = (x * x, y * y);
            let (p, q) = (T::ONE - xx, T::ONE - yy);
            let [a, b, z] = factors([xx, yy], [p, q]);
            // Newton's method on x·A − u·Z = 0, y·B − v·Z = 0.
            let zx = -two * x * (two * z20 * p + z21 * q * (two * p + q));
            let zy = -two * y * (two * z20 * q + z21 * p * (two * q + p));
            let gx = a - two * b02 * xx * (yy * yy) - u * zx;
            let gy = four * x * y * (b02 * p * yy - z20 * q) - u * zy;
            let hx = four * x * y * (b02 * q * xx - z20 * p) - v * zx;
            let hy = b - two * b02 * yy * (xx * xx) - v * zy;
            let (g, h) = (x * a - u * z, y * b - v * z);
            let [dx, dy] = newton([[gx, gy], [hx, hy]], [g, h]);
            (x, y) = (x - dx, y - dy);
        });
        [x, y]
    }

    #[inline(always)]
    fn inverse<T: Real>(&self, _: Face, [x, y]: [T; 2]) -> [T; 3] {
        let (xx, yy) = (x * x, y * y);
        let [a, b, z] = factors([xx, yy], [T::ONE - xx, T::ONE - yy]);
        normalise([x * a, y * b, z])
    }
}
