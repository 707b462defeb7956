//! The fast solver: both problems without a branch that depends on the places, on ellipsoids with |f| <
//! 1/149. A loop over it vectorises. It says where it has no answer; the [`general`](super::general) solver
//! has.
//!
//! The inverse problem looks for ω₁₂, the difference of longitudes on the auxiliary sphere, by Newton's
//! method; the general solver looks for the azimuth α₁. Near the antipode a line follows from α₁ and not from
//! λ₁₂, but from ω₁₂ it always does.

use super::series::{Integrals, short::Short};
use crate::{Ellipsoid, Real};

mod antipode;
mod direct;
mod inverse;
mod pair;

pub use direct::{arrival, start};
pub use pair::{Pair, Trial};

/// An ellipsoid as the fast solver needs it.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Solver<T> {
    b: T,
    f: T,
    /// b/a = 1 − f.
    axes: T,
    series: Short<T>,
}

impl<T: Real> Solver<T> {
    /// For an ellipsoid and the series of its longitude.
    pub fn new(ellipsoid: Ellipsoid<T>, integrals: &Integrals<T>) -> Self {
        let f = ellipsoid.f();
        Self {
            b: ellipsoid.b(),
            f,
            axes: T::ONE - f,
            series: Short::new(ellipsoid, integrals),
        }
    }

    /// Whether the short series are exact on this ellipsoid, but for rounding.
    #[inline(always)]
    pub fn exact(&self) -> bool {
        // 1/150, and room for its rounding.
        self.f.abs() < T::of(1.0 / 149.0)
    }
}
