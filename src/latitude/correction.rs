use super::{Shift, UnsupportedFlattening};
use crate::math::{atan2, latitude as series, sin_cos_small};
use crate::{Dual, Ellipsoid, Real};

/// The small angle between two latitudes, as a function of the first.
///
/// A latitude is only ever changed by adding this angle or turning by it, so that its own rounding hardly counts and a tiny
/// latitude keeps its relative precision.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub(super) enum Correction<T> {
    /// Zero.
    None,
    /// −atan(m sin 2x/(1 + m cos 2x)): the latitudes whose tangents have a fixed ratio (1 − m)/(1 + m).
    Tangent(T),
    /// Σ cₖ sin 2kx.
    Series {
        coefficients: [T; series::ORDER.0],
        /// Whether the flattening is so small that the first [`SHORT`] terms are enough.
        short: bool,
    },
}

/// Terms that reach rounding for |n| ≤ 0.0018, the Earth's ellipsoids: the next one is at most 2e-17 rad (3e-9 in `f32`).
const SHORT: (usize, usize) = (6, 3);

impl<T: Real> Correction<T> {
    /// From the geodetic to the shifted latitude.
    pub fn to_shifted(ellipsoid: Ellipsoid<T>, shift: Shift) -> Result<Self, UnsupportedFlattening<T>> {
        match shift {
            Shift::Geodetic => Ok(Self::None),
            Shift::Geocentric => tangent(ellipsoid, geocentric(ellipsoid)),
            Shift::Parametric => tangent(ellipsoid, ellipsoid.n()),
            Shift::Authalic => series(ellipsoid, &series::AUTHALIC),
            Shift::Conformal => series(ellipsoid, &series::CONFORMAL),
            Shift::Rectifying => series(ellipsoid, &series::RECTIFYING),
        }
    }

    /// From the shifted to the geodetic latitude.
    pub fn to_geodetic(ellipsoid: Ellipsoid<T>, shift: Shift) -> Result<Self, UnsupportedFlattening<T>> {
        match shift {
            Shift::Geodetic => Ok(Self::None),
            Shift::Geocentric => tangent(ellipsoid, -geocentric(ellipsoid)),
            Shift::Parametric => tangent(ellipsoid, -ellipsoid.n()),
            Shift::Authalic => series(ellipsoid, &series::AUTHALIC_INVERSE),
            Shift::Conformal => series(ellipsoid, &series::CONFORMAL_INVERSE),
            Shift::Rectifying => series(ellipsoid, &series::RECTIFYING_INVERSE),
        }
    }

    /// The same function for a scalar with derivatives.
    pub fn lifted<const N: usize>(&self) -> Correction<Dual<T, N>> {
        match *self {
            Self::None => Correction::None,
            Self::Tangent(m) => Correction::Tangent(Dual::constant(m)),
            Self::Series { coefficients, short } => Correction::Series {
                coefficients: coefficients.map(Dual::constant),
                short,
            },
        }
    }

    /// The angle in radians, from sine and cosine of twice the latitude.
    #[inline(always)]
    pub fn angle(&self, (sin2, cos2): (T, T)) -> T {
        match *self {
            Self::None => T::ZERO,
            Self::Tangent(m) => atan2(-(m * sin2), T::ONE + m * cos2),
            Self::Series {
                ref coefficients,
                short,
            } => {
                if short {
                    clenshaw(coefficients, T::terms(SHORT.0, SHORT.1), sin2, cos2)
                } else {
                    clenshaw(coefficients, T::terms(series::ORDER.0, series::ORDER.1), sin2, cos2)
                }
            }
        }
    }

    /// Sine and cosine of the other latitude from those of the first.
    #[inline(always)]
    pub fn turn(&self, (sin, cos): (T, T)) -> (T, T) {
        let two = T::of(2.0);
        let sin2 = two * sin * cos;
        let cos2 = (cos - sin) * (cos + sin);
        // Sine and versed sine (1 − cos) of the correction.
        let (sine, versine) = match *self {
            Self::None => return (sin, cos),
            Self::Tangent(m) => {
                let n = -(m * sin2);
                let d = T::ONE + m * cos2;
                let h = (n * n + d * d).sqrt();
                (n / h, n * n / (h * (h + d)))
            }
            Self::Series { .. } => {
                let (sine, cosine) = sin_cos_small(self.angle((sin2, cos2)));
                (sine, sine * sine / (T::ONE + cosine))
            }
        };
        (sin + (cos * sine - sin * versine), cos - (sin * sine + cos * versine))
    }
}

/// m of the geocentric latitude, (1 − m)/(1 + m) = 1 − e².
fn geocentric<T: Real>(ellipsoid: Ellipsoid<T>) -> T {
    let e2 = ellipsoid.e2();
    e2 / (T::of(2.0) - e2)
}

/// The correction of a fixed ratio of tangents. Beyond these flattenings it is no small angle, and loses digits.
fn tangent<T: Real>(ellipsoid: Ellipsoid<T>, m: T) -> Result<Correction<T>, UnsupportedFlattening<T>> {
    let f = ellipsoid.f();
    if f < -T::ONE || f > T::of(0.5) {
        return Err(UnsupportedFlattening(f));
    }
    Ok(Correction::Tangent(m))
}

/// The coefficients cₖ = nᵏpₖ(n).
fn series<T: Real, const N: usize, const M: usize>(
    ellipsoid: Ellipsoid<T>,
    table: &crate::math::Polynomial<N, M>,
) -> Result<Correction<T>, UnsupportedFlattening<T>> {
    let n = ellipsoid.n();
    // 1/19, and room for its rounding.
    if n.abs() > T::of(0.052_632) {
        return Err(UnsupportedFlattening(ellipsoid.f()));
    }
    let order = T::terms(series::ORDER.0, series::ORDER.1);
    let mut coefficients = [T::ZERO; series::ORDER.0];
    let mut power = T::ONE;
    let mut start = 0;
    for (k, coefficient) in coefficients.iter_mut().enumerate().take(order) {
        power *= n;
        let length = order - k;
        let mut sum = T::ZERO;
        for i in (start..start + length).rev() {
            sum = sum * n + T::coefficient(table, i);
        }
        start += length;
        *coefficient = power * sum;
    }
    Ok(Correction::Series {
        coefficients,
        short: n.abs() < T::of(0.0018),
    })
}

/// Σ cₖ sin 2kx by Clenshaw's recurrence.
#[inline(always)]
fn clenshaw<T: Real>(coefficients: &[T], terms: usize, sin2: T, cos2: T) -> T {
    let twice = cos2 + cos2;
    let (mut b1, mut b2) = (T::ZERO, T::ZERO);
    for &c in coefficients.iter().take(terms).rev() {
        (b1, b2) = (c + (twice * b1 - b2), b1);
    }
    sin2 * b1
}
