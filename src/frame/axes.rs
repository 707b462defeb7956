use core::fmt;

use crate::Real;
use crate::math::{max, select, sin_cos_degrees};
use crate::position::{angle_degrees, write_between};

/// East, north and up from an origin, in metres; or the components of any vector along these axes.
///
/// Up is the outward normal of the ellipsoid at the origin. [`LocalFrame`](crate::LocalFrame) is the origin
/// with its axes.
///
/// ```
/// use terrella::{Aer, Enu};
/// let mast = Enu { east: 30.0, north: 0.0, up: 40.0 };
/// let seen = Aer::from(mast);
/// assert_eq!((seen.azimuth, seen.range), (90.0, 50.0));
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Enu<T = f64> {
    /// Eastward, in metres.
    pub east: T,
    /// Northward, in metres.
    pub north: T,
    /// Upward, in metres.
    pub up: T,
}

/// North, east and down from an origin, in metres, as in aviation; or the components of any vector along
/// these axes.
///
/// ```
/// use terrella::{Enu, Ned};
/// let ned = Ned::from(Enu { east: 1.0, north: 2.0, up: 3.0 });
/// assert_eq!(ned, Ned { north: 2.0, east: 1.0, down: -3.0 });
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Ned<T = f64> {
    /// Northward, in metres.
    pub north: T,
    /// Eastward, in metres.
    pub east: T,
    /// Downward, in metres.
    pub down: T,
}

/// Azimuth, elevation and range from an origin, as an antenna is pointed.
///
/// Worst error of the conversion from [`Enu`]: 1 ulp of the azimuth, 2 ulp of the elevation, 1.5 ulp of the
/// range.
///
/// ```
/// use terrella::{Aer, Enu};
/// let west = Aer::from(Enu { east: -5.0, north: 0.0, up: 0.0 });
/// assert_eq!(west, Aer { azimuth: -90.0, elevation: 0.0, range: 5.0 });
/// // as a compass shows it, 0 to 360
/// let compass = if west.azimuth < 0.0 { west.azimuth + 360.0 } else { west.azimuth };
/// assert_eq!(compass, 270.0);
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Aer<T = f64> {
    /// Azimuth clockwise from north in degrees, in [−180, 180]; 0 straight up, straight down and at the
    /// origin.
    pub azimuth: T,
    /// Angle above the plane of east and north in degrees, in [−90, 90]; 0 at the origin.
    pub elevation: T,
    /// Distance from the origin in metres.
    pub range: T,
}

impl<T: fmt::Display> fmt::Display for Enu<T> {
    /// Writes the components, each with the formatter's options: `east 30, north 0, up 40 m`.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { east, north, up } = self;
        write_between(f, ["east ", ", north ", ", up ", " m"], [east, north, up])
    }
}

impl<T: fmt::Display> fmt::Display for Ned<T> {
    /// Writes the components, each with the formatter's options: `north 0, east 30, down -40 m`.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { north, east, down } = self;
        write_between(f, ["north ", ", east ", ", down ", " m"], [north, east, down])
    }
}

impl<T: fmt::Display> fmt::Display for Aer<T> {
    /// Writes the three numbers, each with the formatter's options: `azimuth 90°, elevation 53.1°, range 50
    /// m`.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self {
            azimuth,
            elevation,
            range,
        } = self;
        write_between(
            f,
            ["azimuth ", "°, elevation ", "°, range ", " m"],
            [azimuth, elevation, range],
        )
    }
}

/// The error for a vector of which a component is infinite or NaN.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct InvalidEnu<T> {
    /// Eastward.
    pub east: T,
    /// Northward.
    pub north: T,
    /// Upward.
    pub up: T,
}

impl<T: fmt::Debug> fmt::Display for InvalidEnu<T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { east, north, up } = self;
        write!(f, "({east:?}, {north:?}, {up:?}) east, north, up is not finite")
    }
}

impl<T: fmt::Debug> core::error::Error for InvalidEnu<T> {}

impl<T: Real> From<Ned<T>> for Enu<T> {
    #[inline(always)]
    fn from(ned: Ned<T>) -> Self {
        Self {
            east: ned.east,
            north: ned.north,
            up: -ned.down,
        }
    }
}

impl<T: Real> From<Enu<T>> for Ned<T> {
    #[inline(always)]
    fn from(enu: Enu<T>) -> Self {
        Self {
            north: enu.north,
            east: enu.east,
            down: -enu.up,
        }
    }
}

impl<T: Real> From<Enu<T>> for Aer<T> {
    #[cfg_attr(not(small), inline(always))]
    fn from(enu: Enu<T>) -> Self {
        // Squares stay in range after a power of two. Adding 0 makes −0 into 0: south is at 180, not −180.
        let largest = max(max(enu.east.abs(), enu.north.abs()), enu.up.abs());
        // 2^∓600 and 2^∓100.
        let (shrink, grow) = (
            T::pick(2.409_919_865_102_884e-181, 7.888_609e-31),
            T::pick(4.149_515_568_880_993e180, 1.267_650_6e30),
        );
        let large = largest > T::pick(3.273_390_607_896_142e150, 1.152_921_5e18);
        // 2^−450 and 2^−40: the square of what is far smaller than the largest has its digits still.
        let small = largest < T::pick(3.439_552_567_074_349_4e-136, 9.094_947e-13);
        let scale = select(large, shrink, select(small, grow, T::ONE));
        let unscale = select(large, grow, select(small, shrink, T::ONE));
        let (east, north, up) = (
            enu.east * scale + T::ZERO,
            enu.north * scale + T::ZERO,
            enu.up * scale + T::ZERO,
        );
        let level = east * east + north * north;
        Self {
            azimuth: angle_degrees(east, north),
            elevation: angle_degrees(up, level.sqrt()),
            range: (level + up * up).sqrt() * unscale,
        }
    }
}

impl<T: Real> From<Aer<T>> for Enu<T> {
    #[cfg_attr(not(small), inline(always))]
    fn from(aer: Aer<T>) -> Self {
        let (sin_azimuth, cos_azimuth) = sin_cos_degrees(aer.azimuth);
        let (sin, cos) = sin_cos_degrees(aer.elevation);
        let level = aer.range * cos;
        Self {
            east: level * sin_azimuth,
            north: level * cos_azimuth,
            up: aer.range * sin,
        }
    }
}

impl<T: Real> From<Ned<T>> for Aer<T> {
    #[inline]
    fn from(ned: Ned<T>) -> Self {
        Enu::from(ned).into()
    }
}

impl<T: Real> From<Aer<T>> for Ned<T> {
    #[inline]
    fn from(aer: Aer<T>) -> Self {
        Enu::from(aer).into()
    }
}
