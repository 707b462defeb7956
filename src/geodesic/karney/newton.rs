use core::f64::consts::PI;

use super::Karney;
use super::angle::Angle;
use super::inverse::{Arc, Canonical, arc_between, tiny};
use super::series::Series;
use crate::Real;
use crate::geodesic::degrees::hypot;
use crate::math::{atan2, max};

/// One evaluation of the longitude.
struct Hybrid<T> {
    /// λ₁₂(α₁) − λ₁₂, and its derivative by α₁ if it was asked for.
    excess: T,
    slope: T,
    sigma: T,
    sigma1: Angle<T>,
    sigma2: Angle<T>,
    alpha2: Angle<T>,
    epsilon: T,
    /// λ₁₂ − ω₁₂.
    shift: T,
}

impl<T: Real> Canonical<T> {
    /// Newton's method on λ₁₂(α₁), kept inside a bracket by bisection.
    pub(super) fn iterate(&self, karney: &Karney<T>, start: Angle<T>) -> Arc<T> {
        let mut alpha1 = start;
        let mut low = Angle {
            sin: tiny::<T>(),
            cos: T::ONE,
        };
        let mut high = Angle {
            sin: tiny::<T>(),
            cos: -T::ONE,
        };
        let newton_steps = 20;
        let all_steps = newton_steps + T::terms(63, 34);
        let mut nearly = false;
        let mut step = 0;
        let mut hybrid = self.hybrid(karney, alpha1, true);
        loop {
            let v = hybrid.excess;
            let close = T::EPSILON * if nearly { T::of(8.0) } else { T::ONE };
            let far = v.abs() >= close;
            if !far || step == all_steps {
                break;
            }
            if v > T::ZERO {
                high = alpha1;
            } else {
                low = alpha1;
            }
            step += 1;
            let newton = (step <= newton_steps && hybrid.slope > T::ZERO)
                .then(|| -v / hybrid.slope)
                .filter(|turn| turn.abs() < T::of(PI))
                .map(|turn| alpha1.plus(Angle::radians(turn)))
                .filter(|next| next.sin > T::ZERO);
            if let Some(next) = newton {
                alpha1 = Angle::of(next.sin, next.cos);
                nearly = v.abs() <= T::of(16.0) * T::EPSILON;
            } else {
                alpha1 = Angle::of((low.sin + high.sin) * T::of(0.5), (low.cos + high.cos) * T::of(0.5));
                nearly = false;
            }
            hybrid = self.hybrid(karney, alpha1, step < newton_steps);
        }
        let omega = self.lambda12.minus(Angle::radians(hybrid.shift));
        let (mut sigma, mut alpha2) = (hybrid.sigma, hybrid.alpha2);
        if sigma < T::of(0.5) && omega.cos > T::ZERO {
            // Between neighbours the triangle keeps the digits that the difference of the arcs has lost.
            let (alphas, side) = self.triangle(omega);
            [alpha1, alpha2] = alphas.map(|alpha| Angle::of(alpha.sin, alpha.cos));
            sigma = side.to_radians();
        }
        let lengths = karney.lengths(
            hybrid.epsilon,
            sigma,
            self.node1(hybrid.sigma1),
            self.node2(hybrid.sigma2),
        );
        let b = karney.ellipsoid.b();
        Arc {
            sigma,
            distance: lengths.distance * b,
            reduced: lengths.reduced * b,
            scales: lengths.scales,
            alpha1,
            alpha2,
            omega: Some(omega),
            evaluations: step + 1,
        }
    }

    /// The hybrid problem: where the geodesic from point 1 at α₁ meets the latitude of point 2 (Karney §4).
    fn hybrid(&self, karney: &Karney<T>, alpha1: Angle<T>, slope: bool) -> Hybrid<T> {
        let (beta1, beta2) = (self.beta1, self.beta2);
        let mut alpha1 = alpha1;
        if beta1.sin == T::ZERO && alpha1.cos == T::ZERO {
            alpha1.cos = -tiny::<T>();
        }
        let sin_alpha0 = alpha1.sin * beta1.cos;
        let cos_alpha0 = hypot(alpha1.cos, alpha1.sin * beta1.sin);
        let omega1 = Angle {
            sin: sin_alpha0 * beta1.sin,
            cos: alpha1.cos * beta1.cos,
        };
        let sigma1 = Angle::of(beta1.sin, omega1.cos);
        // Clairaut, and cos α₂ from it without the difference of squares.
        let equal = beta2.cos == beta1.cos;
        let sin_alpha2 = if equal { alpha1.sin } else { sin_alpha0 / beta2.cos };
        let cos_alpha2 = if !equal || beta2.sin.abs() != -beta1.sin {
            let gain = if beta1.cos < -beta1.sin {
                (beta2.cos - beta1.cos) * (beta1.cos + beta2.cos)
            } else {
                (beta1.sin - beta2.sin) * (beta1.sin + beta2.sin)
            };
            let c = alpha1.cos * beta1.cos;
            (c * c + gain).sqrt() / beta2.cos
        } else {
            alpha1.cos.abs()
        };
        let omega2 = Angle {
            sin: sin_alpha0 * beta2.sin,
            cos: cos_alpha2 * beta2.cos,
        };
        let sigma2 = Angle::of(beta2.sin, omega2.cos);
        let sigma = arc_between(sigma1, sigma2);
        let sin_omega = max(omega1.cos * omega2.sin - omega1.sin * omega2.cos, T::ZERO) + T::ZERO;
        let cos_omega = omega1.cos * omega2.cos + omega1.sin * omega2.sin;
        // ω₁₂ less the wanted λ₁₂.
        let eta = atan2(
            sin_omega * self.lambda12.cos - cos_omega * self.lambda12.sin,
            cos_omega * self.lambda12.cos + sin_omega * self.lambda12.sin,
        );
        let epsilon = Series::epsilon(cos_alpha0 * cos_alpha0 * karney.ellipsoid.ep2());
        let c3 = karney.series.c3(epsilon);
        let bend = karney.series.sines(&c3, sigma2) - karney.series.sines(&c3, sigma1);
        let shift = -karney.ellipsoid.f() * sin_alpha0 * (karney.series.a3(epsilon) * sigma + bend);
        let slope = if !slope {
            T::ZERO
        } else if cos_alpha2 == T::ZERO {
            T::of(-2.0) * karney.axes * self.dn1 / beta1.sin
        } else {
            let lengths = karney.lengths(epsilon, sigma, self.node1(sigma1), self.node2(sigma2));
            lengths.reduced * karney.axes / (cos_alpha2 * beta2.cos)
        };
        Hybrid {
            excess: eta + shift,
            slope,
            sigma,
            sigma1,
            sigma2,
            alpha2: Angle {
                sin: sin_alpha2,
                cos: cos_alpha2,
            },
            epsilon,
            shift,
        }
    }
}
