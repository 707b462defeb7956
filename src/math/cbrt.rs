use crate::Real;

/// Cube root of a positive normal number.
///
/// Within 0.8 ulp. Halley's iteration from a guess that divides the exponent by three; a fixed number of steps.
///
/// ```
/// assert_eq!(terrella::math::cbrt(27.0_f64), 3.0);
/// ```
#[must_use]
#[inline]
pub fn cbrt<T: Real>(x: T) -> T {
    let mut root = x.cbrt_guess();
    for _ in 0..T::terms(3, 2) {
        let cube = root * root * root;
        root += root * ((x - cube) / (cube + cube + x));
    }
    root
}
