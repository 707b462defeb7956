//! What a property is: a function that takes bytes, makes its input of them, and panics where it does not hold.

use crate::bytes::Bytes;

#[derive(Clone, Copy)]
pub struct Property {
    pub double: fn(&mut Bytes<'_>),
    pub single: fn(&mut Bytes<'_>),
}

/// The properties of a room: a list of them for the fuzzer, and in `cargo test` a test for each of them in each
/// scalar. New ones come last: their numbers are in the fuzzer's corpus.
#[macro_export]
macro_rules! properties {
    ($($property:ident)*) => {
        #[allow(dead_code)] // the fuzzer's
        pub const PROPERTIES: &[$crate::property::Property] = &[$(
            $crate::property::Property { double: $property::<f64>, single: $property::<f32> },
        )*];

        $(
            #[cfg(test)]
            mod $property {
                #[test]
                fn double() {
                    $crate::harness::holds(super::$property::<f64>);
                }

                #[test]
                fn single() {
                    $crate::harness::holds(super::$property::<f32>);
                }
            }
        )*
    };
}

/// The property and the scalar that the first byte says, on the bytes after it.
pub fn run(properties: &[Property], bytes: &[u8]) {
    let mut bytes = Bytes::new(bytes);
    let first = usize::from(bytes.byte());
    let property = properties[first / 2 % properties.len()];
    let judge = if first % 2 == 0 {
        property.double
    } else {
        property.single
    };
    judge(&mut bytes);
}
