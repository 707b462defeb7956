//! From `f32` to `f64`, and back by rounding.

use super::{Aer, Enu, GeodeticOffset, Ned};

macro_rules! precision {
    ($($name:ident { $($field:ident),* })*) => {$(
        impl From<$name<f32>> for $name {
            /// The same numbers: every `f32` is an `f64`.
            fn from(from: $name<f32>) -> Self {
                Self { $($field: from.$field.into()),* }
            }
        }

        impl $name {
            /// Returns the three numbers rounded to the nearest `f32`; beyond the largest `f32` it is
            /// infinite.
            #[must_use]
            pub const fn to_f32(self) -> $name<f32> {
                $name { $($field: self.$field as f32),* }
            }
        }
    )*};
}

precision! {
    Enu { east, north, up }
    Ned { north, east, down }
    Aer { azimuth, elevation, range }
    GeodeticOffset { lat, lon, height }
}
