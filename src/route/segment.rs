use super::{Densified, InvalidStep, Waypoints};
use crate::geodesic::{GeodesicError, Inverse, Karney, Line, LinePoint, Passage};
use crate::{Ellipsoid, InvalidLatLon, LatLon, Real};

/// The shortest line between two places of an ellipsoid, with its length: that of
/// [`Karney::inverse`](crate::geodesic::Geodesic::inverse).
///
/// Its points have the errors of [`Karney`]: 10 nm on the Earth, in `f32` 5.5 m. The last point is the second
/// place itself.
///
/// ```
/// use terrella::geodesic::Karney;
/// use terrella::route::Segment;
/// use terrella::{Ellipsoid, LatLon};
///
/// let earth = Karney::new(Ellipsoid::WGS84)?;
/// let (london, tokyo) = (LatLon::new(51.5_f64, -0.1)?, LatLon::new(35.7, 139.8)?);
/// let flight = Segment::new(&earth, london, tokyo);
/// let top = flight.northernmost();
/// assert_eq!(format!("{:.2}", top.point.position), "70.99, 64.19");
/// assert_eq!((top.distance / 1e3).round(), 3806.0);
/// let stops = flight.waypoints(1e6)?;
/// assert_eq!(format!("{:.6} km, {}", flight.length() / 1e3, stops.len()), "9584.874531 km, 11");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Segment<T> {
    line: Line<T>,
    way: Inverse<T>,
    from: LatLon<T>,
    to: LatLon<T>,
    ellipsoid: Ellipsoid<T>,
}

impl<T: Real> Segment<T> {
    /// Makes the segment from one place to another.
    #[must_use]
    pub fn new(karney: &Karney<T>, from: LatLon<T>, to: LatLon<T>) -> Self {
        let (line, way) = karney.line_between(from, to);
        Self {
            line,
            way,
            from,
            to,
            ellipsoid: karney.ellipsoid(),
        }
    }

    /// Returns the line that the segment is a part of, from the first place on.
    #[must_use]
    pub fn line(&self) -> &Line<T> {
        &self.line
    }

    /// Returns the length in metres.
    #[must_use]
    pub fn length(&self) -> T {
        self.way.distance
    }

    /// Returns the two places.
    #[must_use]
    pub fn ends(&self) -> [LatLon<T>; 2] {
        [self.from, self.to]
    }

    /// Its length, and the azimuths at its ends.
    pub(super) fn way(&self) -> Inverse<T> {
        self.way
    }

    pub(super) fn ellipsoid(&self) -> Ellipsoid<T> {
        self.ellipsoid
    }

    /// Returns the point where a fraction of the way is done: 0 is the first place, 1 the second; other
    /// fractions lie beyond, on the same line.
    ///
    /// # Errors
    /// [`GeodesicError::Fraction`] if the fraction is infinite or NaN; [`GeodesicError::TooFar`] if the point
    /// is farther than [`Line::at`] goes.
    ///
    /// ```
    /// use terrella::geodesic::Karney;
    /// use terrella::route::Segment;
    /// use terrella::{Ellipsoid, LatLon};
    /// let earth = Karney::new(Ellipsoid::WGS84)?;
    /// let parallel = Segment::new(&earth, LatLon::new(60.0_f64, 170.0)?, LatLon::new(60.0, -160.0)?);
    /// let third = parallel.fraction(1.0 / 3.0)?.position;
    /// assert_eq!(format!("{third:.3}"), "60.758, 179.921");
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn fraction(&self, fraction: T) -> Result<LinePoint<T>, GeodesicError<T>> {
        if !fraction.is_finite() {
            return Err(GeodesicError::Fraction(fraction));
        }
        let point = self.line.at(self.length() * fraction)?;
        Ok(if fraction == T::ONE { self.ending(point) } else { point })
    }

    /// Returns the point halfway.
    #[must_use]
    pub fn midpoint(&self) -> LinePoint<T> {
        self.point(self.length() * T::of(0.5))
    }

    /// Returns points every so many metres from the first place on, and the second place at the end.
    ///
    /// A last step that is longer than the others by no more than rounding is not divided.
    ///
    /// # Errors
    /// [`InvalidStep`] if the step is not a positive number of metres, or makes more than 16 777 216 steps.
    ///
    /// ```
    /// use terrella::geodesic::Karney;
    /// use terrella::route::Segment;
    /// use terrella::{Ellipsoid, LatLon};
    /// let earth = Karney::new(Ellipsoid::WGS84)?;
    /// let leg = Segment::new(&earth, LatLon::new(0.0_f64, 0.0)?, LatLon::new(1.0, 0.0)?);
    /// let distances: Vec<_> = leg.waypoints(40e3)?.map(|passage| passage.distance).collect();
    /// assert_eq!(distances, [0.0, 40e3, 80e3, leg.length()]);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn waypoints(&self, step: T) -> Result<Waypoints<'_, T>, InvalidStep<T>> {
        Waypoints::every(self, step)
    }

    /// Returns the ends of so many equal parts: a point more than parts.
    ///
    /// Of more than 16 777 216 parts, those are made.
    #[must_use]
    pub fn parts(&self, count: u32) -> Waypoints<'_, T> {
        Waypoints::parts(self, count)
    }

    /// Returns points between which straight lines in space, through the ground, stay within a tolerance in
    /// metres of the geodesic: the ends of equal parts.
    ///
    /// A curve whose radius of curvature is at least ρ leaves the chord of a part of length s by at most
    /// s²/(8ρ); no geodesic is more curved than the ellipsoid, where ρ is b²/a, if it is oblate. So the
    /// number of parts is the smallest that is sure, at most 0.7 % more than the smallest one on the Earth.
    ///
    /// # Errors
    /// [`InvalidStep`] if the tolerance is not a positive number of metres, or makes more than 16 777 216
    /// parts.
    ///
    /// ```
    /// use terrella::geodesic::Karney;
    /// use terrella::route::Segment;
    /// use terrella::{Ellipsoid, LatLon};
    /// let earth = Karney::new(Ellipsoid::WGS84)?;
    /// let cable = Segment::new(&earth, LatLon::new(50.0_f64, -5.0)?, LatLon::new(43.0, -70.0)?);
    /// assert_eq!(cable.chords(100.0)?.len(), 70);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn chords(&self, tolerance: T) -> Result<Waypoints<'_, T>, InvalidStep<T>> {
        let (a, b) = (self.ellipsoid.a(), self.ellipsoid.b());
        let radius = if b < a { b * b / a } else { a * a / b };
        Waypoints::within(self, tolerance, (T::of(8.0) * radius * tolerance).sqrt())
    }

    /// Returns points between which lines that are straight in latitude and longitude stay within a tolerance
    /// in metres of the geodesic, as on a map in the plate carrée: see [`Densified`].
    ///
    /// # Errors
    /// [`InvalidStep`] if the tolerance is not a positive number of metres, or the segment is more than
    /// 16 777 216 times as long.
    pub fn densified(&self, tolerance: T) -> Result<Densified<'_, T>, InvalidStep<T>> {
        Densified::new(self, tolerance)
    }

    /// Returns the northernmost place of the segment: one of the ends, or where the line goes due east or due
    /// west between them.
    #[must_use]
    #[doc(alias = "vertex")]
    pub fn northernmost(&self) -> Passage<T> {
        self.extreme(self.line.northernmost(), |a, b| a > b)
    }

    /// Returns the southernmost place of the segment.
    #[must_use]
    pub fn southernmost(&self) -> Passage<T> {
        self.extreme(self.line.southernmost(), |a, b| a < b)
    }

    /// Returns where the segment meets a parallel, in order: two places, one or none.
    ///
    /// # Errors
    /// [`InvalidLatLon::Latitude`] if the latitude in degrees is outside [−90, 90] or NaN.
    pub fn meets_parallel(&self, lat: T) -> Result<[Option<Passage<T>>; 2], InvalidLatLon<T>> {
        let [first, second] = self.line.meets_parallel(lat)?.map(|met| self.up_to_end(met));
        Ok(if first.is_some() {
            [first, second]
        } else {
            [second, None]
        })
    }

    /// Returns where the segment meets a meridian, the half circle from pole to pole that has this longitude.
    ///
    /// # Errors
    /// [`InvalidLatLon::Longitude`] if the longitude in degrees is infinite or NaN.
    pub fn meets_meridian(&self, lon: T) -> Result<Option<Passage<T>>, InvalidLatLon<T>> {
        Ok(self.up_to_end(Some(self.line.meets_meridian(lon)?)))
    }

    fn up_to_end(&self, met: Option<Passage<T>>) -> Option<Passage<T>> {
        met.filter(|met| met.distance <= self.length())
    }

    fn extreme(&self, vertex: Passage<T>, beyond: impl Fn(T, T) -> bool) -> Passage<T> {
        if vertex.distance <= self.length() {
            return vertex;
        }
        let second = beyond(self.to.lat(), self.from.lat());
        self.passage(if second { self.length() } else { T::ZERO })
    }

    /// The point at a distance from 0 to the length; the ends are the places themselves.
    pub(super) fn passage(&self, distance: T) -> Passage<T> {
        Passage {
            distance,
            point: self.point(distance),
        }
    }

    fn point(&self, distance: T) -> LinePoint<T> {
        let point = self.line.near(distance);
        if distance == self.length() {
            return self.ending(point);
        }
        if distance == T::ZERO {
            return LinePoint {
                position: self.from,
                ..point
            };
        }
        point
    }

    fn ending(&self, point: LinePoint<T>) -> LinePoint<T> {
        LinePoint {
            position: self.to,
            ..point
        }
    }
}
