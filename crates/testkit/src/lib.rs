//! What the tests share: the largest of many errors, among which a NaN is not lost as it is by `f64::max`; the truth and the table of
//! what is claimed; and the numbers, bytes and vectors of the properties.

#![cfg_attr(not(feature = "std"), no_std)]

#[cfg(feature = "std")]
pub mod bytes;
#[cfg(feature = "std")]
pub mod double;
#[cfg(feature = "std")]
pub mod generated;
#[cfg(feature = "tests")]
pub mod harness;
#[cfg(feature = "tests")]
pub mod instances;
#[cfg(feature = "std")]
pub mod measure;
#[cfg(feature = "std")]
pub mod nearest;
#[cfg(feature = "std")]
pub mod parallel;
#[cfg(feature = "std")]
pub mod program;
#[cfg(feature = "std")]
pub mod property;
#[cfg(feature = "std")]
pub mod scalar;
#[cfg(feature = "std")]
pub mod table;
#[cfg(feature = "tests")]
pub mod tiles;
#[cfg(feature = "std")]
pub mod truth;
#[cfg(feature = "std")]
pub mod unfolded;
#[cfg(feature = "std")]
pub mod vector;
mod worst;

pub use worst::Worst;

/// The larger of two numbers; NaN where either is.
pub fn maximum<T: PartialOrd>(a: T, b: T) -> T {
    if a > b || is_nan(&a) { a } else { b }
}

/// The smaller of two numbers; NaN where either is.
pub fn minimum<T: PartialOrd>(a: T, b: T) -> T {
    if a < b || is_nan(&a) { a } else { b }
}

/// Whether it is not even equal to itself.
fn is_nan<T: PartialOrd>(a: &T) -> bool {
    a.partial_cmp(a).is_none()
}

#[cfg(test)]
mod tests {
    use super::{maximum, minimum};

    #[test]
    fn a_nan_on_either_side_is_kept() {
        assert!(maximum(f64::NAN, 1.0).is_nan() && maximum(1.0, f64::NAN).is_nan());
        assert!(minimum(f32::NAN, 1.0).is_nan() && minimum(1.0, f32::NAN).is_nan());
        assert!(maximum(f64::INFINITY, f64::NAN).is_nan() && minimum(f64::NEG_INFINITY, f64::NAN).is_nan());
    }

    #[test]
    fn numbers_are_compared() {
        assert_eq!(
            [maximum(-2.0, 1.0), maximum(1.0, -2.0), maximum(3.0, 3.0)],
            [1.0, 1.0, 3.0]
        );
        assert_eq!(
            [minimum(-2.0, 1.0), minimum(1.0, -2.0), minimum(3.0, 3.0)],
            [-2.0, -2.0, 3.0]
        );
        assert_eq!([0.5, 2.0, -1.0].into_iter().fold(0.0, maximum), 2.0);
    }
}
