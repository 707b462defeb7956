//! The canonical inverse problem, and the lines of it that have a closed form.

use core::f64::consts::PI;

use super::Solver;
use super::lengths::ArcEnd;
use super::start::Guess;
use crate::geodesic::Inverse;
use crate::geodesic::angle::{Angle, longitude_difference};
use crate::geodesic::series::Integrals;
use crate::geodesic::sphere::{Triangle, arc_from_node, node};
use crate::math::{DoubleWord, atan2, hypot, max, select};
use crate::{LatLon, Real};

/// The inverse problem turned so that β₁ ≤ 0, |β₂| ≤ −β₁ and 0 ≤ λ₁₂ ≤ π (Karney 44), with what it takes to
/// turn the answer back.
#[derive(Clone, Copy)]
pub struct Canonical<T> {
    pub beta1: Angle<T>,
    pub beta2: Angle<T>,
    pub dn1: T,
    pub dn2: T,
    /// sin(β₂ − β₁), from the difference of the latitudes.
    pub(super) rise: T,
    /// λ₁₂, in radians and as sine and cosine.
    pub(super) lambda: T,
    pub lambda12: Angle<T>,
    /// 180° − λ₁₂.
    supplement: T,
    /// Whether the first point is a pole.
    polar: bool,
    /// −1 if the points were exchanged.
    swap: T,
    /// −1 if the longitude was reflected; this and `swap` count together.
    lon_sign: T,
    lat_sign: T,
}

/// The geodesic between the points of a canonical problem.
#[derive(Clone, Copy)]
pub struct Segment<T> {
    /// σ₁₂ in radians.
    pub sigma12: T,
    /// s₁₂ in metres.
    pub distance: T,
    /// m₁₂ in metres.
    pub reduced: T,
    /// M₁₂ and M₂₁.
    pub scales: [T; 2],
    pub alpha1: Angle<T>,
    pub alpha2: Angle<T>,
    /// ω₁₂; none along a meridian.
    pub omega12: Option<Angle<T>>,
    /// How often the longitude was evaluated.
    pub evaluations: usize,
}

/// The square root of the smallest positive normal number: stands for a zero that a quotient must survive.
pub(super) fn tiny<T: Real>() -> T {
    T::pick(1.491_668_146_240_041_3e-154, 1.084_202_2e-19)
}

/// A latitude or azimuth in degrees. Its smallest values, of no account on any planet, are rounded to
/// multiples of 2⁻⁵⁷ (`f32`: 2⁻³⁸) so that no product of theirs underflows.
pub(super) fn rounded<T: Real>(degrees: T) -> T {
    let step = T::pick(1.0 / 16.0, 1.0 / 16384.0);
    let size = degrees.abs();
    let size = select(size < step, step - (step - size), size);
    size.copysign(degrees)
}

/// What the area under the geodesic between the points of a canonical problem depends on.
#[derive(Clone, Copy)]
pub struct Course<T> {
    pub alpha1: Angle<T>,
    pub alpha2: Angle<T>,
    /// ω₁₂, unless the course is along a meridian.
    pub omega12: Angle<T>,
    pub meridional: bool,
}

impl<T: Real> Segment<T> {
    pub fn course(&self) -> Course<T> {
        Course {
            alpha1: self.alpha1,
            alpha2: self.alpha2,
            omega12: self.omega12.unwrap_or(self.alpha1),
            meridional: self.omega12.is_none(),
        }
    }
}

impl<T: Real> Canonical<T> {
    #[cfg_attr(not(small), inline(always))]
    pub fn new(solver: &Solver<T>, from: LatLon<T>, to: LatLon<T>) -> Self {
        let DoubleWord { high: lon12, low: rest } = longitude_difference(from, to);
        let mut lon_sign = T::ONE.copysign(lon12);
        let (lon12, rest) = (lon12 * lon_sign, rest * lon_sign);
        let (sin, cos) = DoubleWord { high: lon12, low: rest }.sin_cos_degrees();
        let (mut lat1, mut lat2) = (rounded(from.lat()), rounded(to.lat()));
        let swap = select(lat1.abs() < lat2.abs(), -T::ONE, T::ONE);
        let exchanged = swap < T::ZERO;
        lon_sign = select(exchanged, -lon_sign, lon_sign);
        (lat1, lat2) = select(exchanged, (lat2, lat1), (lat1, lat2));
        let lat_sign = -T::ONE.copysign(lat1);
        let (lat1, lat2) = (lat1 * lat_sign, lat2 * lat_sign);
        let lambda = (lon12 + rest) * T::of(PI / 180.0);
        // Next to the equator the azimuth of a long line turns within its rounding, and Newton's method is
        // lost: these places are taken for places on it, half a nanometre away on the Earth (f32: half a
        // millimetre). The side that the line passes on stays: −0.
        let beside = (lambda > T::ONE) & (lat1 >= T::pick(-5e-15, -5e-9));
        let (lat1, lat2) = (select(beside, -T::ZERO, lat1), select(beside, T::ZERO, lat2));
        let (beta1, radius1) = solver.parametric(lat1);
        let (mut beta2, radius2) = solver.parametric(lat2);
        let (rise, _) = DoubleWord::sum(lat2, -lat1).sin_cos_degrees();
        // Rounding may hide that |β₁| = |β₂|, or turn their order round: the smaller of sine and cosine tells
        // more.
        let level = select(
            beta1.cos < -beta1.sin,
            beta2.cos <= beta1.cos,
            beta2.sin.abs() >= -beta1.sin,
        );
        beta2 = Angle {
            sin: select(level, beta1.sin.copysign(beta2.sin), beta2.sin),
            cos: select(level, beta1.cos, beta2.cos),
        };
        Self {
            beta1,
            beta2,
            dn1: solver.dn(beta1.sin),
            dn2: solver.dn(beta2.sin),
            rise: solver.axes * rise / (radius1 * radius2),
            lambda,
            lambda12: Angle { sin, cos },
            supplement: (T::of(180.0) - lon12) - rest,
            polar: lat1 == T::of(-90.0),
            swap,
            lon_sign,
            lat_sign,
        }
    }

    /// The sign that an area takes on the way back.
    #[inline(always)]
    pub fn area_sign(&self) -> T {
        self.swap * self.lon_sign * self.lat_sign
    }

    /// An azimuth of the problem as it was put from one of the canonical, and back.
    #[cfg_attr(not(small), inline(always))]
    fn turned(&self, alpha: Angle<T>) -> Angle<T> {
        Angle {
            sin: alpha.sin * (self.swap * self.lon_sign) + T::ZERO,
            cos: alpha.cos * (self.swap * self.lat_sign) + T::ZERO,
        }
    }

    /// The azimuths and scales of the problem as it was put.
    pub fn turned_back(&self, arc: &Segment<T>) -> ([Angle<T>; 2], [T; 2]) {
        let (one, two) = (self.turned(arc.alpha1), self.turned(arc.alpha2));
        let [scale1, scale2] = arc.scales;
        if self.swap < T::ZERO {
            ([two, one], [scale2, scale1])
        } else {
            ([one, two], [scale1, scale2])
        }
    }

    /// The course of a line whose inverse problem, as it was put, is solved already: `growth` is ω₁₂ − λ₁₂ in
    /// radians.
    #[cfg_attr(not(small), inline(always))]
    pub fn course(&self, line: Inverse<T>, growth: T) -> Course<T> {
        let one = self.turned(Angle::degrees(line.azimuth1));
        let two = self.turned(Angle::degrees(line.azimuth2));
        let (alpha1, alpha2) = select(self.swap < T::ZERO, (two, one), (one, two));
        Course {
            alpha1,
            alpha2,
            omega12: self.lambda12.plus(Angle::radians(growth)),
            meridional: (self.polar | (self.lambda12.sin == T::ZERO)) & (alpha2.sin == T::ZERO),
        }
    }

    /// The segment of the same line; `sigma12` is σ₁₂.
    pub fn segment(
        &self,
        solver: &Solver<T>,
        line: Inverse<T>,
        [sigma12, growth]: [T; 2],
        evaluations: usize,
    ) -> Segment<T> {
        let course = self.course(line, growth);
        let Course { alpha1, alpha2, .. } = course;
        let alpha0 = node(alpha1, self.beta1);
        let epsilon = Integrals::epsilon(alpha0.cos * alpha0.cos * solver.ellipsoid.ep2());
        let sigma1 = arc_from_node(alpha1, self.beta1);
        let sigma2 = sigma1.plus(Angle::radians(sigma12));
        let lengths = solver.lengths(epsilon, sigma12, self.end1(sigma1), self.end2(sigma2));
        let distance = line.distance;
        let reduced = if sigma12 < solver.short {
            // m₁₂ = s₁₂(1 − σ₁₂²/6 …): between neighbours the differences of its formula would be all
            // rounding.
            distance - distance * (sigma12 * sigma12 / T::of(6.0))
        } else {
            lengths.reduced * solver.ellipsoid.b()
        };
        Segment {
            sigma12,
            distance,
            reduced,
            scales: lengths.scales,
            alpha1,
            alpha2,
            omega12: (!course.meridional).then_some(course.omega12),
            evaluations,
        }
    }

    /// Solves the problem.
    pub fn solve(&self, solver: &Solver<T>) -> Segment<T> {
        if self.polar || self.lambda12.sin == T::ZERO {
            if let Some(segment) = self.meridional(solver) {
                return segment;
            }
        }
        let f = solver.ellipsoid.f();
        if self.beta1.sin == T::ZERO && (f <= T::ZERO || self.supplement >= f * T::of(180.0)) {
            return self.equatorial(solver);
        }
        match self.guess(solver) {
            Guess::Short(segment) => segment,
            Guess::Azimuth(alpha1) => self.newton(solver, alpha1),
        }
    }

    pub(super) fn end1(&self, sigma: Angle<T>) -> ArcEnd<T> {
        ArcEnd {
            sigma,
            cos_beta: self.beta1.cos,
            dn: self.dn1,
        }
    }

    pub(super) fn end2(&self, sigma: Angle<T>) -> ArcEnd<T> {
        ArcEnd {
            sigma,
            cos_beta: self.beta2.cos,
            dn: self.dn2,
        }
    }

    /// Along a meridian, unless a shorter way leaves it (prolate, nearly antipodal).
    fn meridional(&self, solver: &Solver<T>) -> Option<Segment<T>> {
        let alpha1 = Angle {
            sin: self.lambda12.sin,
            cos: self.lambda12.cos,
        };
        let alpha2 = Angle {
            sin: T::ZERO,
            cos: T::ONE,
        };
        let sigma1 = Angle {
            sin: self.beta1.sin,
            cos: alpha1.cos * self.beta1.cos,
        };
        let sigma2 = self.beta2;
        let mut sigma12 = if alpha1.cos > T::ZERO {
            atan2(self.rise, sigma1.cos * sigma2.cos + sigma1.sin * sigma2.sin)
        } else {
            arc_between(sigma1, sigma2)
        };
        let lengths = solver.lengths(solver.ellipsoid.n(), sigma12, self.end1(sigma1), self.end2(sigma2));
        let (mut distance, mut reduced, mut scales) = (lengths.distance, lengths.reduced, lengths.scales);
        if sigma12 < T::of(3.0) * tiny::<T>() {
            (sigma12, distance, reduced, scales) = (T::ZERO, T::ZERO, T::ZERO, [T::ONE; 2]);
        } else if sigma12 < T::EPSILON.sqrt() {
            // m₁₂ = s₁₂(1 − σ₁₂²/6 …): the differences of its formula would be all rounding.
            reduced = distance;
        } else if reduced < T::ZERO {
            return None;
        }
        let b = solver.ellipsoid.b();
        Some(Segment {
            sigma12,
            distance: distance * b,
            reduced: reduced * b,
            scales,
            alpha1,
            alpha2,
            omega12: None,
            evaluations: 0,
        })
    }

    /// Along the equator.
    fn equatorial(&self, solver: &Solver<T>) -> Segment<T> {
        let sigma12 = self.lambda / solver.axes;
        let omega12 = Angle::radians(sigma12);
        let east = Angle {
            sin: T::ONE,
            cos: T::ZERO,
        };
        Segment {
            sigma12,
            distance: solver.ellipsoid.a() * self.lambda,
            reduced: solver.ellipsoid.b() * omega12.sin,
            scales: [omega12.cos; 2],
            alpha1: east,
            alpha2: east,
            omega12: Some(omega12),
            evaluations: 0,
        }
    }

    /// The triangle for one ω₁₂: directions of both azimuths, and σ₁₂, of any length. For cos ω₁₂ ≥ 0 nothing
    /// cancels.
    pub(super) fn triangle(&self, omega12: Angle<T>) -> ([Angle<T>; 2], Angle<T>) {
        let versine = omega12.sin * omega12.sin / (T::ONE + omega12.cos);
        let triangle = Triangle::new(T::ONE, [self.beta1, self.beta2], self.rise, omega12, versine);
        ([triangle.course1, triangle.course2], side(&triangle))
    }
}

/// σ₁₂ of a triangle, of any length (Karney 51).
pub(super) fn side<T: Real>(triangle: &Triangle<T>) -> Angle<T> {
    Angle {
        sin: hypot(triangle.course1.sin, triangle.course1.cos),
        cos: triangle.cos_sigma(),
    }
}

/// σ₂ − σ₁ in [0, π].
pub(super) fn arc_between<T: Real>(one: Angle<T>, two: Angle<T>) -> T {
    let sin = max(one.cos * two.sin - one.sin * two.cos, T::ZERO) + T::ZERO;
    atan2(sin, one.cos * two.cos + one.sin * two.sin)
}
