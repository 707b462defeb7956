use super::angle::{heading, latitude_difference, longitude_step, off_pole, turns_once, wrapped};
use super::half_angle::HalfAngle;
use super::half_arc::HalfArc;
use super::profile::profile;
use super::{Direct, Geodesic, GeodesicError, Inverse};
use crate::math::{DoubleWord, atan2, atan2_degrees, grown, hypot, select, shrunk_square, sin_cos, sin_cos_degrees};
use crate::{Direction, Ellipsoid, InvalidEllipsoid, LatLon, Real};

profile! {
    name: "great-circle",
    title: "Great circle",
    surface: Sphere,
    flattenings: [f64::NEG_INFINITY, f64::INFINITY],
    model: "sphere",
    good_to: "rounding on the sphere everywhere; as the Earth 0.56 %",
    instructions: 760,
    errors: {
        latitudes 0 to 90, f32 adds [4.2e-7 s] [2.24] [6e-8 s + 3.84] {
            all km: [8e-16 s] [3.84e-9] [1e-16 s + 7.04e-9];
        }
    }
}

/// The great circle, the shortest line on a sphere. As accurate between neighbours and near the antipode as
/// anywhere else.
///
/// Delambre's analogies give both azimuths, and by their squares the angle, from the halves of the longitudes'
/// difference and of the latitudes' difference and sum: by products and by sums of squares, so that no digits
/// are lost.
///
/// Worst error on a sphere of 6400 km, in metres. It is proportional to the radius:
///
#[doc = table!()]
///
/// The azimuth at the destination times the cosine of the latitude there is within 1.5e-15 (`f32`: 8e-7) rad.
/// As a model of the Earth a sphere of any radius is up to 0.56 % wrong.
///
/// ```
/// use terrella::geodesic::{Geodesic, GreatCircle};
/// use terrella::{Ellipsoid, LatLon};
/// let sphere = GreatCircle::new(Ellipsoid::WGS84.mean_radius())?;
/// let (oslo, quito) = (LatLon::new(59.91, 10.75)?, LatLon::new(-0.18, -78.47)?);
/// let way: terrella::geodesic::Inverse<f64> = sphere.inverse(oslo, quito)?;
/// assert_eq!(format!("{:.1} {:.6}", way.distance, way.azimuth1), "9981392.5 -90.765136");
/// let there = sphere.direct(oslo, way.azimuth1, way.distance)?;
/// assert!((there.position.lat() - quito.lat()).abs() < 4e-14);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[doc(alias = "orthodrome", alias = "spherical", alias = "great circle")]
pub struct GreatCircle<T> {
    radius: T,
}

/// Where a place lies along and beside a great circle, in radians.
struct Track<T> {
    along: T,
    cross: T,
}

/// The line between two places, by Delambre's four products: sine and cosine of half the sum of the azimuths
/// times the sine of half the side, and of half their difference times its cosine.
pub(super) struct Delambre<T> {
    sum: (T, T),
    difference: (T, T),
    side: HalfArc<T>,
}

impl<T: Real> Delambre<T> {
    /// From half the longitudes' difference, and half the latitudes' difference and sum, as sines and
    /// cosines.
    #[inline(always)]
    pub fn new(lon: (T, T), difference: (T, T), sum: (T, T)) -> Self {
        let [sum, difference] = Self::products(lon, difference, sum);
        let square = |(x, y): (T, T)| grown(x) * grown(x) + grown(y) * grown(y);
        let side = HalfArc::new(square(sum), square(difference));
        Self { sum, difference, side }
    }

    #[inline(always)]
    pub fn between(from: LatLon<T>, to: LatLon<T>) -> Self {
        let lon = HalfAngle::of_difference(longitude_step(from, to));
        let lat = HalfAngle::of_difference(latitude_difference(from, to));
        let both = HalfAngle::of_sum(DoubleWord::sum(from.lat(), to.lat()));
        let [sum, difference] = Self::products(lon.sin_cos(), lat.sin_cos(), both.sin_cos());
        // Of each product one factor is grown.
        let (sin_lon, cos_lon) = lon.grown_squares();
        let ((sin_lat, _), (_, cos_lat)) = (lat.grown_squares(), lat.squares());
        let (sin_both, cos_both) = both.squares();
        let side = HalfArc::new(
            sin_lon * cos_both + shrunk_square(cos_lon) * sin_lat,
            sin_lon * sin_both + cos_lon * cos_lat,
        );
        Self { sum, difference, side }
    }

    #[inline(always)]
    fn products(
        (sin_lon, cos_lon): (T, T),
        (sin_difference, cos_difference): (T, T),
        (sin_sum, cos_sum): (T, T),
    ) -> [(T, T); 2] {
        [
            (sin_lon * cos_sum, cos_lon * sin_difference),
            (sin_lon * sin_sum, cos_lon * cos_difference),
        ]
    }

    /// The side, in radians.
    #[inline(always)]
    pub fn angle(&self) -> T {
        self.side.angle()
    }

    /// The azimuths at both ends.
    #[inline(always)]
    pub fn azimuths(&self) -> (T, T) {
        let angle = |(sin, cos): (T, T)| atan2_degrees(sin, cos);
        let (sum, difference) = (angle(self.sum), angle(self.difference));
        // Between coincident places any sum will do, between antipodes any difference: the line starts to the
        // north.
        let open = |(sin, cos): (T, T)| (sin == T::ZERO) & (cos == T::ZERO);
        let (sum, difference) = (
            select(open(self.sum), difference, sum),
            select(open(self.difference), sum, difference),
        );
        (wrapped(sum - difference), wrapped(sum + difference))
    }
}

impl<T: Real> GreatCircle<T> {
    /// Makes the method for a sphere of this radius in metres, for instance [`Ellipsoid::mean_radius`].
    ///
    /// # Errors
    /// [`InvalidEllipsoid::SemiMajorAxis`] unless 10⁻¹⁵ ≤ radius ≤ 10¹⁵.
    pub fn new(radius: T) -> Result<Self, InvalidEllipsoid<T>> {
        Ellipsoid::sphere(radius).map(|_| Self::within(radius))
    }

    /// For a radius known to be valid.
    pub(crate) const fn within(radius: T) -> Self {
        Self { radius }
    }

    /// For the sphere of an ellipsoid's mean radius, which is valid if the ellipsoid is.
    pub(crate) fn mean(ellipsoid: Ellipsoid<T>) -> Self {
        Self::within(ellipsoid.mean_radius())
    }

    /// The length of a great circle in metres.
    #[inline(always)]
    fn circle(&self) -> T {
        self.radius * T::of(2.0 * core::f64::consts::PI)
    }

    /// Returns the radius in metres.
    #[must_use]
    #[inline(always)]
    pub fn radius(&self) -> T {
        self.radius
    }

    /// Returns the distance in metres between two places, `[latitude, longitude]` in radians.
    ///
    /// The worst error is that of the distance above, for latitudes in [−π/2, π/2] and longitudes up to ±10⁴
    /// (`f32`: ±50). Beyond, the result is NaN.
    ///
    /// ```
    /// use core::f64::consts::PI;
    /// let sphere = terrella::geodesic::GreatCircle::new(1.0)?;
    /// assert_eq!(sphere.distance_radians([0.0, 0.0], [1e-12, PI]), PI - 1e-12);
    /// # Ok::<(), terrella::InvalidEllipsoid<f64>>(())
    /// ```
    #[must_use]
    pub fn distance_radians(&self, from: [T; 2], to: [T; 2]) -> T {
        let half = |x: T, y: T| {
            let DoubleWord { high, low } = DoubleWord::sum(x, y).half();
            let (sin, cos) = sin_cos(high);
            (sin + cos * low, cos - sin * low)
        };
        let ([lat1, lon1], [lat2, lon2]) = (from, to);
        Delambre::new(half(lon2, -lon1), half(lat2, -lat1), half(lat1, lat2)).angle() * self.radius
    }

    /// Returns the angle between two directions in radians, in [0, π].
    ///
    /// Worst relative error 4.0e-16 (`f32`: 2.2e-7), for angles down to 1e-12; the rounding of the
    /// directions' own lengths shows in smaller ones.
    ///
    /// ```
    /// use terrella::{Direction, geodesic::GreatCircle};
    /// let (a, b) = (Direction::new(1.0, 0.0, 0.0)?, Direction::new(-1.0, 1e-9, 0.0)?);
    /// assert_eq!(GreatCircle::angle_radians(a, b), core::f64::consts::PI - 1e-9);
    /// # Ok::<(), terrella::InvalidDirection<f64>>(())
    /// ```
    #[must_use]
    pub fn angle_radians(a: Direction<T>, b: Direction<T>) -> T {
        let ([ax, ay, az], [bx, by, bz]) = (a.to_array(), b.to_array());
        // The cross product of the difference and the sum, which are at right angles: nothing cancels.
        let (ux, uy, uz) = (ax - bx, ay - by, az - bz);
        let (vx, vy, vz) = (ax + bx, ay + by, az + bz);
        let (x, y, z) = (uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx);
        let cross = hypot(hypot(x, y), z);
        let dot = (ax * bx + ay * by) + az * bz;
        atan2(cross, dot + dot)
    }

    /// Returns the place at a fraction of the line between two places: 0 is the first place, 1 the second;
    /// other fractions lie beyond, on the same circle.
    ///
    /// The worst error is that of the destination. Between antipodes the line is that of
    /// [`Geodesic::inverse`].
    ///
    /// # Errors
    /// [`GeodesicError::Fraction`] if the fraction, or its product with the distance, is infinite or NaN.
    ///
    /// ```
    /// use terrella::{LatLon, geodesic::GreatCircle};
    /// let sphere = GreatCircle::new(6_371_000.0_f64)?;
    /// let third = sphere.intermediate(LatLon::new(0.0, 170.0)?, LatLon::new(0.0, -160.0)?, 1.0 / 3.0)?;
    /// assert!((third.lon() - 180.0).abs() < 3e-14);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn intermediate(&self, from: LatLon<T>, to: LatLon<T>, fraction: T) -> Result<LatLon<T>, GeodesicError<T>> {
        let line = Delambre::between(from, to);
        let distance = line.angle() * self.radius * fraction;
        let end = self.direct(from, line.azimuths().0, distance);
        end.map(|end| end.position)
            .map_err(|_| GeodesicError::Fraction(fraction))
    }

    /// Returns the place halfway between two places. The worst error is that of the destination.
    ///
    /// ```
    /// use terrella::{LatLon, geodesic::GreatCircle};
    /// let sphere = GreatCircle::new(6_371_000.0)?;
    /// let middle = sphere.midpoint(LatLon::new(80.0, 0.0)?, LatLon::new(80.0, 180.0)?);
    /// assert_eq!(middle.lat(), 90.0);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[must_use]
    pub fn midpoint(&self, from: LatLon<T>, to: LatLon<T>) -> LatLon<T> {
        let line = Delambre::between(from, to);
        destination(from, sin_cos_degrees(line.azimuths().0), line.angle() * T::of(0.5)).position
    }

    /// Returns the distance in metres of a place from the great circle through `start` and `end`: positive to
    /// the right of the way from start to end, negative to the left.
    ///
    /// The worst error is 2e-15 (`f32`: 1e-6) of the distance from the start to the place, or of the radius
    /// if that is less, for legs of any length. On the Earth:
    ///
    /// | from the start | `f64` | `f32` |
    /// |---|---|---|
    /// | 300 m | 6e-13 m | 0.3 mm |
    /// | 10 km | 2e-11 m | 1 cm |
    /// | 1000 km | 2 nm | 1 m |
    /// | 6371 km and more | 13 nm | 6.4 m |
    ///
    /// If start and end coincide or are antipodes, the circle is the one along [`Inverse::azimuth1`].
    ///
    /// ```
    /// use terrella::{LatLon, geodesic::GreatCircle};
    /// let sphere = GreatCircle::new(6_371_000.0_f64)?;
    /// let (start, end) = (LatLon::new(0.0, 0.0)?, LatLon::new(0.0, 90.0)?);
    /// let south = LatLon::new(-1.0, 30.0)?;
    /// assert!((sphere.cross_track(south, start, end) - 111_194.926).abs() < 1e-3);
    /// assert!((sphere.along_track(south, start, end) - 30.0 * 111_194.926_6).abs() < 1e-2);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[must_use]
    pub fn cross_track(&self, place: LatLon<T>, start: LatLon<T>, end: LatLon<T>) -> T {
        track(place, start, end).cross * self.radius
    }

    /// Returns the distance in metres from the start, along the great circle through `start` and `end`, to
    /// the point of that circle nearest to a place; negative behind the start.
    ///
    /// The worst error is that of [`cross_track`](Self::cross_track), divided by the cosine of the
    /// cross-track distance in radii.
    #[must_use]
    pub fn along_track(&self, place: LatLon<T>, start: LatLon<T>, end: LatLon<T>) -> T {
        track(place, start, end).along * self.radius
    }

    /// The azimuth in degrees at which the great circle to another place starts.
    #[inline(always)]
    pub(crate) fn course(start: LatLon<T>, end: LatLon<T>) -> T {
        Delambre::between(start, end).azimuths().0
    }

    /// Along-track and cross-track distance of a place, from the start of a great circle and its azimuth
    /// there in degrees.
    #[inline(always)]
    pub(crate) fn tracks_beside(&self, place: LatLon<T>, start: LatLon<T>, azimuth: T) -> [T; 2] {
        let Track { along, cross } = track_beside(place, start, azimuth);
        [along * self.radius, cross * self.radius]
    }
}

impl<T: Real> Geodesic<T> for GreatCircle<T> {
    /// Never fails.
    // Inlined for size: who takes the distance alone does not pay for the azimuths.
    #[cfg_attr(small, inline(always))]
    #[cfg_attr(not(small), inline)]
    fn inverse(&self, from: LatLon<T>, to: LatLon<T>) -> Result<Inverse<T>, GeodesicError<T>> {
        Ok(self.fast_inverse(from, to).0)
    }

    /// Goes round any number of times.
    ///
    /// # Errors
    /// [`GeodesicError::Azimuth`] or [`GeodesicError::Distance`] for a value that is infinite or NaN.
    #[inline]
    fn direct(&self, from: LatLon<T>, azimuth: T, distance: T) -> Result<Direct<T>, GeodesicError<T>> {
        let heading = heading(azimuth, distance)?;
        let circle = self.circle();
        let distance = if distance.abs() > circle {
            distance.remainder(circle)
        } else {
            distance
        };
        Ok(destination(from, heading, distance / self.radius))
    }

    #[inline(always)]
    fn fast_inverse(&self, from: LatLon<T>, to: LatLon<T>) -> (Inverse<T>, bool) {
        let line = Delambre::between(from, to);
        let (azimuth1, azimuth2) = line.azimuths();
        let distance = line.angle() * self.radius;
        (
            Inverse {
                distance,
                azimuth1,
                azimuth2,
            },
            true,
        )
    }

    #[inline(always)]
    fn fast_distance(&self, from: LatLon<T>, to: LatLon<T>) -> (T, bool) {
        (Delambre::between(from, to).side.0, true)
    }

    #[inline(always)]
    fn finish_distance(&self, side: T) -> T {
        HalfArc(side).angle() * self.radius
    }

    /// Not found after more than a turn.
    #[inline(always)]
    fn fast_direct(&self, from: LatLon<T>, azimuth: T, distance: T) -> (Direct<T>, bool) {
        let end = destination(from, sin_cos_degrees(azimuth), distance / self.radius);
        (end, turns_once(azimuth) & (distance.abs() <= self.circle()))
    }
}

/// The end of an arc of a great circle: latitude, longitude from the start, and azimuth, in degrees.
pub(super) struct End<T> {
    pub lat: T,
    pub lon: T,
    pub azimuth: T,
}

/// The end of an arc, from sine and cosine of the latitude, the azimuth and the arc. Its latitude is that
/// whose tangent is 1/`axes` times the tangent on the sphere.
#[cfg_attr(not(small), inline(always))]
pub(super) fn end<T: Real>((sin1, cos1): (T, T), azimuth: (T, T), (sin, cos): (T, T), axes: T) -> End<T> {
    let cos1 = off_pole(cos1);
    let (sin_azimuth, cos_azimuth) = azimuth;
    let east = sin_azimuth * sin;
    let outward = cos1 * cos - sin1 * sin * cos_azimuth;
    let up = sin1 * cos + cos1 * sin * cos_azimuth;
    let north = cos1 * cos * cos_azimuth - sin1 * sin;
    End {
        lat: atan2_degrees(up, axes * hypot(east, outward)),
        lon: atan2_degrees(east, outward),
        azimuth: atan2_degrees(cos1 * sin_azimuth, north),
    }
}

/// The end of a line of so many radians, from sine and cosine of its azimuth.
#[inline(always)]
fn destination<T: Real>(from: LatLon<T>, azimuth: (T, T), angle: T) -> Direct<T> {
    let end = end(sin_cos_degrees(from.lat()), azimuth, sin_cos(angle), T::ONE);
    Direct {
        position: LatLon::within(end.lat, wrapped(from.lon() + end.lon)),
        azimuth: end.azimuth,
    }
}

fn track<T: Real>(place: LatLon<T>, start: LatLon<T>, end: LatLon<T>) -> Track<T> {
    track_beside(place, start, GreatCircle::course(start, end))
}

/// The track of a place beside the great circle that leaves a start at an azimuth in degrees.
#[cfg_attr(not(small), inline(always))]
fn track_beside<T: Real>(place: LatLon<T>, start: LatLon<T>, azimuth: T) -> Track<T> {
    let line = Delambre::between(start, place);
    let (sin, cos) = line.side.sin_cos();
    let (toward, _) = line.azimuths();
    let (sin_turn, cos_turn) = sin_cos_degrees(toward - azimuth);
    let ahead = sin * cos_turn;
    Track {
        along: atan2(ahead, cos),
        cross: atan2(sin * sin_turn, hypot(ahead, cos)),
    }
}
