use super::angle::{between_poles, heading, northward_between_poles, off_pole, turns_once};
use super::mid_latitude::{self, Scale};
use super::profile::profile;
use super::{Direct, Geodesic, GeodesicError, Inverse, nearly_round};
use crate::latitude::UnsupportedFlattening;
use crate::math::{DoubleWord, sin_cos_degrees};
use crate::{Ellipsoid, LatLon, Real};

profile! {
    name: "flat",
    title: "Flat",
    surface: Local,
    flattenings: [-1.0 / 60.0, 1.0 / 60.0],
    model: "plane, radii of curvature at the middle latitude",
    good_to: "6 mm at 10 km below 60°",
    instructions: 440,
    errors: {
        latitudes 0 to 30, f32 adds [7e-7 s] [7e-7 s] [7e-7 s + 2.0] {
            1 km: [1.4e-6] [1.4e-6] [1.4e-6];
            10 km: [1.4e-3] [1.4e-3] [1.4e-3];
            100 km: [1.4] [1.4] [1.4];
        }
        latitudes 30 to 60, f32 adds [7e-7 s] [7e-7 s] [7e-7 s + 2.0] {
            1 km: [6e-6] [6e-6] [6e-6];
            10 km: [6e-3] [6e-3] [6e-3];
            100 km: [6.0] [6.0] [6.0];
        }
        latitudes 60 to 80, f32 adds [7e-7 s] [7e-7 s] [7e-7 s + 2.0] {
            1 km: [6e-5] [6e-5] [6e-5];
            10 km: [6e-2] [6e-2] [6e-2];
            100 km: [60.0] [60.0] [60.0];
        }
        latitudes 80 to 89, f32 adds [7e-7 s] [7e-7 s] [7e-7 s + 2.0] {
            1 km: [6e-3] [6e-3] [6e-3];
            10 km: [6.0] [6.0] [6.0];
            100 km: [1.2e4] [1.2e4] [1.2e4];
        }
    }
}

/// A plane for short distances, scaled by the radii of curvature at the middle latitude. Few methods are
/// cheaper.
///
/// The second place is M Δφ north and N cos φ Δλ east of the first, with the meridional and the
/// prime-vertical radius of curvature M and N at the mean φ of both latitudes. The azimuths differ from the
/// plane's by half of the convergence of the meridians, Δλ sin φ, to either side.
///
/// Worst error on the Earth, in metres:
///
#[doc = table!()]
///
/// The error grows with the cube of the distance. Nearer to a pole than ten times the distance, and beyond
/// 1000 km anywhere, do not use it: results are finite, and may be wrong by their own size.
///
/// ```
/// use terrella::geodesic::{Flat, Geodesic};
/// use terrella::{Ellipsoid, LatLon};
/// let earth = Flat::new(Ellipsoid::<f64>::WGS84)?;
/// let way = earth.inverse(LatLon::new(48.8584, 2.2945)?, LatLon::new(48.8530, 2.3499)?)?; // 4109.52780 m
/// assert_eq!(format!("{:.3}", way.distance), "4109.528");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[doc(alias = "equirectangular", alias = "CheapRuler", alias = "flat earth")]
pub struct Flat<T> {
    a: T,
    e2: T,
}

impl<T: Real> Flat<T> {
    /// Makes the method for an ellipsoid.
    ///
    /// # Errors
    /// [`UnsupportedFlattening`] if |f| > 1/60.
    pub fn new(ellipsoid: Ellipsoid<T>) -> Result<Self, UnsupportedFlattening<T>> {
        nearly_round(ellipsoid).map(Self::within)
    }

    /// For an ellipsoid known to be nearly round.
    pub(crate) fn within(ellipsoid: Ellipsoid<T>) -> Self {
        Self {
            a: ellipsoid.a(),
            e2: ellipsoid.e2(),
        }
    }

    #[inline(always)]
    fn scale(&self, lat: DoubleWord<T>) -> Scale<T> {
        let (sin, cos) = lat.sin_cos_degrees();
        let w2 = T::ONE - self.e2 * sin * sin;
        let radius = self.a * T::of(core::f64::consts::PI / 180.0) / w2.sqrt();
        Scale {
            north: radius * (T::ONE - self.e2) / w2,
            east: radius * off_pole(cos),
            sin,
        }
    }
}

impl<T: Real> Geodesic<T> for Flat<T> {
    /// Never fails.
    #[inline]
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
