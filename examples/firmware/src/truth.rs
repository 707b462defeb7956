//! A slice of the truth, and what the README claims: `build.rs` writes the tables.

use terrella::Real;
use terrella::cube::Projection;
use testkit::minimum;

/// A number as the sum of two.
pub struct Long(f64, f64);

/// Numbers that are exact in `f64`, the truth about them, and a word on the row.
pub struct Row<const GIVEN: usize, const TRUTH: usize> {
    pub given: [f64; GIVEN],
    pub truth: [Long; TRUTH],
    pub word: &'static str,
}

include!(concat!(env!("OUT_DIR"), "/truth.rs"));

impl Long {
    /// The nearest `f64`.
    pub fn value(&self) -> f64 {
        self.0
    }

    /// |computed − truth|.
    pub fn error<T: Single>(&self, computed: T) -> f64 {
        ((computed.into() - self.0) - self.1).abs()
    }

    /// |computed − truth| of two angles in degrees.
    pub fn turn<T: Single>(&self, computed: T) -> f64 {
        let error = self.error(computed);
        minimum(error, (360.0 - error).abs())
    }

    /// |computed − truth| in units of the last place of the truth.
    pub fn ulps<T: Single>(&self, computed: T) -> f64 {
        if self.0 == 0.0 {
            return if computed.into() == 0.0 { 0.0 } else { f64::INFINITY };
        }
        let power_of_two = f64::from_bits(self.0.to_bits() & f64::INFINITY.to_bits());
        self.error(computed) / (power_of_two * T::EPSILON.into())
    }
}

/// A scalar whose numbers are exact in `f64`.
pub trait Single: calls::Scalar + Into<f64> {
    /// Which of two claims is about it.
    const INDEX: usize;

    /// The number, if it is exact and normal in this scalar.
    fn lift(number: f64) -> Option<Self>;
}

impl Single for f64 {
    const INDEX: usize = 0;

    fn lift(number: f64) -> Option<Self> {
        Some(number)
    }
}

impl Single for f32 {
    const INDEX: usize = 1;

    fn lift(number: f64) -> Option<Self> {
        let single = number as f32;
        (f64::from(single) == number && (number == 0.0 || single.is_normal())).then_some(single)
    }
}

impl<const GIVEN: usize, const TRUTH: usize> Row<GIVEN, TRUTH> {
    /// What is given, if it is exact in a scalar.
    pub fn lift<T: Single>(&self) -> Option<[T; GIVEN]> {
        let mut lifted = [T::ZERO; GIVEN];
        for (slot, &number) in lifted.iter_mut().zip(&self.given) {
            *slot = T::lift(number)?;
        }
        Some(lifted)
    }
}

/// The square root in `f64`.
pub fn sqrt(x: f64) -> f64 {
    Real::sqrt(x)
}
