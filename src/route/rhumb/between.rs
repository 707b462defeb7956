//! The solution between two latitudes, and the way to the second one.

use super::{Rhumb, radians};
use crate::geodesic::{latitude_difference, off_pole};
use crate::latitude::{SineSeries, Turn, terms};
use crate::math::{DoubleWord, inverse_gudermannian, max, min, select, sin_cos, sin_cos_degrees, sin_cos_small};
use crate::{LatLon, Real};

/// What belongs to two latitudes.
#[derive(Clone, Copy)]
pub(super) struct Between<T> {
    /// μ₂ − μ₁ in radians.
    north: T,
    /// (μ₂ − μ₁)/(ψ₂ − ψ₁): the radius of a parallel, or its mean, over that of a meridian; 0 to a pole.
    slope: T,
    /// The mean over ψ of the sine of the authalic latitude.
    mean_sin: T,
}

impl<T: Real> Between<T> {
    /// The way to the east in metres, of a difference of longitudes in radians; never −0, so that a line to
    /// the south has the azimuth 180.
    #[inline(always)]
    pub(super) fn east(&self, rhumb: &Rhumb<T>, lon: T) -> T {
        lon * self.slope * rhumb.radius + T::ZERO
    }

    /// The way to the north in metres.
    #[inline(always)]
    pub(super) fn north(&self, rhumb: &Rhumb<T>) -> T {
        self.north * rhumb.radius
    }

    #[inline(always)]
    pub(super) fn area(&self, rhumb: &Rhumb<T>, lon: T) -> T {
        rhumb.square * (lon * self.mean_sin)
    }
}

/// The end of a line: in degrees, the longitude running on.
#[derive(Clone, Copy)]
pub(super) struct Reached<T> {
    pub lat: T,
    pub lon: T,
    pub area: T,
}

/// The latitudes of a line's ends, in degrees.
#[derive(Clone, Copy)]
struct Ends<T> {
    first: DoubleWord<T>,
    second: DoubleWord<T>,
    sum: DoubleWord<T>,
    difference: DoubleWord<T>,
}

/// Turns sine and cosine by a small angle.
#[inline(always)]
fn turned<T: Real>((sin, cos): (T, T), angle: T) -> (T, T) {
    let (sine, cosine) = sin_cos_small(angle);
    let versine = sine * sine / (T::ONE + cosine);
    (sin + (cos * sine - sin * versine), cos - (sin * sine + cos * versine))
}

impl<T: Real> Rhumb<T> {
    #[inline(always)]
    pub(super) fn between<const SHORT: bool>(&self, from: LatLon<T>, to: LatLon<T>) -> Between<T> {
        let single = |lat: T| DoubleWord {
            high: lat,
            low: T::ZERO,
        };
        self.divided::<SHORT>(Ends {
            first: single(from.lat()),
            second: single(to.lat()),
            sum: DoubleWord::sum(from.lat(), to.lat()),
            difference: latitude_difference(from, to),
        })
    }

    #[inline(always)]
    fn divided<const SHORT: bool>(&self, ends: Ends<T>) -> Between<T> {
        let conformal = SineSeries::<T, SHORT>(self.conformal);
        // All quotients are even in the difference, and hardly change near 0. So they are those of a
        // difference that is large enough for them.
        let actual = ends.difference.value();
        let little = T::pick(1e-200, 1e-30);
        let near = actual.abs() < little;
        let difference = DoubleWord {
            high: select(near, little, ends.difference.high),
            low: select(near, T::ZERO, ends.difference.low),
        };
        // φ̄ and φ₁₂/2.
        let (sin_mean, cos_mean) = ends.sum.half().sin_cos_degrees();
        let (sin_half, cos_half) = difference.half().sin_cos_degrees();
        let sum = doubled((sin_mean, cos_mean));
        let (sin_difference, cos_difference) = doubled((sin_half, cos_half));
        let [to_rectifying, to_conformal, area] = self.products::<SHORT>(sum, cos_difference);
        let rate = T::ONE + sin_difference / radians(difference) * to_rectifying;
        // χ̄ and χ₁₂/2. Near a pole both corrections have the same sign, and no digits are lost.
        let (first, second) = (ends.first.sin_cos_degrees(), ends.second.sin_cos_degrees());
        let half = T::of(0.5);
        let correction = half * (conformal.angle(doubled(first)) + conformal.angle(doubled(second)));
        let (sin_mean, cos_mean) = turned((sin_mean, cos_mean), correction);
        let (sin_half, cos_half) = turned((sin_half, cos_half), half * sin_difference * to_conformal);
        let cosines = |latitude: (T, T)| max(conformal.turn(latitude).1, T::ZERO);
        // cos χ₁ cos χ₂ = cos² χ̄ − sin² (χ₁₂/2), the geometric mean.
        let middle = (cosines(first) * cosines(second)).sqrt();
        // tanh (ψ₁₂/2) = sin (χ₁₂/2)/cos χ̄.
        let width = off_pole(cos_mean);
        let isometric = inverse_gudermannian((sin_half / width, middle / width));
        let twice = isometric + isometric;
        let slope = radians(difference) * rate / twice;
        // tanh (½ ln (cos χ₁/cos χ₂)) = tan χ̄ tan (χ₁₂/2).
        let outer = off_pole(cos_mean * cos_half);
        let logarithm = inverse_gudermannian((sin_mean * sin_half / outer, middle / outer));
        let (sin_sum, _) = sum;
        let mean_sin = logarithm / isometric - (sin_sum + sin_sum) * (sin_difference / twice) * area;
        let pole = |lat: T| select(lat.abs() >= T::of(90.0), T::ONE.copysign(lat), T::ZERO);
        let poles = max(
            -T::ONE,
            min(T::ONE, pole(ends.first.value()) + pole(ends.second.value())),
        );
        Between {
            north: radians(ends.difference) * rate,
            slope,
            mean_sin: select(middle > T::ZERO, mean_sin, poles),
        }
    }

    /// Differences of the series over sin φ₁₂: Σ 2cₖ cos kΣ sin kφ₁₂ of the rectifying and the conformal
    /// latitude, and Σ Rₖ sin kΣ sin kφ₁₂ over sin Σ, with Σ = φ₁ + φ₂.
    #[inline(always)]
    fn products<const SHORT: bool>(&self, (_, cos_sum): (T, T), cos_difference: T) -> [T; 3] {
        let one = T::ONE;
        // Chebyshev's polynomials T and U.
        let (twice, by) = (cos_sum + cos_sum, cos_difference + cos_difference);
        let (mut t, mut u, mut v) = ((one, cos_sum), (T::ZERO, one), (T::ZERO, one));
        let mut sums = [T::ZERO; 3];
        let series = self.rectifying.iter().zip(&self.conformal).zip(&self.area);
        for ((&rectifying, &conformal), &area) in series.take(terms::<T>(SHORT)) {
            let cosine = (t.1 + t.1) * u.1;
            sums = [
                sums[0] + rectifying * cosine,
                sums[1] + conformal * cosine,
                sums[2] + area * (v.1 * u.1),
            ];
            t = (t.1, twice * t.1 - t.0);
            u = (u.1, by * u.1 - u.0);
            v = (v.1, twice * v.1 - v.0);
        }
        sums
    }

    /// Where a line ends, by the sine and cosine of its azimuth, and whether it ends at all.
    #[inline(always)]
    pub(super) fn reach<const SHORT: bool>(
        &self,
        from: LatLon<T>,
        (sin, cos): (T, T),
        distance: T,
    ) -> (Reached<T>, bool) {
        let quarter = T::pick(core::f64::consts::FRAC_PI_2, core::f32::consts::FRAC_PI_2);
        let (start, north) = (self.rectified::<SHORT>(from.lat()), distance * cos / self.radius);
        let end = start + north;
        let within = end.abs() <= quarter * (T::ONE + T::of(4.0) * T::EPSILON);
        let north = select(within, north, T::ZERO);
        // φ₁₂ from μ₁₂, as products of sines.
        let (_, cos_sum) = sin_cos(start + start + north);
        let (sin_north, cos_north) = sin_cos(north);
        let (twice, by) = (cos_sum + cos_sum, cos_north + cos_north);
        let (mut t, mut u) = ((T::ONE, cos_sum), (T::ZERO, T::ONE));
        let mut sum = T::ZERO;
        for &c in self.from_rectifying.iter().take(terms::<T>(SHORT)) {
            sum += c * ((t.1 + t.1) * u.1);
            t = (t.1, twice * t.1 - t.0);
            u = (u.1, by * u.1 - u.0);
        }
        let degrees = T::of(180.0 / core::f64::consts::PI);
        let difference = DoubleWord {
            high: (north + sin_north * sum) * degrees,
            low: T::ZERO,
        };
        let second = DoubleWord::sum(from.lat(), difference.high);
        let (high, low) = crate::math::sum(from.lat(), second.high);
        let ends = Ends {
            first: DoubleWord {
                high: from.lat(),
                low: T::ZERO,
            },
            second,
            sum: DoubleWord {
                high,
                low: low + second.low,
            },
            difference,
        };
        let between = self.divided::<SHORT>(ends);
        let right = T::of(90.0);
        let lat = max(-right, min(right, second.value()));
        // At a pole any longitude is right.
        let turns = (between.slope > T::ZERO) & (lat.abs() < right);
        let lon = select(turns, distance * sin / (between.slope * self.radius), T::ZERO);
        let area = between.area(self, lon);
        let lon = from.lon() + lon * degrees;
        (Reached { lat, lon, area }, within & lon.is_finite())
    }

    /// The rectifying latitude in radians.
    #[inline(always)]
    fn rectified<const SHORT: bool>(&self, lat: T) -> T {
        let correction = SineSeries::<T, SHORT>(self.rectifying).angle(doubled(sin_cos_degrees(lat)));
        lat * T::of(core::f64::consts::PI / 180.0) + correction
    }

    /// The longest way from a place at an azimuth, of the sign of a distance.
    #[cold]
    pub(super) fn limit(&self, from: LatLon<T>, (_, cos): (T, T), distance: T) -> T {
        let quarter = T::of(core::f64::consts::FRAC_PI_2);
        let start = if self.is_short() {
            self.rectified::<true>(from.lat())
        } else {
            self.rectified::<false>(from.lat())
        };
        let ahead = T::ONE.copysign(cos) * T::ONE.copysign(distance);
        let largest = T::pick(f64::MAX, f32::MAX);
        let limit = (quarter - start * ahead) * self.radius / cos.abs();
        min(limit, largest).copysign(distance)
    }
}

/// Sine and cosine of twice an angle.
#[inline(always)]
fn doubled<T: Real>((sin, cos): (T, T)) -> (T, T) {
    (T::of(2.0) * sin * cos, (cos - sin) * (cos + sin))
}
