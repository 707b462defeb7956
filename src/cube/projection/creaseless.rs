use super::decay::decay;
use super::profile::{Kept, projection};
use super::{CubeProjection, Face, from_gnomonic};
use crate::Real;
use crate::math::{CREASELESS_BOW, CREASELESS_CUBIC, CREASELESS_W, Polynomial, repeat, select};

projection! {
    Creaseless "creaseless" {
        title: "Creaseless",
        also: "",
        summary: "The creaseless equal-area cube: equal-area, and no line bends inside a face.",
        idea: "A line of constant x is a parabola in longitude and height about an axis of the cube. Two \
            functions of x, the parabola’s place and its bow, are chosen so that all cells have the same area \
            and a line crosses the diagonals of a face without a bend. The functions solve a differential \
            equation of the first order. The map is twice differentiable inside a face.",
        origin: "Made for terrella.",
        choose: "Take it for equal areas where lines must not bend. [`Vertex`](super::Vertex) has equal \
            areas with less distortion (ω 20.3° instead of 31.1°) and creases of at most 5°. [`Even`](super::Even) \
            costs less (80 instructions to the sphere instead of 280), with an area ratio of 1.001.",
        keeps: Some(Kept::Areas),
        area_ratio: 1.000,
        aspect_ratio: 2.946,
        oversize: 2.946,
        deformation: 31.1,
        forward: Iteration, error [3.3e-16, 2.5e-7], instructions [780, 410];
        inverse: Polynomial, error [2.7e-16, 1.6e-7], instructions [280, 210];
        tiles: [decay(0.88, 6, 0.0), decay(0.8, 9, 1e-5)],
    }
}

// In the triangle |y| ≤ |x|, whose diagonals go to the gnomonic u = ±v = w(x): a line of constant x is where the
// longitude is κ(x)(1 − g²) less than at its ends, and g is the height over that of the ends. The area beside the
// line gives y/x = g(1 − τ(x)(1 − g²)). `src/math/minimax.py` has w, κ, τ.

/// Coefficients of u² and v² in a first guess at the larger of x and y, fitted for the least largest error:
/// 1, u², u⁴, …, then those with v², with v⁴, ….
const START: [Polynomial<5, 5>; 5] = [
    Polynomial::rounded([0.3816, -0.2424, 0.155, -0.0832, 0.0265]),
    Polynomial::rounded([-0.1729, 0.1913, -0.0634, -0.0078, 0.0]),
    Polynomial::rounded([0.1414, -0.1877, 0.0663, 0.0, 0.0]),
    Polynomial::rounded([-0.0664, 0.0426, 0.0, 0.0, 0.0]),
    Polynomial::rounded([0.018, 0.0, 0.0, 0.0, 0.0]),
];

/// The tangent of a small angle: |ε| ≤ 0.011.
#[inline(always)]
fn small_tangent<T: Real>(angle: T) -> T {
    let square = angle * angle;
    angle + angle * square * (T::of(1.0 / 3.0) + square * (T::of(2.0 / 15.0) + square * T::of(17.0 / 315.0)))
}

/// A polynomial and its derivative.
#[inline(always)]
fn with_slope<T: Real, const N: usize, const M: usize>(x: T, table: &Polynomial<N, M>) -> [T; 2] {
    let (mut value, mut slope) = (T::ZERO, T::ZERO);
    for i in (0..T::terms(N, M)).rev() {
        slope = slope * x + value;
        value = value * x + T::coefficient(table, i);
    }
    [value, slope]
}

impl CubeProjection for Creaseless {
    const KEEPS_AREAS: bool = true;

    #[inline(always)]
    fn forward<T: Real>(&self, _: Face, [right, up, outward]: [T; 3]) -> [T; 2] {
        let steep = up.abs() > right.abs();
        let (u, v) = (select(steep, up, right) / outward, select(steep, right, up) / outward);
        let (uu, vv) = (u * u, v * v);
        let (one, two) = (T::ONE, T::of(2.0));
        let shrink = one / (one + uu + vv);
        // The guess is within 6e-5. After one and two steps of Newton's method the error is at most 3e-9 and 1e-17.
        let [s0, s1, s2, s3, s4] = START.each_ref().map(|row| uu.polynomial(row));
        let mut x = u + u * (one - uu) * (s0 + vv * (s1 + vv * (s2 + vv * (s3 + vv * s4))));
        repeat!(T::steps(2, 1), {
            let (xx, inside) = (x * x, one - x * x);
            let ([p, dp], [h, dh]) = (with_slope(xx, &CREASELESS_W), with_slope(xx, &CREASELESS_BOW));
            let stretch = one + inside * p;
            let w = x * stretch;
            let dw = stretch + two * xx * (inside * dp - p);
            // (1 − g²)w², the angle between the longitudes of the place and the line's ends, and its tangent.
            let lack = (w * w * (one + uu) - vv * (one + w * w)) * shrink;
            let angle = x * inside * h * lack;
            let slope = inside * h * (lack + two * x * w * dw * (one - two * vv * shrink))
                + two * xx * (inside * dh - h) * lack;
            let tangent = small_tangent(angle);
            let rest = w * (one - u * tangent) - (u + tangent);
            x -= rest / (dw * (one - u * tangent) - (one + tangent * tangent) * slope * (one + u * w));
        });
        let xx = x * x;
        let stretch = one + (one - xx) * xx.polynomial(&CREASELESS_W);
        let w = x * stretch;
        let ww = w * w;
        let grown = v * ((one + ww + ww) * shrink).sqrt();
        let height = grown / select(w == T::ZERO, one, w);
        let cubic = one - xx * xx.polynomial(&CREASELESS_CUBIC) * (one - height * height);
        let y = grown / stretch * cubic;
        // The diagonals stay what they are.
        let diagonal = (x - x.vanish()).abs().copysign(v) + y.vanish();
        let y = select(v.abs() == u.abs(), diagonal, y);
        let [x, y] = [x.signed_like(u), y.signed_like(v)];
        [select(steep, y, x), select(steep, x, y)]
    }

    #[inline(always)]
    fn inverse<T: Real>(&self, _: Face, [px, py]: [T; 2]) -> [T; 3] {
        let steep = py.abs() > px.abs();
        let (x, y) = (select(steep, py, px), select(steep, px, py));
        let (one, three) = (T::ONE, T::of(3.0));
        let xx = x * x;
        let inside = one - xx;
        let stretch = one + inside * xx.polynomial(&CREASELESS_W);
        let w = x * stretch;
        let ww = w * w;
        let cubic = xx * xx.polynomial(&CREASELESS_CUBIC);
        let share = y / select(x == T::ZERO, one, x);
        let square = share * share;
        // g over the share of the area. The guess is within 1e-4; one and two steps of Newton's method leave
        // 1e-9 and 1e-18.
        let mut grown = one + cubic * (one - square) * (one + cubic * (one - three * square));
        repeat!(T::steps(2, 1), {
            let bent = cubic * (one - square * (grown * grown));
            grown -= (grown - one - grown * bent) / (one - bent + T::of(2.0) * cubic * square * (grown * grown));
        });
        let lack = ww * (one - square * (grown * grown));
        let tangent = small_tangent(x * inside * xx.polynomial(&CREASELESS_BOW) * lack);
        let u = (w - tangent) / (one + w * tangent);
        let v = y * stretch * grown * ((one + u * u) / (one + ww + lack)).sqrt();
        // A zero keeps its sign: it may be what tells longitude −180 from 180.
        let [u, v] = [u.signed_like(x), v.signed_like(y)];
        from_gnomonic([select(steep, v, u), select(steep, u, v)])
    }
}
