//! Both problems in straight lines, for ordinary places on an ellipsoid about as flat as the Earth.
//!
//! Every geodesic is a great circle on Bessel's auxiliary sphere, between the parametric latitudes; what is unknown there is the difference
//! of longitudes, ω = λ + f sin α₀ I₃. Newton's method finds it in a fixed number of steps, the first of them with short series. The last
//! needs no evaluation after it: distance and azimuths follow from their derivatives by ω. Nearly antipodal places, out of line, begin with the
//! root of the flat triangle.
//!
//! Symbols and series as in C. F. F. Karney, *Algorithms for geodesics*, J. Geodesy 87 (2013). The middle of the arc, σₘ, counts from
//! the node; sums over sines run as Σ 2cₗ cos 2lσₘ sin lσ, so that nothing cancels between neighbours.

use core::f64::consts::PI;

use super::degrees::{Split, off_pole, wrapped};
use super::karney::Series;
use super::{Direct, Inverse};
use crate::math::{
    Polynomial, choose, either, halves, max, octant, select, sin_cos, sin_cos_degrees, sin_cos_eighth, sin_cos_quarter,
};
use crate::{Ellipsoid, LatLon, Real};

/// An ellipsoid as the straight lines need it.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub(super) struct Ordinary<T> {
    b: T,
    f: T,
    axes: T,
    /// ε/cos²α₀ by powers of cos²α₀.
    epsilon: [T; 7],
    /// A₃ by powers of ε.
    a3: [T; 5],
    /// 2A₃C₃ₗ/ε^l by powers of ε, l = 1, 2, 3, 4, one row after the other.
    c3: [T; 10],
}

/// The answer of a straight line, and whether it is one.
type Answer<A> = (A, bool);

/// The great circle between two places for one ω.
#[derive(Clone, Copy)]
struct Arc<T> {
    /// sin σ times sine and cosine of the azimuths.
    course1: (T, T),
    course2: (T, T),
    /// 1/sin²σ.
    inverse_square: T,
    sin_sigma: T,
    cos_sigma: T,
    sin_alpha: T,
    /// cos²α₀.
    square: T,
    /// d sin α₀/dω.
    bend: T,
    /// cos²α₀ cos 2σₘ.
    middle: T,
}

/// The places of an inverse problem, the one of greater latitude first: of both directions of a line the same is solved.
#[derive(Clone, Copy)]
struct Pair<T> {
    lat1: T,
    lat2: T,
    /// Sine and cosine of the parametric latitudes.
    beta1: (T, T),
    beta2: (T, T),
    /// sin(β₂ ∓ β₁)/sin(φ₂ ∓ φ₁).
    scale: T,
    /// The difference of longitudes in degrees, and of half of it sine and cosine.
    lon: T,
    half: (T, T),
    /// What the difference's rounding lost, in radians.
    rest: T,
    /// −1 westward.
    east: T,
    swap: bool,
}

/// A pair seen from the first place, or near the antipode from opposite of it: there ω, λ and β₁ stand for π − ω, π − λ and −β₁.
#[derive(Clone, Copy)]
struct Ends<T, const FAR: bool> {
    beta1: (T, T),
    beta2: (T, T),
    /// sin(β₂ − β₁).
    rise: T,
    /// Sine and cosine of λ/2.
    half: (T, T),
}

/// atan t/t by powers of t², 0 ≤ t ≤ 1; error 1.2e-7 (`f64`), 5e-6 (`f32`).
const ROUGH_ATAN: Polynomial<8, 6> = Polynomial {
    f64: [
        0.999_999_881_996,
        -0.333_318_126_556,
        0.199_669_618_296,
        -0.140_032_901_847,
        0.098_688_654_581_3,
        -0.058_829_753_143_1,
        0.023_780_518_597_2,
        -0.004_559_791_986_13,
    ],
    f32: [
        0.999_994_8,
        -0.332_957_1,
        0.195_346_6,
        -0.120_448_59,
        0.056_589_99,
        -0.013_130_382,
    ],
};

/// ε/k² = 1/(1 + √(1 + k²))² by powers of k².
const EPSILON: Polynomial<7, 7> = Polynomial::rounded([
    1.0 / 4.0,
    -1.0 / 8.0,
    5.0 / 64.0,
    -7.0 / 128.0,
    21.0 / 512.0,
    -33.0 / 1024.0,
    429.0 / 16384.0,
]);

/// c₀ + c₁x + … of the first coefficients.
#[inline(always)]
fn series<T: Real>(x: T, coefficients: &[T], terms: usize) -> T {
    halves(x, terms, |i| coefficients.get(i).copied().unwrap_or(T::ZERO))
}

impl<T: Real> Ordinary<T> {
    /// From the ellipsoid and the series of its longitude.
    pub fn new(ellipsoid: Ellipsoid<T>, series: &Series<T>) -> Self {
        let (a3, c3) = series.low_orders();
        let ep2 = ellipsoid.ep2();
        let f = ellipsoid.f();
        // k² = e'² cos²α₀.
        let mut power = T::ONE;
        let epsilon = T::all(&EPSILON).map(|c| {
            power *= ep2;
            power * c
        });
        Self {
            b: ellipsoid.b(),
            f,
            axes: T::ONE - f,
            epsilon,
            a3,
            c3: c3.map(|c| c + c),
        }
    }

    /// Whether the straight lines hold on this ellipsoid.
    #[inline(always)]
    fn holds(&self) -> bool {
        // Room for the rounding of 1/150.
        self.f.abs() < T::of(1.0 / 149.0)
    }

    /// Whether a distance is at most 50 polar radii.
    #[inline(always)]
    pub fn reaches(&self, distance: T) -> bool {
        distance.abs() <= T::of(50.0) * self.b
    }

    /// Sine and cosine of the parametric latitude, and 1/√(cos²φ + (1 − f)² sin²φ).
    #[cfg_attr(not(small), inline(always))]
    fn parametric(&self, lat: T) -> ((T, T), T) {
        let (sin, cos) = sin_cos_quarter(lat.abs());
        let sin = (sin * self.axes).copysign(lat);
        let inverse = T::ONE / (sin * sin + cos * cos).sqrt();
        ((sin * inverse, cos * inverse), inverse)
    }

    /// The inverse problem, if there is a straight line for it.
    #[inline]
    pub fn inverse(&self, from: LatLon<T>, to: LatLon<T>) -> Option<Inverse<T>> {
        if !self.holds() {
            return None;
        }
        let pair = self.pair(from, to);
        if pair.nearly_antipodal() {
            // On a prolate ellipsoid there are several solutions.
            return if self.f < T::ZERO {
                None
            } else {
                self.far_inverse(&pair)
            };
        }
        let (inverse, found) = self.line::<false>(&pair);
        found.then_some(inverse)
    }

    /// The inverse problem without a branch; not found between nearly antipodal places.
    #[inline(always)]
    pub fn near_inverse(&self, from: LatLon<T>, to: LatLon<T>) -> Answer<Inverse<T>> {
        let pair = self.pair(from, to);
        let (inverse, found) = self.line::<false>(&pair);
        (inverse, found & !pair.nearly_antipodal() & self.holds())
    }

    #[cold]
    #[inline(never)]
    fn far_inverse(&self, pair: &Pair<T>) -> Option<Inverse<T>> {
        let (inverse, found) = self.line::<true>(pair);
        found.then_some(inverse)
    }

    /// The places of an inverse problem.
    #[cfg_attr(not(small), inline(always))]
    fn pair(&self, from: LatLon<T>, to: LatLon<T>) -> Pair<T> {
        // From 0 to 180°, and what its rounding lost.
        let Split { angle, rest } = Split::sum(to.lon() + T::ZERO, -from.lon());
        let (around, east) = (angle.abs(), T::ONE.copysign(angle));
        let over = around > T::of(180.0);
        let turn = T::ONE - either(over, T::of(2.0));
        // Next to 360° the rest is all there is.
        let Split { angle: lon, rest } = Split::sum(either(over, T::of(360.0)) + turn * around, rest * east * turn);
        let east = east * turn;
        let swap = from.lat().abs() < to.lat().abs();
        let lat1 = choose(swap, to.lat(), from.lat());
        let lat2 = choose(swap, from.lat(), to.lat());
        let (beta1, inverse1) = self.parametric(lat1);
        let (beta2, inverse2) = self.parametric(lat2);
        Pair {
            lat1,
            lat2,
            beta1,
            beta2,
            scale: self.axes * inverse1 * inverse2,
            lon,
            half: sin_cos_quarter(lon * T::of(0.5)),
            rest: rest * T::of(PI / 180.0),
            east,
            swap,
        }
    }

    /// The line between places that are not nearly antipodal, or between such as are.
    #[cfg_attr(not(small), inline(always))]
    fn line<const FAR: bool>(&self, pair: &Pair<T>) -> Answer<Inverse<T>> {
        let side = side::<T, FAR>();
        let ends = pair.ends::<FAR>();
        // ω is what `half` stands for and so much more; near the antipode, where every digit of it counts, all of it.
        let (rest, mut grown) = if FAR {
            let lon = (T::of(180.0) - pair.lon) * T::of(PI / 180.0) - pair.rest;
            (lon, self.flat_triangle(&ends, lon))
        } else {
            (pair.rest, T::ZERO)
        };
        let mut arc = ends.arc(if FAR { ends.half(grown) } else { pair.half });
        let mut sigma = arc.rough_sigma::<FAR>();
        // Near the antipode until it settles: the next error, as a part of sin σ, is less than the square of the last step.
        let steps = if FAR { 8 } else { T::terms(2, 1) };
        for _ in 0..steps {
            let (shift, slope) = self.rough_shift(&arc, sigma);
            let step = ((rest - grown) + side * shift) / slope;
            let turn = side * step;
            sigma += turn * (arc.sin_alpha + T::of(0.5) * arc.bend * turn);
            grown += step;
            arc = ends.arc(ends.half(grown));
            if FAR && step.abs() <= arc.sin_sigma * T::pick(5e-5, 2e-3) {
                break;
            }
        }
        let factor = series(arc.square, &self.epsilon, T::terms(7, 3));
        let epsilon = arc.square * factor;
        let waves = waves(epsilon, factor * arc.middle, (arc.sin_sigma, arc.cos_sigma));
        let (a3, bend) = self.i3(epsilon, waves);
        // For the slope σ is known well enough.
        let slope = T::ONE / self.slope(&arc, a3 * sigma + bend, sigma);
        let (eighths, small) = octant(arc.sin_sigma, arc.cos_sigma);
        // π/4 in two parts, the first so short that four times it is exact.
        let high = eighths * T::pick(core::f64::consts::FRAC_PI_4, 1_647_099.0 / 2_097_152.0);
        let low = eighths * T::pick(3.061_616_997_868_383e-17, 1.569_582_4e-7) + small;
        let sigma = high + low;
        let rate = side * (self.f * arc.sin_alpha);
        let excess = ((rest - grown) + rate * bend) + rate * a3 * sigma;
        let step = excess * slope;

        // The azimuths of this triangle, and what the step turns them by.
        let turn = side * step * arc.inverse_square;
        let (course1, course2) = (arc.course1, arc.course2);
        let turns = (turn * (ends.beta2.1 * course2.1), turn * (ends.beta1.1 * course1.1));
        let back = T::ONE - either(pair.swap, T::of(2.0));
        let azimuth = |(sin, cos): (T, T), turn: T| {
            let (eighths, small) = octant(sin.abs(), cos);
            let small = small + turn;
            let (eighths, small) = (either(pair.swap, T::of(4.0)) + back * eighths, back * small);
            (eighths * T::of(45.0) + small * T::of(180.0 / PI)).copysign(sin * pair.east + T::ZERO)
        };
        let (alpha1, alpha2) = (azimuth(course1, turns.0), azimuth(course2, turns.1));

        let b1 = c1(epsilon, waves);
        let more = b1 + a1_less_1(epsilon) * (sigma + b1) + side * (arc.sin_alpha * excess / self.axes);
        let inverse = Inverse {
            distance: self.b * (high + (low + more)),
            azimuth1: choose(pair.swap, alpha2, alpha1),
            azimuth2: choose(pair.swap, alpha1, alpha2),
        };
        // Also false for NaN, which coincident places give; and the excess is asked itself, lest a slope that is nonsense hide it.
        let limit = arc.sin_sigma * T::pick(1e-8, 5e-5);
        let settled = (step.abs() <= limit) & (FAR | (excess.abs() <= T::of(100.0) * limit));
        let within = !FAR | (pair.lon >= T::of(90.0));
        (inverse, settled & within & (arc.sin_sigma > T::pick(1e-100, 1e-15)))
    }

    /// ω near the antipode but for a hundredth, from λ = ω + π f sin α₀ with the triangle taken as flat.
    #[inline(always)]
    fn flat_triangle<const FAR: bool>(&self, ends: &Ends<T, FAR>, lon: T) -> T {
        let (_, cos1) = ends.beta1;
        let (_, cos2) = ends.beta2;
        let reach = T::of(PI) * self.f * cos1;
        let north = ends.rise.abs() / cos2;
        let square = north * north;
        let mut x = max(lon - reach, lon * north / (reach + north));
        for _ in 0..2 {
            // Halley's steps; the larger of two lower bounds comes first.
            let q = x * x + square;
            let reciprocal = T::ONE / q;
            let pull = reach * (q.sqrt() * reciprocal);
            let excess = (x - lon) + x * pull;
            let narrow = pull * (square * reciprocal);
            let slope = T::ONE + narrow;
            x += -excess * slope / (slope * slope + excess * (narrow * (T::of(1.5) * x * reciprocal)));
        }
        x
    }

    /// The direct problem; not found after very many circuits.
    #[inline(always)]
    pub fn direct(&self, from: LatLon<T>, azimuth: T, distance: T) -> Answer<Direct<T>> {
        let (sin_azimuth, cos_azimuth) = sin_cos_degrees(azimuth);
        let ((sin1, cos1), _) = self.parametric(from.lat());
        let cos1 = off_pole(cos1);
        let sin_alpha = sin_azimuth * cos1;
        let across = sin_azimuth * sin1;
        let square = cos_azimuth * cos_azimuth + across * across;
        let factor = series(square, &self.epsilon, T::terms(7, 3));
        let epsilon = factor * square;
        let epsilon2 = epsilon * epsilon;
        // cos α₀ times sine and cosine of an arc from the node; of its double, times ε.
        let along = cos1 * cos_azimuth;
        let doubled = |(sin, cos): (T, T)| (factor * (cos + cos) * sin, factor * ((cos - sin) * (cos + sin)));
        let twice = doubled((sin1, along));

        let spherical = distance / self.b;
        let tau = spherical + spherical * inverse_a1_less_1(epsilon);
        let (sin_tau, cos_tau) = sin_cos(tau);
        let wave1 = c1_sines(epsilon2, twice);
        let (tau1_sin, tau1_cos) = grow((sin1, along), wave1);
        let tau2 = (
            tau1_sin * cos_tau + tau1_cos * sin_tau,
            tau1_cos * cos_tau - tau1_sin * sin_tau,
        );
        let more = wave1 + c1_reverted_sines(epsilon2, doubled(tau2));
        let sigma = tau + more;
        let (sin, cos) = grow((sin_tau, cos_tau), more);

        let east = sin_azimuth * sin;
        let outward = cos1 * cos - sin1 * sin * cos_azimuth;
        let up = sin1 * cos + along * sin;
        let north = along * cos - sin1 * sin;
        let waves = waves(epsilon, twice.1 * cos - twice.0 * sin, (sin, cos));
        let (a3, bend) = self.i3(epsilon, waves);
        let shift = self.f * (sin_alpha * (a3 * sigma + bend));
        let lon = angle_degrees(east, outward) - shift * T::of(180.0 / PI);
        let lat = angle_degrees(up, self.axes * (east * east + outward * outward).sqrt());
        // Next to a pole rounding turns the meridian; the azimuth counts from the one that the longitude names, at the pole itself from
        // the first one.
        let (eastward, inward) = (sin_azimuth * cos, cos1 * sin + sin1 * cos * cos_azimuth);
        let outward = either((east == T::ZERO) & (outward == T::ZERO), T::ONE) + outward;
        let polar = up * up > T::of(0.75);
        let course = select(polar, (outward * eastward + east * inward) * up.abs(), sin_alpha);
        let ahead = select(polar, (outward * inward - east * eastward) * T::ONE.copysign(up), north);
        let there = Direct {
            position: LatLon::within(lat, wrapped(from.lon() + wrapped(lon))),
            azimuth: angle_degrees(course, ahead),
        };
        let few = (azimuth.abs() <= T::of(360.0)) & (tau.abs() <= T::pick(1000.0, 60.0));
        (there, few & self.holds())
    }

    /// f sin α₀ I₃ but for 1e-9, and the derivative of ω less it.
    #[cfg_attr(not(small), inline(always))]
    fn rough_shift(&self, arc: &Arc<T>, sigma: T) -> (T, T) {
        let factor = series(arc.square, &self.epsilon, T::terms(3, 2));
        let epsilon = factor * arc.square;
        let wave = factor * arc.middle * arc.sin_sigma;
        let integral = sigma * series(epsilon, &self.a3, 3) + wave * series(epsilon, &self.c3, 2);
        let slope = T::ONE - self.f * (arc.bend * integral + arc.sin_alpha * arc.sin_alpha);
        (self.f * (arc.sin_alpha * integral), slope)
    }

    /// A₃, and I₃ less A₃σ between the ends.
    #[cfg_attr(not(small), inline(always))]
    fn i3(&self, epsilon: T, [w1, w2, w3, w4, _]: [T; 5]) -> (T, T) {
        let [c11, c12, c13, c14, c22, c23, c24, c33, c34, c44] = self.c3;
        let sum = if T::terms(4, 2) == 4 {
            ((c44 * w4 + (c33 + epsilon * c34) * w3) + (c22 + epsilon * (c23 + epsilon * c24)) * w2)
                + (c11 + epsilon * (c12 + epsilon * (c13 + epsilon * c14))) * w1
        } else {
            (c11 + epsilon * c12) * w1
        };
        (series(epsilon, &self.a3, T::terms(5, 3)), sum)
    }

    /// The derivative of ω − f sin α₀ I₃ by ω, but for f ε².
    #[cfg_attr(not(small), inline(always))]
    fn slope(&self, arc: &Arc<T>, integral: T, sigma: T) -> T {
        let half = T::of(0.5);
        let [g, ..] = self.epsilon;
        let wave = arc.middle * arc.cos_sigma
            - arc.sin_sigma * ((arc.bend + arc.bend) * arc.cos_sigma + arc.square * arc.sin_sigma);
        let rate = T::ONE + g * (half * (wave - arc.square) + sigma * arc.bend);
        T::ONE - self.f * (arc.bend * integral + arc.sin_alpha * arc.sin_alpha * rate)
    }
}

/// The angle of the point (x, y) from the x axis, in degrees.
#[inline(always)]
fn angle_degrees<T: Real>(y: T, x: T) -> T {
    let (eighths, rest) = octant(y.abs(), x);
    (eighths * T::of(45.0) + rest * T::of(180.0 / PI)).copysign(y)
}

/// −1 near the antipode.
#[inline(always)]
fn side<T: Real, const FAR: bool>() -> T {
    if FAR { -T::ONE } else { T::ONE }
}

impl<T: Real> Pair<T> {
    /// Whether the places are so nearly antipodal, 170° apart or more, that ω turns the line faster than λ tells it.
    #[inline(always)]
    fn nearly_antipodal(&self) -> bool {
        let (sin_half, _) = self.half;
        let cos_lambda = T::ONE - (sin_half + sin_half) * sin_half;
        let ((sin1, cos1), (sin2, cos2)) = (self.beta1, self.beta2);
        sin1 * sin2 + cos1 * cos2 * cos_lambda < T::of(-0.985)
    }

    #[cfg_attr(not(small), inline(always))]
    fn ends<const FAR: bool>(&self) -> Ends<T, FAR> {
        let ((sin1, cos1), (sin2, cos2)) = (self.beta1, self.beta2);
        let side = side::<T, FAR>();
        let apart = self.lat2 - side * self.lat1;
        Ends {
            beta1: (side * sin1, cos1),
            beta2: (sin2, cos2),
            rise: choose(
                apart.abs() <= T::of(45.0),
                sin_cos_eighth(apart * T::of(PI / 180.0)).0 * self.scale,
                sin2 * cos1 - cos2 * (side * sin1),
            ),
            half: self.half,
        }
    }
}

impl<T: Real, const FAR: bool> Ends<T, FAR> {
    /// Sine and cosine of half of ω, from how much longer it is than λ; near the antipode from itself, to a quarter of the circle.
    #[inline(always)]
    fn half(&self, grown: T) -> (T, T) {
        let by = grown * T::of(0.5);
        if FAR { sin_cos_eighth(by) } else { grow(self.half, by) }
    }

    /// The great circle for an ω, given by sine and cosine of its half.
    #[cfg_attr(not(small), inline(always))]
    fn arc(&self, (sin_half, cos_half): (T, T)) -> Arc<T> {
        let ((sin1, cos1), (sin2, cos2)) = (self.beta1, self.beta2);
        let side = side::<T, FAR>();
        let twice = sin_half + sin_half;
        let sin_omega = twice * cos_half;
        let versine = twice * sin_half;
        let sines = side * (sin1 * sin2);
        let level = side * (cos1 * cos2 * (T::ONE - versine));
        let course1 = (cos2 * sin_omega, self.rise + sin1 * cos2 * versine);
        let course2 = (cos1 * sin_omega, side * (self.rise - sin2 * cos1 * versine));
        let square = course1.0 * course1.0 + course1.1 * course1.1;
        let (sin_sigma, inverse_square) = (square.sqrt(), T::ONE / square);
        let inverse = sin_sigma * inverse_square;
        let cos_sigma = sines + level;
        let sin_alpha = cos1 * course1.0 * inverse;
        let square = T::ONE - sin_alpha * sin_alpha;
        Arc {
            course1,
            course2,
            inverse_square,
            sin_sigma,
            cos_sigma,
            sin_alpha,
            square,
            bend: (level - sin_alpha * sin_alpha * cos_sigma) * inverse,
            middle: square * cos_sigma - (sines + sines),
        }
    }
}

impl<T: Real> Arc<T> {
    /// σ but for 2e-7.
    #[inline(always)]
    fn rough_sigma<const FAR: bool>(&self) -> T {
        let of = T::of;
        if FAR {
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
        let curve = halves(z, T::terms(8, 6), |i| T::coefficient(&ROUGH_ATAN, i));
        let angle = (t + t) * curve;
        let back = self.cos_sigma < T::ZERO;
        either(back, of(PI)) + (T::ONE - either(back, of(2.0))) * angle
    }
}

/// ε^l cos lμ sin lσ, l = 1, 2, …, from ε cos μ.
#[cfg_attr(not(small), inline(always))]
fn waves<T: Real>(epsilon: T, middle: T, (sin, cos): (T, T)) -> [T; 5] {
    let square = epsilon * epsilon;
    let (twice, twice_middle) = (cos + cos, middle + middle);
    let (s2, m2) = (twice * sin, twice_middle * middle - square);
    let (s3, m3) = (twice * s2 - sin, twice_middle * m2 - square * middle);
    let (s4, m4) = (twice * s3 - s2, twice_middle * m3 - square * m2);
    let (s5, m5) = (twice * s4 - s3, twice_middle * m4 - square * m3);
    [middle * sin, m2 * s2, m3 * s3, m4 * s4, m5 * s5]
}

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

/// (A₁ − 1)/ε by powers of ε.
const A1: Polynomial<6, 6> = Polynomial::rounded([1.0, 1.25, 1.25, 81.0 / 64.0, 81.0 / 64.0, 325.0 / 256.0]);

/// 1/A₁ − 1.
#[inline(always)]
fn inverse_a1_less_1<T: Real>(epsilon: T) -> T {
    epsilon * series(epsilon, &T::all(&INVERSE_A1), T::terms(6, 3))
}

/// A₁ − 1 = (1 + ε²/4 + ε⁴/64 + ε⁶/256)/(1 − ε) − 1.
#[cfg_attr(not(small), inline(always))]
fn a1_less_1<T: Real>(epsilon: T) -> T {
    epsilon * series(epsilon, &T::all(&A1), T::terms(6, 3))
}

/// Sine and cosine of an angle, given so, and a small one in radians, below 0.02.
#[inline(always)]
fn grow<T: Real>((sin, cos): (T, T), by: T) -> (T, T) {
    let of = T::of;
    let square = by * by;
    let (small_sin, small_versine) = if T::terms(3, 2) == 3 {
        (
            by - by * square * (of(1.0 / 6.0) - of(1.0 / 120.0) * square),
            square * (of(0.5) - square * (of(1.0 / 24.0) - of(1.0 / 720.0) * square)),
        )
    } else {
        (by - by * square * of(1.0 / 6.0), square * of(0.5))
    };
    (
        sin + (cos * small_sin - sin * small_versine),
        cos - (sin * small_sin + cos * small_versine),
    )
}
