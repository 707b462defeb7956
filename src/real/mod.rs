//! [`Real`], the scalar that every function is generic over.

use core::fmt::{Debug, Display};
use core::iter::{Product, Sum};
use core::ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Rem, RemAssign, Sub, SubAssign};

mod float;
mod kernel;
mod literal;
mod polynomial;
mod remainder;
mod repeat;
#[cfg(not(feature = "std"))]
mod sqrt;

pub(crate) use kernel::Kernel;
pub(crate) use literal::{Constant, Literal, literal};
pub use polynomial::Polynomial;
pub(crate) use polynomial::complex_polynomial;
pub(crate) use repeat::repeat;

/// A scalar: `f32`, `f64`, or [`Dual`](crate::Dual) over another scalar. The trait is sealed.
///
/// `Real` has constants, operators, conversions and four methods. The other functions of a scalar are in
/// [`math`](crate::math): `sin_cos`, `atan2`, `cbrt`, `min`, `max` and more. A number's `Into<f64>` gives its
/// value.
///
/// The four methods [`sqrt`](Self::sqrt), [`abs`](Self::abs), [`copysign`](Self::copysign) and
/// [`is_finite`](Self::is_finite) mean what they mean for `f64`, and `Real` has no other name that `f64` has.
/// So `use terrella::Real` does not change the meaning of `x.round()`. Where `num_traits::Float` is in scope
/// too, write `Real::sqrt(x)` or `Float::sqrt(x)` for these four, if the compiler asks which.
///
/// A function generic over `Real` does no `f64` arithmetic on `f32`, as long as [`of`](Self::of) is only
/// called with constants.
///
/// ```
/// use terrella::Real;
/// use terrella::math::cbrt;
///
/// /// The radius of the sphere that has the volume of a triaxial ellipsoid.
/// fn mean_radius<T: Real>(a: T, b: T, c: T) -> T {
///     cbrt(a * b * c)
/// }
/// assert_eq!(mean_radius(1.0_f32, 3.0, 9.0), 3.0);
///
/// /// The length of a side of a right-angled triangle.
/// fn cathetus<T: Real>(hypotenuse: T, other: T) -> T {
///     ((hypotenuse - other) * (hypotenuse + other)).sqrt()
/// }
/// assert_eq!(cathetus(5.0_f64, 3.0), 4.0);
/// ```
#[doc(alias = "Float")]
#[doc(alias = "Scalar")]
#[allow(private_bounds)] // what the kernels need of a scalar is no part of the interface
pub trait Real:
    Kernel
    + Copy
    + Default
    + Debug
    + Display
    + PartialEq
    + PartialOrd
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Rem<Output = Self>
    + Neg<Output = Self>
    + AddAssign
    + SubAssign
    + MulAssign
    + DivAssign
    + RemAssign
    + Sum
    + Product
    + Into<f64>
    + Send
    + Sync
    + 'static
{
    /// The scalar without derivatives: `f32` or `f64`.
    type Plain: Real;

    /// 0.
    const ZERO: Self;
    /// 1.
    const ONE: Self;
    /// The distance from 1 to the next larger number: 2⁻²³ for `f32`, 2⁻⁵² for `f64`.
    const EPSILON: Self;
    /// The number of binary digits: 24 for `f32`, 53 for `f64`.
    const DIGITS: u32;

    /// Converts a literal or a constant to the nearest scalar, such as `T::of(core::f64::consts::PI)`.
    ///
    /// The compiler evaluates the conversion of a constant: nothing of it is left at run time.
    ///
    /// ```
    /// use terrella::Real;
    /// assert_eq!(f32::of(0.1), 0.1_f32);
    /// ```
    #[doc(alias = "from_f64")]
    #[must_use]
    fn of(literal: f64) -> Self;

    /// Converts an integer to the nearest scalar.
    ///
    /// ```
    /// use terrella::Real;
    /// assert_eq!(f32::whole(16_777_217), 16_777_216.0);
    /// ```
    #[doc(alias = "from_u64")]
    #[must_use]
    fn whole(integer: u64) -> Self;

    /// Returns the value without derivatives. A plain scalar returns itself.
    #[doc(alias = "value")]
    #[must_use]
    fn plain(self) -> Self::Plain;

    /// Makes a scalar whose derivatives are 0.
    #[must_use]
    fn from_plain(value: Self::Plain) -> Self;

    /// Returns the square root, correctly rounded. It is NaN below 0, and −0 of −0.
    ///
    /// The derivative at 0 is infinite; it is NaN by a variable that the argument does not depend on.
    #[must_use]
    fn sqrt(self) -> Self;

    /// Returns the absolute value.
    ///
    /// The derivative at 0 is 1, and −1 at −0.
    #[doc(alias = "fabs")]
    #[must_use]
    fn abs(self) -> Self;

    /// Returns the absolute value of `self` with the sign of `sign`. The sign of a zero counts.
    #[must_use]
    fn copysign(self, sign: Self) -> Self;

    /// Returns whether the value is neither infinite nor NaN. Derivatives do not count.
    #[must_use]
    fn is_finite(self) -> bool;
}
