//! The mid-latitude formula: between two places the ellipsoid is a plane whose scales are those of their mean
//! latitude. What [`Flat`](super::Flat) and [`Plane`](super::Plane) share.

use super::angle::{latitude_difference, longitude_difference, wrapped};
use super::{Direct, Inverse};
use crate::math::{DoubleWord, atan2_degrees, hypot, max, min, repeat, select, sin_cos_degrees};
use crate::{LatLon, Real};

/// Metres in a degree of latitude and of longitude, and the sine of the latitude.
pub(super) struct Scale<T> {
    pub north: T,
    pub east: T,
    pub sin: T,
}

/// The line, but from pole to pole.
#[inline(always)]
pub(super) fn inverse<T: Real>(
    from: LatLon<T>,
    to: LatLon<T>,
    scale: impl Fn(DoubleWord<T>) -> Scale<T>,
) -> Inverse<T> {
    let lat = latitude_difference(from, to);
    let lon = longitude_difference(from, to);
    let lon = lon.value();
    let scale = scale(DoubleWord::sum(from.lat(), to.lat()).half());
    let (north, east) = (lat.value() * scale.north, lon * scale.east);
    let azimuth = atan2_degrees(east, north);
    let convergence = T::of(0.5) * lon * scale.sin;
    Inverse {
        distance: hypot(north, east),
        azimuth1: wrapped(azimuth - convergence),
        azimuth2: wrapped(azimuth + convergence),
    }
}

/// The middle latitude depends on the end: three steps toward it.
#[inline(always)]
pub(super) fn direct<T: Real>(
    from: LatLon<T>,
    (sin1, cos1): (T, T),
    distance: T,
    scale: impl Fn(DoubleWord<T>) -> Scale<T>,
) -> Direct<T> {
    let (half, half_circle) = (T::of(0.5), T::of(180.0));
    let within = |x: T, limit: T| max(min(x, limit), -limit);
    let (mut lat, mut lon, mut convergence) = (T::ZERO, T::ZERO, T::ZERO);
    repeat!(3, {
        let middle = within(from.lat() + half * lat, T::of(90.0));
        let scale = scale(DoubleWord::sum(middle, T::ZERO));
        let (sin, cos) = sin_cos_degrees(convergence);
        lat = within(distance * ((cos1 * cos - sin1 * sin) / scale.north), half_circle);
        lon = within(distance * ((sin1 * cos + cos1 * sin) / scale.east), half_circle);
        convergence = half * lon * scale.sin;
    });
    let lat = from.lat() + lat;
    // Over a pole and down the other side.
    let over = lat.abs() > T::of(90.0);
    let turn = select(over, half_circle, T::ZERO);
    let azimuth = atan2_degrees(sin1, cos1) + (convergence + convergence);
    Direct {
        position: LatLon::within(
            select(over, half_circle.copysign(lat) - lat, lat),
            wrapped(wrapped(from.lon() + lon) + turn),
        ),
        azimuth: wrapped(wrapped(azimuth) + turn),
    }
}
