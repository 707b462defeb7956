//! Polynomial maps that keep edges, and have the symmetry of the square:
//! u = x(1 + pP(X, Y)), v = y(1 + qP(Y, X)), where X = x², Y = y², p = 1 − X, q = 1 − Y.

use super::{from_gnomonic, newton};
use crate::Real;
use crate::math::{Polynomial, repeat};

/// The polynomial P, and a guess of the way back.
pub(super) trait EdgeKeeping {
    /// Coefficients of 1, p, q, pq and q² in a guess at (x/u − 1)/p, where p = 1 − u² and q = 1 − v²: fitted
    /// for the least largest error.
    const START: Polynomial<5, 5>;

    /// P(X, Y).
    fn polynomial<T: Real>(x: T, y: T) -> T;

    /// The derivatives of P by X and by Y.
    fn slopes<T: Real>(x: T, y: T) -> [T; 2];
}

/// From (right, up, outward) to (x, y): Newton's method, three steps in `f64` and two in `f32`.
#[inline(always)]
pub(super) fn forward<P: EdgeKeeping, T: Real>([right, up, outward]: [T; 3]) -> [T; 2] {
    let (u, v) = (right / outward, up / outward);
    let (pu, pv) = (T::ONE - u * u, T::ONE - v * v);
    let two = T::of(2.0);
    let [c00, c10, c01, c11, c02] = T::all(&P::START);
    let start = |w: T, p: T, q: T| w * (T::ONE + p * (c00 + c10 * p + q * (c01 + c11 * p + c02 * q)));
    let (mut x, mut y) = (start(u, pu, pv), start(v, pv, pu));
    repeat!(T::steps(3, 2), {
        let (xx, yy) = (x * x, y * y);
        let (p, q) = (T::ONE - xx, T::ONE - yy);
        let (a, b) = (P::polynomial(xx, yy), P::polynomial(yy, xx));
        let ([ax, ay], [by, bx]) = (P::slopes(xx, yy), P::slopes(yy, xx));
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

/// From (x, y) to the unit vector.
#[inline(always)]
pub(super) fn inverse<P: EdgeKeeping, T: Real>([x, y]: [T; 2]) -> [T; 3] {
    let (xx, yy) = (x * x, y * y);
    let u = x * (T::ONE + (T::ONE - xx) * P::polynomial(xx, yy));
    let v = y * (T::ONE + (T::ONE - yy) * P::polynomial(yy, xx));
    from_gnomonic([u, v])
}
