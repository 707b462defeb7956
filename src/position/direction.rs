use core::fmt;

use super::{LatLon, write_between};
use crate::Real;
use crate::math::{atan2_degrees, max, select};

/// A unit vector in Earth axes: x toward (0° N, 0° E), y toward (0° N, 90° E), z toward the north pole.
///
/// ```
/// use terrella::Direction;
/// let d = Direction::new(3.0, 0.0, 4.0)?;
/// assert_eq!(d.to_array(), [0.6, 0.0, 0.8]);
/// # Ok::<(), terrella::InvalidDirection<f64>>(())
/// ```
#[doc(alias("nvector", "n-vector"))]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Direction<T = f64> {
    x: T,
    y: T,
    z: T,
}

impl<T: Real> Direction<T> {
    /// Creates the direction of a vector of any length: even of subnormal numbers, or of the largest.
    ///
    /// If the length is 1 apart from rounding, the vector is kept as it is. So the components of a direction
    /// create the same direction again.
    ///
    /// # Errors
    /// [`InvalidDirection`] if the vector is zero, or a component is infinite or NaN.
    #[inline(always)]
    pub fn new(x: T, y: T, z: T) -> Result<Self, InvalidDirection<T>> {
        if Self::is_unit(x, y, z) {
            return Ok(Self { x, y, z });
        }
        Self::of_any_length(x, y, z)
    }

    /// Not inlined, so that the compiler does not merge it with the caller's use of the components.
    #[inline(never)]
    fn of_any_length(x: T, y: T, z: T) -> Result<Self, InvalidDirection<T>> {
        if !(x.is_finite() && y.is_finite() && z.is_finite()) || (x.abs() + y.abs() + z.abs() == T::ZERO) {
            return Err(InvalidDirection { x, y, z });
        }
        let [x, y, z] = Self::normalised([x, y, z]);
        Ok(Self { x, y, z })
    }

    /// The unit vector along a vector, or numbers that are none for a vector that has no direction.
    #[inline(always)]
    pub(crate) fn normalised([x, y, z]: [T; 3]) -> [T; 3] {
        let largest = max(max(x.abs(), y.abs()), z.abs());
        // A power of two keeps the squares in range: 2^±500 and 2^±60 are the bounds.
        let shrink = T::pick(2.409_919_865_102_884e-181, 8.271_806e-25);
        let grow = T::pick(4.149_515_568_880_993e180, 1.267_650_6e30);
        let scale = select(
            largest > T::pick(3.273_390_607_896_142e150, 1.152_921_5e18),
            shrink,
            select(
                largest < T::pick(3.054_936_363_499_605e-151, 8.673_617_4e-19),
                grow,
                T::ONE,
            ),
        );
        let (x, y, z) = (x * scale, y * scale, z * scale);
        let length = select(Self::is_unit(x, y, z), T::ONE, (x * x + y * y + z * z).sqrt());
        [x / length, y / length, z / length]
    }

    /// Whether the length of the vector is 1 apart from rounding.
    #[inline(always)]
    pub(crate) fn is_unit(x: T, y: T, z: T) -> bool {
        (x * x + y * y + z * z - T::ONE).abs() <= T::of(4.0) * T::EPSILON
    }

    /// Creates a direction from components known to be those of a unit vector.
    #[inline(always)]
    pub(crate) const fn within(x: T, y: T, z: T) -> Self {
        Self { x, y, z }
    }

    /// Creates the direction of a latitude and a longitude, each given by its sine and cosine.
    #[inline(always)]
    pub(crate) fn from_angles((sin_lat, cos_lat): (T, T), (sin_lon, cos_lon): (T, T)) -> Self {
        Self::within(cos_lat * cos_lon, cos_lat * sin_lon, sin_lat)
    }

    /// Returns the component toward 0° N, 0° E.
    #[must_use]
    #[inline(always)]
    pub const fn x(self) -> T {
        self.x
    }

    /// Returns the component toward 0° N, 90° E.
    #[must_use]
    #[inline(always)]
    pub const fn y(self) -> T {
        self.y
    }

    /// Returns the component toward the north pole.
    #[must_use]
    #[inline(always)]
    pub const fn z(self) -> T {
        self.z
    }

    /// Returns the components x, y, z.
    #[must_use]
    #[inline(always)]
    pub const fn to_array(self) -> [T; 3] {
        [self.x, self.y, self.z]
    }

    /// Returns the latitude and longitude of this point of the unit sphere; the longitude of a pole is 0 or
    /// ±180.
    ///
    /// Worst error 2.3 ulp of the latitude and 0.85 ulp of the longitude, also next to the poles.
    ///
    /// ```
    /// # use terrella::{Direction, LatLon};
    /// assert_eq!(Direction::new(0.0, -1.0, 0.0)?.to_lat_lon(), LatLon::new(0.0, -90.0).unwrap());
    /// # Ok::<(), terrella::InvalidDirection<f64>>(())
    /// ```
    #[must_use]
    #[inline]
    pub fn to_lat_lon(self) -> LatLon<T> {
        LatLon::within(atan2_degrees(self.z, self.cos_lat()), self.lon())
    }

    /// The distance from the axis: the cosine of the latitude.
    #[inline(always)]
    pub(crate) fn cos_lat(self) -> T {
        (self.x * self.x + self.y * self.y).sqrt()
    }

    /// The longitude in degrees.
    #[inline(always)]
    pub(crate) fn lon(self) -> T {
        atan2_degrees(self.y, self.x)
    }
}

impl<T: fmt::Display> fmt::Display for Direction<T> {
    /// Writes the components, each with the formatter's options: `(0.6, 0, 0.8)`.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write_between(f, ["(", ", ", ", ", ")"], [&self.x, &self.y, &self.z])
    }
}

/// The error for a vector that has no direction: it is zero, or a component is infinite or NaN.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct InvalidDirection<T> {
    /// The vector's x.
    pub x: T,
    /// The vector's y.
    pub y: T,
    /// The vector's z.
    pub z: T,
}

impl<T: fmt::Debug> fmt::Display for InvalidDirection<T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "({:?}, {:?}, {:?}) has no direction", self.x, self.y, self.z)
    }
}

impl<T: fmt::Debug> core::error::Error for InvalidDirection<T> {}
