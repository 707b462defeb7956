use super::{Shift, UnsupportedFlattening};
use crate::math::{Polynomial, atan2, latitude as series, sin_cos_small};
use crate::{Ellipsoid, Real};

/// The small difference between two latitudes, as a function of the first.
///
/// A latitude is changed by adding this angle, or by a rotation through it. So the rounding of the correction
/// hardly counts, and a tiny latitude keeps its relative precision.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub(crate) enum Correction<T> {
    /// Zero: both latitudes are the same.
    None,
    /// Between latitudes whose tangents have a fixed ratio.
    Tangent(Tangent<T, false>),
    /// The same for a ratio near 1.
    Near(Tangent<T, true>),
    /// A short series, for the Earth's ellipsoids.
    Short(SineSeries<T, true>),
    /// A series of full length, for any ellipsoid.
    Long(SineSeries<T, false>),
}

/// Evaluates an expression with the correction as its own type, so that a loop chooses the kind once.
macro_rules! with_correction {
    ($correction:expr, $turn:ident => $result:expr) => {
        match $correction {
            $crate::latitude::Correction::None => {
                let $turn = &$crate::latitude::Unturned;
                $result
            }
            $crate::latitude::Correction::Tangent($turn) => $result,
            $crate::latitude::Correction::Near($turn) => $result,
            $crate::latitude::Correction::Short($turn) => $result,
            $crate::latitude::Correction::Long($turn) => $result,
        }
    };
}
pub(crate) use with_correction;

/// A kind of [`Correction`].
pub(crate) trait Turn<T: Real>: Copy {
    /// The difference in radians, from the sine and cosine of twice the latitude.
    fn angle(&self, double: (T, T)) -> T;

    /// The sine and cosine of the second latitude, from those of the first.
    fn turn(&self, latitude: (T, T)) -> (T, T);
}

/// Sine and cosine of twice a latitude.
#[inline(always)]
fn doubled<T: Real>((sin, cos): (T, T)) -> (T, T) {
    (T::of(2.0) * sin * cos, (cos - sin) * (cos + sin))
}

/// Turns a latitude by an angle, given by its sine and versed sine (1 − cos).
#[inline(always)]
fn turned<T: Real>((sin, cos): (T, T), (sine, versine): (T, T)) -> (T, T) {
    (sin + (cos * sine - sin * versine), cos - (sin * sine + cos * versine))
}

/// No correction.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Unturned;

impl<T: Real> Turn<T> for Unturned {
    #[inline(always)]
    fn angle(&self, _: (T, T)) -> T {
        T::ZERO
    }

    #[inline(always)]
    fn turn(&self, latitude: (T, T)) -> (T, T) {
        latitude
    }
}

/// −atan(m sin 2x/(1 + m cos 2x)): the latitudes whose tangents have the ratio (1 − m)/(1 + m).
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub(crate) struct Tangent<T, const NEAR: bool>(T);

/// atan t = t + t³p(t²) for |t| ≤ 0.0201: the next term is 1e-18 of t (`f64`), 1e-11 of t (`f32`).
const SMALL_ATAN: Polynomial<4, 2> = Polynomial {
    f64: [-1.0 / 3.0, 1.0 / 5.0, -1.0 / 7.0, 1.0 / 9.0],
    f32: [-1.0 / 3.0, 1.0 / 5.0],
};

/// 1 − 1/√(1 + t²) = t²p(t²), the versed sine of the same angle: the next term is 3e-18 (`f64`), 2e-11
/// (`f32`).
const SMALL_VERSINE: Polynomial<4, 2> = Polynomial {
    f64: [1.0 / 2.0, -3.0 / 8.0, 5.0 / 16.0, -35.0 / 128.0],
    f32: [1.0 / 2.0, -3.0 / 8.0],
};

impl<T: Real, const NEAR: bool> Turn<T> for Tangent<T, NEAR> {
    #[inline(always)]
    fn angle(&self, (sin2, cos2): (T, T)) -> T {
        let (sine, cosine) = (-(self.0 * sin2), T::ONE + self.0 * cos2);
        if NEAR {
            let t = sine / cosine;
            let square = t * t;
            t + t * (square * square.polynomial(&SMALL_ATAN))
        } else {
            atan2(sine, cosine)
        }
    }

    #[inline(always)]
    fn turn(&self, latitude: (T, T)) -> (T, T) {
        let (sin2, cos2) = doubled(latitude);
        let (n, d) = (-(self.0 * sin2), T::ONE + self.0 * cos2);
        if NEAR {
            let t = n / d;
            let square = t * t;
            let versine = square * square.polynomial(&SMALL_VERSINE);
            turned(latitude, (t - t * versine, versine))
        } else {
            let h = (n * n + d * d).sqrt();
            turned(latitude, (n / h, n * n / (h * (h + d))))
        }
    }
}

/// Σ cₖ sin 2kx. `SHORT`: the flattening is so small that the first terms are enough.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub(crate) struct SineSeries<T, const SHORT: bool>(pub(crate) [T; series::ORDER.0]);

/// The number of terms that reaches rounding for |n| ≤ 0.0018, the Earth's ellipsoids: the next term is at
/// most 2e-17 rad (`f32`: 3e-9).
const EARTH: (usize, usize) = (6, 3);

impl<T: Real, const SHORT: bool> Turn<T> for SineSeries<T, SHORT> {
    #[inline(always)]
    fn angle(&self, (sin2, cos2): (T, T)) -> T {
        clenshaw(&self.0, terms::<T>(SHORT), sin2, cos2)
    }

    #[inline(always)]
    fn turn(&self, latitude: (T, T)) -> (T, T) {
        let (sine, cosine) = sin_cos_small(self.angle(doubled(latitude)));
        turned(latitude, (sine, sine * sine / (T::ONE + cosine)))
    }
}

/// Returns the ellipsoid if the formula of a shift is accurate on it.
pub(crate) fn supported<T: Real>(
    ellipsoid: Ellipsoid<T>,
    shift: Shift,
) -> Result<Ellipsoid<T>, UnsupportedFlattening<T>> {
    let f = ellipsoid.f();
    let holds = match shift {
        Shift::Geodetic => true,
        // Beyond, the correction is not a small angle, and digits are lost.
        Shift::Geocentric | Shift::Parametric => f >= -T::ONE && f <= T::of(0.5),
        // 1/19, and room for its rounding.
        Shift::Authalic | Shift::Conformal | Shift::Rectifying => ellipsoid.n().abs() <= T::of(0.052_632),
    };
    if holds {
        Ok(ellipsoid)
    } else {
        Err(UnsupportedFlattening(f))
    }
}

impl<T: Real> Correction<T> {
    /// The correction from the geodetic latitude to that of a shift, on an ellipsoid known to be
    /// [`supported`].
    pub fn to_shifted(ellipsoid: Ellipsoid<T>, shift: Shift) -> Self {
        match shift {
            Shift::Geodetic => Self::None,
            Shift::Geocentric => tangent(geocentric(ellipsoid)),
            Shift::Parametric => tangent(ellipsoid.n()),
            Shift::Authalic => series(ellipsoid, &series::AUTHALIC),
            Shift::Conformal => series(ellipsoid, &series::CONFORMAL),
            Shift::Rectifying => series(ellipsoid, &series::RECTIFYING),
        }
    }

    /// The correction from the latitude of a shift to the geodetic one, on an ellipsoid known to be
    /// [`supported`].
    pub fn to_geodetic(ellipsoid: Ellipsoid<T>, shift: Shift) -> Self {
        match shift {
            Shift::Geodetic => Self::None,
            Shift::Geocentric => tangent(-geocentric(ellipsoid)),
            Shift::Parametric => tangent(-ellipsoid.n()),
            Shift::Authalic => series(ellipsoid, &series::AUTHALIC_INVERSE),
            Shift::Conformal => series(ellipsoid, &series::CONFORMAL_INVERSE),
            Shift::Rectifying => series(ellipsoid, &series::RECTIFYING_INVERSE),
        }
    }

    /// Bounds over all latitudes: the largest angle in radians; and a lower and an upper bound that hold both
    /// for the derivative of the second latitude by the first and for the ratio of their cosines.
    ///
    /// If the tangents have a fixed ratio, both lie between that ratio and its inverse. For δ(x) = Σ cₖ sin
    /// 2kx, the derivative is within Σ 2k|cₖ| of 1. So is cos(x + δ)/cos x = cos δ − sin δ tan x, apart from
    /// δ²/2, because
    /// |sin 2kx tan x| = |sin 2kx/sin 2x|·2 sin² x ≤ 2k.
    pub fn bounds(&self) -> (T, [T; 2]) {
        let one = T::ONE;
        let tangent = |m: T| {
            let m = m.abs();
            let ratio = (one + m) / (one - m);
            // The angle is asin m, which is at most tan asin m.
            (m / (one - m * m).sqrt(), [one / ratio, ratio])
        };
        let series = |coefficients: &[T]| {
            let (mut angle, mut slope) = (T::ZERO, T::ZERO);
            for (k, c) in (1..).zip(coefficients) {
                angle += c.abs();
                slope += T::whole(2 * k) * c.abs();
            }
            (angle, [one - slope - T::of(0.5) * angle * angle, one + slope])
        };
        match self {
            Self::None => (T::ZERO, [one, one]),
            Self::Tangent(Tangent(m)) | Self::Near(Tangent(m)) => tangent(*m),
            Self::Short(SineSeries(coefficients)) | Self::Long(SineSeries(coefficients)) => series(coefficients),
        }
    }

    /// The same function for another scalar.
    pub fn map<U: Real>(&self, scalar: impl Fn(T) -> U) -> Correction<U> {
        match *self {
            Self::None => Correction::None,
            Self::Tangent(Tangent(m)) => Correction::Tangent(Tangent(scalar(m))),
            Self::Near(Tangent(m)) => Correction::Near(Tangent(scalar(m))),
            Self::Short(SineSeries(coefficients)) => Correction::Short(SineSeries(coefficients.map(scalar))),
            Self::Long(SineSeries(coefficients)) => Correction::Long(SineSeries(coefficients.map(scalar))),
        }
    }
}

impl<T: Real> Turn<T> for Correction<T> {
    #[inline(always)]
    fn angle(&self, double: (T, T)) -> T {
        with_correction!(self, turn => turn.angle(double))
    }

    #[inline(never)]
    fn turn(&self, latitude: (T, T)) -> (T, T) {
        with_correction!(self, turn => turn.turn(latitude))
    }
}

/// m of the geocentric latitude, (1 − m)/(1 + m) = 1 − e².
fn geocentric<T: Real>(ellipsoid: Ellipsoid<T>) -> T {
    let e2 = ellipsoid.e2();
    e2 / (T::of(2.0) - e2)
}

/// The correction between latitudes whose tangents have the ratio (1 − m)/(1 + m).
fn tangent<T: Real>(m: T) -> Correction<T> {
    if m.abs() <= T::of(0.02) {
        Correction::Near(Tangent(m))
    } else {
        Correction::Tangent(Tangent(m))
    }
}

/// The series of a table.
fn series<T: Real, const N: usize, const M: usize>(
    ellipsoid: Ellipsoid<T>,
    table: &crate::math::Polynomial<N, M>,
) -> Correction<T> {
    let coefficients = coefficients(ellipsoid, table);
    if is_short(ellipsoid) {
        Correction::Short(SineSeries(coefficients))
    } else {
        Correction::Long(SineSeries(coefficients))
    }
}

/// Whether the first terms of a series are enough: how many they are, [`terms`] says.
pub(crate) fn is_short<T: Real>(ellipsoid: Ellipsoid<T>) -> bool {
    ellipsoid.n().abs() < T::of(0.0018)
}

/// The number of terms of a series, short or not.
#[inline(always)]
pub(crate) fn terms<T: Real>(short: bool) -> usize {
    let (f64, f32) = if short { EARTH } else { series::ORDER };
    T::terms(f64, f32)
}

/// The coefficients cₖ = nᵏpₖ(n).
pub(crate) fn coefficients<T: Real, const N: usize, const M: usize>(
    ellipsoid: Ellipsoid<T>,
    table: &crate::math::Polynomial<N, M>,
) -> [T; series::ORDER.0] {
    let n = ellipsoid.n();
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
    coefficients
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

#[cfg(test)]
mod tests {
    use super::*;

    /// The largest angle, and the smallest and largest value of the derivative and of the ratio of cosines.
    fn sampled(correction: Correction<f64>) -> (f64, [f64; 2]) {
        let at = |x: f64| x + correction.angle(doubled(x.sin_cos()));
        let (mut angle, [mut low, mut high]) = (0.0_f64, [1.0_f64; 2]);
        for n in -9000..9000 {
            let (x, step) = (f64::from(2 * n + 1) * core::f64::consts::PI / 36000.0, 1e-6);
            angle = angle.max((at(x) - x).abs());
            for ratio in [(at(x + step) - at(x - step)) / (2.0 * step), at(x).cos() / x.cos()] {
                (low, high) = (low.min(ratio), high.max(ratio));
            }
        }
        (angle, [low, high])
    }

    #[test]
    fn bounds_hold_and_are_close() {
        let mut kinds = 0;
        for f in [1.0 / 298.0, 0.03, 0.1, -0.1, 0.5, -1.0] {
            let ellipsoid = Ellipsoid::new(1.0, f).ok();
            for &shift in Shift::ALL {
                let both = [Correction::to_shifted, Correction::to_geodetic];
                let ellipsoid = ellipsoid.and_then(|ellipsoid| supported(ellipsoid, shift).ok());
                for correction in both.into_iter().filter_map(|new| Some(new(ellipsoid?, shift))) {
                    let (angle, [low, high]) = correction.bounds();
                    let (largest, [least, most]) = sampled(correction);
                    // Apart from the rounding of the difference quotient, a bound is not smaller than the
                    // value, and larger by no more than a part that grows with the flattening.
                    let close = |bound: f64, found: f64| {
                        (-1e-9..=(0.02 + 3.0 * f.abs()) * found + 1e-9).contains(&(bound - found))
                    };
                    assert!(
                        close(angle, largest) && close(high - 1.0, most - 1.0) && close(1.0 - low, 1.0 - least),
                        "{f} {shift}: {angle} {low} {high}, {largest} {least} {most}"
                    );
                    kinds += 1;
                }
            }
        }
        assert_eq!(kinds, 60);
    }
}
