use super::auxiliary::{Arc, Ends, Start, nearly_round, waves};
use super::degrees::{heading, wrapped};
use super::karney;
use super::ordinary::Ordinary;
use super::{Direct, Geodesic, GeodesicError, Inverse, Straight};
use crate::latitude::UnsupportedFlattening;
use crate::math::{max, select, sin_cos};
use crate::{Ellipsoid, LatLon, Real};

/// Vincenty's formulas (1975), with longer series and with Newton's steps for his iteration: nothing is lost near the antipode.
///
/// T. Vincenty, "Direct and inverse solutions of geodesics on the ellipsoid with application of nested equations", Survey Review 23.
/// The equations are his, the series those in Helmert's ε (k₁ in his later notes), two orders longer: C. F. F. Karney,
/// "Algorithms for geodesics", J. Geodesy 87 (2013), equations 17, 18, 24 and 25.
///
/// His iteration λ ← L + f sin α ∫… fails near the antipode, where a small change of λ turns the azimuth. Here λ follows from Newton's steps on the same
/// equation, told from the supplements of λ and L where the ends are more than 90° of longitude apart. Where the slope at the
/// solution is not positive the line is not the shortest, and refused.
///
/// | worst error, up to the antipode | `f64` | `f32` |
/// |---|---|---|
/// | distance, the Earth's ellipsoids | 2.0e-8 m | 7 m, 7e-7 of the distance |
/// | azimuths × reduced length, the Earth's | 1.5e-8 m | 6 m |
/// | position, direct, the Earth's, to 20 000 km | 2.0e-8 m | 7 m |
/// | all of them, \|f\| ≤ 1/150 | 4.0e-7 m | 7 m |
/// | all of them, \|f\| ≤ 1/60 | 4.0e-5 m | 8 m |
///
/// These hold at every latitude, but in `f32` between nearly antipodal places within 10⁻⁴ degrees of the equator, where distances are up to 30 m off. A longer line, of several circuits, adds 2e-16 (1e-7) of its length and as much of the series' error as it is longer.
///
/// On ellipsoids with |f| ≤ 1/149 places take the same straight lines of arithmetic as with [`Karney`](super::Karney), where there is one: between all but the hardest of the nearly antipodal places,
/// and for all but very many circuits. The rest, and other ellipsoids, take Newton's steps until they settle.
///
/// Three or four evaluations are usual then, and 40 allowed: next to where the shortest line turns from east to north, more than 20 are needed. An inverse is never wrong: what does not close is
/// [`GeodesicError::NotConverged`]. No pair of places is known for which that happens, in `f64` or in `f32`; 10⁷ of the hardest were tried.
///
/// Coincident places: distance 0, azimuths 0. At a pole an azimuth counts from the meridian of the given longitude. Of several
/// shortest lines one is taken.
///
/// ```
/// use terrella::geodesic::{Geodesic, Vincenty};
/// use terrella::{Ellipsoid, LatLon};
/// let earth = Vincenty::new(Ellipsoid::<f64>::wgs84())?;
/// let (from, to) = (LatLon::new(0.0, 0.0)?, LatLon::new(0.5, 179.7)?);
/// let way = earth.inverse(from, to)?;
/// assert_eq!(format!("{:.4} {:.8}", way.distance, way.azimuth1), "19944127.4208 15.55688279");
/// let there = earth.direct(from, way.azimuth1, way.distance)?.position;
/// assert!((there.lat() - to.lat()).abs() < 1e-13 && (there.lon() - to.lon()).abs() < 1e-12);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Vincenty<T> {
    ordinary: Ordinary<T>,
    a: T,
    f: T,
    axes: T,
    ep2: T,
    /// Factors of ε, ε², ε³ in A₃.
    a3: [T; 3],
    /// Factors of the powers from εᵏ on in 2C₃ₖ.
    c3: [[T; 3]; 3],
}

/// A₁, 2C₁ₖ for the distance and A₃, 2C₃ₖ for the longitude of one line.
struct Series<T> {
    a1: T,
    c1: [T; 4],
    a3: T,
    c3: [T; 3],
}

/// Evaluations of the longitude at most; the hardest pairs of places need more than 20.
const STEPS: usize = 40;

impl<T: Real> Vincenty<T> {
    /// For an ellipsoid.
    ///
    /// # Errors
    /// [`UnsupportedFlattening`] if |f| > 1/60.
    pub fn new(ellipsoid: Ellipsoid<T>) -> Result<Self, UnsupportedFlattening<T>> {
        let ellipsoid = nearly_round(ellipsoid)?;
        let of = T::of;
        let n = ellipsoid.n();
        let n2 = n * n;
        Ok(Self {
            ordinary: Ordinary::new(ellipsoid, &karney::Series::new(ellipsoid)),
            a: ellipsoid.a(),
            f: ellipsoid.f(),
            axes: T::ONE - ellipsoid.f(),
            ep2: ellipsoid.ep2(),
            a3: [
                of(-0.5) + of(0.5) * n,
                of(-0.25) - of(0.125) * n + of(0.375) * n2,
                of(-0.0625) - of(0.1875) * n - of(0.0625) * n2,
            ],
            c3: [
                [
                    of(0.5) - of(0.5) * n,
                    of(0.25) - of(0.25) * n2,
                    of(0.09375) + of(0.09375) * n - of(0.03125) * n2,
                ],
                [
                    of(0.125) - of(0.1875) * n + of(0.0625) * n2,
                    of(0.09375) - of(0.0625) * n - of(0.09375) * n2,
                    T::ZERO,
                ],
                [of(5.0 / 96.0) - of(0.09375) * n + of(5.0 / 96.0) * n2, T::ZERO, T::ZERO],
            ],
        })
    }

    #[inline(always)]
    fn series(&self, cos2_alpha: T) -> Series<T> {
        let of = T::of;
        let k2 = self.ep2 * cos2_alpha;
        let root = (T::ONE + k2).sqrt();
        let e = k2 / ((T::ONE + root) * (T::ONE + root));
        let e2 = e * e;
        let [a31, a32, a33] = self.a3;
        let [c31, c32, c33] = self.c3.map(|[first, second, third]| first + e * (second + e * third));
        Series {
            a1: (T::ONE + e2 * (of(0.25) + of(1.0 / 64.0) * e2)) / (T::ONE - e),
            c1: [
                -e * (T::ONE - of(0.375) * e2),
                -e2 * (of(0.125) - of(0.0625) * e2),
                -e * e2 * of(1.0 / 24.0),
                -e2 * e2 * of(5.0 / 256.0),
            ],
            a3: T::ONE + e * (a31 + e * (a32 + e * a33)),
            c3: [e * c31, e2 * c32, e * e2 * c33],
        }
    }

    /// How often Newton's steps, if they are taken, evaluate the longitude between two places, or none if they do not converge: what they
    /// cost near the antipode.
    #[must_use]
    pub fn evaluations(&self, from: LatLon<T>, to: LatLon<T>) -> Option<usize> {
        let (_, _, evaluations) = self.solve(&Ends::new(self.axes, from, to))?;
        Some(evaluations)
    }

    /// The arc whose longitude on the ellipsoid is that of the ends, its series, and after how many evaluations.
    #[inline]
    fn solve(&self, ends: &Ends<T>) -> Option<(Arc<T>, Series<T>, usize)> {
        let mut x = ends.lon;
        // On a prolate ellipsoid from beyond the solution, where the slope is positive; on an oblate one Newton's steps come from
        // x = 0 without ever passing it.
        if ends.far() && self.f < T::ZERO {
            x += -self.f * T::of(3.2) * ends.steepest();
        }
        // Where numbers are subnormal there is no relative error to speak of; next to the antipode x is by far smaller than what it stands for.
        let least = if ends.far() {
            T::pick(1e-30, 1e-20)
        } else {
            T::pick(1e-300, 1e-36)
        };
        for evaluations in 1..=STEPS {
            let arc = ends.arc(x);
            let series = self.series(arc.cos2_alpha);
            let integral = series.a3 * (arc.sigma + arc.waves(&series.c3, T::terms(3, 2)));
            let shift = ends.side * self.f * arc.sin_alpha * integral;
            let residual = ends.lon + shift - x;
            let slope = T::ONE - ends.side * self.f * arc.bend * integral - self.f * arc.sin_alpha * arc.sin_alpha;
            let rounding = T::of(4.0) * T::EPSILON * (ends.lon + shift.abs()) + least;
            if residual.abs() <= rounding {
                return (slope > T::ZERO).then_some((arc, series, evaluations));
            }
            let next = max(x + residual / slope, T::ZERO);
            if next == x {
                return None;
            }
            x = next;
        }
        None
    }

    #[cold]
    #[inline(never)]
    fn hard_inverse(&self, from: LatLon<T>, to: LatLon<T>) -> Result<Inverse<T>, GeodesicError<T>> {
        let ends = Ends::new(self.axes, away_from_zero(from), away_from_zero(to));
        let (arc, series, _) = self.solve(&ends).ok_or(GeodesicError::NotConverged(from, to))?;
        let (azimuth1, azimuth2) = arc.azimuths();
        Ok(Inverse {
            distance: self.a * (self.axes * series.a1 * (arc.sigma + arc.waves(&series.c1, T::terms(4, 2)))),
            azimuth1,
            azimuth2,
        })
    }

    #[cold]
    #[inline(never)]
    fn hard_direct(&self, from: LatLon<T>, azimuth: T, distance: T) -> Result<Direct<T>, GeodesicError<T>> {
        let start = Start::new(self.axes, from, heading(azimuth, distance)?);
        let series = self.series(start.cos2_alpha);
        let whole = distance / (self.a * (self.axes * series.a1));
        if !whole.is_finite() {
            return Err(GeodesicError::Distance(distance));
        }
        let circle = T::of(2.0 * core::f64::consts::PI);
        let tau = whole.remainder(circle);
        let k2 = self.ep2 * start.cos2_alpha;
        let half = T::of(0.5);
        // Newton's steps on the distance, whose derivative is known in closed form.
        let mut sigma = tau;
        for _ in 0..T::terms(3, 2) {
            let turn = sin_cos(sigma);
            let reached = sigma + waves(&series.c1, T::terms(4, 2), turn, start.cos_middle(turn));
            let rate = (T::ONE + half * k2 * (T::ONE - start.cos_end(turn))).sqrt() / series.a1;
            sigma += (tau - reached) / rate;
        }
        let turn = sin_cos(sigma);
        let waves3 = waves(&series.c3, T::terms(3, 2), turn, start.cos_middle(turn));
        let shift = self.f * start.sin_alpha * series.a3 * ((sigma + (whole - tau)) + waves3);
        let end = start.end(self.axes, turn);
        let lon = end.lon - (shift * T::of(180.0 / core::f64::consts::PI)).remainder(T::of(360.0));
        Ok(Direct {
            position: LatLon::within(end.lat, wrapped(wrapped(lon) + from.lon())),
            azimuth: end.azimuth,
        })
    }
}

/// Angles other than 0 are at least so large that their squares are normal, which moves a place by less than 10⁻⁹ m: with smaller ones
/// nothing converges.
fn away_from_zero<T: Real>(place: LatLon<T>) -> LatLon<T> {
    let least = T::pick(1e-140, 1e-15);
    let raised = |angle: T| select(angle == T::ZERO, angle, max(angle.abs(), least).copysign(angle));
    LatLon::within(raised(place.lat()), raised(place.lon()))
}

impl<T: Real> Geodesic<T> for Vincenty<T> {
    #[inline]
    fn inverse(&self, from: LatLon<T>, to: LatLon<T>) -> Result<Inverse<T>, GeodesicError<T>> {
        let inverse = self.ordinary.inverse(from, to);
        inverse.map_or_else(|| self.hard_inverse(from, to), Ok)
    }

    #[inline]
    fn direct(&self, from: LatLon<T>, azimuth: T, distance: T) -> Result<Direct<T>, GeodesicError<T>> {
        let (there, found) = self.ordinary.direct(from, azimuth, distance);
        if found {
            return Ok(there);
        }
        self.hard_direct(from, azimuth, distance)
    }
}

impl<T: Real> Straight<T> for Vincenty<T> {
    #[inline(always)]
    fn ordinary_inverse(&self, from: LatLon<T>, to: LatLon<T>) -> (Inverse<T>, bool) {
        self.ordinary.near_inverse(from, to)
    }

    #[inline(always)]
    fn ordinary_direct(&self, from: LatLon<T>, azimuth: T, distance: T) -> (Direct<T>, bool) {
        self.ordinary.direct(from, azimuth, distance)
    }

    #[inline(always)]
    fn reaches(&self, distance: T) -> bool {
        self.ordinary.reaches(distance)
    }
}
