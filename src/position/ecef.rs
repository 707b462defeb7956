use core::fmt;

use super::write_between;
use crate::Real;

/// A point in Earth-centred, Earth-fixed axes, in metres: x toward (0° N, 0° E), y toward (0° N, 90° E), z
/// toward the north pole.
///
/// [`Ellipsoid::to_ecef`](crate::Ellipsoid::to_ecef) and
/// [`Ellipsoid::to_geodetic`](crate::Ellipsoid::to_geodetic) convert between this and
/// [`Geodetic`](crate::Geodetic).
///
/// ```
/// use terrella::Ecef;
/// let pole = Ecef::new(0.0, 0.0, 6_356_752.0)?;
/// assert_eq!(pole.to_array(), [0.0, 0.0, 6_356_752.0]);
/// # Ok::<(), terrella::InvalidEcef<f64>>(())
/// ```
#[doc(alias("ECEF", "geocentric"))]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Ecef<T = f64> {
    x: T,
    y: T,
    z: T,
}

impl<T: Real> Ecef<T> {
    /// Creates the point of three coordinates in metres. All of them may be 0: the Earth's centre.
    ///
    /// # Errors
    /// [`InvalidEcef`] if a coordinate is infinite or NaN.
    #[inline]
    pub fn new(x: T, y: T, z: T) -> Result<Self, InvalidEcef<T>> {
        if !(x.is_finite() && y.is_finite() && z.is_finite()) {
            return Err(InvalidEcef { x, y, z });
        }
        Ok(Self { x, y, z })
    }

    /// Creates a point with coordinates known to be finite.
    #[inline(always)]
    pub(crate) const fn within(x: T, y: T, z: T) -> Self {
        Self { x, y, z }
    }

    /// Returns the coordinate toward 0° N, 0° E, in metres.
    #[must_use]
    #[inline(always)]
    pub const fn x(self) -> T {
        self.x
    }

    /// Returns the coordinate toward 0° N, 90° E, in metres.
    #[must_use]
    #[inline(always)]
    pub const fn y(self) -> T {
        self.y
    }

    /// Returns the coordinate toward the north pole, in metres.
    #[must_use]
    #[inline(always)]
    pub const fn z(self) -> T {
        self.z
    }

    /// Returns the coordinates x, y, z, in metres.
    #[must_use]
    #[inline(always)]
    pub const fn to_array(self) -> [T; 3] {
        [self.x, self.y, self.z]
    }
}

impl<T: fmt::Display> fmt::Display for Ecef<T> {
    /// Writes the coordinates, each with the formatter's options: `(0, 0, 6356752) m`.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write_between(f, ["(", ", ", ", ", ") m"], [&self.x, &self.y, &self.z])
    }
}

/// The error for coordinates of which at least one is infinite or NaN.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct InvalidEcef<T> {
    /// The point's x.
    pub x: T,
    /// The point's y.
    pub y: T,
    /// The point's z.
    pub z: T,
}

impl<T: fmt::Debug> fmt::Display for InvalidEcef<T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "({:?}, {:?}, {:?}) is not a finite point", self.x, self.y, self.z)
    }
}

impl<T: fmt::Debug> core::error::Error for InvalidEcef<T> {}
