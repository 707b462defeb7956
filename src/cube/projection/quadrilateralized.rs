use super::{CubeProjection, Face};
use crate::Real;
use crate::math::{QUAD_M, QUAD_T, exchange, max, min, odd_unit, select};

/// The quadrilateralized cube, QSC: equal-area, with creases along the diagonals.
///
/// O'Neill & Laubscher (1976), after Chan & O'Neill (1975); the same map as Snyder's cube and as Roşca & Plonka's.
/// Dimitrijević, Lambers & Rančić (2016) §4.5.
///
/// With t = min/max of the gnomonic coordinates, q = √(2 + t²) and ρ = √(1 + u² + v²) the longer coordinate is
/// x = u·√(q(q + 1)/(ρ(ρ + 1))), the shorter x·m(t), with m one odd function of one variable.
/// Nothing cancels anywhere, and on an edge ρ = q.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Quadrilateralized;

impl CubeProjection for Quadrilateralized {
    #[inline(always)]
    fn forward<T: Real>(&self, _: Face, [right, up, outward]: [T; 3]) -> [T; 2] {
        // Of equals the first is the larger one, as in the exchange below: a derivative tells them apart.
        let (major, minor) = (max(up.abs(), right.abs()), min(right.abs(), up.abs()));
        let t = minor / select(major == T::ZERO, T::ONE, major);
        let u = major / outward;
        let tt = T::ONE + t * t;
        let q = (T::ONE + tt).sqrt();
        let rho = (T::ONE + u * u * tt).sqrt();
        // The quotient less 1, which is 0 on the edge: its rounding does not reach a coordinate near 1.
        let sum = q + rho;
        let excess = tt * (T::ONE - u * u) * (sum + T::ONE) / (sum * rho * (rho + T::ONE));
        let long = u * (T::ONE + excess).sqrt();
        let short = long * odd_unit(t, &QUAD_M);
        let [x, y] = exchange(up.abs() > right.abs(), [long, short]);
        [x.copysign(right), y.copysign(up)]
    }

    #[inline(always)]
    fn inverse<T: Real>(&self, _: Face, [x, y]: [T; 2]) -> [T; 3] {
        let (long, short) = (max(y.abs(), x.abs()), min(x.abs(), y.abs()));
        let t = odd_unit(short / select(long == T::ZERO, T::ONE, long), &QUAD_T);
        // s is the outward component on the edge; w leaves 0 there, so that outward and major agree to the last bit.
        let s = T::ONE / (T::of(2.0) + t * t).sqrt();
        let w = (T::ONE - long * long) * (T::ONE - s);
        let outward = s + w;
        let major = long * s * (T::ONE + w / (T::ONE + s)).sqrt();
        let minor = t * major;
        let [right, up] = exchange(y.abs() > x.abs(), [major, minor]);
        [right.copysign(x), up.copysign(y), outward]
    }
}
