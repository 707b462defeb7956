//! Symbols as in the paper: U reduced latitude, λ longitude on the auxiliary sphere, L on the ellipsoid, α
//! the azimuth at the equator, σ the arc, σₘ its middle counted from the equator.
//!
//! The paper divides by cos²α for cos 2σₘ: 0/0 along the equator. Wherever cos 2σₘ stands, a factor cos²α is
//! next to it, so their product is formed instead, without a division.

use core::f64::consts::{FRAC_PI_4, PI};

use super::degrees::{heading, northward_between_poles};
use super::ordinary::{Arc, Ends, Start, grow};
use super::{Direct, Geodesic, GeodesicError, Inverse, Straight};
use crate::latitude::UnsupportedFlattening;
use crate::math::{choose, min, octant, repeat, sin_cos, sin_cos_degrees};
use crate::{Ellipsoid, LatLon, Real};

/// The flattening up to which errors are below 0.1 mm; they grow with its fourth power.
const FLATTEST: f64 = 1.0 / 293.0;

/// Evaluations of the longitude at most.
const STEPS: usize = 100;

/// Evaluations of the longitude in a batch, enough for 98 (`f32`: 99.5) of 100 pairs.
#[inline(always)]
fn straight<T: Real>() -> usize {
    T::terms(6, 4)
}

/// Vincenty's method of 1975, as surveyors' programs have it: to reproduce their figures.
/// [`Karney`](super::Karney) is faster, ten thousand times as exact, and answers everywhere.
///
/// T. Vincenty, *Direct and inverse solutions of geodesics on the ellipsoid with application of nested
/// equations*, Survey Review 23 (176), 1975: the nested series in u² and C as printed, and both iterations.
/// The inverse repeats λ ← L + (1 − C) f sin α {…} until λ changes by less than 3·10⁻¹³ (`f32`: 5·10⁻⁸) of σ;
/// 5 (3) evaluations are usual, and 100 allowed. The direct problem's iteration for σ always converges: four
/// evaluations (two) leave rounding.
///
/// **Near the antipode the inverse fails**: where each step is longer than the one before, λ never settles,
/// and the answer is [`GeodesicError::NotConverged`]. On WGS 84 that is one pair in 45 000 of any two places,
/// 7 in 100 of those within 2° of the antipode and 73 in 100 within half a degree; no pair that is more than
/// 0.8° short of it. What is answered is the shortest line.
///
/// | worst error of what it answers, f ≤ 1/293 | `f64` | `f32` |
/// |---|---|---|
/// | distance | 0.1 mm; 1e-11 of the distance and 5 nm | 7 m; 7e-7 of the distance |
/// | azimuths × the shorter of distance and reduced length | 0.1 mm; 1e-11 of the distance and 5 nm | 7 m; 7e-7 of the distance |
/// | position of lines to 20 000 km | 0.1 mm | 7 m |
/// | position of longer lines, and their azimuth × radius of the parallel | 6e-12 of the length | 3.5e-7 |
///
/// on an ellipsoid of the Earth's size, and in proportion on others. Of two bounds in a field both hold. A
/// distance below 10⁻¹⁴³ m (10⁻¹² m) may be 0. Between opposite places the line starts to the north.
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
pub struct Vincenty<T> {
    b: T,
    f: T,
    axes: T,
    ep2: T,
}

/// A point of a line on the auxiliary sphere, as the series see it.
struct Point<T> {
    /// cos²α.
    square: T,
    /// cos²α cos 2σₘ.
    middle: T,
    sin: T,
    cos: T,
}

impl<T: Real> Point<T> {
    #[inline(always)]
    fn of(arc: &Arc<T>) -> Self {
        Self {
            square: arc.square,
            middle: arc.middle,
            sin: arc.sin_sigma,
            cos: arc.cos_sigma,
        }
    }

    /// cos⁴α (2 cos²2σₘ − 1).
    #[inline(always)]
    fn doubled(&self) -> T {
        T::of(2.0) * self.middle * self.middle - self.square * self.square
    }
}

impl<T: Real> Vincenty<T> {
    /// For an ellipsoid of geodesy: those of the Earth have 1/301 ≤ f ≤ 1/293.4.
    ///
    /// # Errors
    /// [`UnsupportedFlattening`] unless 0 ≤ f ≤ 1/293: flatter, errors exceed 0.1 mm; along opposite
    /// meridians of a prolate ellipsoid the iteration finds a line that is not the shortest.
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

    /// How often the longitude is evaluated between two places, or none if it does not converge: what they
    /// cost.
    #[must_use]
    pub fn evaluations(&self, from: LatLon<T>, to: LatLon<T>) -> Option<usize> {
        self.settle(from, to).map(|(_, _, evaluations)| evaluations)
    }

    /// λ − L: equations 10 and 11.
    #[inline(always)]
    fn shift(&self, sin_alpha: T, sigma: T, point: &Point<T>) -> T {
        let (f, of) = (self.f, T::of);
        // C/cos²α
        let c = f * of(1.0 / 16.0) * (of(4.0) + f * (of(4.0) - of(3.0) * point.square));
        let integral = sigma + c * point.sin * (point.middle + c * point.cos * point.doubled());
        (T::ONE - c * point.square) * f * sin_alpha * integral
    }

    /// A, and B/cos²α: equations 3 and 4.
    #[inline(always)]
    fn series(&self, square: T) -> (T, T) {
        let of = T::of;
        let u2 = self.ep2 * square;
        let a = u2 * of(1.0 / 16384.0) * (of(4096.0) + u2 * (of(-768.0) + u2 * (of(320.0) - of(175.0) * u2)));
        let b = of(1.0 / 1024.0) * (of(256.0) + u2 * (of(-128.0) + u2 * (of(74.0) - of(47.0) * u2)));
        (T::ONE + a, self.ep2 * b)
    }

    /// Where the iteration begins, λ = L: what is added to, ω, and its great circle. There ω is λ − L; seen
    /// from the antipode, π − λ.
    #[inline(always)]
    fn begin(ends: &mut Ends<T>, far: bool) -> (T, T, Arc<T>) {
        ends.see(far);
        if far {
            let omega = ends.supplement();
            return (omega, omega, ends.grown(omega));
        }
        (ends.rest, T::ZERO, ends.arc(ends.half))
    }

    /// One step: the next ω by the great circle of the last, and whether that was it, but for this part of σ.
    #[inline(always)]
    fn step(&self, first: T, ends: &Ends<T>, arc: &Arc<T>, last: T) -> (T, bool) {
        let sigma = sigma(arc);
        let next = first + ends.side * self.shift(arc.sin_alpha, sigma, &Point::of(arc));
        (next, (next - last).abs() <= T::pick(3e-13, 5e-8) * sigma)
    }

    /// The ends as they are seen, the great circle on which the iteration settles, and after how many
    /// evaluations.
    ///
    /// It is that of the shortest line: π − L = ω + f sin α ∫… with ω = π − λ has a right side that grows
    /// with ω where f ≥ 0, and has its sign. So there is one solution, not beyond λ = π; and λ is as near to
    /// it as the last step is short.
    #[inline(always)]
    fn settle(&self, from: LatLon<T>, to: LatLon<T>) -> Option<(Ends<T>, Arc<T>, usize)> {
        let mut ends = Ends::new(self.axes, from, to);
        let far = ends.nearly_antipodal();
        let (first, mut omega, mut arc) = Self::begin(&mut ends, far);
        for evaluations in 1..=STEPS {
            let (next, settled) = self.step(first, &ends, &arc, omega);
            if settled {
                return Some((ends, arc, evaluations));
            }
            omega = next;
            arc = ends.grown(omega);
        }
        None
    }

    /// The inverse problem's answer from its great circle.
    #[inline(always)]
    fn line(&self, ends: &Ends<T>, arc: &Arc<T>) -> Inverse<T> {
        let (a, b) = self.series(arc.square);
        let alpha1 = ends.azimuth(arc.course1, T::ZERO);
        let alpha2 = ends.azimuth(arc.course2, T::ZERO);
        Inverse {
            distance: self.b * (a * (sigma(arc) - lead(b, &Point::of(arc)))),
            azimuth1: choose(ends.swap, alpha2, alpha1),
            azimuth2: choose(ends.swap, alpha1, alpha2),
        }
    }

    /// Where a line ends, of many circuits if need be.
    #[inline(always)]
    fn end(&self, from: LatLon<T>, azimuth: (T, T), distance: T, many: bool) -> Direct<T> {
        let start = Start::new(from, azimuth, self.axes);
        let Start {
            sin1, along, square, ..
        } = start;
        let (a, b) = self.series(square);
        // cos²α times sine and cosine of 2σ₁.
        let (sin_twice, cos_twice) = ((along + along) * sin1, (along - sin1) * (along + sin1));
        let point = |(sin, cos): (T, T)| Point {
            square,
            middle: cos_twice * cos - sin_twice * sin,
            sin,
            cos,
        };
        let whole = distance / (self.b * a);
        let first = sin_cos(if many { whole.remainder(T::of(2.0 * PI)) } else { whole });
        let (mut arc, mut more) = (first, T::ZERO);
        // Each time the error is B or less of what it was, 1/583.
        repeat!(T::terms(4, 2), {
            more = lead(b, &point(arc));
            arc = grow(first, more);
        });
        let shift = self.shift(start.sin_alpha, whole + more, &point(arc));
        start.end(arc, shift, many)
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

/// σ.
#[inline(always)]
fn sigma<T: Real>(arc: &Arc<T>) -> T {
    let (eighths, rest) = octant(arc.sin_sigma, arc.cos_sigma);
    eighths * T::of(FRAC_PI_4) + rest
}

/// Δσ from B/cos²α: equation 6.
#[inline(always)]
fn lead<T: Real>(b: T, point: &Point<T>) -> T {
    let of = T::of;
    let &Point {
        square,
        middle,
        sin,
        cos,
    } = point;
    let third = middle * (of(4.0) * sin * sin - of(3.0)) * (of(4.0) * middle * middle - of(3.0) * square * square);
    b * sin * (middle + of(0.25) * b * (cos * point.doubled() - of(1.0 / 6.0) * b * third))
}

impl<T: Real> Geodesic<T> for Vincenty<T> {
    #[inline]
    fn inverse(&self, from: LatLon<T>, to: LatLon<T>) -> Result<Inverse<T>, GeodesicError<T>> {
        let Some((ends, arc, _)) = self.settle(from, to) else {
            return Err(GeodesicError::NotConverged(from, to));
        };
        let mut line = self.line(&ends, &arc);
        if from.lat() == -to.lat() && ends.lon == T::of(180.0) && ends.rest == T::ZERO {
            // Over either pole: the course is 0.
            (line.azimuth1, line.azimuth2) = (T::ZERO, T::of(180.0));
        }
        Ok(northward_between_poles(from, to, line))
    }

    #[inline]
    fn direct(&self, from: LatLon<T>, azimuth: T, distance: T) -> Result<Direct<T>, GeodesicError<T>> {
        let (there, found) = self.ordinary_direct(from, azimuth, distance);
        if found {
            return Ok(there);
        }
        self.far_direct(from, azimuth, distance)
    }
}

impl<T: Real> Straight<T> for Vincenty<T> {
    #[inline(always)]
    fn ordinary_inverse(&self, from: LatLon<T>, to: LatLon<T>) -> (Inverse<T>, bool) {
        let mut ends = Ends::new(self.axes, from, to);
        let far = ends.nearly_antipodal();
        let (first, mut omega, mut arc) = Self::begin(&mut ends, false);
        repeat!(straight::<T>() - 1, {
            // Once it has settled it stays.
            let (next, settled) = self.step(first, &ends, &arc, omega);
            omega = choose(settled, omega, next);
            arc = ends.grown(omega);
        });
        let (_, settled) = self.step(first, &ends, &arc, omega);
        let poles = (from.lat().abs() == T::of(90.0)) & (to.lat().abs() == T::of(90.0));
        (self.line(&ends, &arc), settled & !far & !poles)
    }

    #[inline(always)]
    fn ordinary_direct(&self, from: LatLon<T>, azimuth: T, distance: T) -> (Direct<T>, bool) {
        let few = (azimuth.abs() <= T::of(360.0)) & (distance.abs() <= T::pick(300.0, 60.0) * self.b);
        (self.end(from, sin_cos_degrees(azimuth), distance, false), few)
    }

    #[inline(always)]
    fn reaches(&self, distance: T) -> bool {
        distance.abs() <= T::of(50.0) * self.b
    }
}
