//! The integrals along a geodesic, as series in ε = (√(1 + k²) − 1)/(√(1 + k²) + 1), k = e′ cos α₀ (Karney 9
//! and 16). The distance is s = b I₁(σ) (7), the longitude λ = ω − f sin α₀ I₃(σ) (8), the reduced length
//! follows from I₁ − I₂ (38 to 40), and the area from I₄ (58 to 63).
//!
//! | file | holds |
//! |---|---|
//! | [`integrals`] | I₁, I₂, I₃ to the order that rounding asks for: the general solver's |
//! | [`area`] | I₄ |
//! | [`short`] | I₁ and I₃ of a fixed order, without loops, for \|f\| < 1/149: the fast solver's |
//!
//! C. F. F. Karney, *Algorithms for geodesics*, J. Geodesy 87 (2013); the tables are made by
//! `math/geodesic.py`.

use super::angle::Angle;
use crate::Real;
use crate::math::{Polynomial, geodesic as table};

mod area;
mod integrals;
pub(super) mod short;

pub(super) use area::{AreaSeries, cosines};
pub(super) use integrals::{Integrals, sines};

/// Coefficients of a sine series, lowest first: as many as the longest order.
pub type Row<T> = [T; table::ORDER.0];

/// Entries of a triangle of rows of length ORDER − 1, …, 1.
const ROWS: usize = table::ORDER.0 * (table::ORDER.0 - 1) / 2;

/// The order of the tables for this scalar.
fn longest<T: Real>() -> usize {
    T::terms(table::ORDER.0, table::ORDER.1)
}

/// Puts the polynomials in n of a table into a triangle of powers of ε, from the row `first` on.
fn in_n<T: Real, const N: usize, const M: usize>(
    n: T,
    first: usize,
    coefficients: &Polynomial<N, M>,
    triangle: &mut [T],
) {
    let order = longest::<T>();
    let mut entries = triangle.iter_mut();
    let mut start = 0;
    // Row l holds the powers l … order − 1 of ε; that of ε^j is a polynomial of degree order − 1 − j in n.
    for l in first..order {
        for j in l..order {
            let length = order - j;
            let sum = (start..start + length)
                .rev()
                .fold(T::ZERO, |sum, i| sum * n + T::coefficient(coefficients, i));
            start += length;
            if let Some(entry) = entries.next() {
                *entry = sum;
            }
        }
    }
}

/// ε^l times polynomials in ε from a triangle whose rows begin with ε^first.
fn rows<T: Real>(entries: &[T], first: usize, order: usize, epsilon: T) -> Row<T> {
    let mut power = if first == 0 { T::ONE } else { epsilon };
    let mut start = 0;
    let mut l = first;
    [(); table::ORDER.0].map(|()| {
        let used = order.saturating_sub(l);
        let row = entries.iter().skip(start).take(used);
        let sum = row.rev().fold(T::ZERO, |sum, &c| sum * epsilon + c);
        start += longest::<T>().saturating_sub(l);
        l += 1;
        let value = power * sum;
        power *= epsilon;
        value
    })
}

/// Sine and cosine of twice an angle.
#[cfg_attr(not(small), inline(always))]
fn doubled<T: Real>(sigma: Angle<T>) -> (T, T) {
    let two = T::of(2.0);
    (
        two * sigma.sin * sigma.cos,
        (sigma.cos - sigma.sin) * (sigma.cos + sigma.sin),
    )
}

/// The last two partial sums, b₀ and b₁, of Clenshaw's recurrence in 2 cos 2σ.
#[cfg_attr(not(small), inline(always))]
fn clenshaw<'a, T: Real>(row: impl DoubleEndedIterator<Item = &'a T>, cos2: T) -> (T, T) {
    let twice = cos2 + cos2;
    row.rev()
        .fold((T::ZERO, T::ZERO), |(b1, b2), &c| (c + (twice * b1 - b2), b1))
}
