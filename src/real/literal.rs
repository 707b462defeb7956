//! Literals as constants of any scalar: an associated constant of a generic type cannot call a conversion.

/// The number with these bits as `f64`, for [`Constant`].
pub(crate) struct Literal<const BITS: u64>;

/// A constant of the scalar `T`: the one nearest to the literal, as [`Real::of`](super::Real::of) gives it.
pub(crate) trait Constant<T> {
    const VALUE: T;
}

impl<const BITS: u64> Constant<f32> for Literal<BITS> {
    const VALUE: f32 = f64::from_bits(BITS) as f32;
}

impl<const BITS: u64> Constant<f64> for Literal<BITS> {
    const VALUE: f64 = f64::from_bits(BITS);
}

/// `literal!(T, 0.1)`: the constant of the scalar `T` nearest to a constant `f64`.
macro_rules! literal {
    ($scalar:ty, $value:expr) => {
        <<$scalar as crate::real::Kernel>::Literal<{ f64::to_bits($value) }> as crate::real::Constant<$scalar>>::VALUE
    };
}
pub(crate) use literal;
