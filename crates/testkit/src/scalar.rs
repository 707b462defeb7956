//! What the tests need of a scalar beyond [`Real`].

use terrella::Real;

pub trait Scalar: Real + Into<f64> {
    const NAME: &'static str;
    /// Where a pair of claims for `f64` and `f32` has this scalar's.
    const CLAIM: usize;
    /// The smallest positive number.
    const SMALLEST: Self;
    /// The smallest positive normal number.
    const SMALLEST_NORMAL: Self;
    /// The largest number.
    const LARGEST: Self;
    /// The scalar of some bits; the lower half of them are those of `f32`.
    fn from_bits(bits: u64) -> Self;
    /// The value, if it is exact in this scalar.
    fn lift(value: f64) -> Option<Self>;
    /// The bits, to tell zeros and NaNs apart.
    fn bits(self) -> u64;
    /// The next larger number, of a finite one; of infinity, NaN.
    fn above(self) -> Self;
    /// The next smaller number.
    fn below(self) -> Self {
        -(-self).above()
    }
}

macro_rules! scalar {
    ($($float:ident $bits:ident $claim:literal)*) => {$(
        impl Scalar for $float {
            const NAME: &'static str = stringify!($float);
            const CLAIM: usize = $claim;
            const SMALLEST: Self = $float::from_bits(1);
            const SMALLEST_NORMAL: Self = $float::MIN_POSITIVE;
            const LARGEST: Self = $float::MAX;
            fn from_bits(bits: u64) -> Self {
                $float::from_bits(bits as $bits)
            }
            fn lift(value: f64) -> Option<Self> {
                let scalar = value as $float;
                // Subnormal numbers have no last place to speak of: those of `f32` are normal in `f64`.
                let is_whole = size_of::<Self>() == 8 || scalar == 0.0 || scalar.is_normal();
                (f64::from(scalar).to_bits() == value.to_bits() && is_whole).then_some(scalar)
            }
            fn bits(self) -> u64 {
                self.to_bits().into()
            }
            fn above(self) -> Self {
                if self == 0.0 {
                    return Self::SMALLEST;
                }
                let bits = self.to_bits();
                Self::from_bits(if self > 0.0 { bits + 1 } else { bits - 1 })
            }
        }
    )*};
}
scalar!(f64 u64 0 f32 u32 1);

/// The same bits, or both NaN.
pub fn same<T: Scalar>(a: T, b: T) -> bool {
    a.bits() == b.bits() || (a.into().is_nan() && b.into().is_nan())
}

/// The number so many steps above, or below; of a finite one.
pub fn steps<T: Scalar>(from: T, count: i32) -> T {
    let step = if count < 0 { T::below } else { T::above };
    (0..count.abs()).fold(from, |number, _| step(number))
}

/// |a − b| in ulps of the numbers in [½, 1): halves of [`Real::EPSILON`].
pub fn ulps<T: Scalar>(a: T, b: T) -> f64 {
    (a.into() - b.into()).abs() / (0.5 * T::EPSILON.into())
}
