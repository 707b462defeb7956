use core::f64::consts::PI;

use super::Karney;
use super::angle::Angle;
use super::astroid::astroid;
use super::lengths::Node;
use super::series::Series;
use crate::geodesic::degrees::{Split, hypot, longitude_difference};
use crate::geodesic::ordinary;
use crate::math::{atan2, max, min, select};
use crate::{LatLon, Real};

/// The inverse problem turned so that β₁ ≤ 0, |β₂| ≤ −β₁ and 0 ≤ λ₁₂ ≤ π, with what it takes to turn the answer back.
#[derive(Clone, Copy)]
pub(super) struct Canonical<T> {
    pub beta1: Angle<T>,
    pub beta2: Angle<T>,
    pub dn1: T,
    pub dn2: T,
    /// sin(β₂ − β₁), from the difference of the latitudes.
    rise: T,
    /// λ₁₂, in radians and as sine and cosine.
    lambda: T,
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
pub(super) struct Arc<T> {
    /// The arc on the auxiliary sphere in radians, σ₁₂.
    pub sigma: T,
    /// In metres.
    pub distance: T,
    /// In metres.
    pub reduced: T,
    pub scales: [T; 2],
    pub alpha1: Angle<T>,
    pub alpha2: Angle<T>,
    /// The longitude difference on the auxiliary sphere, ω₁₂; none along a meridian.
    pub omega: Option<Angle<T>>,
    /// How often the longitude was evaluated.
    pub evaluations: usize,
}

/// The square root of the smallest positive normal number: stands for a zero that a quotient must survive.
pub(super) fn tiny<T: Real>() -> T {
    T::pick(1.491_668_146_240_041_3e-154, 1.084_202_2e-19)
}

/// A latitude or azimuth in degrees with its smallest values, of no account on any planet, rounded to multiples of 2⁻⁵⁷ (2⁻³⁸) so that no
/// product of theirs underflows.
pub(super) fn rounded<T: Real>(degrees: T) -> T {
    let step = T::pick(1.0 / 16.0, 1.0 / 16384.0);
    let size = degrees.abs();
    let size = select(size < step, step - (step - size), size);
    size.copysign(degrees)
}

impl<T: Real> Canonical<T> {
    pub fn new(karney: &Karney<T>, from: LatLon<T>, to: LatLon<T>) -> Self {
        let Split { angle: lon12, rest } = longitude_difference(from, to);
        let mut lon_sign = T::ONE.copysign(lon12);
        let (lon12, rest) = (lon12 * lon_sign, rest * lon_sign);
        let (sin, cos) = Split { angle: lon12, rest }.sin_cos();
        let (mut lat1, mut lat2) = (rounded(from.lat()), rounded(to.lat()));
        let swap = select(lat1.abs() < lat2.abs(), -T::ONE, T::ONE);
        if swap < T::ZERO {
            lon_sign = -lon_sign;
            (lat1, lat2) = (lat2, lat1);
        }
        let lat_sign = -T::ONE.copysign(lat1);
        let (lat1, lat2) = (lat1 * lat_sign, lat2 * lat_sign);
        let lambda = (lon12 + rest) * T::of(PI / 180.0);
        // Next to the equator the azimuth of a long line turns within its rounding, and Newton's method is lost: these places are taken for
        // places on it, half a nanometre away on the Earth (f32: half a millimetre). The side that the line passes on stays: −0.
        let beside = (lambda > T::ONE) & (lat1 >= T::pick(-5e-15, -5e-9));
        let (lat1, lat2) = (select(beside, -T::ZERO, lat1), select(beside, T::ZERO, lat2));
        let (beta1, radius1) = karney.reduced(lat1);
        let (mut beta2, radius2) = karney.reduced(lat2);
        let (rise, _) = Split::sum(lat2, -lat1).sin_cos();
        // |β₁| = |β₂| exactly where rounding would hide it, or turn it round: the smaller of sine and cosine tells more.
        let level = if beta1.cos < -beta1.sin {
            beta2.cos <= beta1.cos
        } else {
            beta2.sin.abs() >= -beta1.sin
        };
        if level {
            beta2 = Angle {
                sin: beta1.sin.copysign(beta2.sin),
                cos: beta1.cos,
            };
        }
        Self {
            beta1,
            beta2,
            dn1: karney.dn(beta1.sin),
            dn2: karney.dn(beta2.sin),
            // β = atan((1 − f) tan φ) for both.
            rise: karney.axes * rise / (radius1 * radius2),
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
    pub fn area_sign(&self) -> T {
        self.swap * self.lon_sign * self.lat_sign
    }

    /// An azimuth of the problem as it was put from one of the canonical, and back.
    fn turned(&self, alpha: Angle<T>) -> Angle<T> {
        Angle {
            sin: alpha.sin * (self.swap * self.lon_sign) + T::ZERO,
            cos: alpha.cos * (self.swap * self.lat_sign) + T::ZERO,
        }
    }

    /// The azimuths (sine and cosine) and scales of the problem as it was put.
    pub fn turned_back(&self, arc: &Arc<T>) -> ([Angle<T>; 2], [T; 2]) {
        let (one, two) = (self.turned(arc.alpha1), self.turned(arc.alpha2));
        let [scale1, scale2] = arc.scales;
        if self.swap < T::ZERO {
            ([two, one], [scale2, scale1])
        } else {
            ([one, two], [scale1, scale2])
        }
    }

    /// The line that the straight lines of arithmetic found between the places of the problem as it was put.
    pub fn found(&self, karney: &Karney<T>, line: &ordinary::Line<T>) -> Arc<T> {
        let (azimuth1, azimuth2) = (line.inverse.azimuth1, line.inverse.azimuth2);
        let turn = |azimuth| self.turned(Angle::degrees(azimuth));
        let (alpha1, alpha2) = if self.swap < T::ZERO {
            (turn(azimuth2), turn(azimuth1))
        } else {
            (turn(azimuth1), turn(azimuth2))
        };
        let sigma = line.sigma;
        let cos_alpha0 = hypot(alpha1.cos, alpha1.sin * self.beta1.sin);
        let epsilon = Series::epsilon(cos_alpha0 * cos_alpha0 * karney.ellipsoid.ep2());
        let sigma1 = Angle::of(self.beta1.sin, alpha1.cos * self.beta1.cos);
        let sigma2 = sigma1.plus(Angle::radians(sigma));
        let lengths = karney.lengths(epsilon, sigma, self.node1(sigma1), self.node2(sigma2));
        let meridional = (self.polar || self.lambda12.sin == T::ZERO) && alpha2.sin == T::ZERO;
        let omega = self.lambda12.plus(Angle::radians(line.growth));
        let distance = line.inverse.distance;
        let reduced = if sigma < karney.short {
            // Between neighbours the differences of its formula would be all rounding.
            distance - distance * (sigma * sigma / T::of(6.0))
        } else {
            lengths.reduced * karney.ellipsoid.b()
        };
        Arc {
            sigma,
            distance,
            reduced,
            scales: lengths.scales,
            alpha1,
            alpha2,
            omega: (!meridional).then_some(omega),
            evaluations: line.evaluations,
        }
    }

    /// Solves the problem.
    pub fn solve(&self, karney: &Karney<T>) -> Arc<T> {
        if (self.polar || self.lambda12.sin == T::ZERO)
            && let Some(arc) = self.meridional(karney)
        {
            return arc;
        }
        let f = karney.ellipsoid.f();
        if self.beta1.sin == T::ZERO && (f <= T::ZERO || self.supplement >= f * T::of(180.0)) {
            return self.equatorial(karney);
        }
        match self.start(karney) {
            Start::Short(arc) => arc,
            Start::Azimuth(alpha1) => self.iterate(karney, alpha1),
        }
    }

    pub(super) fn node1(&self, sigma: Angle<T>) -> Node<T> {
        Node {
            sigma,
            cos_beta: self.beta1.cos,
            dn: self.dn1,
        }
    }

    pub(super) fn node2(&self, sigma: Angle<T>) -> Node<T> {
        Node {
            sigma,
            cos_beta: self.beta2.cos,
            dn: self.dn2,
        }
    }

    /// Along a meridian, unless a shorter way leaves it (prolate, nearly antipodal).
    fn meridional(&self, karney: &Karney<T>) -> Option<Arc<T>> {
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
        let mut sigma = if alpha1.cos > T::ZERO {
            atan2(self.rise, sigma1.cos * sigma2.cos + sigma1.sin * sigma2.sin)
        } else {
            arc_between(sigma1, sigma2)
        };
        let lengths = karney.lengths(karney.ellipsoid.n(), sigma, self.node1(sigma1), self.node2(sigma2));
        let (mut distance, mut reduced, mut scales) = (lengths.distance, lengths.reduced, lengths.scales);
        if sigma < T::of(3.0) * tiny::<T>() {
            (sigma, distance, reduced, scales) = (T::ZERO, T::ZERO, T::ZERO, [T::ONE; 2]);
        } else if sigma < T::EPSILON.sqrt() {
            // m₁₂ = s₁₂(1 − σ²/6 …): the differences of its formula would be all rounding.
            reduced = distance;
        } else if reduced < T::ZERO {
            return None;
        }
        let b = karney.ellipsoid.b();
        Some(Arc {
            sigma,
            distance: distance * b,
            reduced: reduced * b,
            scales,
            alpha1,
            alpha2,
            omega: None,
            evaluations: 0,
        })
    }

    /// Along the equator.
    fn equatorial(&self, karney: &Karney<T>) -> Arc<T> {
        let sigma = self.lambda / karney.axes;
        let omega = Angle::radians(sigma);
        let east = Angle {
            sin: T::ONE,
            cos: T::ZERO,
        };
        Arc {
            sigma,
            distance: karney.ellipsoid.a() * self.lambda,
            reduced: karney.ellipsoid.b() * omega.sin,
            scales: [omega.cos; 2],
            alpha1: east,
            alpha2: east,
            omega: Some(omega),
            evaluations: 0,
        }
    }

    /// The triangle of the two points and the pole on the auxiliary sphere for the longitude difference ω₁₂: directions of both azimuths,
    /// and sine and cosine of the side between the points. For cos ω₁₂ ≥ 0 nothing cancels.
    pub(super) fn triangle(&self, omega: Angle<T>) -> ([Angle<T>; 2], Angle<T>) {
        let (beta1, beta2) = (self.beta1, self.beta2);
        let versine = omega.sin * omega.sin / (T::ONE + omega.cos);
        let alpha1 = Angle {
            sin: beta2.cos * omega.sin,
            cos: self.rise + beta2.cos * beta1.sin * versine,
        };
        let alpha2 = Angle {
            sin: beta1.cos * omega.sin,
            cos: self.rise - beta1.cos * beta2.sin * versine,
        };
        let sigma = Angle {
            sin: hypot(alpha1.sin, alpha1.cos),
            cos: beta1.sin * beta2.sin + beta1.cos * beta2.cos * omega.cos,
        };
        ([alpha1, alpha2], sigma)
    }

    /// Starting azimuth for Newton's method, or the answer itself for a short line (Karney §5).
    fn start(&self, karney: &Karney<T>) -> Start<T> {
        let (beta1, beta2) = (self.beta1, self.beta2);
        let half = T::of(0.5);
        let rise_cos = beta2.cos * beta1.cos + beta2.sin * beta1.sin;
        let short = rise_cos >= T::ZERO && self.rise < half && beta2.cos * self.lambda < half;
        let mut dn = T::ONE;
        let mut omega = self.lambda12;
        if short {
            // ω₁₂ = λ₁₂/((1 − f)dn) at the middle latitude, as λ₁₂ and a little more.
            let sines = (beta1.sin + beta2.sin) * (beta1.sin + beta2.sin);
            let cosines = (beta1.cos + beta2.cos) * (beta1.cos + beta2.cos);
            let ellipsoid = karney.ellipsoid;
            dn = (T::ONE + ellipsoid.ep2() * (sines / (sines + cosines))).sqrt();
            let scale = karney.axes * dn;
            let more = ellipsoid.e2() * (cosines / (sines + cosines)) / (scale * (T::ONE + scale));
            omega = omega.plus(Angle::radians(self.lambda * more));
            // Rounded past π it would pass the pole on the other side, and half of the ellipsoid be under it with the other sign.
            omega.sin = select(omega.sin < T::ZERO, tiny(), omega.sin);
        }
        // β₁ + β₂ in (−π, 0].
        let sum_sin = beta2.sin * beta1.cos + beta2.cos * beta1.sin;
        let ([mut alpha1, alpha2], sigma) = if omega.cos >= T::ZERO {
            self.triangle(omega)
        } else {
            // Seen from the antipode of the first point.
            let versine = omega.sin * omega.sin / (T::ONE - omega.cos);
            let alpha1 = Angle {
                sin: beta2.cos * omega.sin,
                cos: sum_sin - beta2.cos * beta1.sin * versine,
            };
            let sigma = Angle {
                sin: hypot(alpha1.sin, alpha1.cos),
                cos: beta1.sin * beta2.sin + beta1.cos * beta2.cos * omega.cos,
            };
            let alpha2 = Angle {
                sin: beta1.cos * omega.sin,
                cos: self.rise - beta1.cos * beta2.sin * (T::ONE - omega.cos),
            };
            ([alpha1, alpha2], sigma)
        };
        if short && sigma.sin < karney.short {
            let sigma12 = sigma.to_radians();
            let along = Angle::radians(sigma12 / dn);
            let b = karney.ellipsoid.b();
            return Start::Short(Arc {
                sigma: sigma12,
                distance: sigma12 * dn * b,
                reduced: dn * dn * b * along.sin,
                scales: [along.cos; 2],
                alpha1: Angle::of(alpha1.sin, alpha1.cos),
                alpha2: Angle::of(alpha2.sin, alpha2.cos),
                omega: Some(omega),
                evaluations: 0,
            });
        }
        let n = karney.ellipsoid.n().abs();
        if sigma.cos < T::ZERO && sigma.sin < T::of(6.0 * PI) * n * beta1.cos * beta1.cos {
            alpha1 = self.antipodal(karney, sum_sin);
        }
        Start::Azimuth(if alpha1.sin > T::ZERO {
            Angle::of(alpha1.sin, alpha1.cos)
        } else {
            Angle {
                sin: T::ONE,
                cos: T::ZERO,
            }
        })
    }

    /// Starting azimuth for nearly antipodal points: the astroid problem in scaled coordinates (Karney 53 to 58).
    fn antipodal(&self, karney: &Karney<T>, sum_sin: T) -> Angle<T> {
        let (beta1, beta2) = (self.beta1, self.beta2);
        let f = karney.ellipsoid.f();
        let pi = T::of(PI);
        // λ₁₂ − π.
        let lambda = atan2(-self.lambda12.sin, -self.lambda12.cos);
        let oblate = f >= T::ZERO;
        let (x, y, lambda_scale) = if oblate {
            let epsilon = Series::epsilon(karney.ellipsoid.ep2() * beta1.sin * beta1.sin);
            let scale = f * beta1.cos * karney.series.a3(epsilon) * pi;
            (lambda / scale, sum_sin / (scale * beta1.cos), scale)
        } else {
            let sum_cos = beta2.cos * beta1.cos - beta2.sin * beta1.sin;
            let sum = atan2(sum_sin, sum_cos);
            let behind = Angle {
                sin: beta1.sin,
                cos: -beta1.cos,
            };
            let lengths = karney.lengths(karney.ellipsoid.n(), pi + sum, self.node1(behind), self.node2(beta2));
            let x = lengths.reduced / (beta1.cos * beta2.cos * lengths.secular * pi) - T::ONE;
            let beta_scale = if x < T::of(-0.01) {
                sum_sin / x
            } else {
                -f * beta1.cos * beta1.cos * pi
            };
            let scale = beta_scale / beta1.cos;
            (x, lambda / scale, scale)
        };
        let root = T::EPSILON.sqrt();
        if y > T::of(-200.0) * T::EPSILON && x > -T::ONE - T::of(1000.0) * root {
            // On the cut, where the geodesics are a family.
            return if oblate {
                let sin = min(T::ONE, -x);
                Angle {
                    sin,
                    cos: -(T::ONE - sin * sin).sqrt(),
                }
            } else {
                let limit = if x > T::of(-200.0) * T::EPSILON {
                    T::ZERO
                } else {
                    -T::ONE
                };
                let cos = max(limit, x);
                Angle {
                    sin: (T::ONE - cos * cos).sqrt(),
                    cos,
                }
            };
        }
        let k = astroid(x, y);
        let small = lambda_scale
            * if oblate {
                -x * k / (T::ONE + k)
            } else {
                -y * (T::ONE + k) / k
            };
        let (sin, cos) = crate::math::sin_cos(small);
        let (sin, cos) = (sin, -cos);
        Angle {
            sin: beta2.cos * sin,
            cos: sum_sin - beta2.cos * beta1.sin * sin * sin / (T::ONE - cos),
        }
    }
}

enum Start<T> {
    Short(Arc<T>),
    Azimuth(Angle<T>),
}

/// σ₂ − σ₁ in [0, π].
pub(super) fn arc_between<T: Real>(one: Angle<T>, two: Angle<T>) -> T {
    let sin = max(one.cos * two.sin - one.sin * two.cos, T::ZERO) + T::ZERO;
    atan2(sin, one.cos * two.cos + one.sin * two.sin)
}
