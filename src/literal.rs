//! Literals as constants of any scalar: an associated constant of a generic type cannot call a conversion.

use crate::{Dual, Real};

/// The number with these bits as `f64`, for [`Constant`].
pub struct Literal<const BITS: u64>;

/// A constant of the scalar `T`: the one nearest to the literal, as [`Real::of`] gives it.
pub trait Constant<T> {
    const VALUE: T;
}

impl<const BITS: u64> Constant<f32> for Literal<BITS> {
    const VALUE: f32 = f64::from_bits(BITS) as f32;
}

impl<const BITS: u64> Constant<f64> for Literal<BITS> {
    const VALUE: f64 = f64::from_bits(BITS);
}

impl<T: Real, const N: usize, const BITS: u64> Constant<Dual<T, N>> for Literal<BITS> {
    const VALUE: Dual<T, N> = Dual::constant(<T::Literal<BITS> as Constant<T>>::VALUE);
}

/// `literal!(T, 0.1)`: the constant of the scalar `T` nearest to a constant `f64`.
macro_rules! literal {
    ($scalar:ty, $value:expr) => {
        <<$scalar as crate::real::sealed::Sealed>::Literal<{ f64::to_bits($value) }> as crate::literal::Constant<
            $scalar,
        >>::VALUE
    };
}
pub(crate) use literal;
