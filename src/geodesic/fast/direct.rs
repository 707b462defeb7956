//! The direct problem: the arc follows from the distance by a reverted series.

use core::f64::consts::PI;

use super::Solver;
use crate::geodesic::Direct;
use crate::geodesic::angle::{Angle, off_pole, wrapped};
use crate::geodesic::series::short::{c1, c1_reverted, inverse_a1_less_1, waves};
use crate::geodesic::sphere::{Start, parametric_by_reciprocal};
use crate::math::{either, octant_degrees, select, sin_cos, sin_cos_degrees};
use crate::{LatLon, Real};

impl<T: Real> Solver<T> {
    /// The direct problem, and whether the answer is right: not for azimuths beyond ±360°, nor for distances
    /// over 300 (`f32`: 60) polar radii, some fifty (ten) circuits.
    #[inline(always)]
    pub fn direct(&self, from: LatLon<T>, azimuth: T, distance: T) -> (Direct<T>, bool) {
        let few = (azimuth.abs() <= T::of(360.0)) & (distance.abs() <= T::pick(300.0, 60.0) * self.b);
        (self.end(from, sin_cos_degrees(azimuth).into(), distance), few)
    }

    /// The end of a line of few circuits.
    #[inline(always)]
    fn end(&self, from: LatLon<T>, alpha1: Angle<T>, distance: T) -> Direct<T> {
        let start = start(from, alpha1, self.axes);
        let (sin1, along) = (start.beta1.sin, start.along);
        let epsilon_by_cos2 = self.series.epsilon_by_cos2(start.cos2_alpha0);
        let epsilon = epsilon_by_cos2 * start.cos2_alpha0;
        let epsilon2 = epsilon * epsilon;
        // From cos α₀ times sine and cosine of σ: ε times those of 2σ.
        let doubled = |sigma: Angle<T>| {
            let Angle { sin, cos } = sigma;
            (
                epsilon_by_cos2 * (cos + cos) * sin,
                epsilon_by_cos2 * ((cos - sin) * (cos + sin)),
            )
        };
        let sigma1 = Angle { sin: sin1, cos: along };
        let twice = doubled(sigma1);

        // τ₁₂ = s₁₂/(bA₁), τ = σ + Σ C₁ₗ sin 2lσ (Karney 20).
        let spherical = distance / self.b;
        let tau12 = spherical + spherical * inverse_a1_less_1(epsilon);
        let turn = Angle::from(sin_cos(tau12));
        let wave1 = c1(epsilon2, twice);
        let tau1 = sigma1.plus_small(wave1);
        let tau2 = tau1.plus(turn);
        let more = wave1 + c1_reverted(epsilon2, doubled(tau2));
        let sigma12 = tau12 + more;
        let arc = turn.plus_small(more);

        let waves = waves(epsilon, twice.1 * arc.cos - twice.0 * arc.sin, (arc.sin, arc.cos));
        let (a3, bend) = self.series.i3(epsilon, waves);
        let shift = self.f * (start.sin_alpha0 * (a3 * sigma12 + bend));
        arrival(&start, from, self.axes, arc, shift, false)
    }
}

/// A great circle of the auxiliary sphere from a place; `axes` is b/a.
#[inline(always)]
pub fn start<T: Real>(from: LatLon<T>, alpha1: Angle<T>, axes: T) -> Start<T> {
    let (mut beta1, _) = parametric_by_reciprocal(from.lat(), axes);
    beta1.cos = off_pole(beta1.cos);
    Start::new(beta1, alpha1)
}

/// The end of an arc σ₁₂. `shift` is ω₁₂ − λ₁₂ in radians; after `many` circuits it may be any number.
#[inline(always)]
pub fn arrival<T: Real>(
    start: &Start<T>,
    from: LatLon<T>,
    axes: T,
    Angle { sin, cos }: Angle<T>,
    shift: T,
    many: bool,
) -> Direct<T> {
    let &Start {
        beta1, alpha1, along, ..
    } = start;
    // The end in the frame of the start's meridian: to the east, away from the axis, and up.
    let east = alpha1.sin * sin;
    let outward = beta1.cos * cos - beta1.sin * sin * alpha1.cos;
    let up = beta1.sin * cos + along * sin;
    let north = along * cos - beta1.sin * sin;
    let shift = shift * T::of(180.0 / PI);
    let shift = if many { shift.remainder(T::of(360.0)) } else { shift };
    let lon = angle_degrees(east, outward) - shift;
    let lat = angle_degrees(up, axes * (east * east + outward * outward).sqrt());
    // Next to a pole rounding turns the meridian; the azimuth counts from the one that the longitude names,
    // at the pole itself from the first one.
    let (eastward, inward) = (alpha1.sin * cos, beta1.cos * sin + beta1.sin * cos * alpha1.cos);
    let outward = either((east == T::ZERO) & (outward == T::ZERO), T::ONE) + outward;
    let polar = up * up > T::of(0.75);
    let course = select(polar, (outward * eastward + east * inward) * up.abs(), start.sin_alpha0);
    let ahead = select(polar, (outward * inward - east * eastward) * T::ONE.copysign(up), north);
    Direct {
        position: LatLon::within(lat, wrapped(from.lon() + wrapped(lon))),
        azimuth: angle_degrees(course, ahead),
    }
}

/// The angle of the point (x, y) from the x axis, in degrees.
#[inline(always)]
fn angle_degrees<T: Real>(y: T, x: T) -> T {
    octant_degrees(y.abs(), x).copysign(y)
}
