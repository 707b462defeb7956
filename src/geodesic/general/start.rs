//! Where Newton's method begins (Karney, section 5), or the answer itself for a short line.

use core::f64::consts::PI;

use super::Solver;
use super::astroid::astroid;
use super::canonical::{Canonical, Segment, side, tiny};
use crate::Real;
use crate::geodesic::angle::Angle;
use crate::geodesic::series::Integrals;
use crate::geodesic::sphere::Triangle;
use crate::math::{atan2, max, min, select, sin_cos};

/// What is known before Newton's method begins.
pub(super) enum Guess<T> {
    /// The line itself, between neighbours.
    Short(Segment<T>),
    /// α₁ to begin with.
    Azimuth(Angle<T>),
}

impl<T: Real> Canonical<T> {
    /// The α₁ that Newton's method begins with, or the answer itself for a short line.
    pub(super) fn guess(&self, solver: &Solver<T>) -> Guess<T> {
        let (beta1, beta2) = (self.beta1, self.beta2);
        let half = T::of(0.5);
        let rise_cos = beta2.cos * beta1.cos + beta2.sin * beta1.sin;
        let short = rise_cos >= T::ZERO && self.rise < half && beta2.cos * self.lambda < half;
        let mut dn = T::ONE;
        let mut omega = self.lambda12;
        if short {
            // ω₁₂ = λ₁₂/((1 − f)dn) at the middle latitude, as λ₁₂ and a little more.
            let sines = (beta1.sin + beta2.sin) * (beta1.sin + beta2.sin);
            let cosines = (beta1.cos + beta2.cos) * (beta1.cos + beta2.cos);
            let ellipsoid = solver.ellipsoid;
            dn = (T::ONE + ellipsoid.ep2() * (sines / (sines + cosines))).sqrt();
            let scale = solver.axes * dn;
            let more = ellipsoid.e2() * (cosines / (sines + cosines)) / (scale * (T::ONE + scale));
            omega = omega.plus(Angle::radians(self.lambda * more));
            // Rounded past π it would pass the pole on the other side, and half of the ellipsoid be under it
            // with the other sign.
            omega.sin = select(omega.sin < T::ZERO, tiny(), omega.sin);
        }
        // β₁ + β₂ in (−π, 0].
        let sum_sin = beta2.sin * beta1.cos + beta2.cos * beta1.sin;
        let ([mut alpha1, alpha2], sigma) = if omega.cos >= T::ZERO {
            self.triangle(omega)
        } else {
            // From the antipode of point 1.
            let seen = Angle {
                sin: omega.sin,
                cos: -omega.cos,
            };
            let versine = omega.sin * omega.sin / (T::ONE + seen.cos);
            let triangle = Triangle::new(-T::ONE, [beta1, beta2], sum_sin, seen, versine);
            // Not the triangle's: next to a pole places may be as far apart in longitude, and yet neighbours.
            let alpha2 = Angle {
                sin: beta1.cos * omega.sin,
                cos: self.rise - beta1.cos * beta2.sin * (T::ONE - omega.cos),
            };
            ([triangle.course1, alpha2], side(&triangle))
        };
        if short && sigma.sin < solver.short {
            let sigma12 = sigma.to_radians();
            let along = Angle::radians(sigma12 / dn);
            let b = solver.ellipsoid.b();
            return Guess::Short(Segment {
                sigma12,
                distance: sigma12 * dn * b,
                reduced: dn * dn * b * along.sin,
                scales: [along.cos; 2],
                alpha1: Angle::of(alpha1.sin, alpha1.cos),
                alpha2: Angle::of(alpha2.sin, alpha2.cos),
                omega12: Some(omega),
                evaluations: 0,
            });
        }
        let n = solver.ellipsoid.n().abs();
        if sigma.cos < T::ZERO && sigma.sin < T::of(6.0 * PI) * n * beta1.cos * beta1.cos {
            alpha1 = self.antipodal(solver, sum_sin);
        }
        Guess::Azimuth(if alpha1.sin > T::ZERO {
            Angle::of(alpha1.sin, alpha1.cos)
        } else {
            Angle {
                sin: T::ONE,
                cos: T::ZERO,
            }
        })
    }

    /// The α₁ to begin with between nearly antipodal places: the astroid problem in scaled coordinates
    /// (Karney 53 to 58). `sum_sin` is sin(β₁ + β₂).
    fn antipodal(&self, solver: &Solver<T>, sum_sin: T) -> Angle<T> {
        let (beta1, beta2) = (self.beta1, self.beta2);
        let f = solver.ellipsoid.f();
        let pi = T::of(PI);
        // λ₁₂ − π.
        let lambda = atan2(-self.lambda12.sin, -self.lambda12.cos);
        let oblate = f >= T::ZERO;
        let (x, y, lambda_scale) = if oblate {
            let epsilon = Integrals::epsilon(solver.ellipsoid.ep2() * beta1.sin * beta1.sin);
            let scale = f * beta1.cos * solver.integrals.a3(epsilon) * pi;
            (lambda / scale, sum_sin / (scale * beta1.cos), scale)
        } else {
            let sum_cos = beta2.cos * beta1.cos - beta2.sin * beta1.sin;
            let sum = atan2(sum_sin, sum_cos);
            let behind = Angle {
                sin: beta1.sin,
                cos: -beta1.cos,
            };
            let lengths = solver.lengths(solver.ellipsoid.n(), pi + sum, self.end1(behind), self.end2(beta2));
            let x = lengths.reduced / (beta1.cos * beta2.cos * lengths.secular * pi) - T::ONE;
            let beta_scale = if x < T::of(-0.01) {
                sum_sin / x
            } else {
                -f * beta1.cos * beta1.cos * pi
            };
            let scale = beta_scale / beta1.cos;
            (x, lambda / scale, scale)
        };
        // 200, as in GeographicLib: between (52.784459512564, 0) and (−52.784459512563990912,
        // 179.634407464943777557) y is 186 roundings below 0, and a bound of 100 failed.
        let near_cut = T::of(-200.0) * T::EPSILON;
        // So far beyond the cusp x = −1, κ ≈ −1 − x is small, and y/κ, the tangent wanted, a quotient of
        // roundings.
        let beyond_cusp = T::of(1000.0) * T::EPSILON.sqrt();
        if y > near_cut && x > -T::ONE - beyond_cusp {
            // On the cut, where the shortest lines are two.
            return if oblate {
                let sin = min(T::ONE, -x);
                Angle {
                    sin,
                    cos: -(T::ONE - sin * sin).sqrt(),
                }
            } else {
                let limit = if x > near_cut { T::ZERO } else { -T::ONE };
                let cos = max(limit, x);
                Angle {
                    sin: (T::ONE - cos * cos).sqrt(),
                    cos,
                }
            };
        }
        let k = astroid(x, y);
        let small = lambda_scale
            * if oblate {
                -x * k / (T::ONE + k)
            } else {
                -y * (T::ONE + k) / k
            };
        let (sin, cos) = sin_cos(small);
        let (sin, cos) = (sin, -cos);
        Angle {
            sin: beta2.cos * sin,
            cos: sum_sin - beta2.cos * beta1.sin * sin * sin / (T::ONE - cos),
        }
    }
}
