//! Where Newton's method begins between nearly antipodal places.
//!
//! There the general solver takes the root of Karney's astroid (55), exact for f → 0. Here a hundredth of ω₁₂
//! is enough, and two of Halley's steps are cheaper than the root of a quartic.

use core::f64::consts::PI;

use super::{Pair, Solver};
use crate::Real;
use crate::math::{either, max, select};

impl<T: Real> Solver<T> {
    /// Between latitudes exactly opposite and up to the λ₁₂ at which its azimuth is 90°, the line leaves the
    /// antipode to the north or to the south, and ω₁₂, then 0, says nothing of the azimuth: there the rise is
    /// made far less than its rounding. Beyond, ω₁₂ is no less than its own. Other pairs stay as they are.
    #[inline(always)]
    pub(super) fn leave_antipode(&self, pair: &mut Pair<T>) {
        let level = pair.is_level();
        let cos2_alpha0 = pair.beta1.sin * pair.beta1.sin;
        let epsilon = cos2_alpha0 * self.series.epsilon_by_cos2(cos2_alpha0);
        let turn = T::of(PI) * self.f * pair.beta1.cos * self.series.a3(epsilon);
        let nothing = T::EPSILON * T::EPSILON;
        let beyond = pair.supplement() - turn > nothing;
        pair.least_omega = either(level & beyond, T::of(8.0) * T::EPSILON * self.f.abs());
        let leaves = max(pair.rise.abs(), nothing).copysign(pair.rise);
        pair.rise = select(level & !beyond, leaves, pair.rise);
    }

    /// ω₁₂ but for a hundredth, from λ₁₂ = ω₁₂ + π f sin α₀ with the triangle taken as flat; on a prolate
    /// ellipsoid, where there are several, beyond the one whose line is the shortest. `lambda12` is π − λ₁₂.
    #[inline(always)]
    pub(super) fn omega_of_flat_triangle(&self, pair: &Pair<T>, lambda12: T) -> T {
        let reach = T::of(PI) * self.f * pair.beta1.cos;
        if self.f <= T::ZERO {
            return lambda12 - T::of(1.02) * reach;
        }
        let north = pair.rise.abs() / max(pair.beta2.cos, T::EPSILON);
        let square = north * north;
        let mut x = max(
            max(lambda12 - reach, lambda12 * north / (reach + north)),
            pair.least_omega,
        );
        for _ in 0..2 {
            // Halley's steps; the larger of two lower bounds comes first.
            let q = x * x + square;
            let reciprocal = T::ONE / q;
            let pull = reach * (q.sqrt() * reciprocal);
            let excess = (x - lambda12) + x * pull;
            let narrow = pull * (square * reciprocal);
            let slope = T::ONE + narrow;
            let step = excess * slope / (slope * slope + excess * (narrow * (T::of(1.5) * x * reciprocal)));
            x = max(x - step, pair.least_omega);
        }
        x
    }
}
