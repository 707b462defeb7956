//! Where a line is northernmost, and where it meets parallels and meridians.
//!
//! On the auxiliary sphere sin β = cos α₀ sin σ, tan ω = sin α₀ tan σ (Karney 2013, equations 11 and 12): a
//! latitude gives the arc σ in closed form. A longitude λ = ω + sin α₀ (…) needs Newton's method for ω.

use core::f64::consts::PI;

use super::{Line, LinePoint, Place};
use crate::geodesic::GeodesicError;
use crate::geodesic::angle::Angle;
use crate::math::{atan2_degrees, select};
use crate::{InvalidLatLon, LatLon, Real};

/// A place that a [`Line`] passes.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Passage<T> {
    /// The distance in metres from the start of the line.
    pub distance: T,
    /// The point of the line there.
    pub point: LinePoint<T>,
}

impl<T: Real> Passage<T> {
    /// The same place by another latitude and longitude.
    fn moved_to(self, lat: T, lon: T) -> Self {
        let position = LatLon::within(lat, lon);
        let point = LinePoint { position, ..self.point };
        Self { point, ..self }
    }
}

/// Questions about the way ahead: the first circuit of the line, from its start on. A place behind the start
/// by no more than 4 roundings of σ, 6 nm (`f32`: 3 m) on the Earth, counts as the start.
///
/// Worst errors on the Earth, of the place and of the distance, in metres:
///
/// | | `f64` | `f32` |
/// |---|---|---|
/// | latitude of the northernmost place | 2e-9 | 1 |
/// | its distance, times sin α₀ cos α₀ | 2e-8 | 12 |
/// | where a parallel is met, times the cosine of the azimuth | 2e-8 | 12 |
/// | where a meridian is met, times the sine of the azimuth | 2e-8 | 12 |
impl<T: Real> Line<T> {
    /// Returns the northernmost place of the line, the first one ahead of the start: there it goes due east
    /// or due west. Its latitude φ has tan φ = cot α₀ / (1 − f), where α₀ is the azimuth at the equator.
    ///
    /// A line along the equator has it at the start, and a meridian at the pole.
    ///
    /// ```
    /// use terrella::geodesic::Karney;
    /// use terrella::{Ellipsoid, LatLon};
    /// let earth = Karney::new(Ellipsoid::WGS84)?;
    /// // From London to the north-east.
    /// let line = earth.line(LatLon::new(51.5_f64, -0.1)?, 30.0)?;
    /// let top = line.northernmost();
    /// assert_eq!(format!("{:.2} {:.0}", top.point.position, top.distance / 1e3), "71.88, 65.58 3855");
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[must_use]
    #[doc(alias = "vertex", alias = "apex")]
    pub fn northernmost(&self) -> Passage<T> {
        self.vertex(T::ONE)
    }

    /// Returns the southernmost place of the line, the first one ahead of the start, as
    /// [`northernmost`](Self::northernmost) does the northernmost.
    #[must_use]
    pub fn southernmost(&self) -> Passage<T> {
        self.vertex(-T::ONE)
    }

    /// Returns where the line meets a parallel on its first circuit, in the order in which it gets there: two
    /// places, one if it only touches the parallel, or none.
    ///
    /// A line along the equator meets that at its start.
    ///
    /// # Errors
    /// [`InvalidLatLon::Latitude`] if the latitude in degrees is outside [−90, 90] or NaN.
    ///
    /// ```
    /// use terrella::geodesic::Karney;
    /// use terrella::{Ellipsoid, LatLon};
    /// let earth = Karney::new(Ellipsoid::WGS84)?;
    /// let line = earth.line(LatLon::new(51.5_f64, -0.1)?, 30.0)?;
    /// let [first, second] = line.meets_parallel(60.0)?.map(Option::unwrap);
    /// assert_eq!(first.point.position.lat(), 60.0);
    /// assert!(first.distance < line.northernmost().distance && second.distance > first.distance);
    /// assert_eq!(line.meets_parallel(72.0)?, [None, None]);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn meets_parallel(&self, lat: T) -> Result<[Option<Passage<T>>; 2], InvalidLatLon<T>> {
        let place = LatLon::new(lat, T::ZERO)?;
        let (beta, _) = self.solver.parametric(place.lat());
        let Angle { sin, cos } = self.alpha0;
        let (sin, pole) = (sin.abs(), place.lat().abs() == T::of(90.0));
        // cos α₀ cos σ, by the factors in which less is lost.
        let square = if cos > sin {
            (beta.cos - sin) * (beta.cos + sin)
        } else {
            (cos - beta.sin) * (cos + beta.sin)
        };
        let touching = square == T::ZERO || (pole && sin == T::ZERO);
        if touching {
            let along_equator = cos == T::ZERO;
            let sigma = if along_equator {
                self.sigma1
            } else {
                Angle {
                    sin: T::ONE.copysign(beta.sin),
                    cos: T::ZERO,
                }
            };
            return Ok([Some(self.pass_parallel(sigma, lat)), None]);
        }
        // Also for NaN.
        let within = square > T::ZERO;
        if !within {
            return Ok([None, None]);
        }
        let root = square.sqrt();
        let [a, b] = [root, -root].map(|cos| self.pass_parallel(Angle::of(beta.sin, cos), lat));
        let ordered = if b.distance < a.distance { [b, a] } else { [a, b] };
        Ok(ordered.map(Some))
    }

    /// Returns where the line first meets a meridian, from its start on: the half circle from pole to pole
    /// that has this longitude. A line over the poles meets its own meridian at its start, and all others at
    /// the first pole.
    ///
    /// Newton's method takes 8 steps (`f32`: 4).
    ///
    /// # Errors
    /// [`InvalidLatLon::Longitude`] if the longitude in degrees is infinite or NaN.
    ///
    /// ```
    /// use terrella::geodesic::Karney;
    /// use terrella::{Ellipsoid, LatLon};
    /// let earth = Karney::new(Ellipsoid::WGS84)?;
    /// let line = earth.line(LatLon::new(51.5_f64, -0.1)?, 30.0)?;
    /// let dateline = line.meets_meridian(180.0)?;
    /// assert_eq!(format!("{:.2}", dateline.point.position), "-51.81, 180.00");
    /// assert_eq!((dateline.distance / 1e3).round(), 20_040.0);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn meets_meridian(&self, lon: T) -> Result<Passage<T>, InvalidLatLon<T>> {
        let lon = LatLon::new(T::ZERO, lon)?.lon();
        let circle = T::of(360.0);
        let east = T::ONE.copysign(self.alpha0.sin);
        let ahead = east * (lon - self.lon1);
        let ahead = ahead + select(ahead < T::ZERO, circle, T::ZERO);
        if ahead == T::ZERO || ahead == circle {
            let start = self.pass(self.sigma1);
            return Ok(start.moved_to(start.point.position.lat(), lon));
        }
        if self.alpha0.sin == T::ZERO {
            // At a pole already, it is that.
            let polar = self.sigma1.cos.abs() <= T::EPSILON;
            let sin = if polar { self.sigma1.sin } else { self.sigma1.cos };
            let sin = T::ONE.copysign(sin);
            let pole = self.pass(Angle { sin, cos: T::ZERO });
            return Ok(pole.moved_to(T::of(90.0).copysign(sin), lon));
        }
        // On an oblate ellipsoid it may take more than a circuit of σ.
        let (arc, sigma2) = self.reach_longitude(ahead * T::of(PI / 180.0));
        let passage = self.pass_after(arc, sigma2);
        Ok(passage.moved_to(passage.point.position.lat(), lon))
    }

    /// Returns the latitude and the longitude in degrees of the point at a distance in metres from the start.
    /// The longitude runs on beyond ±180: it is that of the start plus all that the line has turned.
    ///
    /// # Errors
    /// Those of [`at`](Self::at).
    ///
    /// ```
    /// use terrella::geodesic::Karney;
    /// use terrella::{Ellipsoid, LatLon};
    /// let earth = Karney::new(Ellipsoid::WGS84)?;
    /// let line = earth.line(LatLon::new(0.0_f64, 170.0)?, 90.0)?;
    /// let [_, lon] = line.unrolled(100_000e3)?;
    /// assert_eq!(format!("{lon:.2}"), "1068.32");
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[doc(alias = "LONG_UNROLL", alias = "unwrap")]
    pub fn unrolled(&self, distance: T) -> Result<[T; 2], GeodesicError<T>> {
        Ok(self.unrolled_to(&self.place(distance)?))
    }

    /// The same of a distance known to be short enough.
    pub(crate) fn near_unrolled(&self, distance: T) -> [T; 2] {
        self.unrolled_to(&self.near_place(distance))
    }

    pub(in crate::geodesic) fn unrolled_to(&self, place: &Place<T>) -> [T; 2] {
        let arc = place.point.arc * T::of(PI / 180.0);
        let turned = self.turned(arc, place.sigma2);
        let [lat, lon] = [place.point.position.lat(), place.point.position.lon()];
        let circle = T::of(360.0);
        let circles = (self.lon1 + turned * T::of(180.0 / PI) - lon) / circle;
        [lat, lon + circle * circles.round_ties_even()]
    }

    /// λ₁₂ in radians, through all turns.
    fn turned(&self, arc: T, sigma2: Angle<T>) -> T {
        let omega12 = T::ONE.copysign(self.alpha0.sin) * (arc + (self.lead(sigma2) - self.lead(self.sigma1)));
        let integrals = &self.solver.integrals;
        omega12 + (self.a3 * arc + (integrals.sines(&self.c3, sigma2) - self.b31))
    }

    /// By how much ±ω is ahead of σ, in radians: less than a quarter of a circle.
    fn lead(&self, sigma: Angle<T>) -> T {
        let omega = Angle {
            sin: self.alpha0.sin.abs() * sigma.sin,
            cos: sigma.cos,
        };
        omega.to_radians() - sigma.to_radians()
    }

    /// σ₁₂ and σ₂ after a turn of the longitude in radians, in (0, 2π), in the direction of travel; not of a
    /// meridian.
    fn reach_longitude(&self, ahead: T) -> (T, Angle<T>) {
        let sin0 = self.alpha0.sin.abs();
        let east = T::ONE.copysign(self.alpha0.sin);
        let integrals = &self.solver.integrals;
        let lead1 = self.lead(self.sigma1);
        let omega1 = Angle {
            sin: sin0 * self.sigma1.sin,
            cos: self.sigma1.cos,
        };
        let omega1 = Angle::of(omega1.sin, omega1.cos);
        let at = |omega12: T| {
            let omega2 = omega1.plus(Angle::radians(omega12));
            let sigma2 = Angle::of(omega2.sin, sin0 * omega2.cos);
            (omega12 - (self.lead(sigma2) - lead1), sigma2, omega2)
        };
        let mut omega12 = ahead;
        for _ in 0..T::steps(8, 4) {
            let (arc, sigma2, omega2) = at(omega12);
            let beyond = east * (self.a3 * arc + (integrals.sines(&self.c3, sigma2) - self.b31));
            // dλ/dω without the derivative of the sines, which is of second order in f.
            let cos2 = omega2.cos * omega2.cos;
            let slope = T::ONE + east * self.a3 * sin0 / (sin0 * sin0 * cos2 + omega2.sin * omega2.sin);
            omega12 -= (omega12 + beyond - ahead) / slope;
        }
        let (arc, sigma2, _) = at(omega12);
        (arc, sigma2)
    }

    fn pass_parallel(&self, sigma: Angle<T>, lat: T) -> Passage<T> {
        let passage = self.pass(sigma);
        passage.moved_to(lat, passage.point.position.lon())
    }

    fn vertex(&self, side: T) -> Passage<T> {
        let Angle { sin, cos } = self.alpha0;
        if cos == T::ZERO {
            return self.pass(self.sigma1);
        }
        let passage = self.pass(Angle {
            sin: side,
            cos: T::ZERO,
        });
        let lat = atan2_degrees(side * cos, self.solver.axes * sin.abs());
        passage.moved_to(lat, passage.point.position.lon())
    }

    /// The next point ahead at σ₂, less than a circuit away.
    fn pass(&self, sigma2: Angle<T>) -> Passage<T> {
        let arc = sigma2.minus(self.sigma1).to_radians();
        // The start itself is not a circuit ahead.
        let behind = arc < -T::of(4.0) * T::EPSILON;
        let arc = if behind {
            arc + T::of(2.0 * PI)
        } else {
            select(arc < T::ZERO, T::ZERO, arc)
        };
        self.pass_after(arc, sigma2)
    }

    /// The point at σ₂ = σ₁ + σ₁₂.
    fn pass_after(&self, arc: T, sigma2: Angle<T>) -> Passage<T> {
        let integrals = &self.solver.integrals;
        let tau12 = arc + (integrals.sines(&self.c1, sigma2) - self.b11);
        let tau12 = select(tau12 < T::ZERO, T::ZERO, tau12);
        let b = self.solver.ellipsoid.b();
        let place = self.reach(tau12, true, |row, sigma| integrals.sines(row, sigma));
        Passage {
            distance: tau12 * (b + b * self.a1),
            point: place.point,
        }
    }
}
