//! From `f32` to `f64`, and back by rounding.

use super::{Direction, Ecef, Geodetic, LatLon};

impl From<LatLon<f32>> for LatLon {
    /// The same latitude and longitude: every `f32` is an `f64`.
    fn from(place: LatLon<f32>) -> Self {
        Self::within(place.lat().into(), place.lon().into())
    }
}

impl LatLon {
    /// Returns the place with latitude and longitude rounded to the nearest `f32`.
    #[must_use]
    pub const fn to_f32(self) -> LatLon<f32> {
        LatLon::within(self.lat() as f32, self.lon() as f32)
    }
}

impl From<Geodetic<f32>> for Geodetic {
    /// The same latitude, longitude and height: every `f32` is an `f64`.
    fn from(position: Geodetic<f32>) -> Self {
        Self::within(position.lat_lon().into(), position.height().into())
    }
}

impl Geodetic {
    /// Returns the position with its three numbers rounded to the nearest `f32`; a height beyond the largest
    /// `f32`, to that.
    #[must_use]
    pub const fn to_f32(self) -> Geodetic<f32> {
        Geodetic::within(self.lat_lon().to_f32(), saturated(self.height()))
    }
}

impl From<Ecef<f32>> for Ecef {
    /// The same coordinates: every `f32` is an `f64`.
    fn from(point: Ecef<f32>) -> Self {
        let [x, y, z] = point.to_array().map(f64::from);
        Self::within(x, y, z)
    }
}

impl Ecef {
    /// Returns the point with coordinates rounded to the nearest `f32`; a coordinate beyond the largest
    /// `f32`, to that.
    ///
    /// On the Earth the point moves by up to 0.43 m.
    #[must_use]
    pub const fn to_f32(self) -> Ecef<f32> {
        Ecef::within(saturated(self.x()), saturated(self.y()), saturated(self.z()))
    }
}

impl From<Direction<f32>> for Direction {
    /// The same direction within 2·10⁻¹⁶ rad, with a length of 1 to the digits of `f64`: the components are
    /// not those of the `f32`, and may round to neighbours of them.
    fn from(direction: Direction<f32>) -> Self {
        let [x, y, z] = direction.to_array().map(f64::from);
        let length = crate::Real::sqrt(x * x + y * y + z * z);
        Self::within(x / length, y / length, z / length)
    }
}

impl Direction {
    /// Returns the direction with components rounded to the nearest `f32`, within 6·10⁻⁸ rad.
    #[must_use]
    pub const fn to_f32(self) -> Direction<f32> {
        Direction::within(self.x() as f32, self.y() as f32, self.z() as f32)
    }
}

/// The nearest `f32` that is finite.
const fn saturated(number: f64) -> f32 {
    (number as f32).clamp(-f32::MAX, f32::MAX)
}
