use super::Solver;
use crate::Real;
use crate::geodesic::angle::Angle;
use crate::geodesic::series::Row;

/// An end of an arc on the auxiliary sphere.
#[derive(Clone, Copy)]
pub struct ArcEnd<T> {
    /// σ.
    pub sigma: Angle<T>,
    /// cos β.
    pub cos_beta: T,
    /// √(1 + e′² sin²β) = √(1 + k² sin²σ).
    pub dn: T,
}

/// Lengths between two points of a geodesic, in units of b.
pub struct Lengths<T> {
    /// s₁₂ (Karney 7).
    pub distance: T,
    /// The reduced length m₁₂ (Karney 38).
    pub reduced: T,
    /// The coefficient m₀ of its secular term.
    pub secular: T,
    /// The geodesic scales M₁₂ and M₂₁ (Karney 39).
    pub scales: [T; 2],
}

impl<T: Real> Solver<T> {
    /// The lengths for ε and the arc σ₁₂ from one end to the other.
    pub(super) fn lengths(&self, epsilon: T, sigma12: T, one: ArcEnd<T>, two: ArcEnd<T>) -> Lengths<T> {
        let integrals = &self.integrals;
        let short = sigma12 < T::of(0.5);
        let (step, sum) = (Angle::radians(sigma12), one.sigma.plus(two.sigma));
        let difference = |row: Row<T>| {
            if short {
                integrals.rise(&row, sum, step)
            } else {
                integrals.sines(&row, two.sigma) - integrals.sines(&row, one.sigma)
            }
        };
        let (a1, a2) = (integrals.a1_less_1(epsilon), integrals.a2_less_1(epsilon));
        let secular = a1 - a2;
        let (a1, a2) = (T::ONE + a1, T::ONE + a2);
        let b1 = difference(integrals.c1(epsilon));
        let b2 = difference(integrals.c2(epsilon));
        let j12 = secular * sigma12 + (a1 * b1 - a2 * b2);
        let (s1, s2) = (one.sigma, two.sigma);
        let reduced = two.dn * (s1.cos * s2.sin) - one.dn * (s1.sin * s2.cos) - s1.cos * s2.cos * j12;
        let cos12 = s1.cos * s2.cos + s1.sin * s2.sin;
        let t =
            self.ellipsoid.ep2() * (one.cos_beta - two.cos_beta) * (one.cos_beta + two.cos_beta) / (one.dn + two.dn);
        Lengths {
            distance: a1 * (sigma12 + b1),
            reduced,
            secular,
            scales: [
                cos12 + (t * s2.sin - s2.cos * j12) * s1.sin / one.dn,
                cos12 - (t * s1.sin - s1.cos * j12) * s2.sin / two.dn,
            ],
        }
    }
}
