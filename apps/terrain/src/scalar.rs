//! The two precisions a picture is drawn in.

use terrella::Real;

/// A scalar that a picture is drawn with.
pub trait Scalar: Real {
    /// A number of this precision.
    fn from_double(number: f64) -> Self;

    /// The nearest number of single precision, for colours.
    fn single(self) -> f32;
}

impl Scalar for f32 {
    fn from_double(number: f64) -> Self {
        number as Self
    }

    fn single(self) -> f32 {
        self
    }
}

impl Scalar for f64 {
    fn from_double(number: f64) -> Self {
        number
    }

    fn single(self) -> f32 {
        self as f32
    }
}

/// Three components of this precision.
pub fn lowered<T: Scalar>(vector: [f64; 3]) -> [T; 3] {
    vector.map(T::from_double)
}

pub fn dot<T: Scalar>(a: [T; 3], b: [T; 3]) -> T {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

pub fn normalised<T: Scalar>(vector: [T; 3]) -> [T; 3] {
    let length = dot(vector, vector).sqrt();
    vector.map(|v| v / length)
}
