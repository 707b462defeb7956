//! [`LocalFrame`]: the axes east, north and up about an origin, and positions as [`Enu`], [`Ned`] and [`Aer`]
//! in them.

mod axes;
mod offset;
mod precision;

pub use axes::{Aer, Enu, InvalidEnu, Ned};
pub use offset::GeodeticOffset;
use offset::{LongOffset, long_sin_cos};

use crate::math::{either, select, sin_cos_degrees, sum};
use crate::{Direction, Ecef, Ellipsoid, Geodetic, InvalidEcef, Real};

/// A local tangent frame: the axes east, north and up about an origin.
///
/// Up is the outward normal of the ellipsoid. At a pole, north and east belong to the meridian of the
/// origin's longitude.
///
/// The frame converts positions given as [`Geodetic`] or as [`Ecef`], and back to either. Prefer [`Geodetic`]
/// if you have it: the size of the Earth costs no digits then.
///
/// ```
/// use terrella::{Ellipsoid, Geodetic, LatLon, LocalFrame};
/// let antenna = Geodetic::new(LatLon::new(52.0, 8.0)?, 110.0)?;
/// let aircraft = Geodetic::new(LatLon::new(52.1, 8.3)?, 10_000.0)?;
/// let frame = LocalFrame::new(Ellipsoid::WGS84, antenna);
/// let aer = frame.geodetic_to_aer(aircraft);
/// assert!((aer.azimuth - 61.483_777_f64).abs() < 1e-6 && (aer.elevation - 22.793_889).abs() < 1e-6);
/// assert!((aer.range - 25_417.268_385).abs() < 1e-6);
/// // the same through Earth axes
/// let ecef = Ellipsoid::WGS84.to_ecef(aircraft);
/// assert!((frame.to_aer(ecef).range - aer.range).abs() < 1e-8);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[doc(alias("ENU", "NED", "LocalCartesian", "topocentric"))]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct LocalFrame<T = f64> {
    ellipsoid: Ellipsoid<T>,
    origin: Geodetic<T>,
    ecef: Ecef<T>,
    sin: T,
    cos: T,
    /// What the rounding of `sin` and `cos` lost.
    rests: (T, T),
    sin_lon: T,
    cos_lon: T,
}

impl<T: Real> LocalFrame<T> {
    /// Creates the frame about an origin on, above or below an ellipsoid.
    #[must_use]
    pub fn new(ellipsoid: Ellipsoid<T>, origin: Geodetic<T>) -> Self {
        let [(sin, cos), rests] = long_sin_cos(origin.lat());
        let (sin_lon, cos_lon) = sin_cos_degrees(origin.lon());
        Self {
            ellipsoid,
            origin,
            ecef: ellipsoid.to_ecef(origin),
            sin,
            cos,
            rests,
            sin_lon,
            cos_lon,
        }
    }

    /// Returns the ellipsoid.
    #[must_use]
    pub const fn ellipsoid(&self) -> Ellipsoid<T> {
        self.ellipsoid
    }

    /// Returns the origin.
    #[must_use]
    pub const fn origin(&self) -> Geodetic<T> {
        self.origin
    }

    /// Returns the origin in Earth axes.
    #[must_use]
    pub const fn origin_ecef(&self) -> Ecef<T> {
        self.ecef
    }

    /// Returns the unit vector toward the east, in Earth axes.
    #[must_use]
    pub fn east(&self) -> Direction<T> {
        Direction::within(-self.sin_lon, self.cos_lon, T::ZERO)
    }

    /// Returns the unit vector toward the north, in Earth axes.
    #[must_use]
    pub fn north(&self) -> Direction<T> {
        Direction::within(-self.sin * self.cos_lon, -self.sin * self.sin_lon, self.cos)
    }

    /// Returns the unit vector upward, in Earth axes.
    #[must_use]
    pub fn up(&self) -> Direction<T> {
        Direction::within(self.cos * self.cos_lon, self.cos * self.sin_lon, self.sin)
    }

    /// Rotates a vector, such as a velocity or a line of sight, from Earth axes to this frame's. The position
    /// of the origin is not subtracted.
    ///
    /// Worst error 5·10⁻¹⁶ (`f64`), 2.5·10⁻⁷ (`f32`) of the vector's length.
    ///
    /// ```
    /// use terrella::{Aer, Direction, Ellipsoid, Geodetic, LatLon, LocalFrame};
    /// let frame = LocalFrame::new(Ellipsoid::WGS84, LatLon::new(60.0, 0.0)?.into());
    /// // where the celestial pole stands
    /// let pole = Direction::new(0.0, 0.0, 1.0)?;
    /// let aer = Aer::from(frame.vector_to_enu(pole.to_array()));
    /// assert_eq!((aer.azimuth, aer.elevation), (0.0, 60.0));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[doc(alias("ecef2enuv", "uvw2enu"))]
    #[must_use]
    #[inline(always)]
    pub fn vector_to_enu(&self, [x, y, z]: [T; 3]) -> Enu<T> {
        let out = self.cos_lon * x + self.sin_lon * y;
        Enu {
            east: self.cos_lon * y - self.sin_lon * x,
            north: self.cos * z - self.sin * out,
            up: self.cos * out + self.sin * z,
        }
    }

    /// Rotates a vector from this frame's axes to Earth axes: the inverse of
    /// [`vector_to_enu`](Self::vector_to_enu). For [`Ned`] and [`Aer`], use `into()`.
    #[doc(alias("enu2ecefv", "enu2uvw"))]
    #[must_use]
    #[inline(always)]
    pub fn vector_from_enu(&self, enu: Enu<T>) -> [T; 3] {
        let out = self.cos * enu.up - self.sin * enu.north;
        [
            self.cos_lon * out - self.sin_lon * enu.east,
            self.sin_lon * out + self.cos_lon * enu.east,
            self.sin * enu.up + self.cos * enu.north,
        ]
    }

    /// Returns a point of Earth axes relative to the origin, as east, north, up.
    ///
    /// Worst error on the Earth: that of the two positions, 7 nm (`f64`), 2 m (`f32`). If you have the
    /// position as [`Geodetic`], [`geodetic_to_enu`](Self::geodetic_to_enu) has a smaller error.
    #[doc(alias = "ecef2enu")]
    #[must_use]
    #[inline(always)]
    pub fn to_enu(&self, point: Ecef<T>) -> Enu<T> {
        self.vector_to_enu([
            point.x() - self.ecef.x(),
            point.y() - self.ecef.y(),
            point.z() - self.ecef.z(),
        ])
    }

    /// [`Self::to_enu`] as north, east, down.
    #[doc(alias = "ecef2ned")]
    #[must_use]
    #[inline]
    pub fn to_ned(&self, point: Ecef<T>) -> Ned<T> {
        self.to_enu(point).into()
    }

    /// [`Self::to_enu`] as azimuth, elevation and range.
    #[doc(alias = "ecef2aer")]
    #[must_use]
    #[inline]
    pub fn to_aer(&self, point: Ecef<T>) -> Aer<T> {
        self.to_enu(point).into()
    }

    /// Returns the point, in Earth axes, at this distance east, north and up of the origin.
    ///
    /// # Errors
    /// [`InvalidEcef`] if the point is not finite.
    #[doc(alias = "enu2ecef")]
    #[inline]
    pub fn from_enu(&self, enu: Enu<T>) -> Result<Ecef<T>, InvalidEcef<T>> {
        let [x, y, z] = self.point_of(enu);
        Ecef::new(x, y, z)
    }

    /// x, y and z.
    #[inline(always)]
    pub(crate) fn point_of(&self, enu: Enu<T>) -> [T; 3] {
        let [x, y, z] = self.vector_from_enu(enu);
        [self.ecef.x() + x, self.ecef.y() + y, self.ecef.z() + z]
    }

    /// [`Self::from_enu`] from north, east, down.
    ///
    /// # Errors
    /// [`InvalidEcef`] if the point is not finite.
    #[doc(alias = "ned2ecef")]
    #[inline]
    pub fn from_ned(&self, ned: Ned<T>) -> Result<Ecef<T>, InvalidEcef<T>> {
        self.from_enu(ned.into())
    }

    /// [`Self::from_enu`] from azimuth, elevation and range.
    ///
    /// # Errors
    /// [`InvalidEcef`] if the point is not finite.
    #[doc(alias = "aer2ecef")]
    #[inline]
    pub fn from_aer(&self, aer: Aer<T>) -> Result<Ecef<T>, InvalidEcef<T>> {
        self.from_enu(aer.into())
    }

    /// Returns a geodetic position relative to the origin, as east, north, up. It is computed from
    /// differences of angles and heights, without the cancellation of Earth axes.
    ///
    /// Worst error 6·10⁻¹⁶ (`f64`), 10⁻⁷ (`f32`) of the distance, at any distance: within 10 km, 5 pm and 0.8
    /// mm. An `f32` latitude has steps of up to 0.4 m on the Earth, which this does not count.
    ///
    /// ```
    /// use terrella::{Ellipsoid, Geodetic, LatLon, LocalFrame};
    /// let tower = Geodetic::new(LatLon::new(48.858_2_f32, 2.294_5)?, 33.0)?;
    /// let drone = Geodetic::new(tower.lat_lon(), 33.125)?;
    /// let frame = LocalFrame::new(Ellipsoid::WGS84, tower);
    /// assert_eq!(frame.geodetic_to_enu(drone).up, 0.125);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[doc(alias = "geodetic2enu")]
    #[must_use]
    #[inline]
    pub fn geodetic_to_enu(&self, position: Geodetic<T>) -> Enu<T> {
        self.geodetic_to_enu_inline(position)
    }

    #[inline(always)]
    pub(crate) fn geodetic_to_enu_inline(&self, position: Geodetic<T>) -> Enu<T> {
        let difference = |to: T, from: T| sum(to, -from);
        let (lon, lon_lost) = difference(position.lon(), self.origin.lon());
        // Exact: the two are within a factor of two of each other.
        let once_round = either(lon.abs() > T::of(180.0), T::of(360.0).copysign(lon));
        let offset = LongOffset {
            lat: difference(position.lat(), self.origin.lat()),
            // Across ±180° what was lost may be all there is.
            lon: sum(lon - once_round, lon_lost),
            height: difference(position.height(), self.origin.height()),
        };
        let height = (position.height(), T::ZERO);
        self.seen(offset, height, Some(long_sin_cos(position.lat())))
    }

    /// [`Self::geodetic_to_enu`] as north, east, down.
    #[doc(alias = "geodetic2ned")]
    #[must_use]
    #[inline]
    pub fn geodetic_to_ned(&self, position: Geodetic<T>) -> Ned<T> {
        self.geodetic_to_enu(position).into()
    }

    /// [`Self::geodetic_to_enu`] as azimuth, elevation and range.
    #[doc(alias = "geodetic2aer")]
    #[must_use]
    #[inline]
    pub fn geodetic_to_aer(&self, position: Geodetic<T>) -> Aer<T> {
        self.geodetic_to_enu(position).into()
    }
}

/// The difference of two longitudes in [−180, 180]. Across ±180, no sum as large as 360 is rounded.
#[inline(always)]
pub(crate) fn turn<T: Real>(from: T, to: T) -> T {
    let straight = to - from;
    let half_circle = T::of(180.0).copysign(straight);
    let wrapped = (to - half_circle) - (from + half_circle);
    select(straight.abs() > T::of(180.0), wrapped, straight)
}
