//! The inverse problem: Newton's method finds ω₁₂ = λ₁₂ + f sin α₀ I₃ (Karney 8). Its last step needs no
//! evaluation after it: distance and azimuths follow from their derivatives by ω₁₂.
//!
//! Most places take a fixed number of steps. Nearly antipodal ones, seen from the antipode so that no digit
//! is lost, take steps until they settle; so do the few that the fixed number was not enough for.

use super::{Pair, Solver, Trial};
use crate::geodesic::Inverse;
use crate::geodesic::series::short::{a1_less_1, c1_between, waves};
use crate::math::{choose, max, min, octant_radians, repeat, select};
use crate::{LatLon, Real};

/// Where Newton's method has ended.
pub struct Outcome<T> {
    pub inverse: Inverse<T>,
    /// σ₁₂, in radians.
    pub sigma12: T,
    /// ω₁₂ − λ₁₂, in radians.
    pub growth: T,
    /// How often the longitude was evaluated.
    pub evaluations: usize,
    /// Whether this is the answer.
    pub found: bool,
}

/// The longitude of a great circle, and the step of Newton's method from there.
struct Evaluation<T> {
    epsilon: T,
    waves: [T; 5],
    /// σ₁₂ in two parts.
    high: T,
    low: T,
    sigma12: T,
    /// What λ₁₂ is in excess by.
    excess: T,
    step: T,
    small_step: T,
    found: bool,
}

/// Evaluations of the longitude that nearly always are enough, but near the antipode.
#[inline(always)]
fn fixed<T: Real>() -> usize {
    T::terms(3, 2)
}

/// Steps in lanes near the antipode: enough for most places.
const FAR_STEPS: usize = 4;

/// Evaluations of the longitude at most. Where the shortest line turns from east to north some twenty are
/// needed.
const STEPS: usize = 40;

impl<T: Real> Solver<T> {
    /// The inverse problem; none between places so near that squares underflow, and between poles: no others
    /// are known.
    #[inline(always)]
    pub fn inverse(&self, from: LatLon<T>, to: LatLon<T>) -> Option<Inverse<T>> {
        let pair = Pair::new(self.axes, from, to);
        let antipodal = pair.nearly_antipodal();
        if antipodal && !cfg!(small) {
            return self.antipodal_inverse(pair);
        }
        self.solve(pair, antipodal).map(|outcome| outcome.inverse)
    }

    /// The same with all that is known of the line.
    pub fn outcome(&self, from: LatLon<T>, to: LatLon<T>) -> Option<Outcome<T>> {
        let pair = Pair::new(self.axes, from, to);
        self.solve(pair, pair.nearly_antipodal())
    }

    /// The inverse problem without a branch, and whether the answer is that of [`inverse`](Self::inverse):
    /// not between nearly antipodal places, either.
    #[inline(always)]
    pub fn near_inverse(&self, from: LatLon<T>, to: LatLon<T>) -> (Inverse<T>, bool) {
        let (Outcome { inverse, found, .. }, same) = self.near_outcome(from, to);
        // Between a place and itself nothing is divided by the arc.
        let unless_same = |value| select(same, T::ZERO, value);
        let line = Inverse {
            distance: unless_same(inverse.distance),
            azimuth1: unless_same(inverse.azimuth1),
            azimuth2: unless_same(inverse.azimuth2),
        };
        (line, same | found)
    }

    /// The same with all that is known of the line; nothing is if the places are the same, and whether they
    /// are.
    #[inline(always)]
    pub fn near_outcome(&self, from: LatLon<T>, to: LatLon<T>) -> (Outcome<T>, bool) {
        let mut pair = Pair::new(self.axes, from, to);
        pair.see(false);
        let outcome = self.newton(&pair, fixed::<T>());
        let same = (pair.phi1 == pair.phi2) & (pair.lambda12 == T::ZERO) & (pair.rest == T::ZERO);
        let found = outcome.found & !pair.nearly_antipodal();
        (Outcome { found, ..outcome }, same)
    }

    #[cold]
    #[inline(never)]
    fn antipodal_inverse(&self, pair: Pair<T>) -> Option<Inverse<T>> {
        self.solve(pair, true).map(|outcome| outcome.inverse)
    }

    #[inline(always)]
    fn solve(&self, mut pair: Pair<T>, antipodal: bool) -> Option<Outcome<T>> {
        pair.see(antipodal);
        if antipodal {
            if pair.phi2.abs() == T::of(90.0) {
                return None;
            }
            if pair.is_level() {
                self.leave_antipode(&mut pair);
            }
        }
        let outcome = self.newton(&pair, STEPS);
        outcome.found.then_some(outcome)
    }

    /// The line between the places as they are seen, in so many steps at most.
    #[inline(always)]
    fn newton(&self, pair: &Pair<T>, most: usize) -> Outcome<T> {
        let antipodal = pair.antipodal;
        // ω₁₂ is λ₁₂ as it is rounded and so much more; near the antipode, where every digit of it counts,
        // all of it.
        let (rest, mut growth) = if antipodal {
            let lambda12 = pair.supplement();
            (lambda12, self.omega_of_flat_triangle(pair, lambda12))
        } else {
            (pair.rest, T::ZERO)
        };
        // One at least near the antipode; elsewhere as many as nearly always are enough, so that a batch does
        // the same.
        let least = if antipodal { 1 } else { fixed::<T>() };
        let mut evaluations = 1;
        let mut trial = if antipodal | cfg!(small) {
            pair.grown(growth)
        } else {
            pair.trial(pair.half_lambda12)
        };
        // In `f32` the short series are all there is.
        if T::terms(1, 0) == 1 {
            let steps = if antipodal { most } else { least };
            (growth, trial, evaluations) = self.approach(pair, (rest, growth, trial), steps);
        }
        loop {
            let evaluation = self.evaluate(pair, rest - growth, rest, &trial);
            if (evaluations < least) | ((evaluations < most) & !evaluation.found) {
                growth = pair.stepped(growth, evaluation.step);
                trial = pair.grown(growth);
                evaluations += 1;
                continue;
            }
            return self.outcome_of(pair, &trial, &evaluation, (growth, rest), evaluations);
        }
    }

    /// Evaluates the longitude of a great circle; `left` is what is left of λ₁₂.
    #[inline(always)]
    fn evaluate(&self, pair: &Pair<T>, left: T, rest: T, trial: &Trial<T>) -> Evaluation<T> {
        let side = pair.side;
        let epsilon_by_cos2 = self.series.epsilon_by_cos2(trial.cos2_alpha0);
        let epsilon = trial.cos2_alpha0 * epsilon_by_cos2;
        let waves = waves(
            epsilon,
            epsilon_by_cos2 * trial.cos_2sigma_m,
            (trial.sin_sigma12, trial.cos_sigma12),
        );
        let (a3, bend) = self.series.i3(epsilon, waves);
        let (high, low) = octant_radians(trial.sin_sigma12, trial.cos_sigma12);
        let sigma12 = high + low;
        let rate = side * (self.f * trial.sin_alpha0);
        let excess = (left + rate * bend) + rate * a3 * sigma12;
        let slope = self.slope(trial, a3 * sigma12 + bend, sigma12);
        let step = excess * (T::ONE / slope);
        // The square of such a step is rounding, and what is in excess by no more than this is the rounding
        // of its own sum.
        let small_step = trial.sin_sigma12 * T::pick(1e-8, 5e-5);
        let rounding = T::of(8.0) * T::EPSILON * (rest.abs() + T::of(3.0) * self.f.abs());
        Evaluation {
            epsilon,
            waves,
            high,
            low,
            sigma12,
            excess,
            step,
            small_step,
            found: excess.abs() <= small_step * slope + rounding,
        }
    }

    /// The line of the last great circle and its evaluation.
    #[inline(always)]
    fn outcome_of(
        &self,
        pair: &Pair<T>,
        trial: &Trial<T>,
        evaluation: &Evaluation<T>,
        (growth, rest): (T, T),
        evaluations: usize,
    ) -> Outcome<T> {
        let &Evaluation {
            epsilon,
            waves,
            high,
            low,
            sigma12,
            excess,
            step,
            small_step,
            found,
        } = evaluation;
        let side = pair.side;
        // The azimuths of this triangle, and what the step turns them by.
        let turn = side * max(min(step, small_step), -small_step) * trial.inverse_square;
        let (course1, course2) = (trial.course1, trial.course2);
        let alpha1 = pair.azimuth(course1, turn * (pair.beta2.cos * course2.cos));
        let alpha2 = pair.azimuth(course2, turn * (pair.beta1.cos * course1.cos));

        let b1 = c1_between(epsilon, waves);
        let more = b1 + a1_less_1(epsilon) * (sigma12 + b1) + side * (trial.sin_alpha0 * excess / self.axes);
        Outcome {
            inverse: Inverse {
                distance: self.b * (high + (low + more)),
                azimuth1: choose(pair.swap, alpha2, alpha1),
                azimuth2: choose(pair.swap, alpha1, alpha2),
            },
            sigma12: sigma12 + side * (trial.sin_alpha0 * step),
            growth: side * ((growth + step) - rest),
            evaluations,
            // Where it is less, squares are no numbers with all their digits.
            found: found & (trial.sin_sigma12 > T::pick(1e-150, 1e-18)),
        }
    }

    /// The inverse problem between nearly antipodal places without a branch, and whether the answer is that
    /// of [`inverse`](Self::inverse): not if it takes more steps than most.
    #[inline(always)]
    pub fn far_inverse(&self, from: LatLon<T>, to: LatLon<T>) -> (Inverse<T>, bool) {
        let mut pair = Pair::new(self.axes, from, to);
        let antipodal = pair.nearly_antipodal();
        pair.see(true);
        self.leave_antipode(&mut pair);
        let usual = antipodal & (pair.phi2.abs() != T::of(90.0));
        let rest = pair.supplement();
        let mut growth = self.omega_of_flat_triangle(&pair, rest);
        let mut trial = pair.grown(growth);
        let mut settled = T::terms(1, 0) == 0;
        if T::terms(1, 0) == 1 {
            let mut last = (growth, trial.rough_sigma12(true));
            repeat!(FAR_STEPS, {
                let (step, sigma12) = self.rough_step(&pair, (rest, last.0, &trial), last.1);
                // Once it has settled it stays.
                last = (
                    choose(settled, last.0, pair.stepped(last.0, step)),
                    choose(settled, last.1, sigma12),
                );
                growth = last.0;
                trial = pair.grown(growth);
                settled |= self.is_rough_end(step, &trial);
            });
        } else {
            repeat!(FAR_STEPS, {
                let evaluation = self.evaluate(&pair, rest - growth, rest, &trial);
                growth = choose(evaluation.found, growth, pair.stepped(growth, evaluation.step));
                trial = pair.grown(growth);
            });
        }
        let evaluation = self.evaluate(&pair, rest - growth, rest, &trial);
        let outcome = self.outcome_of(&pair, &trial, &evaluation, (growth, rest), 0);
        (outcome.inverse, outcome.found & usual & settled)
    }

    /// Steps with short series to the last but one, or near the antipode until they settle: how much ω₁₂ has
    /// grown, its great circle, and how many evaluations that makes with the one to come.
    #[inline(always)]
    fn approach(
        &self,
        pair: &Pair<T>,
        (rest, mut growth, mut trial): (T, T, Trial<T>),
        steps: usize,
    ) -> (T, Trial<T>, usize) {
        let mut sigma12 = trial.rough_sigma12(pair.antipodal);
        let mut evaluations = 1;
        while evaluations < steps {
            let step;
            (step, sigma12) = self.rough_step(pair, (rest, growth, &trial), sigma12);
            growth = pair.stepped(growth, step);
            trial = pair.grown(growth);
            evaluations += 1;
            // The next error, as a part of sin σ₁₂, is less than the square of the last step; or the series
            // are too short to tell.
            if pair.antipodal && self.is_rough_end(step, &trial) {
                break;
            }
        }
        (growth, trial, evaluations)
    }

    /// A step with short series, and σ₁₂ after it.
    #[inline(always)]
    fn rough_step(&self, pair: &Pair<T>, (rest, growth, trial): (T, T, &Trial<T>), sigma12: T) -> (T, T) {
        let (shift, slope) = self.rough_shift(trial, sigma12);
        let step = ((rest - growth) + pair.side * shift) / slope;
        let turn = pair.side * step;
        (
            step,
            sigma12 + turn * (trial.sin_alpha0 + T::of(0.5) * trial.dsin_alpha0 * turn),
        )
    }

    /// Whether after this step one evaluation by the long series is enough.
    #[inline(always)]
    fn is_rough_end(&self, step: T, trial: &Trial<T>) -> bool {
        step.abs() <= trial.sin_sigma12 * T::of(5e-5) + self.f.abs() * T::of(1e-9)
    }

    /// f sin α₀ I₃ but for 1e-9, and the derivative of ω₁₂ less it.
    #[cfg_attr(not(small), inline(always))]
    fn rough_shift(&self, trial: &Trial<T>, sigma12: T) -> (T, T) {
        let i3 = self
            .series
            .rough_i3(trial.cos2_alpha0, trial.cos_2sigma_m, trial.sin_sigma12, sigma12);
        let slope = T::ONE - self.f * (trial.dsin_alpha0 * i3 + trial.sin_alpha0 * trial.sin_alpha0);
        (self.f * (trial.sin_alpha0 * i3), slope)
    }

    /// The derivative of ω₁₂ − f sin α₀ I₃ by ω₁₂, but for f ε².
    #[cfg_attr(not(small), inline(always))]
    fn slope(&self, trial: &Trial<T>, i3: T, sigma12: T) -> T {
        let rate = if T::terms(1, 0) == 1 {
            let dsin_alpha0 = trial.dsin_alpha0;
            let wave = trial.cos_2sigma_m * trial.cos_sigma12
                - trial.sin_sigma12
                    * ((dsin_alpha0 + dsin_alpha0) * trial.cos_sigma12 + trial.cos2_alpha0 * trial.sin_sigma12);
            T::ONE + self.series.quarter_ep2() * (T::of(0.5) * (wave - trial.cos2_alpha0) + sigma12 * trial.dsin_alpha0)
        } else {
            T::ONE
        };
        T::ONE - self.f * (trial.dsin_alpha0 * i3 + trial.sin_alpha0 * trial.sin_alpha0 * rate)
    }
}
