mod between;
mod line;

use crate::geodesic::{GeodesicError, heading, longitude_difference, turns_once};
use crate::latitude::{UnsupportedFlattening, coefficients, is_short, supported};
use crate::math::latitude::{CONFORMAL, ORDER, RECTIFYING, RECTIFYING_INVERSE};
use crate::math::rhumb::AREA;
use crate::math::{DoubleWord, Polynomial, atan2_degrees, hypot};
use crate::{Ellipsoid, LatLon, Real, Shift};

pub use line::RhumbLine;

/// Rhumb lines (loxodromes) on an ellipsoid: lines of constant azimuth.
///
/// | worst error | `f64` | `f32` |
/// |---|---|---|
/// | [`inverse`](Self::inverse): distance | 9 nm | 10 m |
/// | azimuth, times the distance | 9 nm | 7 m |
/// | area under the line, of half of the Earth's area | 5·10⁻¹⁶ | 3·10⁻⁷ |
/// | [`direct`](Self::direct): position | 5 nm | 12 m |
///
/// The errors of short lines are smaller: those of distance and azimuth are a few units in the last place,
/// because differences of latitudes are formed before any function of them is.
///
/// **Which line.** From one place to another there are many rhumb lines, with any number of turns about the
/// axis. It is the shortest one: the longitude changes by at most 180°. At a change of exactly 180° the line
/// goes to the east if λ₂ − λ₁, as they are given, is 180, to the west if it is −180.
///
/// **Poles.** A line that is not a meridian winds about a pole without end, on a finite length. The functions
/// keep to these rules:
///
/// | line | distance | azimuth | area |
/// |---|---|---|---|
/// | coincident places | 0 | 0 | 0 |
/// | to or from a pole | along the meridian | 0 or 180 | between the pole, the equator and both meridians |
/// | from pole to pole | along a meridian | 0 or 180 | 0 |
///
/// They are the limits of lines toward the pole at fixed longitudes. [`direct`](Self::direct) refuses to go
/// beyond a pole; at a pole, any longitude is right, and the start's is returned.
///
/// Karney, [The area of rhumb polygons](https://arxiv.org/abs/2303.03219), 2024: the divided differences of
/// his section 3, here in closed form for the isometric latitude (ψ₁₂ = 2 atanh(sin(χ₁₂/2)/cos χ̄)), and by
/// products of sines for the series of the rectifying and the conformal latitude.
///
/// ```
/// use terrella::route::Rhumb;
/// use terrella::{Ellipsoid, LatLon};
/// let earth = Rhumb::new(Ellipsoid::WGS84)?;
/// // New York's airport JFK to London's LHR.
/// let (jfk, lhr) = (LatLon::new(40.6_f64, -73.8)?, LatLon::new(51.6, -0.5)?);
/// let line = earth.inverse(jfk, lhr);
/// assert!((line.distance - 5_771_083.383_328).abs() < 1e-6);
/// assert!((line.azimuth - 77.768_389_710_255).abs() < 1e-12);
/// let end = earth.direct(jfk, line.azimuth, line.distance)?;
/// assert!((end.position.lon() - lhr.lon()).abs() < 1e-12);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[doc(alias = "loxodrome")]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Rhumb<T> {
    ellipsoid: Ellipsoid<T>,
    short: bool,
    /// The length of a meridian over 2π.
    radius: T,
    /// The square of the authalic radius.
    square: T,
    conformal: [T; ORDER.0],
    rectifying: [T; ORDER.0],
    from_rectifying: [T; ORDER.0],
    area: [T; ORDER.0],
}

/// A rhumb line between two places, from [`Rhumb::inverse`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct RhumbInverse<T> {
    /// The length in metres, not negative.
    pub distance: T,
    /// The azimuth in degrees clockwise from north, in [−180, 180].
    pub azimuth: T,
    /// The area in m² between the line, the equator and the meridians of its ends: positive if the line goes
    /// to the east in the north, or to the west in the south.
    ///
    /// The sum along a polygon that does not hold a pole is its area, negative if it runs counter-clockwise.
    pub area: T,
}

/// The end of a rhumb line, from [`Rhumb::direct`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct RhumbEnd<T> {
    /// The place reached.
    pub position: LatLon<T>,
    /// Its longitude in degrees, running on: the start's and how far the line turned about the axis, any
    /// number of turns.
    pub longitude: T,
    /// The area in m² under the line, as in [`RhumbInverse`].
    pub area: T,
}

/// The mean of the meridian over the mean of the axes, less 1, by powers of n²: the squares of (2k − 3)!!/(2k)!!. The
/// next term is 1e-17 for the flattest.
const MEAN: Polynomial<5, 5> =
    Polynomial::rounded([1.0 / 4.0, 1.0 / 64.0, 1.0 / 256.0, 25.0 / 16384.0, 49.0 / 65536.0]);

impl<T: Real> Rhumb<T> {
    /// Makes the rhumb lines of an ellipsoid.
    ///
    /// # Errors
    /// [`UnsupportedFlattening`] unless −1/9 ≤ f ≤ 1/10.
    pub fn new(ellipsoid: Ellipsoid<T>) -> Result<Self, UnsupportedFlattening<T>> {
        let ellipsoid = supported(ellipsoid, Shift::Rectifying)?;
        let n = ellipsoid.n();
        let square = n * n;
        let [c1, c2, c3, c4, c5] = T::all(&MEAN);
        let mean = square * (c1 + square * (c2 + square * (c3 + square * (c4 + square * c5))));
        let half = T::of(0.5) * (ellipsoid.a() + ellipsoid.b());
        Ok(Self {
            ellipsoid,
            short: is_short(ellipsoid),
            radius: half + half * mean,
            square: ellipsoid.authalic_radius_squared(),
            conformal: coefficients(ellipsoid, &CONFORMAL),
            rectifying: coefficients(ellipsoid, &RECTIFYING),
            from_rectifying: coefficients(ellipsoid, &RECTIFYING_INVERSE),
            area: coefficients(ellipsoid, &AREA),
        })
    }

    /// Returns the ellipsoid.
    #[must_use]
    pub fn ellipsoid(&self) -> Ellipsoid<T> {
        self.ellipsoid
    }

    /// Whether the first terms of the series are enough: what [`between`](Self::between) takes.
    #[inline(always)]
    pub(crate) fn is_short(&self) -> bool {
        self.short
    }

    /// Returns the distance, the azimuth and the area under the shortest rhumb line between two places.
    #[must_use]
    #[doc(alias("loxodrome", "bearing"))]
    pub fn inverse(&self, from: LatLon<T>, to: LatLon<T>) -> RhumbInverse<T> {
        if self.short {
            self.solve::<true>(from, to)
        } else {
            self.solve::<false>(from, to)
        }
    }

    /// Returns the length in metres of the shortest rhumb line between two places: that of
    /// [`inverse`](Self::inverse), bit for bit.
    #[must_use]
    pub fn distance(&self, from: LatLon<T>, to: LatLon<T>) -> T {
        let [east, north] = self.sides(from, to);
        hypot(east, north)
    }

    /// Where a line arrives that leaves a place at an azimuth in degrees, and goes a distance in metres; a
    /// negative distance goes back.
    ///
    /// # Errors
    /// [`GeodesicError::Azimuth`] and [`GeodesicError::Distance`] if a number is not finite.
    /// [`GeodesicError::TooFar`] beyond a pole, with the distance to it, and for a distance that makes no
    /// finite longitude.
    pub fn direct(&self, from: LatLon<T>, azimuth: T, distance: T) -> Result<RhumbEnd<T>, GeodesicError<T>> {
        self.along(from, heading(azimuth, distance)?, distance)
    }

    /// Makes the line from a place at an azimuth in degrees.
    ///
    /// # Errors
    /// [`GeodesicError::Azimuth`] if the azimuth is not finite.
    pub fn line(&self, from: LatLon<T>, azimuth: T) -> Result<RhumbLine<T>, GeodesicError<T>> {
        let heading = heading(azimuth, T::ZERO)?;
        Ok(RhumbLine::new(*self, from, heading))
    }

    /// Makes the line from one place to another: the one that [`inverse`](Self::inverse) finds. It ends at
    /// its [`length`](RhumbLine::length).
    #[must_use]
    pub fn line_between(&self, from: LatLon<T>, to: LatLon<T>) -> RhumbLine<T> {
        RhumbLine::between(*self, from, self.sides(from, to))
    }

    /// How far east and north a place is, in metres along the line.
    fn sides(&self, from: LatLon<T>, to: LatLon<T>) -> [T; 2] {
        if self.short {
            self.fast_sides::<true>(from, to)
        } else {
            self.fast_sides::<false>(from, to)
        }
    }

    #[inline(always)]
    fn fast_sides<const SHORT: bool>(&self, from: LatLon<T>, to: LatLon<T>) -> [T; 2] {
        let between = self.between::<SHORT>(from, to);
        let lon = radians(longitude_difference(from, to));
        [between.east(self, lon), between.north(self)]
    }

    /// [`Self::inverse`] without a branch.
    #[inline(always)]
    pub(crate) fn solve<const SHORT: bool>(&self, from: LatLon<T>, to: LatLon<T>) -> RhumbInverse<T> {
        let between = self.between::<SHORT>(from, to);
        let lon = radians(longitude_difference(from, to));
        let (east, north) = (between.east(self, lon), between.north(self));
        RhumbInverse {
            distance: hypot(east, north),
            azimuth: atan2_degrees(east, north),
            area: between.area(self, lon),
        }
    }

    /// The end of a line, by the sine and cosine of its azimuth.
    fn along(&self, from: LatLon<T>, heading: (T, T), distance: T) -> Result<RhumbEnd<T>, GeodesicError<T>> {
        if !distance.is_finite() {
            return Err(GeodesicError::Distance(distance));
        }
        let (end, reached) = if self.short {
            self.reach::<true>(from, heading, distance)
        } else {
            self.reach::<false>(from, heading, distance)
        };
        if !reached {
            return Err(GeodesicError::TooFar {
                distance,
                limit: self.limit(from, heading, distance),
            });
        }
        let position = LatLon::new(end.lat, end.lon).map_err(|_| GeodesicError::Distance(distance))?;
        Ok(RhumbEnd {
            position,
            longitude: end.lon,
            area: end.area,
        })
    }

    /// [`Self::direct`] without a branch: latitude and longitude, and whether they are those, bit for bit.
    /// Not after more than one turn.
    #[inline(always)]
    pub(crate) fn fast_direct<const SHORT: bool>(&self, from: LatLon<T>, azimuth: T, distance: T) -> ([T; 2], bool) {
        let (end, reached) = self.reach::<SHORT>(from, crate::math::sin_cos_degrees(azimuth), distance);
        let few = end.lon.abs() <= T::of(540.0);
        ([end.lat, LatLon::turned(end.lon)], turns_once(azimuth) & reached & few)
    }
}

/// An angle in radians.
#[inline(always)]
fn radians<T: Real>(degrees: DoubleWord<T>) -> T {
    degrees.value() * T::of(core::f64::consts::PI / 180.0)
}
