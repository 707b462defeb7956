use super::{ROWS, Row, clenshaw, doubled, in_n, longest, rows};
use crate::geodesic::angle::Angle;
use crate::math::{Polynomial, geodesic as table};
use crate::{Ellipsoid, Real};

/// I₁ = A₁(σ + Σ C₁ₗ sin 2lσ), I₂ and I₃ alike, for one ellipsoid: to order 6 on the Earth's, 12 at most
/// (`f32`: 6).
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Integrals<T> {
    /// Terms that reach rounding for this flattening.
    pub(super) order: usize,
    /// A₃ by powers of ε.
    a3: Row<T>,
    /// A₃C₃ₗ/ε^l by powers of ε, l = 1, 2, …, one row after the other.
    c3: [T; ROWS],
}

impl<T: Real> Integrals<T> {
    pub fn new(ellipsoid: Ellipsoid<T>) -> Self {
        let n = ellipsoid.n();
        let mut order = 1;
        let mut next = n * n;
        while next.abs() > T::EPSILON * T::of(1.0 / 64.0) && order < longest::<T>() {
            next *= n;
            order += 1;
        }
        let mut a3 = [T::ZERO; table::ORDER.0];
        let mut c3 = [T::ZERO; ROWS];
        in_n(n, 0, &table::A3, &mut a3);
        in_n(n, 1, &table::C3, &mut c3);
        Self { order, a3, c3 }
    }

    /// A₃ by powers of ε, and the rows A₃C₃ₗ/ε^l, l = 1 … 4, both to ε⁴.
    pub fn low_orders(&self) -> ([T; 5], [T; 10]) {
        let mut powers = self.a3.iter().copied();
        let a3 = [(); 5].map(|()| powers.next().unwrap_or(T::ZERO));
        let mut entries = (1..5).flat_map(|l| {
            let start = (1..l).map(|m| longest::<T>() - m).sum();
            self.c3.iter().copied().skip(start).take(5 - l)
        });
        let c3 = [(); 10].map(|()| entries.next().unwrap_or(T::ZERO));
        (a3, c3)
    }

    /// ε from k² (Karney 16).
    pub fn epsilon(k2: T) -> T {
        let root = (T::ONE + k2).sqrt();
        k2 / (T::of(2.0) * (T::ONE + root) + k2)
    }

    /// A₁ − 1 (Karney 17).
    pub fn a1_less_1(&self, epsilon: T) -> T {
        let rest = self.in_square(epsilon, &table::A1);
        (rest + epsilon) / (T::ONE - epsilon)
    }

    /// A₂ − 1 (Karney 42).
    pub fn a2_less_1(&self, epsilon: T) -> T {
        let rest = self.in_square(epsilon, &table::A2);
        rest - epsilon * (T::ONE + rest)
    }

    /// C₁ₗ (Karney 18).
    pub fn c1(&self, epsilon: T) -> Row<T> {
        self.row(epsilon, &table::C1)
    }

    /// C′₁ₗ, the reversion of C₁ₗ: σ = τ + Σ C′₁ₗ sin 2lτ (Karney 20 and 21).
    pub fn c1_reverted(&self, epsilon: T) -> Row<T> {
        self.row(epsilon, &table::C1P)
    }

    /// C₂ₗ (Karney 43).
    pub fn c2(&self, epsilon: T) -> Row<T> {
        self.row(epsilon, &table::C2)
    }

    /// A₃ (Karney 24).
    pub fn a3(&self, epsilon: T) -> T {
        let powers = self.a3.iter().take(self.order);
        powers.rev().fold(T::ZERO, |sum, &c| sum * epsilon + c)
    }

    /// A₃C₃ₗ (Karney 25).
    pub fn c3(&self, epsilon: T) -> Row<T> {
        rows(&self.c3, 1, self.order, epsilon)
    }

    /// Σ cₗ sin 2lσ by Clenshaw's recurrence.
    pub fn sines(&self, row: &Row<T>, sigma: Angle<T>) -> T {
        sines(row, self.order, sigma)
    }

    /// The number of terms that reach rounding. Coefficients beyond are 0.
    #[inline(always)]
    pub fn order(&self) -> usize {
        self.order
    }

    /// Σ cₗ (sin 2lσ₂ − sin 2lσ₁) = Σ 2cₗ cos l(σ₁ + σ₂) sin l(σ₂ − σ₁): between neighbours nothing cancels.
    pub fn rise(&self, row: &Row<T>, sum: Angle<T>, step: Angle<T>) -> T {
        let (mut s, mut d) = (sum, step);
        let mut total = T::ZERO;
        for &c in row.iter().take(self.order) {
            total += c * (s.cos * d.sin);
            (s, d) = (s.plus(sum), d.plus(step));
        }
        total + total
    }

    /// A polynomial in ε² without its first term, 1.
    fn in_square<const N: usize, const M: usize>(&self, epsilon: T, coefficients: &Polynomial<N, M>) -> T {
        let square = epsilon * epsilon;
        (1..=self.order / 2)
            .rev()
            .fold(T::ZERO, |sum, i| (sum + T::coefficient(coefficients, i)) * square)
    }

    /// ε^l times polynomials in ε², from a table whose rows are as long as the longest order asks.
    fn row<const N: usize, const M: usize>(&self, epsilon: T, coefficients: &Polynomial<N, M>) -> Row<T> {
        let square = epsilon * epsilon;
        let mut power = T::ONE;
        let mut start = 0;
        let mut l = 0;
        [(); table::ORDER.0].map(|()| {
            l += 1;
            power *= epsilon;
            if l > self.order {
                return T::ZERO;
            }
            let used = (self.order - l) / 2;
            let sum = (0..=used)
                .rev()
                .fold(T::ZERO, |sum, i| sum * square + T::coefficient(coefficients, start + i));
            start += (longest::<T>() - l) / 2 + 1;
            power * sum
        })
    }
}

/// Σ cₗ sin 2lσ of so many terms by Clenshaw's recurrence.
#[inline(always)]
pub fn sines<T: Real>(row: &Row<T>, terms: usize, sigma: Angle<T>) -> T {
    let (sin2, cos2) = doubled(sigma);
    let (b, _) = clenshaw(row.iter().take(terms), cos2);
    sin2 * b
}
