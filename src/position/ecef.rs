use core::fmt;

use crate::Real;

/// A point in Earth axes (Earth-centred, Earth-fixed), in metres: x through (0° N, 0° E), y through (0° N, 90° E), z
/// through the north pole.
///
/// ```
/// use terrella::Ecef;
/// let pole = Ecef::new(0.0, 0.0, 6_356_752.0)?;
/// assert_eq!(pole.to_array(), [0.0, 0.0, 6_356_752.0]);
/// # Ok::<(), terrella::InvalidEcef<f64>>(())
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Ecef<T> {
    x: T,
    y: T,
    z: T,
}

impl<T: Real> Ecef<T> {
    /// From the three coordinates in metres; the geocentre is a point like any other.
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

    /// For coordinates known to be finite.
    #[inline(always)]
    pub(crate) const fn within(x: T, y: T, z: T) -> Self {
        Self { x, y, z }
    }

    /// Toward 0° N, 0° E, in metres.
    #[must_use]
    #[inline(always)]
    pub fn x(self) -> T {
        self.x
    }

    /// Toward 0° N, 90° E, in metres.
    #[must_use]
    #[inline(always)]
    pub fn y(self) -> T {
        self.y
    }

    /// Toward the north pole, in metres.
    #[must_use]
    #[inline(always)]
    pub fn z(self) -> T {
        self.z
    }

    /// The coordinates x, y, z.
    #[must_use]
    #[inline(always)]
    pub fn to_array(self) -> [T; 3] {
        [self.x, self.y, self.z]
    }
}

/// Coordinates that are not those of a point: one is infinite or not a number.
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
