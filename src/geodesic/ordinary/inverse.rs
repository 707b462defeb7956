//! The inverse problem: what is unknown is the difference of longitudes on the sphere, ω = λ + f sin α₀ I₃. Newton's method finds it, and
//! its last step needs no evaluation after it: distance and azimuths follow from their derivatives by ω.
//!
//! Ordinary places take a fixed number of steps. Nearly antipodal ones, seen from the antipode so that no digit is lost, take them until they
//! settle; so do the few that the fixed number was not enough for.

use core::f64::consts::{FRAC_PI_4, PI};

use super::{Answer, Ordinary, grow, parametric, series, waves};
use crate::geodesic::Inverse;
use crate::geodesic::degrees::{Split, longitude_difference};
use crate::math::{Polynomial, choose, halves, max, min, mirrored, negated, octant, sin_cos_eighth, sin_cos_quarter};
use crate::{LatLon, Real};

/// The ends of an inverse problem's line, the one of greater latitude first: of both directions of a line the same is solved.
///
/// Seen from the first end, or near the antipode from opposite of it: there ω, λ and β₁ stand for π − ω, π − λ and −β₁.
#[derive(Clone, Copy)]
pub(in crate::geodesic) struct Ends<T> {
    lat1: T,
    lat2: T,
    /// Sine and cosine of the parametric latitudes.
    beta1: (T, T),
    beta2: (T, T),
    /// sin(β₂ ∓ β₁)/sin(φ₂ ∓ φ₁).
    scale: T,
    /// The difference of longitudes in degrees, and of half of it sine and cosine.
    pub lon: T,
    pub half: (T, T),
    /// What the difference's rounding lost, in radians.
    pub rest: T,
    /// −1 westward.
    east: T,
    pub swap: bool,
    /// Whether it is nearly antipodal; then −1, else 1.
    far: bool,
    pub side: T,
    /// sin(β₂ − β₁).
    rise: T,
    /// The smallest ω near the antipode.
    least: T,
}

/// The great circle between two places for one ω.
#[derive(Clone, Copy)]
pub(in crate::geodesic) struct Arc<T> {
    /// sin σ times sine and cosine of the azimuths.
    pub course1: (T, T),
    pub course2: (T, T),
    /// 1/sin²σ.
    inverse_square: T,
    pub sin_sigma: T,
    pub cos_sigma: T,
    pub sin_alpha: T,
    /// cos²α₀.
    pub square: T,
    /// d sin α₀/dω.
    bend: T,
    /// cos²α₀ cos 2σₘ.
    pub middle: T,
}

/// A line, once it is found.
pub(in crate::geodesic) struct Line<T> {
    pub inverse: Inverse<T>,
    /// σ, in radians.
    pub sigma: T,
    /// ω − λ, in radians.
    pub growth: T,
    /// How often the longitude was evaluated.
    pub evaluations: usize,
    found: bool,
}

/// Evaluations of the longitude that nearly always are enough, but near the antipode.
#[inline(always)]
fn fixed<T: Real>() -> usize {
    T::terms(3, 2)
}

/// Evaluations of the longitude at most. Where the shortest line turns from east to north some twenty are needed.
const STEPS: usize = 40;

impl<T: Real> Ordinary<T> {
    /// The inverse problem; not found between places that are all but the same, nor from pole to pole: no
    /// others are known.
    #[inline(always)]
    pub fn inverse(&self, from: LatLon<T>, to: LatLon<T>) -> Option<Inverse<T>> {
        let ends = Ends::new(self.axes, from, to);
        let far = ends.nearly_antipodal();
        if far && !cfg!(small) {
            return self.far_inverse(ends);
        }
        self.solve(ends, far).map(|line| line.inverse)
    }

    /// The same with the rest of the line.
    pub fn whole(&self, from: LatLon<T>, to: LatLon<T>) -> Option<Line<T>> {
        let ends = Ends::new(self.axes, from, to);
        self.solve(ends, ends.nearly_antipodal())
    }

    /// The inverse problem without a branch; not found between nearly antipodal places, either.
    #[inline(always)]
    pub fn near_inverse(&self, from: LatLon<T>, to: LatLon<T>) -> Answer<Inverse<T>> {
        let mut ends = Ends::new(self.axes, from, to);
        ends.see(false);
        let line = self.line(&ends, fixed::<T>());
        (line.inverse, line.found & !ends.nearly_antipodal())
    }

    #[cold]
    #[inline(never)]
    fn far_inverse(&self, ends: Ends<T>) -> Option<Inverse<T>> {
        self.solve(ends, true).map(|line| line.inverse)
    }

    #[inline(always)]
    fn solve(&self, mut ends: Ends<T>, far: bool) -> Option<Line<T>> {
        ends.see(far);
        if far {
            if ends.lat2.abs() == T::of(90.0) {
                return None;
            }
            self.leave_antipode(&mut ends);
        }
        let line = self.line(&ends, STEPS);
        line.found.then_some(line)
    }

    /// Between latitudes exactly opposite and up to the λ at which its azimuth is 90°, the line leaves the
    /// antipode to the north or to the south, and ω, then 0, says nothing of the azimuth: there the rise is
    /// made far less than its rounding. Beyond, ω is no less than its own.
    #[inline(always)]
    fn leave_antipode(&self, ends: &mut Ends<T>) {
        if ends.rise.abs() > T::EPSILON {
            return;
        }
        let square = ends.beta1.0 * ends.beta1.0;
        let epsilon = square * series(square, &self.epsilon, T::terms(7, 3));
        let turn = T::of(PI) * self.f * ends.beta1.1 * series(epsilon, &self.a3, T::terms(5, 3));
        let nothing = T::EPSILON * T::EPSILON;
        if ends.supplement() - turn > nothing {
            ends.least = T::of(8.0) * T::EPSILON * self.f.abs();
        } else {
            ends.rise = max(ends.rise.abs(), nothing).copysign(ends.rise);
        }
    }

    /// The line between the ends as they are seen, in so many steps at most.
    #[inline(always)]
    fn line(&self, ends: &Ends<T>, most: usize) -> Line<T> {
        let (far, side) = (ends.far, ends.side);
        // ω is what `half` stands for and so much more; near the antipode, where every digit of it counts, all of it.
        let (rest, mut grown) = if far {
            let lon = ends.supplement();
            (lon, self.flat_triangle(ends, lon))
        } else {
            (ends.rest, T::ZERO)
        };
        // One at least near the antipode; elsewhere as many as nearly always are enough, so that a batch does the same.
        let least = if far { 1 } else { fixed::<T>() };
        let mut evaluations = 1;
        let mut arc = if far | cfg!(small) {
            ends.grown(grown)
        } else {
            ends.arc(ends.half)
        };
        // In `f32` the short series are all there is.
        if T::terms(1, 0) == 1 {
            (grown, arc, evaluations) = self.approach(ends, (rest, grown, arc), if far { most } else { least });
        }
        loop {
            let factor = series(arc.square, &self.epsilon, T::terms(7, 3));
            let epsilon = arc.square * factor;
            let waves = waves(epsilon, factor * arc.middle, (arc.sin_sigma, arc.cos_sigma));
            let (a3, bend) = self.i3(epsilon, waves);
            let (eighths, small) = octant(arc.sin_sigma, arc.cos_sigma);
            // π/4 in two parts, the first so short that four times it is exact.
            let high = eighths * T::pick(FRAC_PI_4, 1_647_099.0 / 2_097_152.0);
            let low = eighths * T::pick(3.061_616_997_868_383e-17, 1.569_582_4e-7) + small;
            let sigma = high + low;
            let rate = side * (self.f * arc.sin_alpha);
            let excess = ((rest - grown) + rate * bend) + rate * a3 * sigma;
            let slope = self.slope(&arc, a3 * sigma + bend, sigma);
            let step = excess * (T::ONE / slope);
            // The square of such a step is rounding, and what is in excess by no more than this is the rounding of its own sum.
            let small_step = arc.sin_sigma * T::pick(1e-8, 5e-5);
            let rounding = T::of(8.0) * T::EPSILON * (rest.abs() + T::of(3.0) * self.f.abs());
            let found = excess.abs() <= small_step * slope + rounding;
            if (evaluations < least) | ((evaluations < most) & !found) {
                grown = ends.stepped(grown, step);
                arc = ends.grown(grown);
                evaluations += 1;
                continue;
            }

            // The azimuths of this triangle, and what the step turns them by.
            let turn = side * max(min(step, small_step), -small_step) * arc.inverse_square;
            let (course1, course2) = (arc.course1, arc.course2);
            let alpha1 = ends.azimuth(course1, turn * (ends.beta2.1 * course2.1));
            let alpha2 = ends.azimuth(course2, turn * (ends.beta1.1 * course1.1));

            let b1 = c1(epsilon, waves);
            let more = b1 + a1_less_1(epsilon) * (sigma + b1) + side * (arc.sin_alpha * excess / self.axes);
            return Line {
                inverse: Inverse {
                    distance: self.b * (high + (low + more)),
                    azimuth1: choose(ends.swap, alpha2, alpha1),
                    azimuth2: choose(ends.swap, alpha1, alpha2),
                },
                sigma: sigma + side * (arc.sin_alpha * step),
                growth: side * ((grown + step) - rest),
                evaluations,
                // Where it is less, squares are no numbers with all their digits.
                found: found & (arc.sin_sigma > T::pick(1e-150, 1e-18)),
            };
        }
    }

    /// Steps with short series to the last but one, or near the antipode until they settle: how much ω has grown, its arc, and how many
    /// evaluations that makes with the one to come.
    #[inline(always)]
    fn approach(&self, ends: &Ends<T>, (rest, mut grown, mut arc): (T, T, Arc<T>), steps: usize) -> (T, Arc<T>, usize) {
        let mut sigma = arc.rough_sigma(ends.far);
        let mut evaluations = 1;
        while evaluations < steps {
            let (shift, slope) = self.rough_shift(&arc, sigma);
            let step = ((rest - grown) + ends.side * shift) / slope;
            let turn = ends.side * step;
            sigma += turn * (arc.sin_alpha + T::of(0.5) * arc.bend * turn);
            grown = ends.stepped(grown, step);
            arc = ends.grown(grown);
            evaluations += 1;
            // The next error, as a part of sin σ, is less than the square of the last step; or the series are too short to tell.
            if ends.far && step.abs() <= arc.sin_sigma * T::of(5e-5) + self.f.abs() * T::of(1e-9) {
                break;
            }
        }
        (grown, arc, evaluations)
    }

    /// Where Newton's steps begin near the antipode: ω but for a hundredth, from λ = ω + π f sin α₀ with the triangle taken as flat; on a
    /// prolate ellipsoid, where there are several, beyond the one whose line is the shortest.
    #[inline(always)]
    fn flat_triangle(&self, ends: &Ends<T>, lon: T) -> T {
        let reach = T::of(PI) * self.f * ends.beta1.1;
        if self.f <= T::ZERO {
            return lon - T::of(1.02) * reach;
        }
        let north = ends.rise.abs() / max(ends.beta2.1, T::EPSILON);
        let square = north * north;
        let mut x = max(max(lon - reach, lon * north / (reach + north)), ends.least);
        for _ in 0..2 {
            // Halley's steps; the larger of two lower bounds comes first.
            let q = x * x + square;
            let reciprocal = T::ONE / q;
            let pull = reach * (q.sqrt() * reciprocal);
            let excess = (x - lon) + x * pull;
            let narrow = pull * (square * reciprocal);
            let slope = T::ONE + narrow;
            let step = excess * slope / (slope * slope + excess * (narrow * (T::of(1.5) * x * reciprocal)));
            x = max(x - step, ends.least);
        }
        x
    }

    /// f sin α₀ I₃ but for 1e-9, and the derivative of ω less it.
    #[cfg_attr(not(small), inline(always))]
    fn rough_shift(&self, arc: &Arc<T>, sigma: T) -> (T, T) {
        let factor = series(arc.square, &self.epsilon, 3);
        let epsilon = factor * arc.square;
        let wave = factor * arc.middle * arc.sin_sigma;
        let integral = sigma * series(epsilon, &self.a3, 3) + wave * series(epsilon, &self.c3, 2);
        let slope = T::ONE - self.f * (arc.bend * integral + arc.sin_alpha * arc.sin_alpha);
        (self.f * (arc.sin_alpha * integral), slope)
    }

    /// The derivative of ω − f sin α₀ I₃ by ω, but for f ε².
    #[cfg_attr(not(small), inline(always))]
    fn slope(&self, arc: &Arc<T>, integral: T, sigma: T) -> T {
        let [g, ..] = self.epsilon;
        let rate = if T::terms(1, 0) == 1 {
            let wave = arc.middle * arc.cos_sigma
                - arc.sin_sigma * ((arc.bend + arc.bend) * arc.cos_sigma + arc.square * arc.sin_sigma);
            T::ONE + g * (T::of(0.5) * (wave - arc.square) + sigma * arc.bend)
        } else {
            T::ONE
        };
        T::ONE - self.f * (arc.bend * integral + arc.sin_alpha * arc.sin_alpha * rate)
    }
}

impl<T: Real> Ends<T> {
    /// The ends of an inverse problem's line, not seen yet.
    #[cfg_attr(not(small), inline(always))]
    pub fn new(axes: T, from: LatLon<T>, to: LatLon<T>) -> Self {
        let Split { angle, rest } = longitude_difference(from, to);
        let east = T::ONE.copysign(angle);
        let swap = from.lat().abs() < to.lat().abs();
        let lat1 = choose(swap, to.lat(), from.lat());
        let lat2 = choose(swap, from.lat(), to.lat());
        let (beta1, inverse1) = parametric(lat1, axes);
        let (beta2, inverse2) = parametric(lat2, axes);
        Self {
            lat1,
            lat2,
            beta1,
            beta2,
            scale: axes * inverse1 * inverse2,
            lon: angle.abs(),
            half: sin_cos_quarter(angle.abs() * T::of(0.5)),
            rest: rest * east * T::of(PI / 180.0),
            east,
            swap,
            far: false,
            side: T::ONE,
            rise: T::ZERO,
            least: T::ZERO,
        }
    }

    /// Whether the places are so nearly antipodal, 170° apart or more, that ω turns the line faster than λ tells it. To be asked before the ends are
    /// seen from opposite.
    #[inline(always)]
    pub fn nearly_antipodal(&self) -> bool {
        let (sin_half, _) = self.half;
        let cos_lambda = T::ONE - (sin_half + sin_half) * sin_half;
        let ((sin1, cos1), (sin2, cos2)) = (self.beta1, self.beta2);
        let cos_sigma = sin1 * sin2 + cos1 * cos2 * cos_lambda;
        (self.lon >= T::of(90.0)) & (cos_sigma < T::of(-0.985))
    }

    /// π − λ.
    #[inline(always)]
    pub fn supplement(&self) -> T {
        (T::of(180.0) - self.lon) * T::of(PI / 180.0) - self.rest
    }

    /// An azimuth in degrees, and what it turns by in radians.
    #[cfg_attr(not(small), inline(always))]
    #[cfg_attr(small, inline(never))]
    pub fn azimuth(&self, (sin, cos): (T, T), turn: T) -> T {
        let (eighths, small) = octant(sin.abs(), cos);
        let (eighths, small) = (
            mirrored(self.swap, T::of(4.0), eighths),
            negated(self.swap, small + turn),
        );
        let azimuth = eighths * T::of(45.0) + small * T::of(180.0 / PI);
        min(azimuth, T::of(180.0)).copysign(sin * self.east + T::ZERO)
    }

    /// From the first end, or from opposite of it.
    #[inline(always)]
    pub fn see(&mut self, far: bool) {
        self.far = far;
        self.side = if far { -T::ONE } else { T::ONE };
        self.beta1.0 *= self.side;
        let apart = self.lat2 - self.side * self.lat1;
        self.rise = choose(
            apart.abs() <= T::of(45.0),
            sin_cos_eighth(apart * T::of(PI / 180.0)).0 * self.scale,
            self.beta2.0 * self.beta1.1 - self.beta2.1 * self.beta1.0,
        );
    }

    /// An ω after one more step.
    #[inline(always)]
    fn stepped(&self, grown: T, step: T) -> T {
        if self.far {
            max(grown + step, self.least)
        } else {
            grown + step
        }
    }

    /// The great circle for an ω that has grown by so much; near the antipode for this one, to a quarter circle.
    #[cfg_attr(not(small), inline(always))]
    pub fn grown(&self, by: T) -> Arc<T> {
        let by = by * T::of(0.5);
        self.arc(if self.far {
            sin_cos_eighth(by)
        } else {
            grow(self.half, by)
        })
    }

    /// The great circle for an ω, given by sine and cosine of its half.
    #[inline(always)]
    pub fn arc(&self, (sin_half, cos_half): (T, T)) -> Arc<T> {
        let ((sin1, cos1), (sin2, cos2)) = (self.beta1, self.beta2);
        let side = self.side;
        let twice = sin_half + sin_half;
        let sin_omega = twice * cos_half;
        let versine = twice * sin_half;
        let sines = side * (sin1 * sin2);
        let level = side * (cos1 * cos2 * (T::ONE - versine));
        let course1 = (cos2 * sin_omega, self.rise + sin1 * cos2 * versine);
        let course2 = (cos1 * sin_omega, side * (self.rise - sin2 * cos1 * versine));
        let square = course1.0 * course1.0 + course1.1 * course1.1;
        let (sin_sigma, inverse_square) = (square.sqrt(), T::ONE / max(square, T::pick(1e-300, 1e-37)));
        let inverse = sin_sigma * inverse_square;
        let cos_sigma = sines + level;
        let sin_alpha = cos1 * course1.0 * inverse;
        let square = T::ONE - sin_alpha * sin_alpha;
        let bend = if self.far {
            // Without a difference, of which near the antipode no digit would be left.
            cos1 * cos2 * (course1.1 * inverse) * (course2.1 * inverse_square)
        } else {
            (level - sin_alpha * sin_alpha * cos_sigma) * inverse
        };
        Arc {
            course1,
            course2,
            inverse_square,
            sin_sigma,
            cos_sigma,
            sin_alpha,
            square,
            bend,
            middle: square * cos_sigma - (sines + sines),
        }
    }
}

impl<T: Real> Arc<T> {
    /// σ but for 2e-7.
    #[inline(always)]
    fn rough_sigma(&self, far: bool) -> T {
        let of = T::of;
        if far {
            // The supplement from its sine.
            let s = self.sin_sigma;
            let z = s * s;
            let curve = of(1.0 / 6.0) + z * (of(3.0 / 40.0) + z * (of(15.0 / 336.0) + z * of(105.0 / 3456.0)));
            return of(PI) - (s + s * z * curve);
        }
        // tan σ/2, or of the supplement; its square without waiting for the root in sin σ.
        let cos = self.cos_sigma.abs();
        let reciprocal = T::ONE / (T::ONE + cos);
        let (t, z) = (self.sin_sigma * reciprocal, (T::ONE - cos) * reciprocal);
        let curve = halves(z, 8, |i| T::coefficient(&ROUGH_ATAN, i));
        let angle = (t + t) * curve;
        mirrored(self.cos_sigma < T::ZERO, of(PI), angle)
    }
}

/// atan t/t by powers of t², 0 ≤ t ≤ 1; error 1.2e-7.
const ROUGH_ATAN: Polynomial<8, 8> = Polynomial::rounded([
    0.999_999_881_996, -0.333_318_126_556, 0.199_669_618_296, -0.140_032_901_847, 0.098_688_654_581_3,
    -0.058_829_753_143_1, 0.023_780_518_597_2, -0.004_559_791_986_13,
]);

/// Σ C₁ₗ (sin 2lσ₂ − sin 2lσ₁).
#[cfg_attr(not(small), inline(always))]
fn c1<T: Real>(epsilon: T, [w1, w2, w3, w4, w5]: [T; 5]) -> T {
    let of = T::of;
    let square = epsilon * epsilon;
    if T::terms(5, 2) == 2 {
        return -(w1 + of(1.0 / 8.0) * w2);
    }
    let rest = of(-7.0 / 640.0) * w5 - of(5.0 / 256.0) * w4;
    let rest = rest + (of(3.0 / 128.0) * square - of(1.0 / 24.0)) * w3;
    let rest = rest + (of(1.0 / 16.0) * square - of(1.0 / 8.0)) * w2;
    (rest + square * (of(3.0 / 8.0) - of(1.0 / 16.0) * square) * w1) - w1
}

/// (A₁ − 1)/ε by powers of ε.
const A1: Polynomial<6, 6> = Polynomial::rounded([1.0, 1.25, 1.25, 81.0 / 64.0, 81.0 / 64.0, 325.0 / 256.0]);

/// A₁ − 1 = (1 + ε²/4 + ε⁴/64 + ε⁶/256)/(1 − ε) − 1.
#[cfg_attr(not(small), inline(always))]
fn a1_less_1<T: Real>(epsilon: T) -> T {
    epsilon * series(epsilon, &T::all(&A1), T::terms(6, 3))
}
