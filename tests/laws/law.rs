//! What a law is: a function that takes bytes, makes its input of them, and panics where it does not hold.

use crate::bytes::Bytes;

#[derive(Clone, Copy)]
pub struct Law {
    pub double: fn(&mut Bytes<'_>),
    pub single: fn(&mut Bytes<'_>),
}

/// The laws of a room: for the fuzzer a list of them, in `cargo test` a test for each of them in each scalar. New ones come last: their
/// numbers are in the fuzzer's corpus.
macro_rules! laws {
    ($($law:ident)*) => {
        #[allow(dead_code)] // the fuzzer's
        pub const LAWS: &[$crate::law::Law] = &[$(
            $crate::law::Law { double: $law::<f64>, single: $law::<f32> },
        )*];

        $(
            #[cfg(test)]
            mod $law {
                #[test]
                fn double() {
                    crate::harness::holds(super::$law::<f64>);
                }

                #[test]
                fn single() {
                    crate::harness::holds(super::$law::<f32>);
                }
            }
        )*
    };
}
pub(crate) use laws;

/// The law and the scalar that the first byte says, on the bytes after it.
pub fn run(laws: &[Law], bytes: &[u8]) {
    let mut bytes = Bytes::new(bytes);
    let first = usize::from(bytes.byte());
    let law = laws[first / 2 % laws.len()];
    let judge = if first % 2 == 0 { law.double } else { law.single };
    judge(&mut bytes);
}
