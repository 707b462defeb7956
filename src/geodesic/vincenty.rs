//! Symbols as in the paper: λ longitude on the auxiliary sphere, L on the ellipsoid, α the azimuth at the
//! equator (elsewhere α₀), σ the arc, σₘ its middle counted from the equator.
//!
//! The paper divides by cos²α for cos 2σₘ: 0/0 along the equator. Wherever cos 2σₘ stands, a factor cos²α is
//! next to it, so their product is formed instead, without a division.

use core::f64::consts::{FRAC_PI_4, PI};

use super::angle::{Angle, heading, northward_between_poles};
use super::fast::{Pair, Trial, arrival, start};
use super::profile::profile;
use super::{Direct, Geodesic, GeodesicError, Inverse};
use crate::latitude::UnsupportedFlattening;
use crate::math::{choose, min, octant, repeat, sin_cos, sin_cos_degrees};
use crate::{Ellipsoid, LatLon, Real};

/// The flattening up to which errors are below 0.1 mm. They grow with its fourth power.
const FLATTEST: f64 = 1.0 / 293.0;

/// Evaluations of the longitude at most.
const STEPS: usize = 100;

/// Evaluations of the longitude in a batch, enough for 98 (`f32`: 99.5) of 100 pairs.
#[inline(always)]
fn fixed<T: Real>() -> usize {
    T::terms(6, 4)
}

profile! {
    name: "vincenty",
    title: "Vincenty",
    surface: Ellipsoid,
    flattenings: [0.0, 1.0 / 293.0],
    model: "geodesic of the ellipsoid: his iteration of 1975",
    good_to: "0.1 mm where it answers: not next to the antipode; the Earth’s ellipsoids (f ≤ 1/293)",
    instructions: 1500,
    errors: {
        latitudes 0 to 90, f32 adds [7e-7 s] [7e-7 s] [5e-7 s + 2.0] {
            10000 km: [1e-11 s + 5e-9] [1e-11 s + 5e-9] [1e-11 s + 5e-9];
        }
        latitudes 0 to 90, f32 adds [7.0] [7.0] [7.0] {
            20000 km: [1e-4] [1e-4] [1e-4];
        }
        latitudes 0 to 90, f32 adds [7.0] [7.0] [3.5e-7 s] {
            all km: [1e-4] [1e-4] [6e-12 s];
        }
    }
}

/// Vincenty's method of 1975, as surveyors' programs have it: to reproduce their figures.
///
/// For any other purpose take [`Karney`](super::Karney): it is faster, ten thousand times as exact, and
/// always answers.
///
/// T. Vincenty, *Direct and inverse solutions of geodesics on the ellipsoid with application of nested
/// equations*, Survey Review 23 (176), 1975: the nested series in u² and C as printed, and both iterations.
/// The inverse problem repeats λ ← L + (1 − C) f sin α {…} until λ changes by less than 3·10⁻¹³ (`f32`:
/// 5·10⁻⁸) of σ. 5 (`f32`: 3) evaluations are usual, 100 are allowed. The direct problem's iteration for σ
/// always converges: after four evaluations (`f32`: two) only rounding is left.
///
/// **Near the antipode the inverse problem fails**: where each step is longer than the one before, λ never
/// settles, and the result is [`GeodesicError::NotConverged`]. On WGS 84 this happens for one pair of places
/// in 45 000, for 7 in 100 of those within 2° of the antipode, and for 73 in 100 within half a degree; for
/// none that is more than 0.8° from it. If there is a result, it is the shortest line.
///
/// Worst error of the results on an ellipsoid of the Earth's size and f ≤ 1/293, in metres:
///
#[doc = table!()]
///
/// Errors are proportional to the size. A distance below 10⁻¹⁴³ m (`f32`: 10⁻¹² m) may be 0. Between opposite
/// places the line starts to the north.
///
/// ```
/// use terrella::geodesic::{Geodesic, GeodesicError, Vincenty};
/// use terrella::{Ellipsoid, LatLon};
/// // Line (a) of the paper.
/// let bessel = Vincenty::new(Ellipsoid::<f64>::BESSEL1841)?;
/// let dms = |d: f64, m: f64, s: f64| d + m / 60.0 + s / 3600.0;
/// let from = LatLon::new(dms(55.0, 45.0, 0.0), 0.0)?;
/// let to = LatLon::new(-dms(33.0, 26.0, 0.0), dms(108.0, 13.0, 0.0))?;
/// let way = bessel.inverse(from, to)?;
/// assert!((way.distance - 14_110_526.170).abs() < 1e-3);
/// assert!((way.azimuth1 - dms(96.0, 36.0, 8.79960)).abs() < 1e-8);
/// // Nearly antipodal.
/// let (from, to) = (LatLon::new(0.0, 0.0)?, LatLon::new(0.5, 179.7)?);
/// assert_eq!(bessel.inverse(from, to), Err(GeodesicError::NotConverged(from, to)));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[doc(
    alias = "vincenty_inverse",
    alias = "vincenty_direct",
    alias = "vdist",
    alias = "vreckon"
)]
pub struct Vincenty<T> {
    b: T,
    f: T,
    axes: T,
    ep2: T,
}

/// An arc on the auxiliary sphere, as the series see it.
struct Phase<T> {
    cos2_alpha: T,
    /// cos²α cos 2σₘ.
    cos_2sigma_m: T,
    /// Of σ.
    sin: T,
    cos: T,
}

impl<T: Real> Phase<T> {
    #[inline(always)]
    fn of(trial: &Trial<T>) -> Self {
        Self {
            cos2_alpha: trial.cos2_alpha0,
            cos_2sigma_m: trial.cos_2sigma_m,
            sin: trial.sin_sigma12,
            cos: trial.cos_sigma12,
        }
    }

    /// cos⁴α (2 cos²2σₘ − 1).
    #[inline(always)]
    fn doubled(&self) -> T {
        T::of(2.0) * self.cos_2sigma_m * self.cos_2sigma_m - self.cos2_alpha * self.cos2_alpha
    }
}

impl<T: Real> Vincenty<T> {
    /// Makes the method for an ellipsoid. Those of the Earth, 1/301 ≤ f ≤ 1/293.4, are accepted.
    ///
    /// # Errors
    /// [`UnsupportedFlattening`] unless 0 ≤ f ≤ 1/293. On flatter ellipsoids errors exceed 0.1 mm; along
    /// opposite meridians of a prolate ellipsoid the iteration finds a line that is not the shortest.
    pub fn new(ellipsoid: Ellipsoid<T>) -> Result<Self, UnsupportedFlattening<T>> {
        let f = ellipsoid.f();
        // Room for the rounding of 1/293.
        if f >= T::ZERO && f <= T::of(FLATTEST + 1e-9) {
            Ok(Self {
                b: ellipsoid.b(),
                f,
                axes: T::ONE - f,
                ep2: ellipsoid.ep2(),
            })
        } else {
            Err(UnsupportedFlattening(f))
        }
    }

    /// Returns how often [`inverse`](Geodesic::inverse) evaluates the longitude between two places, a measure
    /// of the cost; `None` if it does not converge.
    #[must_use]
    pub fn evaluations(&self, from: LatLon<T>, to: LatLon<T>) -> Option<usize> {
        self.settle(from, to).map(|(_, _, evaluations)| evaluations)
    }

    /// λ − L: equations 10 and 11.
    #[inline(always)]
    fn shift(&self, sin_alpha: T, sigma: T, phase: &Phase<T>) -> T {
        let (f, of) = (self.f, T::of);
        // C/cos²α
        let c = f * of(1.0 / 16.0) * (of(4.0) + f * (of(4.0) - of(3.0) * phase.cos2_alpha));
        let integral = sigma + c * phase.sin * (phase.cos_2sigma_m + c * phase.cos * phase.doubled());
        (T::ONE - c * phase.cos2_alpha) * f * sin_alpha * integral
    }

    /// A, and B/cos²α: equations 3 and 4.
    #[inline(always)]
    fn series(&self, cos2_alpha: T) -> (T, T) {
        let of = T::of;
        let u2 = self.ep2 * cos2_alpha;
        let a = u2 * of(1.0 / 16384.0) * (of(4096.0) + u2 * (of(-768.0) + u2 * (of(320.0) - of(175.0) * u2)));
        let b = of(1.0 / 1024.0) * (of(256.0) + u2 * (of(-128.0) + u2 * (of(74.0) - of(47.0) * u2)));
        (T::ONE + a, self.ep2 * b)
    }

    /// Where the iteration begins, λ = L: what is added to, λ − L, and the great circle. Seen from the
    /// antipode, π − λ stands for both.
    #[inline(always)]
    fn begin(pair: &mut Pair<T>, antipodal: bool) -> (T, T, Trial<T>) {
        pair.see(antipodal);
        if antipodal {
            let lambda = pair.supplement();
            return (lambda, lambda, pair.grown(lambda));
        }
        (pair.rest, T::ZERO, pair.trial(pair.half_lambda12))
    }

    /// One step: the next λ by the great circle of the last, and whether that was it, but for this part of σ.
    #[inline(always)]
    fn step(&self, first: T, pair: &Pair<T>, trial: &Trial<T>, last: T) -> (T, bool) {
        let sigma = sigma(trial);
        let next = first + pair.side * self.shift(trial.sin_alpha0, sigma, &Phase::of(trial));
        (next, (next - last).abs() <= T::pick(3e-13, 5e-8) * sigma)
    }

    /// The places as they are seen, the great circle on which the iteration settles, and after how many
    /// evaluations.
    ///
    /// It is that of the shortest line: π − L = ω + f sin α ∫… with ω = π − λ has a right side that grows
    /// with ω where f ≥ 0, and has its sign. So there is one solution, not beyond λ = π; and λ is as near to
    /// it as the last step is short.
    #[inline(always)]
    fn settle(&self, from: LatLon<T>, to: LatLon<T>) -> Option<(Pair<T>, Trial<T>, usize)> {
        let mut pair = Pair::new(self.axes, from, to);
        let antipodal = pair.nearly_antipodal();
        let (first, mut lambda, mut trial) = Self::begin(&mut pair, antipodal);
        for evaluations in 1..=STEPS {
            let (next, settled) = self.step(first, &pair, &trial, lambda);
            if settled {
                return Some((pair, trial, evaluations));
            }
            lambda = next;
            trial = pair.grown(lambda);
        }
        None
    }

    /// The inverse problem's answer from its great circle.
    #[inline(always)]
    fn line(&self, pair: &Pair<T>, trial: &Trial<T>) -> Inverse<T> {
        let (a, b) = self.series(trial.cos2_alpha0);
        let alpha1 = pair.azimuth(trial.course1, T::ZERO);
        let alpha2 = pair.azimuth(trial.course2, T::ZERO);
        Inverse {
            distance: self.b * (a * (sigma(trial) - delta_sigma(b, &Phase::of(trial)))),
            azimuth1: choose(pair.swap, alpha2, alpha1),
            azimuth2: choose(pair.swap, alpha1, alpha2),
        }
    }

    /// Where a line ends, of many circuits if need be.
    #[inline(always)]
    fn end(&self, from: LatLon<T>, azimuth: (T, T), distance: T, many: bool) -> Direct<T> {
        let start = start(from, azimuth.into(), self.axes);
        let (sin1, along, cos2_alpha) = (start.beta1.sin, start.along, start.cos2_alpha0);
        let (a, b) = self.series(cos2_alpha);
        // cos²α times sine and cosine of 2σ₁.
        let (sin_twice, cos_twice) = ((along + along) * sin1, (along - sin1) * (along + sin1));
        let phase = |Angle { sin, cos }| Phase {
            cos2_alpha,
            cos_2sigma_m: cos_twice * cos - sin_twice * sin,
            sin,
            cos,
        };
        let whole = distance / (self.b * a);
        let first = Angle::from(sin_cos(if many { whole.remainder(T::of(2.0 * PI)) } else { whole }));
        let (mut arc, mut more) = (first, T::ZERO);
        // Each time the error is B or less of what it was, 1/583.
        repeat!(T::terms(4, 2), {
            more = delta_sigma(b, &phase(arc));
            arc = first.plus_small(more);
        });
        let shift = self.shift(start.sin_alpha0, whole + more, &phase(arc));
        arrival(&start, from, self.axes, arc, shift, many)
    }

    /// The direct problem after however many circuits.
    #[cold]
    #[inline(never)]
    fn far_direct(&self, from: LatLon<T>, azimuth: T, distance: T) -> Result<Direct<T>, GeodesicError<T>> {
        let azimuth = heading(azimuth, distance)?;
        // Twice as far, so that no sum overflows.
        if !((distance + distance) / self.b).is_finite() {
            return Err(GeodesicError::quotient(distance, T::of(0.5) * min(self.b, T::ONE)));
        }
        Ok(self.end(from, azimuth, distance, true))
    }
}

/// σ in radians.
#[inline(always)]
fn sigma<T: Real>(trial: &Trial<T>) -> T {
    let (eighths, rest) = octant(trial.sin_sigma12, trial.cos_sigma12);
    eighths * T::of(FRAC_PI_4) + rest
}

/// Δσ from B/cos²α: equation 6.
#[inline(always)]
fn delta_sigma<T: Real>(b: T, phase: &Phase<T>) -> T {
    let of = T::of;
    let &Phase {
        cos2_alpha: square,
        cos_2sigma_m: middle,
        sin,
        cos,
    } = phase;
    let third = middle * (of(4.0) * sin * sin - of(3.0)) * (of(4.0) * middle * middle - of(3.0) * square * square);
    b * sin * (middle + of(0.25) * b * (cos * phase.doubled() - of(1.0 / 6.0) * b * third))
}

impl<T: Real> Geodesic<T> for Vincenty<T> {
    /// # Errors
    /// [`GeodesicError::NotConverged`] between nearly antipodal places.
    #[inline]
    fn inverse(&self, from: LatLon<T>, to: LatLon<T>) -> Result<Inverse<T>, GeodesicError<T>> {
        let Some((pair, trial, _)) = self.settle(from, to) else {
            return Err(GeodesicError::NotConverged(from, to));
        };
        let mut line = self.line(&pair, &trial);
        if from.lat() == -to.lat() && pair.lambda12 == T::of(180.0) && pair.rest == T::ZERO {
            // Over either pole: the course is 0.
            (line.azimuth1, line.azimuth2) = (T::ZERO, T::of(180.0));
        }
        Ok(northward_between_poles(from, to, line))
    }

    /// # Errors
    /// [`GeodesicError::Azimuth`] or [`GeodesicError::Distance`] for a value that is infinite or NaN;
    /// [`GeodesicError::TooFar`] for a distance near the largest number, or one that an ellipsoid of metres
    /// divides beyond all numbers.
    #[inline]
    fn direct(&self, from: LatLon<T>, azimuth: T, distance: T) -> Result<Direct<T>, GeodesicError<T>> {
        let (end, found) = self.fast_direct(from, azimuth, distance);
        if found {
            return Ok(end);
        }
        self.far_direct(from, azimuth, distance)
    }

    /// Not found if the longitude has to be evaluated more than six (`f32`: four) times, nor between nearly
    /// antipodal places or poles.
    #[inline(always)]
    fn fast_inverse(&self, from: LatLon<T>, to: LatLon<T>) -> (Inverse<T>, bool) {
        let mut pair = Pair::new(self.axes, from, to);
        let antipodal = pair.nearly_antipodal();
        let (first, mut lambda, mut trial) = Self::begin(&mut pair, false);
        repeat!(fixed::<T>() - 1, {
            // Once it has settled it stays.
            let (next, settled) = self.step(first, &pair, &trial, lambda);
            lambda = choose(settled, lambda, next);
            trial = pair.grown(lambda);
        });
        let (_, settled) = self.step(first, &pair, &trial, lambda);
        let poles = (from.lat().abs() == T::of(90.0)) & (to.lat().abs() == T::of(90.0));
        (self.line(&pair, &trial), settled & !antipodal & !poles)
    }

    #[inline(always)]
    fn fast_direct(&self, from: LatLon<T>, azimuth: T, distance: T) -> (Direct<T>, bool) {
        let few = (azimuth.abs() <= T::of(360.0)) & (distance.abs() <= T::pick(300.0, 60.0) * self.b);
        (self.end(from, sin_cos_degrees(azimuth), distance, false), few)
    }
}
