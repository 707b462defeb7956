//! The iteration: Newton's method for the azimuth α₁, kept inside a bracket by bisection (Karney, section 4).

use core::f64::consts::PI;

use super::Solver;
use super::canonical::{Canonical, Segment, arc_between, tiny};
use crate::Real;
use crate::geodesic::angle::Angle;
use crate::geodesic::series::Integrals;
use crate::geodesic::sphere::{arc_from_node, node};
use crate::math::{atan2, max};

/// One evaluation of the hybrid problem: the geodesic from point 1 at α₁ to where it meets the latitude of
/// point 2.
struct Hybrid<T> {
    /// λ₁₂(α₁) − λ₁₂, and its derivative by α₁ if it was asked for.
    excess: T,
    slope: T,
    sigma12: T,
    sigma1: Angle<T>,
    sigma2: Angle<T>,
    alpha2: Angle<T>,
    epsilon: T,
    /// λ₁₂ − ω₁₂.
    shift: T,
}

impl<T: Real> Canonical<T> {
    /// The root of λ₁₂(α₁) − λ₁₂.
    pub(super) fn newton(&self, solver: &Solver<T>, start: Angle<T>) -> Segment<T> {
        let mut alpha1 = start;
        let mut low = Angle {
            sin: tiny::<T>(),
            cos: T::ONE,
        };
        let mut high = Angle {
            sin: tiny::<T>(),
            cos: -T::ONE,
        };
        // As in GeographicLib: 20 steps, of which 2 to 6 are usual, then as many bisections as a number has
        // digits, and 10 (`f32`: 10).
        let newton_steps = 20;
        let all_steps = newton_steps + T::terms(63, 34);
        let mut nearly = false;
        let mut step = 0;
        let mut hybrid = self.hybrid(solver, alpha1, true);
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
            hybrid = self.hybrid(solver, alpha1, step < newton_steps);
        }
        let omega12 = self.lambda12.minus(Angle::radians(hybrid.shift));
        let (mut sigma12, mut alpha2) = (hybrid.sigma12, hybrid.alpha2);
        if sigma12 < T::of(0.5) && omega12.cos > T::ZERO {
            // Between neighbours the triangle keeps the digits that the difference of the arcs has lost.
            let (alphas, side) = self.triangle(omega12);
            [alpha1, alpha2] = alphas.map(|alpha| Angle::of(alpha.sin, alpha.cos));
            sigma12 = side.to_radians();
        }
        let lengths = solver.lengths(
            hybrid.epsilon,
            sigma12,
            self.end1(hybrid.sigma1),
            self.end2(hybrid.sigma2),
        );
        let b = solver.ellipsoid.b();
        Segment {
            sigma12,
            distance: lengths.distance * b,
            reduced: lengths.reduced * b,
            scales: lengths.scales,
            alpha1,
            alpha2,
            omega12: Some(omega12),
            evaluations: step + 1,
        }
    }

    /// Solves the hybrid problem; `slope` asks for the derivative (Karney 46).
    fn hybrid(&self, solver: &Solver<T>, alpha1: Angle<T>, slope: bool) -> Hybrid<T> {
        let (beta1, beta2) = (self.beta1, self.beta2);
        let mut alpha1 = alpha1;
        if beta1.sin == T::ZERO && alpha1.cos == T::ZERO {
            alpha1.cos = -tiny::<T>();
        }
        let alpha0 = node(alpha1, beta1);
        let omega1 = Angle {
            sin: alpha0.sin * beta1.sin,
            cos: alpha1.cos * beta1.cos,
        };
        let sigma1 = arc_from_node(alpha1, beta1);
        // Clairaut's relation (Karney 5), and cos α₂ from it without the difference of squares (45).
        let equal = beta2.cos == beta1.cos;
        let sin_alpha2 = if equal { alpha1.sin } else { alpha0.sin / beta2.cos };
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
            sin: alpha0.sin * beta2.sin,
            cos: cos_alpha2 * beta2.cos,
        };
        let sigma2 = Angle::of(beta2.sin, omega2.cos);
        let sigma12 = arc_between(sigma1, sigma2);
        let sin_omega = max(omega1.cos * omega2.sin - omega1.sin * omega2.cos, T::ZERO) + T::ZERO;
        let cos_omega = omega1.cos * omega2.cos + omega1.sin * omega2.sin;
        // ω₁₂ less the wanted λ₁₂.
        let eta = atan2(
            sin_omega * self.lambda12.cos - cos_omega * self.lambda12.sin,
            cos_omega * self.lambda12.cos + sin_omega * self.lambda12.sin,
        );
        let epsilon = Integrals::epsilon(alpha0.cos * alpha0.cos * solver.ellipsoid.ep2());
        let c3 = solver.integrals.c3(epsilon);
        let bend = solver.integrals.sines(&c3, sigma2) - solver.integrals.sines(&c3, sigma1);
        let shift = -solver.ellipsoid.f() * alpha0.sin * (solver.integrals.a3(epsilon) * sigma12 + bend);
        let slope = if !slope {
            T::ZERO
        } else if cos_alpha2 == T::ZERO {
            T::of(-2.0) * solver.axes * self.dn1 / beta1.sin
        } else {
            let lengths = solver.lengths(epsilon, sigma12, self.end1(sigma1), self.end2(sigma2));
            lengths.reduced * solver.axes / (cos_alpha2 * beta2.cos)
        };
        Hybrid {
            excess: eta + shift,
            slope,
            sigma12,
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
