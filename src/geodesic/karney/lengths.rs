use super::Karney;
use super::angle::Angle;
use super::series::Row;
use crate::Real;

/// A point of a geodesic on the auxiliary sphere.
#[derive(Clone, Copy)]
pub(super) struct Node<T> {
    /// The arc from the node, σ.
    pub sigma: Angle<T>,
    /// The cosine of the parametric latitude, β.
    pub cos_beta: T,
    /// dn = √(1 + e'² sin²β) = √(1 + k² sin²σ).
    pub dn: T,
}

/// Lengths between two points of a geodesic, in units of b.
pub(super) struct Lengths<T> {
    /// The distance.
    pub distance: T,
    /// The reduced length m₁₂ (Karney 38).
    pub reduced: T,
    /// The coefficient m₀ of its secular term.
    pub secular: T,
    /// The geodesic scales M₁₂ and M₂₁ (Karney 39).
    pub scales: [T; 2],
}

impl<T: Real> Karney<T> {
    /// Lengths for ε and the arc σ₁₂ from the first to the second point.
    pub(super) fn lengths(&self, epsilon: T, arc: T, one: Node<T>, two: Node<T>) -> Lengths<T> {
        let series = &self.series;
        let short = arc < T::of(0.5);
        let (step, sum) = (Angle::radians(arc), one.sigma.plus(two.sigma));
        let difference = |row: Row<T>| {
            if short {
                series.rise(&row, sum, step)
            } else {
                series.sines(&row, two.sigma) - series.sines(&row, one.sigma)
            }
        };
        let (a1, a2) = (series.a1_less_1(epsilon), series.a2_less_1(epsilon));
        let secular = a1 - a2;
        let (a1, a2) = (T::ONE + a1, T::ONE + a2);
        let b1 = difference(series.c1(epsilon));
        let b2 = difference(series.c2(epsilon));
        let j12 = secular * arc + (a1 * b1 - a2 * b2);
        let (s1, s2) = (one.sigma, two.sigma);
        let reduced = two.dn * (s1.cos * s2.sin) - one.dn * (s1.sin * s2.cos) - s1.cos * s2.cos * j12;
        let cos12 = s1.cos * s2.cos + s1.sin * s2.sin;
        let t =
            self.ellipsoid.ep2() * (one.cos_beta - two.cos_beta) * (one.cos_beta + two.cos_beta) / (one.dn + two.dn);
        Lengths {
            distance: a1 * (arc + b1),
            reduced,
            secular,
            scales: [
                cos12 + (t * s2.sin - s2.cos * j12) * s1.sin / one.dn,
                cos12 - (t * s1.sin - s1.cos * j12) * s2.sin / two.dn,
            ],
        }
    }
}
