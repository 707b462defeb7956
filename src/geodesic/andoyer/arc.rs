//! Great circles of the auxiliary sphere in closed form: what [`Andoyer`](super::Andoyer) and
//! [`AndoyerSecond`](crate::geodesic::AndoyerSecond) share.

use core::f64::consts::PI;

use crate::geodesic::Direct;
use crate::geodesic::angle::{Angle, latitude_difference, longitude_difference, off_pole, wrapped};
use crate::geodesic::great_circle::end;
use crate::geodesic::sphere::{Start, Triangle, parametric};
use crate::math::{DoubleWord, atan2, atan2_degrees, hypot, max, min, select, sin_cos};
use crate::{LatLon, Real};

/// The ends of a line. More than 90° of longitude apart they are seen from the antipode of the first one
/// ([`Triangle`]): π − ω and π − λ stand for ω and λ.
#[derive(Clone, Copy)]
pub struct Ends<T> {
    beta1: Angle<T>,
    beta2: Angle<T>,
    /// sin(β₂ − β₁), or sin(β₂ + β₁).
    rise: T,
    /// −1 if seen from the antipode, else 1.
    pub side: T,
    /// λ₁₂ in radians.
    pub lambda12: T,
    /// 1 eastward, −1 westward.
    east: T,
}

/// The great circle between two ends for one ω.
#[derive(Clone, Copy)]
pub struct Arc<T> {
    /// σ₁₂ in radians.
    pub sigma12: T,
    pub sin_sigma12: T,
    pub cos_sigma12: T,
    pub sin_alpha0: T,
    pub cos2_alpha0: T,
    pub cos_2sigma_m: T,
    /// d sin α₀/dω.
    pub dsin_alpha0: T,
    /// sin σ₁₂ times sine and cosine of the azimuths.
    course1: Angle<T>,
    course2: Angle<T>,
}

impl<T: Real> Ends<T> {
    /// The ends of the line between two places; `axes` is b/a.
    #[inline(always)]
    pub fn new(axes: T, from: LatLon<T>, to: LatLon<T>) -> Self {
        let (mut beta1, divisor1) = parametric(from.lat(), axes);
        let (mut beta2, divisor2) = parametric(to.lat(), axes);
        (beta1.cos, beta2.cos) = (off_pole(beta1.cos), off_pole(beta2.cos));
        let difference = longitude_difference(from, to);
        let east = T::ONE.copysign(difference.high);
        let (angle, rest) = (difference.high.abs(), difference.low * east);
        let far = angle > T::of(90.0);
        let supplement = DoubleWord::sum(T::of(180.0) - angle, -rest);
        let lon12 = select(far, supplement.value(), angle + rest);
        let (apart, _) = latitude_difference(from, to).sin_cos_degrees();
        let (together, _) = DoubleWord::sum(from.lat(), to.lat()).sin_cos_degrees();
        let rise = select(far, together, apart) * axes / (divisor1 * divisor2);
        // Between latitudes exactly opposite λ says nothing of the azimuth: there one is moved by far less
        // than its rounding. Not so between a pole and itself.
        let opposite = far & (beta1.sin * beta2.sin <= T::ZERO);
        let least = select(opposite, T::EPSILON * T::EPSILON, T::ZERO);
        Self {
            beta1,
            beta2,
            rise: max(rise.abs(), least).copysign(rise),
            side: select(far, -T::ONE, T::ONE),
            lambda12: lon12 * T::of(PI / 180.0),
            east,
        }
    }

    /// The azimuths at both ends in degrees, once ω has grown by so much of sin σ₁₂.
    #[cfg_attr(not(small), inline(always))]
    pub fn azimuths_after(&self, arc: &Arc<T>, growth: T) -> (T, T) {
        let (course1, course2) = (arc.course1, arc.course2);
        // Each end moves beside the line by the cosine of its latitude and azimuth.
        let divisor = select(arc.sin_sigma12 == T::ZERO, T::ONE, arc.sin_sigma12);
        let turn = growth * self.east / divisor;
        let turn1 = turn * (self.beta2.cos * (course2.cos / divisor));
        let turn2 = turn * (self.beta1.cos * (course1.cos / divisor));
        (
            atan2_degrees(course1.sin + course1.cos * turn1, course1.cos - course1.sin * turn1),
            atan2_degrees(course2.sin + course2.cos * turn2, course2.cos - course2.sin * turn2),
        )
    }

    /// The great circle for one ω₁₂ in radians.
    #[cfg_attr(not(small), inline(always))]
    pub fn arc(&self, omega12: T) -> Arc<T> {
        let Self { beta1, beta2, side, .. } = *self;
        let omega = Angle::from(sin_cos(omega12));
        let versine = omega.sin * omega.sin / (T::ONE + omega.cos);
        let triangle = Triangle::new(side, [beta1, beta2], self.rise, omega, versine);
        let (mut course1, mut course2) = (triangle.course1, triangle.course2);
        let sin_sigma12 = hypot(course1.sin, course1.cos);
        let cos_sigma12 = triangle.cos_sigma();
        // Coincident places; or antipodal ones, from which the line goes north.
        let degenerate = sin_sigma12 == T::ZERO;
        let opposite = degenerate & (cos_sigma12 < T::ZERO);
        let divisor = select(degenerate, T::ONE, sin_sigma12);
        course1.cos = select(opposite, T::ONE, course1.cos);
        course2.cos = select(opposite, side, course2.cos);
        let (sin_alpha1, cos_alpha1) = (course1.sin / divisor, course1.cos / divisor);
        let sin_alpha0 = beta1.cos * sin_alpha1;
        let across = sin_alpha1 * beta1.sin;
        let cos2_alpha0 = cos_alpha1 * cos_alpha1 + across * across;
        let twice = (triangle.sines + triangle.sines) / select(cos2_alpha0 == T::ZERO, T::ONE, cos2_alpha0);
        let slope = beta1.cos * beta2.cos * omega.cos - side * (sin_alpha0 * sin_alpha0 * cos_sigma12);
        course1.sin *= self.east;
        course2.sin *= self.east;
        Arc {
            sigma12: atan2(sin_sigma12, cos_sigma12),
            sin_sigma12,
            cos_sigma12,
            sin_alpha0,
            cos2_alpha0,
            cos_2sigma_m: max(min(cos_sigma12 - twice, T::ONE), -T::ONE),
            dsin_alpha0: select(degenerate & !opposite, T::ZERO, slope / off_pole(sin_sigma12)),
            course1,
            course2,
        }
    }
}

impl<T: Real> Arc<T> {
    /// The azimuths at both ends, in degrees.
    #[inline(always)]
    pub fn azimuths(&self) -> (T, T) {
        let (course1, course2) = (self.course1, self.course2);
        (
            atan2_degrees(course1.sin, course1.cos),
            atan2_degrees(course2.sin, course2.cos),
        )
    }

    /// Σ cₖ sin kσ₁₂ cos 2kσₘ of the first terms.
    #[inline(always)]
    pub fn waves(&self, c: &[T], terms: usize) -> T {
        waves(c, terms, (self.sin_sigma12, self.cos_sigma12), self.cos_2sigma_m)
    }
}

/// Σ cₖ sin kσ cos kμ, by the recurrences of both factors: nothing is lost where σ is small.
#[inline(always)]
pub fn waves<T: Real>(c: &[T], terms: usize, (sin, cos): (T, T), cos_mu: T) -> T {
    let (twice, twice_mu) = (cos + cos, cos_mu + cos_mu);
    let (mut s0, mut s1) = (T::ZERO, sin);
    let (mut c0, mut c1) = (T::ONE, cos_mu);
    let mut sum = T::ZERO;
    for &ck in c.iter().take(terms) {
        sum += ck * s1 * c1;
        (s0, s1) = (s1, twice * s1 - s0);
        (c0, c1) = (c1, twice_mu * c1 - c0);
    }
    sum
}

/// A great circle from a place along an azimuth.
pub struct Departure<T> {
    from: LatLon<T>,
    /// b/a.
    axes: T,
    start: Start<T>,
    /// Sine and cosine of 2σ₁.
    twice: (T, T),
}

impl<T: Real> Departure<T> {
    /// From sine and cosine of the azimuth; `axes` is b/a.
    #[inline(always)]
    pub fn new(axes: T, from: LatLon<T>, azimuth: (T, T)) -> Self {
        let (mut beta1, _) = parametric(from.lat(), axes);
        beta1.cos = off_pole(beta1.cos);
        let start = Start::new(beta1, azimuth.into());
        let (sin1, along) = (beta1.sin, start.along);
        // σ₁ is the angle of (cos α₀ cos σ₁, cos α₀ sin σ₁), of length cos α₀.
        let divisor = select(start.cos2_alpha0 == T::ZERO, T::ONE, start.cos2_alpha0);
        let twice = (
            (sin1 + sin1) * along / divisor,
            (along - sin1) * (along + sin1) / divisor,
        );
        Self {
            from,
            axes,
            start,
            twice,
        }
    }

    #[inline(always)]
    pub fn sin_alpha0(&self) -> T {
        self.start.sin_alpha0
    }

    #[inline(always)]
    pub fn cos2_alpha0(&self) -> T {
        self.start.cos2_alpha0
    }

    /// cos 2σₘ, from sine and cosine of σ₁₂.
    #[inline(always)]
    pub fn cos_2sigma_m(&self, (sin, cos): (T, T)) -> T {
        let (sin_twice, cos_twice) = self.twice;
        cos_twice * cos - sin_twice * sin
    }

    /// The end of the arc with this sine and cosine, its longitude less by so many radians.
    #[inline(always)]
    pub fn end(&self, arc: (T, T), shift: T, many: bool) -> Direct<T> {
        let Start { beta1, alpha1, .. } = self.start;
        let end = end((beta1.sin, beta1.cos), (alpha1.sin, alpha1.cos), arc, self.axes);
        let lon = end.lon - without_turns(shift * T::of(180.0 / PI), T::of(360.0), many);
        Direct {
            position: LatLon::within(end.lat, wrapped(wrapped(lon) + self.from.lon())),
            azimuth: end.azimuth,
        }
    }
}

/// A distance as an arc in radians: without whole circuits if there may be `many`, and with them.
#[inline(always)]
pub fn arc<T: Real>(distance: T, radius: T, many: bool) -> (T, T) {
    let whole = distance / radius;
    (without_turns(whole, T::of(2.0 * PI), many), whole)
}

/// Whether an arc in radians, and the longitude that it adds, are less than a turn.
#[inline(always)]
pub fn is_less_than_a_turn<T: Real>(arc: T) -> bool {
    arc.abs() < T::of(2.0 * PI)
}

/// An angle, without its whole turns if there may be `many`.
#[inline(always)]
fn without_turns<T: Real>(angle: T, turn: T, many: bool) -> T {
    if many { angle.remainder(turn) } else { angle }
}
