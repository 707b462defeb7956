//! Two places on the auxiliary sphere, and the great circle between them for one ω₁₂.

use core::f64::consts::PI;

use crate::geodesic::angle::{Angle, longitude_difference};
use crate::geodesic::sphere::{Triangle, parametric_by_reciprocal};
use crate::math::{
    DoubleWord, Polynomial, choose, halves, max, min, mirrored, negated, octant, sin_cos_eighth, sin_cos_quarter,
};
use crate::{LatLon, Real};

/// The places of an inverse problem, the one of greater latitude first, so that both directions of a line
/// have the same bits.
///
/// Seen from point 1, or near the antipode from the antipode of point 1 ([`Triangle`]): there π − ω₁₂ and π −
/// λ₁₂ stand for ω₁₂ and λ₁₂.
#[derive(Clone, Copy)]
pub struct Pair<T> {
    pub(super) phi1: T,
    pub(super) phi2: T,
    pub(super) beta1: Angle<T>,
    pub(super) beta2: Angle<T>,
    /// sin(β₂ ∓ β₁)/sin(φ₂ ∓ φ₁).
    scale: T,
    /// λ₁₂ in degrees, and λ₁₂/2.
    pub lambda12: T,
    pub half_lambda12: Angle<T>,
    /// What the rounding of λ₁₂ lost, in radians.
    pub rest: T,
    /// −1 westward.
    east: T,
    /// Whether the places were exchanged.
    pub swap: bool,
    /// Whether the places are seen from the antipode of point 1; then `side` is −1, else 1.
    pub(super) antipodal: bool,
    pub side: T,
    /// sin(β₂ − β₁), or sin(β₂ + β₁).
    pub(super) rise: T,
    /// The smallest ω₁₂ near the antipode.
    pub(super) least_omega: T,
    /// Whether the equator is the shortest line.
    equatorial: bool,
}

/// The great circle between two places for one ω₁₂.
#[derive(Clone, Copy)]
pub struct Trial<T> {
    /// sin σ₁₂ times sine and cosine of the azimuths.
    pub course1: Angle<T>,
    pub course2: Angle<T>,
    /// 1/sin²σ₁₂.
    pub(super) inverse_square: T,
    pub sin_sigma12: T,
    pub cos_sigma12: T,
    pub sin_alpha0: T,
    pub cos2_alpha0: T,
    /// d sin α₀/dω₁₂.
    pub(super) dsin_alpha0: T,
    /// cos²α₀ cos 2σₘ.
    pub cos_2sigma_m: T,
}

impl<T: Real> Pair<T> {
    /// The places, not seen yet; `axes` is b/a.
    #[cfg_attr(not(small), inline(always))]
    pub fn new(axes: T, from: LatLon<T>, to: LatLon<T>) -> Self {
        let DoubleWord { high, low } = longitude_difference(from, to);
        let east = T::ONE.copysign(high);
        let swap = from.lat().abs() < to.lat().abs();
        let phi1 = choose(swap, to.lat(), from.lat());
        let phi2 = choose(swap, from.lat(), to.lat());
        let (beta1, inverse1) = parametric_by_reciprocal(phi1, axes);
        let (beta2, inverse2) = parametric_by_reciprocal(phi2, axes);
        Self {
            phi1,
            phi2,
            beta1,
            beta2,
            scale: axes * inverse1 * inverse2,
            lambda12: high.abs(),
            half_lambda12: sin_cos_quarter(high.abs() * T::of(0.5)).into(),
            rest: low * east * T::of(PI / 180.0),
            east,
            swap,
            antipodal: false,
            side: T::ONE,
            rise: T::ZERO,
            least_omega: T::ZERO,
            // On an oblate ellipsoid it is up to the conjugate point, where ω₁₂ is π.
            equatorial: (phi1 == T::ZERO) & (high.abs() < T::of(180.0) * axes),
        }
    }

    /// Whether the places are so nearly antipodal, 170° apart or more, that ω₁₂ turns the line faster than
    /// λ₁₂ tells it; along the equator it does not.
    #[inline(always)]
    pub fn nearly_antipodal(&self) -> bool {
        let sin_half = self.half_lambda12.sin;
        let cos_lambda12 = T::ONE - (sin_half + sin_half) * sin_half;
        let (beta1, beta2) = (self.beta1, self.beta2);
        let cos_sigma12 = beta1.sin * beta2.sin + beta1.cos * beta2.cos * cos_lambda12;
        (self.lambda12 >= T::of(90.0)) & (cos_sigma12 < T::of(-0.985)) & !self.equatorial
    }

    /// Whether, seen as it is, the second place is neither north nor south of the first.
    #[inline(always)]
    pub(super) fn is_level(&self) -> bool {
        self.rise.abs() <= T::EPSILON
    }

    /// π − λ₁₂.
    #[inline(always)]
    pub fn supplement(&self) -> T {
        (T::of(180.0) - self.lambda12) * T::of(PI / 180.0) - self.rest
    }

    /// An azimuth of the problem as it was put, in degrees, from one of the great circle and what that turns
    /// by in radians.
    #[cfg_attr(not(small), inline(always))]
    #[cfg_attr(small, inline(never))]
    pub fn azimuth(&self, Angle { sin, cos }: Angle<T>, turn: T) -> T {
        let (eighths, small) = octant(sin.abs(), cos);
        let (eighths, small) = (
            mirrored(self.swap, T::of(4.0), eighths),
            negated(self.swap, small + turn),
        );
        let azimuth = eighths * T::of(45.0) + small * T::of(180.0 / PI);
        min(azimuth, T::of(180.0)).copysign(sin * self.east + T::ZERO)
    }

    /// Sees the places from point 1, or from its antipode.
    #[inline(always)]
    pub fn see(&mut self, antipodal: bool) {
        self.antipodal = antipodal;
        self.side = if antipodal { -T::ONE } else { T::ONE };
        let apart = self.phi2 - self.side * self.phi1;
        self.rise = choose(
            apart.abs() <= T::of(45.0),
            sin_cos_eighth(apart * T::of(PI / 180.0)).0 * self.scale,
            self.beta2.sin * self.beta1.cos - self.side * (self.beta2.cos * self.beta1.sin),
        );
    }

    /// How much ω₁₂ has grown after one more step.
    #[inline(always)]
    pub(super) fn stepped(&self, growth: T, step: T) -> T {
        if self.antipodal {
            max(growth + step, self.least_omega)
        } else {
            growth + step
        }
    }

    /// The great circle for ω₁₂ = λ₁₂ and so much more; near the antipode for this ω₁₂, to a quarter circle.
    #[cfg_attr(not(small), inline(always))]
    pub fn grown(&self, by: T) -> Trial<T> {
        let by = by * T::of(0.5);
        self.trial(if self.antipodal {
            sin_cos_eighth(by).into()
        } else {
            self.half_lambda12.plus_small(by)
        })
    }

    /// The great circle for one ω₁₂/2.
    #[inline(always)]
    pub fn trial(&self, half_omega12: Angle<T>) -> Trial<T> {
        let (beta1, beta2) = (self.beta1, self.beta2);
        let twice = half_omega12.sin + half_omega12.sin;
        let versine = twice * half_omega12.sin;
        let omega = Angle {
            sin: twice * half_omega12.cos,
            cos: T::ONE - versine,
        };
        let triangle = Triangle::new(self.side, [beta1, beta2], self.rise, omega, versine);
        let (course1, course2) = (triangle.course1, triangle.course2);
        let square = course1.sin * course1.sin + course1.cos * course1.cos;
        let (sin_sigma12, inverse_square) = (square.sqrt(), T::ONE / max(square, T::pick(1e-300, 1e-37)));
        let inverse = sin_sigma12 * inverse_square;
        let cos_sigma12 = triangle.cos_sigma();
        let sin_alpha0 = beta1.cos * course1.sin * inverse;
        let cos2_alpha0 = T::ONE - sin_alpha0 * sin_alpha0;
        let dsin_alpha0 = if self.antipodal {
            // Without a difference, of which near the antipode no digit would be left.
            beta1.cos * beta2.cos * (course1.cos * inverse) * (course2.cos * inverse_square)
        } else {
            (triangle.cosines - sin_alpha0 * sin_alpha0 * cos_sigma12) * inverse
        };
        Trial {
            course1,
            course2,
            inverse_square,
            sin_sigma12,
            cos_sigma12,
            sin_alpha0,
            cos2_alpha0,
            dsin_alpha0,
            cos_2sigma_m: cos2_alpha0 * cos_sigma12 - (triangle.sines + triangle.sines),
        }
    }
}

impl<T: Real> Trial<T> {
    /// σ₁₂ but for 2e-7.
    #[inline(always)]
    pub(super) fn rough_sigma12(&self, antipodal: bool) -> T {
        let of = T::of;
        if antipodal {
            // The supplement from its sine.
            let s = self.sin_sigma12;
            let z = s * s;
            let curve = of(1.0 / 6.0) + z * (of(3.0 / 40.0) + z * (of(15.0 / 336.0) + z * of(105.0 / 3456.0)));
            return of(PI) - (s + s * z * curve);
        }
        // tan σ/2, or of the supplement; its square without waiting for the root in sin σ.
        let cos = self.cos_sigma12.abs();
        let reciprocal = T::ONE / (T::ONE + cos);
        let (t, z) = (self.sin_sigma12 * reciprocal, (T::ONE - cos) * reciprocal);
        let curve = halves(z, 8, |i| T::coefficient(&ROUGH_ATAN, i));
        let angle = (t + t) * curve;
        mirrored(self.cos_sigma12 < T::ZERO, of(PI), angle)
    }
}

/// atan t/t by powers of t², 0 ≤ t ≤ 1; error 1.2e-7.
const ROUGH_ATAN: Polynomial<8, 8> = Polynomial::rounded([
    0.999_999_881_996, -0.333_318_126_556, 0.199_669_618_296, -0.140_032_901_847, 0.098_688_654_581_3,
    -0.058_829_753_143_1, 0.023_780_518_597_2, -0.004_559_791_986_13,
]);
