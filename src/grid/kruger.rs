//! Krüger's series as numbers of one ellipsoid: between the complex conformal and rectifying latitudes.

use crate::math::kruger as series;
use crate::math::{Complex, Polynomial};
use crate::{Ellipsoid, Real};

/// Coefficients of Σ cⱼ sin 2jζ.
pub(super) type Coefficients<T> = [T; series::ORDER.0];

/// αⱼ, from the conformal to the rectifying latitude.
pub(super) fn forward<T: Real>(ellipsoid: Ellipsoid<T>) -> Coefficients<T> {
    coefficients(ellipsoid.n(), &series::FORWARD)
}

/// −βⱼ, from the rectifying to the conformal latitude.
pub(super) fn inverse<T: Real>(ellipsoid: Ellipsoid<T>) -> Coefficients<T> {
    coefficients(ellipsoid.n(), &series::INVERSE).map(|c| T::ZERO - c)
}

/// The radius of the circle that is as long as a meridian.
pub(super) fn rectifying_radius<T: Real>(ellipsoid: Ellipsoid<T>) -> T {
    let n = ellipsoid.n();
    ellipsoid.a() * series::RECTIFYING_RADIUS.at(n * n) / (T::ONE + n)
}

/// cⱼ = nʲpⱼ(n).
fn coefficients<T: Real, const N: usize, const M: usize>(n: T, table: &Polynomial<N, M>) -> Coefficients<T> {
    let order = T::terms(series::ORDER.0, series::ORDER.1);
    let mut coefficients = [T::ZERO; series::ORDER.0];
    let (mut power, mut start) = (T::ONE, 0);
    for (j, coefficient) in coefficients.iter_mut().enumerate().take(order) {
        power *= n;
        let end = start + order - j;
        *coefficient = power
            * (start..end)
                .rev()
                .fold(T::ZERO, |sum, i| sum * n + T::coefficient(table, i));
        start = end;
    }
    coefficients
}

/// Σ cⱼ sin 2jζ of ζ = ξ + iη, from sine and cosine of 2ξ and hyperbolic sine and cosine of 2η, by Clenshaw's
/// recurrence.
#[inline(always)]
pub(super) fn sum<T: Real>(coefficients: &Coefficients<T>, (sin, cos): (T, T), (sinh, cosh): (T, T)) -> Complex<T> {
    let sine = Complex {
        re: sin * cosh,
        im: cos * sinh,
    };
    let cosine = Complex {
        re: cos * cosh,
        im: T::ZERO - sin * sinh,
    };
    let twice = cosine + cosine;
    let zero = Complex {
        re: T::ZERO,
        im: T::ZERO,
    };
    let (mut b1, mut b2) = (zero, zero);
    for &c in coefficients
        .iter()
        .take(T::terms(series::ORDER.0, series::ORDER.1))
        .rev()
    {
        let product = twice * b1;
        let next = Complex {
            re: c + (product.re - b2.re),
            im: product.im - b2.im,
        };
        (b1, b2) = (next, b1);
    }
    sine * b1
}
