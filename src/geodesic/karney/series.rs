use super::angle::Angle;
use crate::math::{Polynomial, geodesic as table};
use crate::{Ellipsoid, Real};

/// Coefficients of a sine series, lowest first: as many as the longest order.
pub(super) type Row<T> = [T; table::ORDER.0];

/// The series of the geodesic integrals for one ellipsoid (Karney 2013, §§3, 4, 6; orders and tables from `geodesic.py`).
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Series<T> {
    /// Terms that reach rounding for this flattening.
    order: usize,
    /// A₃ by powers of ε.
    a3: Row<T>,
    /// A₃C₃ₗ/ε^l by powers of ε, l = 1, 2, …, one row after the other.
    c3: [T; ROWS],
}

/// Entries of a triangle of rows of length ORDER − 1, …, 1.
const ROWS: usize = table::ORDER.0 * (table::ORDER.0 - 1) / 2;

impl<T: Real> Series<T> {
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

    /// ε from k² (Karney 17).
    pub fn epsilon(k2: T) -> T {
        let root = (T::ONE + k2).sqrt();
        k2 / (T::of(2.0) * (T::ONE + root) + k2)
    }

    /// A₁ − 1.
    pub fn a1_less_1(&self, epsilon: T) -> T {
        let rest = self.in_square(epsilon, &table::A1);
        (rest + epsilon) / (T::ONE - epsilon)
    }

    /// A₂ − 1.
    pub fn a2_less_1(&self, epsilon: T) -> T {
        let rest = self.in_square(epsilon, &table::A2);
        rest - epsilon * (T::ONE + rest)
    }

    /// C₁ₗ.
    pub fn c1(&self, epsilon: T) -> Row<T> {
        self.row(epsilon, &table::C1)
    }

    /// C′₁ₗ.
    pub fn c1_reverted(&self, epsilon: T) -> Row<T> {
        self.row(epsilon, &table::C1P)
    }

    /// C₂ₗ.
    pub fn c2(&self, epsilon: T) -> Row<T> {
        self.row(epsilon, &table::C2)
    }

    /// A₃.
    pub fn a3(&self, epsilon: T) -> T {
        let powers = self.a3.iter().take(self.order);
        powers.rev().fold(T::ZERO, |sum, &c| sum * epsilon + c)
    }

    /// A₃C₃ₗ.
    pub fn c3(&self, epsilon: T) -> Row<T> {
        triangle(&self.c3, 1, self.order, epsilon)
    }

    /// Σ cₗ sin 2lσ by Clenshaw's recurrence.
    pub fn sines(&self, row: &Row<T>, sigma: Angle<T>) -> T {
        let (sin2, cos2) = doubled(sigma);
        let (b, _) = clenshaw(row.iter().take(self.order), cos2);
        sin2 * b
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

/// The area's series C₄ for one ellipsoid.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub(super) struct AreaSeries<T> {
    order: usize,
    /// C₄ₗ/ε^l by powers of ε, l = 0, 1, …, one row after the other.
    c4: [T; ROWS + table::ORDER.0],
}

impl<T: Real> AreaSeries<T> {
    pub fn new(ellipsoid: Ellipsoid<T>, series: &Series<T>) -> Self {
        let mut c4 = [T::ZERO; ROWS + table::ORDER.0];
        in_n(ellipsoid.n(), 0, &table::C4, &mut c4);
        Self {
            order: series.order,
            c4,
        }
    }

    /// C₄ₗ.
    pub fn c4(&self, epsilon: T) -> Row<T> {
        triangle(&self.c4, 0, self.order, epsilon)
    }

    /// Σ cₗ cos (2l + 1)σ by Clenshaw's recurrence.
    pub fn cosines(&self, row: &Row<T>, sigma: Angle<T>) -> T {
        let (_, cos2) = doubled(sigma);
        let (b0, b1) = clenshaw(row.iter().take(self.order), cos2);
        sigma.cos * (b0 - b1)
    }
}

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
fn triangle<T: Real>(entries: &[T], first: usize, order: usize, epsilon: T) -> Row<T> {
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
fn doubled<T: Real>(sigma: Angle<T>) -> (T, T) {
    let two = T::of(2.0);
    (
        two * sigma.sin * sigma.cos,
        (sigma.cos - sigma.sin) * (sigma.cos + sigma.sin),
    )
}

/// The last two partial sums, b₀ and b₁, of Clenshaw's recurrence in 2 cos 2σ.
fn clenshaw<'a, T: Real>(row: impl DoubleEndedIterator<Item = &'a T>, cos2: T) -> (T, T) {
    let twice = cos2 + cos2;
    row.rev()
        .fold((T::ZERO, T::ZERO), |(b1, b2), &c| (c + (twice * b1 - b2), b1))
}
