//! The truth, as the tests read it.

pub use testkit::truth::{Row, Scalar, Truth};

/// The rows of a truth file whose inputs are exact in the scalar, kept for as long as the program runs.
pub fn rows<T: Scalar>(name: &str, inputs: &[&str]) -> Vec<Row<'static>> {
    Box::leak(Box::new(Truth::read(name))).exact_in::<T>(inputs)
}
