//! [`LocalFrame`]: east, north and up about an origin, what is seen from there, and where that is.

mod axes;
mod offset;

pub use axes::{Aer, Enu, InvalidEnu, Ned};
pub use offset::GeodeticOffset;
use offset::{LongOffset, long_sin_cos};

use crate::math::{either, select, sin_cos_degrees, sum};
use crate::{Direction, Ecef, Ellipsoid, Geodetic, InvalidEcef, Real};

/// The axes east, north and up (along the ellipsoid's normal) about an origin, built once.
///
/// At a pole, east and north are those of the meridian that the origin's longitude names.
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
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct LocalFrame<T> {
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
    /// The frame about an origin.
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

    /// The ellipsoid.
    #[must_use]
    pub fn ellipsoid(&self) -> Ellipsoid<T> {
        self.ellipsoid
    }

    /// The origin.
    #[must_use]
    pub fn origin(&self) -> Geodetic<T> {
        self.origin
    }

    /// The origin in Earth axes.
    #[must_use]
    pub fn origin_ecef(&self) -> Ecef<T> {
        self.ecef
    }

    /// East in Earth axes.
    #[must_use]
    pub fn east(&self) -> Direction<T> {
        Direction::within(-self.sin_lon, self.cos_lon, T::ZERO)
    }

    /// North in Earth axes.
    #[must_use]
    pub fn north(&self) -> Direction<T> {
        Direction::within(-self.sin * self.cos_lon, -self.sin * self.sin_lon, self.cos)
    }

    /// Up in Earth axes.
    #[must_use]
    pub fn up(&self) -> Direction<T> {
        Direction::within(self.cos * self.cos_lon, self.cos * self.sin_lon, self.sin)
    }

    /// A vector of Earth axes (a velocity, a line of sight) in this frame's: turned, not moved. Worst error 5·10⁻¹⁶
    /// (`f64`), 2.5·10⁻⁷ (`f32`) of its length.
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
    #[must_use]
    #[inline]
    pub fn vector_to_enu(&self, [x, y, z]: [T; 3]) -> Enu<T> {
        let out = self.cos_lon * x + self.sin_lon * y;
        Enu {
            east: self.cos_lon * y - self.sin_lon * x,
            north: self.cos * z - self.sin * out,
            up: self.cos * out + self.sin * z,
        }
    }

    /// A vector of this frame in Earth axes: turned, not moved. [`Ned`] and [`Aer`] go through `into()`.
    #[must_use]
    #[inline]
    pub fn vector_from_enu(&self, enu: Enu<T>) -> [T; 3] {
        let out = self.cos * enu.up - self.sin * enu.north;
        [
            self.cos_lon * out - self.sin_lon * enu.east,
            self.sin_lon * out + self.cos_lon * enu.east,
            self.sin * enu.up + self.cos * enu.north,
        ]
    }

    /// A point in Earth axes, seen from the origin.
    ///
    /// Worst error on the Earth: that of the two positions, 7 nm (`f64`), 2 m (`f32`). A position that is at hand as
    /// [`Geodetic`] is better seen with [`Self::geodetic_to_enu`].
    #[must_use]
    #[inline]
    pub fn to_enu(&self, point: Ecef<T>) -> Enu<T> {
        self.vector_to_enu([
            point.x() - self.ecef.x(),
            point.y() - self.ecef.y(),
            point.z() - self.ecef.z(),
        ])
    }

    /// [`Self::to_enu`] as north, east, down.
    #[must_use]
    #[inline]
    pub fn to_ned(&self, point: Ecef<T>) -> Ned<T> {
        self.to_enu(point).into()
    }

    /// [`Self::to_enu`] as azimuth, elevation and range.
    #[must_use]
    #[inline]
    pub fn to_aer(&self, point: Ecef<T>) -> Aer<T> {
        self.to_enu(point).into()
    }

    /// The point in Earth axes that is so far east, north and up of the origin.
    ///
    /// # Errors
    /// [`InvalidEcef`] if the point is not finite.
    #[inline]
    pub fn from_enu(&self, enu: Enu<T>) -> Result<Ecef<T>, InvalidEcef<T>> {
        let [x, y, z] = self.vector_from_enu(enu);
        Ecef::new(self.ecef.x() + x, self.ecef.y() + y, self.ecef.z() + z)
    }

    /// [`Self::from_enu`] from north, east, down.
    ///
    /// # Errors
    /// [`InvalidEcef`] if the point is not finite.
    #[inline]
    pub fn from_ned(&self, ned: Ned<T>) -> Result<Ecef<T>, InvalidEcef<T>> {
        self.from_enu(ned.into())
    }

    /// [`Self::from_enu`] from azimuth, elevation and range.
    ///
    /// # Errors
    /// [`InvalidEcef`] if the point is not finite.
    #[inline]
    pub fn from_aer(&self, aer: Aer<T>) -> Result<Ecef<T>, InvalidEcef<T>> {
        self.from_enu(aer.into())
    }

    /// A geodetic position, seen from the origin, without the cancellation of Earth axes: from differences of angles and heights.
    ///
    /// Worst error 6·10⁻¹⁶ (`f64`), 10⁻⁷ (`f32`) of the distance, at any distance: within 10 km, 5 pm and 0.8
    /// mm. (An `f32` latitude has steps of up to 0.4 m; they are the input's own.)
    ///
    /// ```
    /// use terrella::{Ellipsoid, Geodetic, LatLon, LocalFrame};
    /// let tower = Geodetic::new(LatLon::new(48.858_2_f32, 2.294_5)?, 33.0)?;
    /// let drone = Geodetic::new(tower.lat_lon(), 33.125)?;
    /// let frame = LocalFrame::new(Ellipsoid::WGS84, tower);
    /// assert_eq!(frame.geodetic_to_enu(drone).up, 0.125);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[must_use]
    #[inline]
    pub fn geodetic_to_enu(&self, position: Geodetic<T>) -> Enu<T> {
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
    #[must_use]
    #[inline]
    pub fn geodetic_to_ned(&self, position: Geodetic<T>) -> Ned<T> {
        self.geodetic_to_enu(position).into()
    }

    /// [`Self::geodetic_to_enu`] as azimuth, elevation and range.
    #[must_use]
    #[inline]
    pub fn geodetic_to_aer(&self, position: Geodetic<T>) -> Aer<T> {
        self.geodetic_to_enu(position).into()
    }
}

/// The longitude difference in [−180, 180]; across ±180 it is not rounded at the size of 360.
#[inline(always)]
pub(crate) fn turn<T: Real>(from: T, to: T) -> T {
    let straight = to - from;
    let half_circle = T::of(180.0).copysign(straight);
    let wrapped = (to - half_circle) - (from + half_circle);
    select(straight.abs() > T::of(180.0), wrapped, straight)
}
