use super::{CubeProjection, Face, from_gnomonic};
use crate::Real;
use crate::math::{Polynomial, repeat};
use crate::real::Kernel;

/// A polynomial quadrilateralized cube with your own coefficients: the family of the COBE sky cube.
///
/// With the gnomonic coordinates u and v of a point, x = F(u, v) and y = F(v, u), where
///
/// F(u, v) = γ\*u + u³(1 − γ\*) + uv²(1 − u²)\[Γ + (M − Γ)u² + (1 − v²)ΣCᵢⱼu²ⁱv²ʲ\]
/// + u³(1 − u²)\[Ω₁ − (1 − u²)ΣDᵢu²ⁱ\].
///
/// To the sphere, Newton's method solves the same polynomial. So a round trip is exact to rounding with any
/// published coefficients, for example those of Chan & O'Neill's QLSC (1975). The polynomial must be one to
/// one, and its slope must be larger than about ½.
///
/// The coefficients are, in order, γ\*, M, Γ, Ω₁, C₀₀, C₁₀, C₀₁, C₁₁, C₂₀, C₀₂, D₀, D₁.
///
/// ```
/// use terrella::{Direction, cube::{CubeProjection, QuadCube}};
/// let d = Direction::new(3.0_f64, 1.0, -2.0)?;
/// let p = QuadCube::COBE.project(d);
/// let back = QuadCube::COBE.unproject(p);
/// assert!((back.y() - d.y()).abs() < 1e-15);
/// # Ok::<(), terrella::InvalidDirection<f64>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct QuadCube(pub Polynomial<12, 12>);

impl QuadCube {
    /// COBE's coefficients.
    pub const COBE: Self = Self(Polynomial::rounded([
        1.374_848_477_32, 0.004_869_491_981, -0.131_616_714_74, -0.159_596_235_474, 0.141_189_631_152,
        0.080_970_128_652_5, -0.281_528_535_557, 0.153_841_128_76, -0.178_251_207_466, 0.106_959_469_314,
        0.075_919_620_046_7, -0.021_776_249_069_9,
    ]));

    /// F(u, v) with its derivatives by u and by v.
    #[inline(always)]
    fn value_and_slopes<T: Real>(self, u: T, v: T) -> [T; 3] {
        let [gamma_star, m, gamma, omega, c00, c10, c01, c11, c20, c02, d0, d1] = T::all(&self.0);
        let two = T::of(2.0);
        let (x, y) = (u * u, v * v);
        let (p, q) = (T::ONE - x, T::ONE - y);
        // F = u(1 + pG), exact on the edge, where p = 0.
        let s = c00 + x * (c10 + c20 * x) + y * (c01 + c11 * x + c02 * y);
        let edge = gamma + (m - gamma) * x;
        let d = d0 + d1 * x;
        let bracket = omega - p * d;
        let g = (gamma_star - T::ONE) + (y * (edge + q * s) + x * bracket);
        let g_x = y * ((m - gamma) + q * (c10 + c11 * y + two * c20 * x)) + bracket + x * (d - p * d1);
        let g_y = edge + q * s - y * s + y * q * (c01 + c11 * x + two * c02 * y);
        [
            (u + u * (p * g)).signed_like(u),
            T::ONE + p * g + two * x * (p * g_x - g),
            two * u * v * (p * g_y),
        ]
    }

    /// The forward polynomials F(u, v) and F(v, u).
    #[inline(always)]
    pub(super) fn apply<T: Real>(self, [u, v]: [T; 2]) -> [T; 2] {
        let [x, _, _] = self.value_and_slopes(u, v);
        let [y, _, _] = self.value_and_slopes(v, u);
        [x, y]
    }

    /// Where the forward polynomials are (x, y), by steps of Newton's method: so many in `f64` and in `f32`.
    #[inline(always)]
    pub(super) fn solve<T: Real>(self, [x, y]: [T; 2], start: [T::Plain; 2], [double, single]: [usize; 2]) -> [T; 2] {
        // The derivatives, if any are asked for, come from steps at the root alone.
        let (px, py) = (x.plain(), y.plain());
        let [mut u, mut v] = start;
        repeat!(T::Plain::steps(double, single), {
            [u, v] = self.newton([u, v], [px, py]);
        });
        let (mut u, mut v) = (T::from_plain(u), T::from_plain(v));
        // A loop, which a plain number never enters: written out, the steps that are not taken would be half
        // of what a compiler has to read.
        for _ in 0..T::steps(0, 0) {
            [u, v] = self.newton([u, v], [x, y]);
        }
        [u.signed_like(x), v.signed_like(y)]
    }

    /// (u, v) one step nearer to where the forward polynomial is (x, y).
    #[inline(always)]
    fn newton<T: Real>(self, [u, v]: [T; 2], [x, y]: [T; 2]) -> [T; 2] {
        let [f, f_u, f_v] = self.value_and_slopes(u, v);
        let [g, g_v, g_u] = self.value_and_slopes(v, u);
        let determinant = f_u * g_v - f_v * g_u;
        let (df, dg) = (x - f, y - g);
        [
            u + (df * g_v - dg * f_v) / determinant,
            v + (dg * f_u - df * g_u) / determinant,
        ]
    }
}

impl CubeProjection for QuadCube {
    #[inline(always)]
    fn forward<T: Real>(&self, _: Face, [right, up, outward]: [T; 3]) -> [T; 2] {
        self.apply([right / outward, up / outward])
    }

    #[inline(always)]
    fn inverse<T: Real>(&self, _: Face, point: [T; 2]) -> [T; 3] {
        from_gnomonic(self.solve(point, point.map(T::plain), [6, 5]))
    }
}
