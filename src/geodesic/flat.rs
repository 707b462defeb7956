use super::auxiliary::nearly_round;
use super::degrees::{Split, off_pole};
use super::middle::{self, Scale};
use super::{Direct, Geodesic, GeodesicError, Inverse};
use crate::latitude::UnsupportedFlattening;
use crate::{Ellipsoid, LatLon, Real};

/// The flat model: a plane whose scales are the radii of curvature at the middle latitude. The cheapest inverse there is.
///
/// North M Δφ and east N cos φ Δλ, with M and N at the mean of the latitudes; the azimuths are half of the meridians'
/// convergence Δλ sin φ to either side of the plane's.
///
/// Worst error on the Earth of distance, azimuths × distance, and position of the direct problem, in metres, by the latitude of the first place:
///
/// | distance | 0 to 30° | 30 to 60° | 60 to 80° | 80 to 89° |
/// |---|---|---|---|---|
/// | 1 km | 1.4e-6 | 6e-6 | 6e-5 | 6e-3 |
/// | 10 km | 1.4e-3 | 6e-3 | 6e-2 | 6 |
/// | 100 km | 1.4 | 6 | 60 | 1.2e4 |
///
/// It grows with the cube of the distance. Nearer to a pole than ten distances, and beyond 1000 km anywhere, the plane is no model: the numbers
/// are finite, and up to as wrong as they are large. `f32` adds 7e-7 of the distance, and 2 m to a position.
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
pub struct Flat<T> {
    a: T,
    e2: T,
}

impl<T: Real> Flat<T> {
    /// For an ellipsoid.
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
    fn scale(&self, lat: Split<T>) -> Scale<T> {
        let (sin, cos) = lat.sin_cos();
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
    /// Never an error.
    #[inline]
    fn inverse(&self, from: LatLon<T>, to: LatLon<T>) -> Result<Inverse<T>, GeodesicError<T>> {
        Ok(middle::inverse(from, to, |lat| self.scale(lat)))
    }

    #[inline]
    fn direct(&self, from: LatLon<T>, azimuth: T, distance: T) -> Result<Direct<T>, GeodesicError<T>> {
        middle::direct(from, azimuth, distance, |lat| self.scale(lat))
    }
}
