//! The direct problem: the arc follows from the distance by a reverted series.

use core::f64::consts::PI;

use super::{Answer, Ordinary, grow, parametric, series, waves};
use crate::geodesic::Direct;
use crate::geodesic::degrees::{off_pole, wrapped};
use crate::math::{Polynomial, either, octant, select, sin_cos, sin_cos_degrees};
use crate::{LatLon, Real};

impl<T: Real> Ordinary<T> {
    /// The direct problem without a branch; not found for azimuths beyond ±360°, nor after very many circuits.
    #[inline(always)]
    pub fn few_direct(&self, from: LatLon<T>, azimuth: T, distance: T) -> Answer<Direct<T>> {
        let few = (azimuth.abs() <= T::of(360.0)) & (distance.abs() <= T::pick(300.0, 60.0) * self.b);
        (self.end(from, sin_cos_degrees(azimuth), distance), few)
    }

    /// Where a line ends.
    #[inline(always)]
    fn end(&self, from: LatLon<T>, azimuth: (T, T), distance: T) -> Direct<T> {
        let start = Start::new(from, azimuth, self.axes);
        let Start {
            sin1, along, square, ..
        } = start;
        let factor = series(square, &self.epsilon, T::terms(7, 3));
        let epsilon = factor * square;
        let epsilon2 = epsilon * epsilon;
        // cos α₀ times sine and cosine of an arc from the node; of its double, times ε.
        let doubled = |(sin, cos): (T, T)| (factor * (cos + cos) * sin, factor * ((cos - sin) * (cos + sin)));
        let twice = doubled((sin1, along));

        let spherical = distance / self.b;
        let whole = spherical + spherical * inverse_a1_less_1(epsilon);
        let (sin_tau, cos_tau) = sin_cos(whole);
        let wave1 = c1_sines(epsilon2, twice);
        let (tau1_sin, tau1_cos) = grow((sin1, along), wave1);
        let tau2 = (
            tau1_sin * cos_tau + tau1_cos * sin_tau,
            tau1_cos * cos_tau - tau1_sin * sin_tau,
        );
        let more = wave1 + c1_reverted_sines(epsilon2, doubled(tau2));
        let sigma = whole + more;
        let (sin, cos) = grow((sin_tau, cos_tau), more);

        let waves = waves(epsilon, twice.1 * cos - twice.0 * sin, (sin, cos));
        let (a3, bend) = self.i3(epsilon, waves);
        let shift = self.f * (start.sin_alpha * (a3 * sigma + bend));
        start.end((sin, cos), shift, false)
    }
}

/// A line from a place along an azimuth, on the auxiliary sphere.
pub(in crate::geodesic) struct Start<T> {
    from: LatLon<T>,
    axes: T,
    azimuth: (T, T),
    /// Sine and cosine of the parametric latitude.
    pub sin1: T,
    cos1: T,
    /// cos β₁ cos α₁: with sin β₁ cos α₀ times cosine and sine of the arc from the node.
    pub along: T,
    pub sin_alpha: T,
    /// cos²α₀.
    pub square: T,
}

impl<T: Real> Start<T> {
    /// From sine and cosine of the azimuth.
    #[inline(always)]
    pub fn new(from: LatLon<T>, azimuth: (T, T), axes: T) -> Self {
        let ((sin1, cos1), _) = parametric(from.lat(), axes);
        let cos1 = off_pole(cos1);
        let (sin_azimuth, cos_azimuth) = azimuth;
        let across = sin_azimuth * sin1;
        Self {
            from,
            axes,
            azimuth,
            sin1,
            cos1,
            along: cos1 * cos_azimuth,
            sin_alpha: sin_azimuth * cos1,
            square: cos_azimuth * cos_azimuth + across * across,
        }
    }

    /// The end of an arc, from its sine and cosine and by what the longitude on the ellipsoid is less than on
    /// the sphere, in radians: of many circuits if need be.
    #[inline(always)]
    pub fn end(&self, (sin, cos): (T, T), shift: T, many: bool) -> Direct<T> {
        let &Self {
            sin1,
            cos1,
            along,
            azimuth: (sin_azimuth, cos_azimuth),
            ..
        } = self;
        let east = sin_azimuth * sin;
        let outward = cos1 * cos - sin1 * sin * cos_azimuth;
        let up = sin1 * cos + along * sin;
        let north = along * cos - sin1 * sin;
        let shift = shift * T::of(180.0 / PI);
        let shift = if many { shift.remainder(T::of(360.0)) } else { shift };
        let lon = angle_degrees(east, outward) - shift;
        let lat = angle_degrees(up, self.axes * (east * east + outward * outward).sqrt());
        // Next to a pole rounding turns the meridian; the azimuth counts from the one that the longitude names, at the pole itself from
        // the first one.
        let (eastward, inward) = (sin_azimuth * cos, cos1 * sin + sin1 * cos * cos_azimuth);
        let outward = either((east == T::ZERO) & (outward == T::ZERO), T::ONE) + outward;
        let polar = up * up > T::of(0.75);
        let course = select(polar, (outward * eastward + east * inward) * up.abs(), self.sin_alpha);
        let ahead = select(polar, (outward * inward - east * eastward) * T::ONE.copysign(up), north);
        Direct {
            position: LatLon::within(lat, wrapped(self.from.lon() + wrapped(lon))),
            azimuth: angle_degrees(course, ahead),
        }
    }
}

/// The angle of the point (x, y) from the x axis, in degrees.
#[inline(always)]
fn angle_degrees<T: Real>(y: T, x: T) -> T {
    let (eighths, rest) = octant(y.abs(), x);
    (eighths * T::of(45.0) + rest * T::of(180.0 / PI)).copysign(y)
}

/// Σ C₁ₗ sin 2lσ from ε² and ε times sine and cosine of 2σ.
#[inline(always)]
fn c1_sines<T: Real>(square: T, double: (T, T)) -> T {
    let of = T::of;
    sines(
        [
            of(-0.5) + square * (of(3.0 / 16.0) - of(1.0 / 32.0) * square),
            of(-1.0 / 16.0) + square * of(1.0 / 32.0),
            of(-1.0 / 48.0) + square * of(3.0 / 256.0),
            of(-5.0 / 512.0),
            of(-7.0 / 1280.0),
            T::ZERO,
        ],
        T::terms(5, 2),
        square,
        double,
    )
}

/// Σ C′₁ₗ sin 2lτ from ε² and ε times sine and cosine of 2τ.
#[inline(always)]
fn c1_reverted_sines<T: Real>(square: T, double: (T, T)) -> T {
    let of = T::of;
    sines(
        [
            of(0.5) - square * (of(9.0 / 32.0) - of(205.0 / 1536.0) * square),
            of(5.0 / 16.0) - square * (of(37.0 / 96.0) - of(1335.0 / 4096.0) * square),
            of(29.0 / 96.0) - square * of(75.0 / 128.0),
            of(539.0 / 1536.0) - square * of(2391.0 / 2560.0),
            of(3467.0 / 7680.0),
            of(38081.0 / 61440.0),
        ],
        T::terms(6, 2),
        square,
        double,
    )
}

/// Σ cₗ ε^l sin 2lσ by Clenshaw's recurrence, from ε² and ε times sine and cosine of 2σ.
#[inline(always)]
fn sines<T: Real, const N: usize>(c: [T; N], terms: usize, square: T, (sin, cos): (T, T)) -> T {
    let twice = cos + cos;
    let used = c.iter().take(terms).rev();
    let (b, _) = used.fold((T::ZERO, T::ZERO), |(b1, b2), &c| (c + (twice * b1 - square * b2), b1));
    sin * b
}

/// (1/A₁ − 1)/ε by powers of ε.
const INVERSE_A1: Polynomial<6, 6> =
    Polynomial::rounded([-1.0, -1.0 / 4.0, 1.0 / 4.0, 3.0 / 64.0, -3.0 / 64.0, -3.0 / 256.0]);

/// 1/A₁ − 1.
#[inline(always)]
fn inverse_a1_less_1<T: Real>(epsilon: T) -> T {
    epsilon * series(epsilon, &T::all(&INVERSE_A1), T::terms(6, 3))
}
