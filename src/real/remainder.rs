use super::Real;

/// The remainder of a division with the sign of the dividend, exact; NaN of an infinite dividend or by zero.
///
/// One step for each binary digit of the quotient. C's `fmod`, which the `libm` crate has with a panic in it.
pub(crate) fn remainder<T: Real>(dividend: T, divisor: T) -> T {
    let (mut rest, least) = (dividend.abs(), divisor.abs());
    if !(rest.is_finite() && least > T::ZERO) {
        return T::of(f64::NAN);
    }
    if rest < least {
        return dividend;
    }
    let half = T::of(0.5);
    let mut part = least;
    while part <= rest * half {
        part += part;
    }
    // Each difference is exact: part ≤ rest < 2·part.
    while part >= least {
        if part <= rest {
            rest -= part;
        }
        part *= half;
    }
    rest.copysign(dividend)
}
