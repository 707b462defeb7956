//! The series for ellipsoids with |f| < 1/149, whose order is fixed: no loop and no branch, so that a loop
//! over places vectorises.
//!
//! Sums over sines between two points run as Σ 2cₗ cos 2lσₘ sin lσ₁₂, with σₘ the middle of the arc counted
//! from the node: nothing cancels between neighbours.

use super::Integrals;
use crate::math::{Polynomial, halves};
use crate::{Ellipsoid, Real};

/// The coefficients of an ellipsoid.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Short<T> {
    /// ε/cos²α₀ by powers of cos²α₀.
    epsilon: [T; 7],
    /// A₃ by powers of ε.
    a3: [T; 5],
    /// 2A₃C₃ₗ/ε^l by powers of ε, l = 1, 2, 3, 4, one row after the other.
    c3: [T; 10],
}

/// ε/k² = 1/(1 + √(1 + k²))² by powers of k².
const EPSILON: Polynomial<7, 7> = Polynomial::rounded([
    1.0 / 4.0,
    -1.0 / 8.0,
    5.0 / 64.0,
    -7.0 / 128.0,
    21.0 / 512.0,
    -33.0 / 1024.0,
    429.0 / 16384.0,
]);

/// (A₁ − 1)/ε by powers of ε, A₁ = (1 + ε²/4 + ε⁴/64 + ε⁶/256)/(1 − ε) (Karney 17).
const A1: Polynomial<6, 6> = Polynomial::rounded([1.0, 1.25, 1.25, 81.0 / 64.0, 81.0 / 64.0, 325.0 / 256.0]);

/// (1/A₁ − 1)/ε by powers of ε.
const INVERSE_A1: Polynomial<6, 6> =
    Polynomial::rounded([-1.0, -1.0 / 4.0, 1.0 / 4.0, 3.0 / 64.0, -3.0 / 64.0, -3.0 / 256.0]);

/// c₀ + c₁x + … of the first coefficients.
#[inline(always)]
fn polynomial<T: Real>(x: T, coefficients: &[T], terms: usize) -> T {
    halves(x, terms, |i| coefficients.get(i).copied().unwrap_or(T::ZERO))
}

impl<T: Real> Short<T> {
    /// From the ellipsoid and the series of its longitude.
    pub fn new(ellipsoid: Ellipsoid<T>, integrals: &Integrals<T>) -> Self {
        let (a3, c3) = integrals.low_orders();
        let ep2 = ellipsoid.ep2();
        // k² = e′² cos²α₀.
        let mut power = T::ONE;
        let epsilon = T::all(&EPSILON).map(|c| {
            power *= ep2;
            power * c
        });
        Self {
            epsilon,
            a3,
            c3: c3.map(|c| c + c),
        }
    }

    /// ε/cos²α₀.
    #[inline(always)]
    pub fn epsilon_by_cos2(&self, cos2_alpha0: T) -> T {
        polynomial(cos2_alpha0, &self.epsilon, T::terms(7, 3))
    }

    /// e′²/4: dε/d cos²α₀ but for terms in ε.
    #[inline(always)]
    pub fn quarter_ep2(&self) -> T {
        let [first, ..] = self.epsilon;
        first
    }

    /// A₃ (Karney 24).
    #[inline(always)]
    pub fn a3(&self, epsilon: T) -> T {
        polynomial(epsilon, &self.a3, T::terms(5, 3))
    }

    /// A₃, and I₃ less A₃σ₁₂ between two points (Karney 23).
    #[cfg_attr(not(small), inline(always))]
    pub fn i3(&self, epsilon: T, [w1, w2, w3, w4, _]: [T; 5]) -> (T, T) {
        let [c11, c12, c13, c14, c22, c23, c24, c33, c34, c44] = self.c3;
        let sum = if T::terms(4, 2) == 4 {
            ((c44 * w4 + (c33 + epsilon * c34) * w3) + (c22 + epsilon * (c23 + epsilon * c24)) * w2)
                + (c11 + epsilon * (c12 + epsilon * (c13 + epsilon * c14))) * w1
        } else {
            (c11 + epsilon * c12) * w1
        };
        (self.a3(epsilon), sum)
    }

    /// I₃ between two points but for 1e-9/f, from cos²α₀, cos²α₀ cos 2σₘ, sin σ₁₂ and σ₁₂.
    #[inline(always)]
    pub fn rough_i3(&self, cos2_alpha0: T, cos_2sigma_m: T, sin_sigma12: T, sigma12: T) -> T {
        let factor = polynomial(cos2_alpha0, &self.epsilon, 3);
        let epsilon = factor * cos2_alpha0;
        let wave = factor * cos_2sigma_m * sin_sigma12;
        sigma12 * polynomial(epsilon, &self.a3, 3) + wave * polynomial(epsilon, &self.c3, 2)
    }
}

/// ε^l cos 2lσₘ sin lσ₁₂, l = 1, 2, …, from ε cos 2σₘ and sine and cosine of σ₁₂.
#[cfg_attr(not(small), inline(always))]
pub fn waves<T: Real>(epsilon: T, middle: T, (sin, cos): (T, T)) -> [T; 5] {
    let square = epsilon * epsilon;
    let (twice, twice_middle) = (cos + cos, middle + middle);
    let (s2, m2) = (twice * sin, twice_middle * middle - square);
    if T::terms(5, 2) == 2 {
        return [middle * sin, m2 * s2, T::ZERO, T::ZERO, T::ZERO];
    }
    let (s3, m3) = (twice * s2 - sin, twice_middle * m2 - square * middle);
    let (s4, m4) = (twice * s3 - s2, twice_middle * m3 - square * m2);
    let (s5, m5) = (twice * s4 - s3, twice_middle * m4 - square * m3);
    [middle * sin, m2 * s2, m3 * s3, m4 * s4, m5 * s5]
}

/// A₁ − 1 (Karney 17).
#[cfg_attr(not(small), inline(always))]
pub fn a1_less_1<T: Real>(epsilon: T) -> T {
    epsilon * polynomial(epsilon, &T::all(&A1), T::terms(6, 3))
}

/// 1/A₁ − 1.
#[inline(always)]
pub fn inverse_a1_less_1<T: Real>(epsilon: T) -> T {
    epsilon * polynomial(epsilon, &T::all(&INVERSE_A1), T::terms(6, 3))
}

/// Σ C₁ₗ (sin 2lσ₂ − sin 2lσ₁) from [`waves`] (Karney 18).
#[cfg_attr(not(small), inline(always))]
pub fn c1_between<T: Real>(epsilon: T, [w1, w2, w3, w4, w5]: [T; 5]) -> T {
    let of = T::of;
    let square = epsilon * epsilon;
    if T::terms(5, 2) == 2 {
        return -(w1 + of(1.0 / 8.0) * w2);
    }
    let rest = of(-7.0 / 640.0) * w5 - of(5.0 / 256.0) * w4;
    let rest = rest + (of(3.0 / 128.0) * square - of(1.0 / 24.0)) * w3;
    let rest = rest + (of(1.0 / 16.0) * square - of(1.0 / 8.0)) * w2;
    (rest + square * (of(3.0 / 8.0) - of(1.0 / 16.0) * square) * w1) - w1
}

/// Σ C₁ₗ sin 2lσ from ε² and ε times sine and cosine of 2σ (Karney 18).
#[inline(always)]
pub fn c1<T: Real>(square: T, double: (T, T)) -> T {
    let of = T::of;
    sines(
        [
            of(-0.5) + square * (of(3.0 / 16.0) - of(1.0 / 32.0) * square),
            of(-1.0 / 16.0) + square * of(1.0 / 32.0),
            of(-1.0 / 48.0) + square * of(3.0 / 256.0),
            of(-5.0 / 512.0),
            of(-7.0 / 1280.0),
            T::ZERO,
        ],
        T::terms(5, 2),
        square,
        double,
    )
}

/// Σ C′₁ₗ sin 2lτ from ε² and ε times sine and cosine of 2τ (Karney 21).
#[inline(always)]
pub fn c1_reverted<T: Real>(square: T, double: (T, T)) -> T {
    let of = T::of;
    sines(
        [
            of(0.5) - square * (of(9.0 / 32.0) - of(205.0 / 1536.0) * square),
            of(5.0 / 16.0) - square * (of(37.0 / 96.0) - of(1335.0 / 4096.0) * square),
            of(29.0 / 96.0) - square * of(75.0 / 128.0),
            of(539.0 / 1536.0) - square * of(2391.0 / 2560.0),
            of(3467.0 / 7680.0),
            of(38081.0 / 61440.0),
        ],
        T::terms(6, 2),
        square,
        double,
    )
}

/// Σ cₗ ε^l sin 2lσ by Clenshaw's recurrence, from ε² and ε times sine and cosine of 2σ.
#[inline(always)]
fn sines<T: Real, const N: usize>(c: [T; N], terms: usize, square: T, (sin, cos): (T, T)) -> T {
    let twice = cos + cos;
    let used = c.iter().take(terms).rev();
    let (b, _) = used.fold((T::ZERO, T::ZERO), |(b1, b2), &c| (c + (twice * b1 - square * b2), b1));
    sin * b
}
