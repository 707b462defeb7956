//! Conversions: of the value alone, and to numbers without derivatives.

use num_traits::{FromPrimitive, NumCast, ToPrimitive};

use crate::{Dual, Real};

macro_rules! to_value {
    ($($method:ident $integer:ty),*) => {
        $(
            #[inline]
            fn $method(&self) -> Option<$integer> {
                self.value().$method()
            }
        )*
    };
}

impl<T: Real + ToPrimitive, const N: usize> ToPrimitive for Dual<T, N> {
    to_value! {
        to_isize isize, to_i8 i8, to_i16 i16, to_i32 i32, to_i64 i64, to_i128 i128,
        to_usize usize, to_u8 u8, to_u16 u16, to_u32 u32, to_u64 u64, to_u128 u128,
        to_f32 f32, to_f64 f64
    }
}

macro_rules! from_value {
    ($($method:ident $number:ty),*) => {
        $(
            #[inline]
            fn $method(number: $number) -> Option<Self> {
                T::$method(number).map(Self::constant)
            }
        )*
    };
}

impl<T: Real + FromPrimitive, const N: usize> FromPrimitive for Dual<T, N> {
    from_value! {
        from_isize isize, from_i8 i8, from_i16 i16, from_i32 i32, from_i64 i64, from_i128 i128,
        from_usize usize, from_u8 u8, from_u16 u16, from_u32 u32, from_u64 u64, from_u128 u128,
        from_f32 f32, from_f64 f64
    }
}

impl<T: Real + NumCast, const N: usize> NumCast for Dual<T, N> {
    #[inline]
    fn from<P: ToPrimitive>(number: P) -> Option<Self> {
        <T as NumCast>::from(number).map(Self::constant)
    }
}
