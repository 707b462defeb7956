use core::fmt;

use crate::math::{atan2_degrees, either, max, min, select, sin_cos_degrees};
use crate::{LatLon, Real};

/// A place in the coordinates that the pixels and the plane of HEALPix share, relative to the middle of its
/// quarter of longitude.
#[derive(Clone, Copy)]
pub(crate) struct Facet<T> {
    /// The number of the quarter, 0 to 3 eastward from longitude 0.
    pub quarter: u8,
    /// The longitude from the middle of the quarter, divided by 90°, in [−½, ½].
    pub turn: T,
    /// 3/2 of the sine of the latitude: in [−1, 1] in the equatorial zone.
    pub height: T,
    /// √(3(1 − |sin φ|)): 0 at the poles, 1 where the equatorial zone and a polar cap meet.
    pub outward: T,
}

impl<T: Real> Facet<T> {
    /// Creates it for a place on the sphere.
    #[inline(always)]
    pub(super) fn of_place(place: LatLon<T>) -> Self {
        Self::of(sin_cos_degrees(place.lat()), place.lon())
    }

    /// Creates it from sine and cosine of the latitude on the sphere, and the longitude in degrees from −180
    /// to 180. A place on a meridian between two quarters belongs to the eastern one.
    #[inline(always)]
    pub(crate) fn of((sin, cos): (T, T), lon: T) -> Self {
        let (right_angle, half_circle) = (T::of(90.0), T::of(180.0));
        let lon = select(lon < half_circle, lon, -half_circle);
        let east = select(lon < right_angle, 0, 1);
        let west = select(lon < -right_angle, 2, 3);
        let quarter = select(lon < T::ZERO, west, east);
        Self {
            quarter,
            turn: (lon - middle(quarter)) / right_angle,
            height: T::of(1.5) * sin,
            // 1 − |sin φ| is not used: the subtraction loses digits near the pole.
            outward: cos * (T::of(3.0) / (T::ONE + sin.abs())).sqrt(),
        }
    }

    /// Whether the place is in a polar cap.
    #[inline(always)]
    pub(super) fn is_cap(self) -> bool {
        self.height.abs() > T::ONE
    }
}

/// A place on the sphere, before its latitude is an angle.
#[derive(Clone, Copy)]
pub(crate) struct Spot<T> {
    /// The sine and the cosine of the latitude, which may have a common factor near 1.
    pub latitude: (T, T),
    /// The longitude in degrees, from −180 to 180.
    pub lon: T,
}

impl<T: Real> Spot<T> {
    #[inline(always)]
    pub(super) fn on_sphere(self) -> LatLon<T> {
        let (sin, cos) = self.latitude;
        LatLon::within(atan2_degrees(sin, cos), self.lon)
    }
}

/// The middle of a quarter of longitude, in degrees from −180 to 180.
#[inline(always)]
pub(super) fn middle<T: Real>(quarter: u8) -> T {
    let quarter = T::from_byte(quarter);
    T::of(45.0) + T::of(90.0) * quarter - either(quarter > T::of(1.5), T::of(360.0))
}

/// Sine and cosine of the latitude in the northern polar cap, from `outward`.
#[inline(always)]
pub(super) fn cap<T: Real>(outward: T) -> (T, T) {
    let square = outward * outward;
    let third = T::of(1.0 / 3.0);
    (T::ONE - square * third, outward * (T::of(6.0) - square).sqrt() * third)
}

/// Sine and cosine of the latitude in the northern half of the equatorial zone, from `height`.
#[inline(always)]
pub(super) fn belt<T: Real>(height: T) -> (T, T) {
    let sin = height * T::of(2.0 / 3.0);
    (sin, ((T::ONE - sin) * (T::ONE + sin)).sqrt())
}

/// Projects a place on the sphere to HEALPix's plane (Calabretta & Roukema, MNRAS 381, 2007).
///
/// Returns [x, y] with x in [0, 8) and y in [−2, 2], in units of π/4. In these units a base pixel is a square
/// that stands on its corner and is 2 wide. Longitude 0 is at x = 0 and the equator at y = 0; the equatorial
/// zone |sin φ| ≤ ⅔ is |y| ≤ 1, and the poles are the tips at x = 1, 3, 5, 7.
///
/// The worst error is 8.6·10⁻¹⁶ (`f64`) or 4.6·10⁻⁷ (`f32`) of a unit, which is 0.5 ulp of 8. Next to a tip y
/// is near 2 and has only the digits of a number of that size; for a place that near a pole, use
/// [`Pixel`](super::Pixel), which loses none.
///
/// ```
/// use terrella::healpix;
/// use terrella::LatLon;
/// assert_eq!(healpix::to_plane(LatLon::new(0.0, -90.0)?), [6.0, 0.0]);
/// assert_eq!(healpix::to_plane(LatLon::new(90.0, 100.0)?), [3.0, 2.0]);
/// # Ok::<(), terrella::InvalidLatLon<f64>>(())
/// ```
#[doc(alias = "HPX")]
#[doc(alias = "HEALPix projection")]
#[must_use]
#[inline]
pub fn to_plane<T: Real>(place: LatLon<T>) -> [T; 2] {
    point(Facet::of_place(place), place.lon())
}

/// The point of the plane of a place with this longitude.
#[inline(always)]
pub(super) fn point<T: Real>(facet: Facet<T>, lon: T) -> [T; 2] {
    let (two, eight) = (T::of(2.0), T::of(8.0));
    let tip = two * T::from_byte(facet.quarter) + T::ONE;
    let across = tip + two * facet.turn * facet.outward;
    let along = lon / T::of(45.0);
    let along = along + either(along < T::ZERO, eight);
    // A longitude just west of 0 rounds to x = 8, which is the same place as 0.
    let along = either(along < eight, along);
    let up = (two - facet.outward).copysign(facet.height);
    select(facet.is_cap(), [across, up], [along, facet.height])
}

/// Returns the place on the sphere of a point of HEALPix's plane: the inverse of [`to_plane`]. The longitude
/// is in [−180, 180]; for a pole it is that of the middle of the quarter.
///
/// The worst error is 4.3·10⁻¹⁶ (`f64`) or 2.3·10⁻⁷ (`f32`) radians on the sphere, including the rounding of
/// latitude and longitude.
///
/// ```
/// use terrella::healpix;
/// let place = healpix::from_plane([7.25, 1.5])?;
/// assert_eq!(place.lon(), -22.5);
/// assert!(healpix::from_plane([0.5, 1.75]).is_err()); // between two tips
/// # Ok::<(), terrella::healpix::OutsidePlane<f64>>(())
/// ```
///
/// # Errors
/// [`OutsidePlane`] if x is outside [0, 8], |y| > 2, a coordinate is NaN, or the point is in the gap between
/// two tips by more than rounding.
#[inline]
pub fn from_plane<T: Real>(point: [T; 2]) -> Result<LatLon<T>, OutsidePlane<T>> {
    Ok(spot(point)?.on_sphere())
}

/// The place of a point of the plane.
#[inline(always)]
pub(super) fn spot<T: Real>([x, y]: [T; 2]) -> Result<Spot<T>, OutsidePlane<T>> {
    let (two, eight) = (T::of(2.0), T::of(8.0));
    let inside = (x >= T::ZERO) & (x <= eight) & (y.abs() <= two);
    if !inside {
        return Err(OutsidePlane { x, y });
    }
    let quarter = (x * T::of(0.5)).floor().clamp(0, 3) as u8;
    let across = x - (two * T::from_byte(quarter) + T::ONE);
    let outward = two - y.abs();
    let is_cap = y.abs() > T::ONE;
    // The allowance for the rounding of x, which is a sum.
    if is_cap & (across.abs() > outward + T::of(4.0) * T::EPSILON) {
        return Err(OutsidePlane { x, y });
    }
    let share = across / select(outward > T::ZERO, outward, T::ONE);
    let share = either(outward > T::ZERO, max(min(share, T::ONE), -T::ONE));
    let degrees = T::of(45.0);
    let lon = select(
        is_cap,
        middle::<T>(quarter) + degrees * share,
        degrees * (x - either(x > T::of(4.0), eight)),
    );
    let (sin, cos) = select(is_cap, cap(outward), belt(y.abs()));
    Ok(Spot {
        latitude: (sin.copysign(y), cos),
        lon,
    })
}

/// The error of [`from_plane`]: the point is outside HEALPix's plane.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct OutsidePlane<T> {
    /// The coordinate along the equator.
    pub x: T,
    /// The coordinate toward the north.
    pub y: T,
}

impl<T: fmt::Debug> fmt::Display for OutsidePlane<T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "({:?}, {:?}) is outside HEALPix's plane", self.x, self.y)
    }
}

impl<T: fmt::Debug> core::error::Error for OutsidePlane<T> {}
