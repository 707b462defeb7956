use core::fmt;

use crate::geodesic::{Direct, Geodesic, GeodesicError, Karney, wrapped};
use crate::math::{Polynomial, max, min, sin_cos_degrees};
use crate::{LatLon, Real};

/// The direction of a turn.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Turn {
    /// Counter-clockwise: the centre is on the left.
    Left,
    /// Clockwise: the centre is on the right.
    Right,
}

/// Why an [`Arc`], its corners or a [`Corridor`](super::Corridor) was refused.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum InvalidArc<T> {
    /// The radius, or the half of a width, is not positive, longer than allowed, or NaN.
    Radius(T),
    /// The azimuth of the start is infinite or NaN.
    Azimuth(T),
    /// The sweep is not in [−360, 360].
    Sweep(T),
    /// The tolerance is not positive, so small that there would be more than a million corners, or NaN.
    Tolerance(T),
}

impl<T: fmt::Debug> fmt::Display for InvalidArc<T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Radius(radius) => write!(f, "radius {radius:?} is not positive, or too long"),
            Self::Azimuth(azimuth) => write!(f, "azimuth {azimuth:?} is not finite"),
            Self::Sweep(sweep) => write!(f, "sweep {sweep:?} is not in -360 to 360"),
            Self::Tolerance(tolerance) => write!(f, "tolerance {tolerance:?} is not positive, or too small"),
        }
    }
}

impl<T: fmt::Debug> core::error::Error for InvalidArc<T> {}

/// A leg on a circle about a centre, on the ellipsoid: all its places are at the same distance from the
/// centre, along geodesics. In ARINC 424 it is the leg RF.
///
/// Its error is that of [`Karney`]: a place of the arc is within 10 nm (`f32`: 7·10⁻⁷ of the radius and 1 m)
/// of the circle, distances to it are as exact, its length is exact to 2 nm and 10⁻¹⁵ of itself (`f32`:
/// 10⁻⁶).
///
/// The reduced length m₁₂ at the distance of the radius is how wide a radian is there (Karney 2013, section
/// 3). So the length is its integral over the azimuth, by Gauss's rule with 6 places for each 45°. All
/// geodesics from the centre meet the circle at a right angle (Gauss's lemma): what is beside the arc is at
/// the difference of the distances from the centre.
///
/// ```
/// use terrella::geodesic::Karney;
/// use terrella::route::{Arc, Turn};
/// use terrella::{Ellipsoid, LatLon};
/// let earth = Karney::new(Ellipsoid::WGS84)?;
/// let centre = LatLon::new(47.2_f64, 11.4)?;
/// // Past the centre in the north, from the west to the east.
/// let (start, end) = (LatLon::new(47.2, 11.3)?, LatLon::new(47.2, 11.5)?);
/// let leg = Arc::between(&earth, centre, 7_500.0, start, end, Turn::Right)?;
/// assert!((leg.sweep() - 180.0).abs() < 0.1 && (leg.length() - 23_561.0).abs() < 20.0);
/// let north = leg.at(leg.length() / 2.0)?;
/// assert!((north.position.lon() - 11.4).abs() < 1e-9 && (north.azimuth - 90.0).abs() < 1e-3);
/// // 500 m to the left of the leg.
/// let aircraft = earth.line(centre, 0.0)?.at(8_000.0)?.position;
/// assert!((leg.distance(aircraft) - 500.0).abs() < 1e-6 && (leg.cross_track(aircraft) + 500.0).abs() < 1e-6);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[doc(alias("RF leg", "radius to fix", "DME arc", "circle"))]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Arc<'a, T> {
    karney: &'a Karney<T>,
    centre: LatLon<T>,
    radius: T,
    /// The azimuth of the start from the centre, in degrees.
    start: T,
    /// In degrees, clockwise.
    sweep: T,
}

/// Gauss's rule of 6 places: half of them in [−1, 1], and their weights.
const PLACES: Polynomial<3, 3> =
    Polynomial::rounded([0.238_619_186_083_196_9, 0.661_209_386_466_264_5, 0.932_469_514_203_152]);
const WEIGHTS: Polynomial<3, 3> = Polynomial::rounded([
    0.467_913_934_572_691_04, 0.360_761_573_048_138_6, 0.171_324_492_379_170_36,
]);

fn radians<T: Real>(degrees: T) -> T {
    degrees * T::of(core::f64::consts::PI / 180.0)
}

/// In how many chords an arc is to be divided, so that they are within a tolerance of it; at most a million.
pub(super) fn chords<T: Real>(radius: T, sweep: T, tolerance: T) -> Result<usize, InvalidArc<T>> {
    // 1 − cos h ≤ h²/2, and one in a hundred for the ellipsoid; a third of a circle at most.
    let step = T::of(2.0) * min(T::of(1.98) * tolerance / radius, T::ONE).sqrt();
    let count = radians(sweep.abs()) / step;
    let few = tolerance > T::ZERO && tolerance.is_finite() && count <= T::of(1e6);
    if !few {
        return Err(InvalidArc::Tolerance(tolerance));
    }
    Ok(usize::try_from(count.floor()).unwrap_or(0) + 1)
}

/// The place at a distance along the geodesic at an azimuth; the start itself where there is none.
pub(super) fn reached<T: Real>(karney: &Karney<T>, from: LatLon<T>, azimuth: T, distance: T) -> Direct<T> {
    let nowhere = |_: GeodesicError<T>| Direct {
        position: from,
        azimuth,
    };
    karney.direct(from, azimuth, distance).unwrap_or_else(nowhere)
}

impl<'a, T: Real> Arc<'a, T> {
    /// Makes the arc about a centre that starts at an azimuth from the centre and goes round by a sweep:
    /// clockwise by positive degrees, counter-clockwise by negative ones.
    ///
    /// # Errors
    /// [`InvalidArc`] unless 0 < radius ≤ 1.5 b (9500 km), the azimuth is finite, and the sweep is in [−360,
    /// 360].
    pub fn new(
        karney: &'a Karney<T>,
        centre: LatLon<T>,
        radius: T,
        azimuth: T,
        sweep: T,
    ) -> Result<Self, InvalidArc<T>> {
        let longest = T::of(1.5) * karney.ellipsoid().b();
        if !(radius > T::ZERO && radius <= longest) {
            return Err(InvalidArc::Radius(radius));
        }
        if !azimuth.is_finite() {
            return Err(InvalidArc::Azimuth(azimuth));
        }
        let circle = T::of(360.0);
        let once = sweep.abs() <= circle; // false for NaN
        if !once {
            return Err(InvalidArc::Sweep(sweep));
        }
        Ok(Self {
            karney,
            centre,
            radius,
            start: wrapped(azimuth.remainder(circle)),
            sweep,
        })
    }

    /// Makes the arc about a centre from the azimuth of one place to that of another. The distances of these
    /// places from the centre do not count. Between the same azimuths the sweep is 0.
    ///
    /// # Errors
    /// [`InvalidArc::Radius`], as [`new`](Self::new).
    pub fn between(
        karney: &'a Karney<T>,
        centre: LatLon<T>,
        radius: T,
        start: LatLon<T>,
        end: LatLon<T>,
        turn: Turn,
    ) -> Result<Self, InvalidArc<T>> {
        let (from, to) = (karney.way(centre, start).azimuth1, karney.way(centre, end).azimuth1);
        let sweep = match turn {
            Turn::Right => forward(to - from),
            Turn::Left => -forward(from - to),
        };
        Self::new(karney, centre, radius, from, sweep)
    }

    /// Makes the whole circle about a centre, counter-clockwise from the north.
    ///
    /// ```
    /// use terrella::geodesic::{Area, Karney};
    /// use terrella::route::Arc;
    /// use terrella::{Ellipsoid, LatLon};
    /// let earth = Karney::new(Ellipsoid::WGS84)?;
    /// let circle = Arc::circle(&earth, LatLon::new(60.0_f64, 25.0)?, 10_000.0)?;
    /// let area = Area::new(Ellipsoid::WGS84)?;
    /// let mut polygon = area.polygon();
    /// circle.corners(5.0)?.for_each(|corner| polygon.add(corner));
    /// // Nearly pi square myriametres.
    /// assert!((polygon.area() / 1e8 - 3.1403).abs() < 1e-3);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`InvalidArc::Radius`], as [`new`](Self::new).
    pub fn circle(karney: &'a Karney<T>, centre: LatLon<T>, radius: T) -> Result<Self, InvalidArc<T>> {
        Self::new(karney, centre, radius, T::ZERO, T::of(-360.0))
    }

    /// Returns the centre.
    #[must_use]
    pub const fn centre(&self) -> LatLon<T> {
        self.centre
    }

    /// Returns the radius in metres.
    #[must_use]
    pub const fn radius(&self) -> T {
        self.radius
    }

    /// Returns the degrees that the arc goes round, positive clockwise.
    #[must_use]
    pub const fn sweep(&self) -> T {
        self.sweep
    }

    /// Returns the first place.
    #[must_use]
    pub fn start(&self) -> LatLon<T> {
        self.turned(T::ZERO).position
    }

    /// Returns the last place.
    #[must_use]
    pub fn end(&self) -> LatLon<T> {
        self.turned(self.sweep).position
    }

    /// The place so many degrees clockwise from the start, and the azimuth of travel there.
    fn turned(&self, degrees: T) -> Direct<T> {
        let from = reached(self.karney, self.centre, self.start + degrees, self.radius);
        let right = T::of(90.0).copysign(self.sweep);
        Direct {
            azimuth: wrapped(from.azimuth + right),
            ..from
        }
    }

    /// How wide a radian is on a small circle, with Gauss's curvature of the centre (K = 1/(MN)): s − Ks³/6 +
    /// K²s⁵/120. In f32 the reduced length is the difference of far longer ones.
    fn small(&self) -> Option<T> {
        let ellipsoid = self.karney.ellipsoid();
        let arc = self.radius / ellipsoid.b();
        let small = arc < T::pick(1e-4, 0.06);
        small.then(|| {
            let (sin, _) = sin_cos_degrees(self.centre.lat());
            let stretch = T::ONE - ellipsoid.e2() * sin * sin;
            let square = arc * stretch * arc * stretch;
            self.radius - self.radius * (square * (T::of(1.0 / 6.0) - square * T::of(1.0 / 120.0)))
        })
    }

    /// How wide a radian is, so many degrees clockwise from the start.
    fn width(&self, degrees: T) -> T {
        let end = self
            .karney
            .line(self.centre, self.start + degrees)
            .and_then(|line| line.at(self.radius));
        end.map_or(self.radius, |end| end.reduced_length)
    }

    /// The length of the first so many degrees, at most ±720.
    fn length_of(&self, degrees: T) -> T {
        if let Some(width) = self.small() {
            return width * radians(degrees.abs());
        }
        let parts = usize::try_from((degrees.abs() / T::of(45.0)).floor())
            .unwrap_or(0)
            .min(15)
            + 1;
        let half = degrees / (T::of(2.0) * T::whole(parts as u64));
        let mut sum = T::ZERO;
        for part in 0..parts {
            let middle = half * T::whole(2 * part as u64 + 1);
            for (place, weight) in T::all(&PLACES).into_iter().zip(T::all(&WEIGHTS)) {
                let aside = half * place;
                sum += weight * (self.width(middle - aside) + self.width(middle + aside));
            }
        }
        sum * radians(half.abs())
    }

    /// Returns the length in metres.
    #[must_use]
    pub fn length(&self) -> T {
        self.length_of(self.sweep)
    }

    /// Returns the place at a distance in metres along the arc from its start, and the azimuth of travel
    /// there. Before the start and after the end it is on the same circle.
    ///
    /// # Errors
    /// [`GeodesicError::Distance`] if the distance is infinite or NaN, [`GeodesicError::TooFar`] if it is
    /// more than once round.
    pub fn at(&self, distance: T) -> Result<Direct<T>, GeodesicError<T>> {
        let circle = T::of(360.0).copysign(self.sweep);
        let round = self.length_of(circle);
        let within = distance.abs() <= round; // false for NaN
        if !within {
            return Err(GeodesicError::refused(distance, round));
        }
        let mut degrees = circle * (distance / round);
        if self.small().is_some() {
            return Ok(self.turned(degrees));
        }
        // Newton's method: the width of a radian varies by less than a hundredth.
        for _ in 0..T::steps(3, 2) {
            let excess = self.length_of(degrees).copysign(distance) - distance;
            let step = excess / self.width(degrees) * T::of(180.0 / core::f64::consts::PI);
            degrees -= step.copysign(step * self.sweep);
        }
        Ok(self.turned(degrees))
    }

    /// Returns whether a place is abeam of the arc: whether the ray from the centre to it crosses the arc.
    #[must_use]
    pub fn abeam(&self, place: LatLon<T>) -> bool {
        self.spans(self.karney.way(self.centre, place).azimuth1)
    }

    fn spans(&self, azimuth: T) -> bool {
        let turn = (azimuth - self.start) * T::ONE.copysign(self.sweep);
        forward(turn) <= self.sweep.abs()
    }

    /// Returns the distance in metres of a place from the arc: abeam from the circle, elsewhere from the
    /// nearer end.
    #[must_use]
    pub fn distance(&self, place: LatLon<T>) -> T {
        let from = self.karney.way(self.centre, place);
        if self.spans(from.azimuth1) {
            return (from.distance - self.radius).abs();
        }
        let to = |end| self.karney.way(place, end).distance;
        min(to(self.start()), to(self.end()))
    }

    /// Returns the distance in metres of a place from the circle, positive to the right of the way round,
    /// negative to the left.
    #[must_use]
    pub fn cross_track(&self, place: LatLon<T>) -> T {
        let inward = self.radius - self.karney.way(self.centre, place).distance;
        inward * T::ONE.copysign(self.sweep)
    }

    /// Returns corners on the arc, from its start to its end, or once round a whole circle: the line through
    /// them is within a tolerance in metres of the arc, on its inner side.
    ///
    /// # Errors
    /// [`InvalidArc::Tolerance`] unless it is positive and finite, and a million corners are enough.
    pub fn corners(&self, tolerance: T) -> Result<impl Iterator<Item = LatLon<T>> + use<'a, T>, InvalidArc<T>> {
        let whole = self.sweep.abs() == T::of(360.0);
        let least = if whole { 3 } else { 1 };
        let count = chords(self.radius, self.sweep, tolerance)?.max(least);
        let step = self.sweep / T::whole(count as u64);
        let arc = *self;
        let last = if whole { count } else { count + 1 };
        Ok((0..last).map(move |corner| {
            let degrees = if corner == count {
                arc.sweep
            } else {
                step * T::whole(corner as u64)
            };
            arc.turned(degrees).position
        }))
    }
}

/// Degrees in (−540, 540) brought to [0, 360).
fn forward<T: Real>(degrees: T) -> T {
    let turned = wrapped(degrees);
    let circle = T::of(360.0);
    let positive = if turned < T::ZERO { turned + circle } else { turned };
    // What is nearly a whole turn may be rounded to one.
    if positive >= circle {
        T::ZERO
    } else {
        max(positive, T::ZERO)
    }
}
