use super::angle::{between_poles, heading, northward_between_poles, off_pole, turns_once};
use super::mid_latitude::{self, Scale};
use super::profile::profile;
use super::{Direct, Geodesic, GeodesicError, Inverse, nearly_round};
use crate::latitude::UnsupportedFlattening;
use crate::math::{DoubleWord, sin_cos_degrees};
use crate::{Ellipsoid, LatLon, Real};

profile! {
    name: "plane",
    title: "Plane",
    surface: Local,
    flattenings: [-1.0 / 60.0, 1.0 / 60.0],
    model: "`Flat` about a place, without a sine; in `f32` from offsets",
    good_to: "as `Flat`, 0.2 mm more on a kilometre half a degree away at latitude 60",
    instructions: 330,
    errors: {}
}

/// [`Flat`](super::Flat) about one place: its scales are polynomials of the second degree in the latitude, so
/// that the distance needs no sine. The cheapest method here.
///
/// If both latitudes are within δ radians of the place's latitude, a distance s is wrong by at most s δ³/6
/// (tan φ + 6e² + δ/4) more than with [`Flat`](super::Flat), where φ is the latitude farthest from the
/// equator (Taylor's theorem): 0.2 mm on 1 km within 0.5° at latitude 60. [`scene`](crate::scene) has both
/// errors as one bound.
///
/// [`Plane::local`] takes places as offsets from the place. `f32` holds offsets to 2⁻²⁴ of themselves,
/// latitudes and longitudes only to 0.4 m.
///
/// ```
/// use terrella::geodesic::{Geodesic, Plane};
/// use terrella::{Ellipsoid, LatLon};
/// let home = LatLon::new(47.397_742_f32, 8.545_594)?;
/// let plane = Plane::local(Ellipsoid::WGS84, home)?;
/// // Offsets in degrees, from the difference in f64 or in whole numbers.
/// let (start, end) = (LatLon::new(0.0, 0.0)?, LatLon::new(0.004_5, -0.006)?);
/// let way = plane.inverse(start, end)?; // 674.8628 m
/// assert!((way.distance - 674.8628).abs() < 5e-4);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Plane<T> {
    middle: T,
    /// By powers 1, u, u² of the degrees u from the place's latitude: metres in a degree of latitude and of
    /// longitude, and sin φ.
    north: [T; 3],
    east: [T; 3],
    sin: [T; 3],
}

impl<T: Real> Plane<T> {
    /// Makes the plane about a place.
    ///
    /// # Errors
    /// [`UnsupportedFlattening`] if |f| > 1/60.
    pub fn new(ellipsoid: Ellipsoid<T>, place: LatLon<T>) -> Result<Self, UnsupportedFlattening<T>> {
        nearly_round(ellipsoid).map(|ellipsoid| Self::within(ellipsoid, place.lat(), place.lat()))
    }

    /// Makes the plane about a place, for places given as degrees north and east of it.
    ///
    /// # Errors
    /// [`UnsupportedFlattening`] if |f| > 1/60.
    pub fn local(ellipsoid: Ellipsoid<T>, place: LatLon<T>) -> Result<Self, UnsupportedFlattening<T>> {
        nearly_round(ellipsoid).map(|ellipsoid| Self::within(ellipsoid, place.lat(), T::ZERO))
    }

    /// About a latitude that is given as `middle`, on an ellipsoid known to be nearly round.
    pub(crate) fn within(ellipsoid: Ellipsoid<T>, lat: T, middle: T) -> Self {
        let (half, degree) = (T::of(0.5), T::of(core::f64::consts::PI / 180.0));
        let (s, c) = sin_cos_degrees(lat);
        let e2 = ellipsoid.e2();
        let w2 = T::ONE - e2 * s * s;
        // M = a(1 − e²)/W³ and N cos φ, N = a/W, and their derivatives: (N cos φ)′ = −M sin φ,
        // M′ = 3Me² sin φ cos φ/W².
        let n = ellipsoid.a() * degree / w2.sqrt();
        let m = n * (T::ONE - e2) / w2;
        let rise = T::of(3.0) * e2 / w2;
        let m1 = m * rise * s * c;
        let m2 = half * m * rise * (c * c - s * s + T::of(5.0) / T::of(3.0) * rise * s * s * c * c);
        let powers = |[p, q, r]: [T; 3]| [p, q * degree, r * degree * degree];
        Self {
            middle,
            north: powers([m, m1, m2]),
            east: powers([n * c, -m * s, -half * (m * c + m1 * s)]),
            sin: powers([s, c, -half * s]),
        }
    }

    #[inline(always)]
    fn scale(&self, lat: DoubleWord<T>) -> Scale<T> {
        let u = (lat.high - self.middle) + lat.low;
        let of = |[p, q, r]: [T; 3]| p + u * (q + u * r);
        Scale {
            north: of(self.north),
            // Far from the place the polynomial may be negative.
            east: off_pole(of(self.east)),
            sin: of(self.sin),
        }
    }
}

impl<T: Real> Geodesic<T> for Plane<T> {
    /// Never fails.
    // Inlined for size: who takes the distance alone does not pay for the azimuths.
    #[cfg_attr(small, inline(always))]
    #[cfg_attr(not(small), inline)]
    fn inverse(&self, from: LatLon<T>, to: LatLon<T>) -> Result<Inverse<T>, GeodesicError<T>> {
        let line = mid_latitude::inverse(from, to, |lat| self.scale(lat));
        Ok(northward_between_poles(from, to, line))
    }

    /// # Errors
    /// [`GeodesicError::Azimuth`] or [`GeodesicError::Distance`] for a value that is infinite or NaN.
    #[inline]
    fn direct(&self, from: LatLon<T>, azimuth: T, distance: T) -> Result<Direct<T>, GeodesicError<T>> {
        let heading = heading(azimuth, distance)?;
        Ok(mid_latitude::direct(from, heading, distance, |lat| self.scale(lat)))
    }

    /// Not found between poles.
    #[inline(always)]
    fn fast_inverse(&self, from: LatLon<T>, to: LatLon<T>) -> (Inverse<T>, bool) {
        let line = mid_latitude::inverse(from, to, |lat| self.scale(lat));
        (line, !between_poles(from, to))
    }

    /// Not found for azimuths beyond ±360°.
    #[inline(always)]
    fn fast_direct(&self, from: LatLon<T>, azimuth: T, distance: T) -> (Direct<T>, bool) {
        let heading = sin_cos_degrees(azimuth);
        let end = mid_latitude::direct(from, heading, distance, |lat| self.scale(lat));
        (end, turns_once(azimuth) & distance.is_finite())
    }
}
