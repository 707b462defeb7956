use super::{Integrals, ROWS, Row, clenshaw, doubled, in_n, longest, rows};
use crate::geodesic::angle::Angle;
use crate::math::geodesic as table;
use crate::{Ellipsoid, Real};

/// The area's series C₄ for one ellipsoid.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct AreaSeries<T> {
    order: usize,
    /// C₄ₗ/ε^l by powers of ε, l = 0, 1, …, one row after the other.
    c4: [T; ROWS + table::ORDER.0],
}

impl<T: Real> AreaSeries<T> {
    pub fn new(ellipsoid: Ellipsoid<T>, integrals: &Integrals<T>) -> Self {
        let mut c4 = [T::ZERO; ROWS + table::ORDER.0];
        in_n(ellipsoid.n(), 0, &table::C4, &mut c4);
        Self {
            order: integrals.order,
            c4,
        }
    }

    /// C₄ₗ.
    pub fn c4(&self, epsilon: T) -> Row<T> {
        rows(&self.c4, 0, self.order, epsilon)
    }

    /// Σ cₗ cos (2l + 1)σ by Clenshaw's recurrence.
    pub fn cosines(&self, row: &Row<T>, sigma: Angle<T>) -> T {
        cosines(row.get(..self.order).unwrap_or(row), sigma)
    }

    /// C₄ₗ/ε^l by powers of ε, as many as there is room for, 0 beyond the order.
    pub fn first_rows<const N: usize>(&self) -> [[T; N]; N] {
        let mut entries = self.c4.iter().copied();
        let mut length = longest::<T>();
        let mut used = self.order;
        [(); N].map(|()| {
            let mut row = [T::ZERO; N];
            for (j, entry) in entries.by_ref().take(length).enumerate() {
                if let Some(slot) = row.get_mut(j).filter(|_| j < used) {
                    *slot = entry;
                }
            }
            length = length.saturating_sub(1);
            used = used.saturating_sub(1);
            row
        })
    }
}

/// Σ cₗ cos (2l + 1)σ by Clenshaw's recurrence.
#[inline(always)]
pub fn cosines<T: Real>(row: &[T], sigma: Angle<T>) -> T {
    let (_, cos2) = doubled(sigma);
    let (b0, b1) = clenshaw(row.iter(), cos2);
    sigma.cos * (b0 - b1)
}
