//! Bessel's auxiliary sphere: every geodesic of the ellipsoid is a great circle there, between the reduced latitudes, and distance
//! and longitude follow from its arc by two integrals.
//!
//! Symbols as in Vincenty (1975): U reduced latitude, λ longitude on the sphere, L on the ellipsoid, α the azimuth at the equator,
//! σ the arc, σₘ its middle counted from the equator.

use super::degrees::{Split, hypot, latitude_difference, longitude_difference, off_pole};
use super::great_circle::{End, end};
use crate::latitude::UnsupportedFlattening;
use crate::math::{atan2, atan2_degrees, max, min, select, sin_cos, sin_cos_degrees};
use crate::{Ellipsoid, LatLon, Real};

const RADIAN: f64 = core::f64::consts::PI / 180.0;

/// The flattening up to which the series of the methods here are worth their claims.
pub(super) const FLATTEST: f64 = 1.0 / 60.0;

/// The ellipsoid, if its flattening is at most [`FLATTEST`].
pub(super) fn nearly_round<T: Real>(ellipsoid: Ellipsoid<T>) -> Result<Ellipsoid<T>, UnsupportedFlattening<T>> {
    // Room for the rounding of 1/60.
    if ellipsoid.f().abs() > T::of(FLATTEST + 1e-8) {
        return Err(UnsupportedFlattening(ellipsoid.f()));
    }
    Ok(ellipsoid)
}

/// Sine and cosine of the reduced latitude, from those of the latitude; and what divided them, √(cos²φ + (1 − f)² sin²φ).
#[inline(always)]
fn reduced<T: Real>(lat: T, axes: T) -> ((T, T), T) {
    let (sin, cos) = sin_cos_degrees(lat);
    let sin = sin * axes;
    let divisor = (sin * sin + cos * cos).sqrt();
    ((sin / divisor, off_pole(cos / divisor)), divisor)
}

/// The ends of a line.
///
/// More than 90° of longitude apart, everything is told from the supplements of λ and L, so that no digit is lost near the antipode.
#[derive(Clone, Copy)]
pub(super) struct Ends<T> {
    u1: (T, T),
    u2: (T, T),
    /// sin(U₂ − U₁); if far, sin(U₂ + U₁).
    north: T,
    /// −1 if far, 1 if not: cos λ = side · cos x.
    pub side: T,
    /// x on the ellipsoid: |L|, or π − |L| if far.
    pub lon: T,
    /// 1 eastward, −1 westward.
    east: T,
}

/// The great circle between two ends for one λ.
#[derive(Clone, Copy)]
pub(super) struct Arc<T> {
    pub sigma: T,
    pub sin_sigma: T,
    pub cos_sigma: T,
    pub sin_alpha: T,
    pub cos2_alpha: T,
    /// cos 2σₘ
    pub cos_middle: T,
    /// d sin α/dx
    pub bend: T,
    /// sin σ times sine and cosine of the azimuths.
    course1: (T, T),
    course2: (T, T),
}

impl<T: Real> Ends<T> {
    #[inline(always)]
    pub fn new(axes: T, from: LatLon<T>, to: LatLon<T>) -> Self {
        let (u1, divisor1) = reduced(from.lat(), axes);
        let (u2, divisor2) = reduced(to.lat(), axes);
        let difference = longitude_difference(from, to);
        let east = T::ONE.copysign(difference.angle);
        let (angle, rest) = (difference.angle.abs(), difference.rest * east);
        let far = angle > T::of(90.0);
        let supplement = Split::sum(T::of(180.0) - angle, -rest);
        let lon = select(far, supplement.angle + supplement.rest, angle + rest) * T::of(RADIAN);
        let (apart, _) = latitude_difference(from, to).sin_cos();
        let (together, _) = Split::sum(from.lat(), to.lat()).sin_cos();
        let north = select(far, together, apart) * axes / (divisor1 * divisor2);
        // Between latitudes exactly opposite λ says nothing of the azimuth: there one is moved by far less
        // than its rounding. Not so between a pole and itself.
        let opposite = far & (u1.0 * u2.0 <= T::ZERO);
        let least = select(opposite, T::EPSILON * T::EPSILON, T::ZERO);
        Self {
            u1,
            u2,
            north: max(north.abs(), least).copysign(north),
            side: select(far, -T::ONE, T::ONE),
            lon,
            east,
        }
    }

    /// The azimuths at both ends in degrees, once the longitude on the sphere has grown by so much of sin σ.
    #[cfg_attr(not(small), inline(always))]
    pub fn azimuths_after(&self, arc: &Arc<T>, shift: T) -> (T, T) {
        let ((e1, n1), (e2, n2)) = (arc.course1, arc.course2);
        // Each end moves beside the line by the cosine of its latitude and azimuth.
        let divisor = select(arc.sin_sigma == T::ZERO, T::ONE, arc.sin_sigma);
        let turn = shift * self.east / divisor;
        let turn1 = turn * (self.u2.1 * (n2 / divisor));
        let turn2 = turn * (self.u1.1 * (n1 / divisor));
        (
            atan2_degrees(e1 + n1 * turn1, n1 - e1 * turn1),
            atan2_degrees(e2 + n2 * turn2, n2 - e2 * turn2),
        )
    }

    #[cfg_attr(not(small), inline(always))]
    pub fn arc(&self, x: T) -> Arc<T> {
        let ((sin1, cos1), (sin2, cos2)) = (self.u1, self.u2);
        let (sin_x, cos_x) = sin_cos(x);
        // 2 sin²(x/2)
        let lift = sin_x * sin_x / (T::ONE + cos_x);
        let (e1, n1) = (cos2 * sin_x, self.north + self.side * (sin1 * cos2 * lift));
        let (e2, n2) = (cos1 * sin_x, self.side * (self.north - sin2 * cos1 * lift));
        let sin_sigma = hypot(e1, n1);
        let cos_sigma = sin1 * sin2 + self.side * (cos1 * cos2 * cos_x);
        // Coincident places; or antipodal ones, from which the line goes north.
        let degenerate = sin_sigma == T::ZERO;
        let opposite = degenerate & (cos_sigma < T::ZERO);
        let divisor = select(degenerate, T::ONE, sin_sigma);
        let n1 = select(opposite, T::ONE, n1);
        let n2 = select(opposite, self.side, n2);
        let (sin_course, cos_course) = (e1 / divisor, n1 / divisor);
        let sin_alpha = cos1 * sin_course;
        let across = sin_course * sin1;
        let cos2_alpha = cos_course * cos_course + across * across;
        let middle = (sin1 + sin1) * sin2 / select(cos2_alpha == T::ZERO, T::ONE, cos2_alpha);
        let bend = cos1 * cos2 * cos_x - self.side * (sin_alpha * sin_alpha * cos_sigma);
        Arc {
            sigma: atan2(sin_sigma, cos_sigma),
            sin_sigma,
            cos_sigma,
            sin_alpha,
            cos2_alpha,
            cos_middle: max(min(cos_sigma - middle, T::ONE), -T::ONE),
            bend: select(degenerate & !opposite, T::ZERO, bend / off_pole(sin_sigma)),
            course1: (e1 * self.east, n1),
            course2: (e2 * self.east, n2),
        }
    }
}

impl<T: Real> Arc<T> {
    /// The azimuths at both ends, in degrees.
    #[inline(always)]
    pub fn azimuths(&self) -> (T, T) {
        let ((e1, n1), (e2, n2)) = (self.course1, self.course2);
        (atan2_degrees(e1, n1), atan2_degrees(e2, n2))
    }

    /// Σ cₖ sin kσ cos 2kσₘ of the first terms.
    #[inline(always)]
    pub fn waves(&self, c: &[T], terms: usize) -> T {
        waves(c, terms, (self.sin_sigma, self.cos_sigma), self.cos_middle)
    }
}

/// Σ cₖ sin kσ cos kμ, by the recurrences of both factors: nothing is lost where σ is small.
#[inline(always)]
pub(super) fn waves<T: Real>(c: &[T], terms: usize, (sin, cos): (T, T), cos_middle: T) -> T {
    let (twice, twice_middle) = (cos + cos, cos_middle + cos_middle);
    let (mut s0, mut s1) = (T::ZERO, sin);
    let (mut c0, mut c1) = (T::ONE, cos_middle);
    let mut sum = T::ZERO;
    for &ck in c.iter().take(terms) {
        sum += ck * s1 * c1;
        (s0, s1) = (s1, twice * s1 - s0);
        (c0, c1) = (c1, twice_middle * c1 - c0);
    }
    sum
}

/// A line from a place along an azimuth, on the sphere.
pub(super) struct Start<T> {
    u1: (T, T),
    azimuth: (T, T),
    pub sin_alpha: T,
    pub cos2_alpha: T,
    /// Sine and cosine of 2σ₁.
    twice: (T, T),
}

impl<T: Real> Start<T> {
    #[inline(always)]
    pub fn new(axes: T, from: LatLon<T>, azimuth: (T, T)) -> Self {
        let (u1, _) = reduced(from.lat(), axes);
        let ((sin1, cos1), (sin, cos)) = (u1, azimuth);
        let across = sin * sin1;
        let cos2_alpha = cos * cos + across * across;
        // σ₁ is the angle of (cos U₁ cos α₁, sin U₁), of length cos α.
        let along = cos1 * cos;
        let divisor = select(cos2_alpha == T::ZERO, T::ONE, cos2_alpha);
        Self {
            u1,
            azimuth,
            sin_alpha: cos1 * sin,
            cos2_alpha,
            twice: (
                (sin1 + sin1) * along / divisor,
                (along - sin1) * (along + sin1) / divisor,
            ),
        }
    }

    /// cos 2σₘ, from sine and cosine of σ.
    #[inline(always)]
    pub fn cos_middle(&self, (sin, cos): (T, T)) -> T {
        let (sin_twice, cos_twice) = self.twice;
        cos_twice * cos - sin_twice * sin
    }

    #[inline(always)]
    pub fn end(&self, axes: T, arc: (T, T)) -> End<T> {
        end(self.u1, self.azimuth, arc, axes)
    }
}
