use super::auxiliary::nearly_round;
use super::degrees::{Split, heading, hypot, latitude_difference, longitude_difference, off_pole, wrapped};
use super::{Direct, Geodesic, GeodesicError, Inverse};
use crate::latitude::UnsupportedFlattening;
use crate::math::{atan2_degrees, max, min, select, sin_cos_degrees};
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
/// Coincident places have azimuths 0.
///
/// ```
/// use terrella::geodesic::{Flat, Geodesic};
/// use terrella::{Ellipsoid, LatLon};
/// let earth = Flat::new(Ellipsoid::<f64>::wgs84())?;
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

/// Metres in a degree of latitude and of longitude, and the sine of the latitude.
struct Scale<T> {
    north: T,
    east: T,
    sin: T,
}

impl<T: Real> Flat<T> {
    /// For an ellipsoid.
    ///
    /// # Errors
    /// [`UnsupportedFlattening`] if |f| > 1/60.
    pub fn new(ellipsoid: Ellipsoid<T>) -> Result<Self, UnsupportedFlattening<T>> {
        nearly_round(ellipsoid).map(|ellipsoid| Self {
            a: ellipsoid.a(),
            e2: ellipsoid.e2(),
        })
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
        let lat = latitude_difference(from, to);
        let lon = longitude_difference(from, to);
        let lon = lon.angle + lon.rest;
        let scale = self.scale(Split::sum(from.lat(), to.lat()).half());
        let (north, east) = ((lat.angle + lat.rest) * scale.north, lon * scale.east);
        let azimuth = atan2_degrees(east, north);
        let convergence = T::of(0.5) * lon * scale.sin;
        Ok(Inverse {
            distance: hypot(north, east),
            azimuth1: wrapped(azimuth - convergence),
            azimuth2: wrapped(azimuth + convergence),
        })
    }

    #[inline]
    fn direct(&self, from: LatLon<T>, azimuth: T, distance: T) -> Result<Direct<T>, GeodesicError<T>> {
        let (sin1, cos1) = heading(azimuth, distance)?;
        let (half, half_circle) = (T::of(0.5), T::of(180.0));
        let within = |x: T, limit: T| max(min(x, limit), -limit);
        let (mut lat, mut lon, mut convergence) = (T::ZERO, T::ZERO, T::ZERO);
        for _ in 0..3 {
            let middle = within(from.lat() + half * lat, T::of(90.0));
            let scale = self.scale(Split::sum(middle, T::ZERO));
            let (sin, cos) = sin_cos_degrees(convergence);
            lat = within(distance * ((cos1 * cos - sin1 * sin) / scale.north), half_circle);
            lon = within(distance * ((sin1 * cos + cos1 * sin) / scale.east), half_circle);
            convergence = half * lon * scale.sin;
        }
        let lat = from.lat() + lat;
        // Over a pole and down the other side.
        let over = lat.abs() > T::of(90.0);
        let turn = select(over, half_circle, T::ZERO);
        let azimuth = atan2_degrees(sin1, cos1) + (convergence + convergence);
        Ok(Direct {
            position: LatLon::within(
                select(over, half_circle.copysign(lat) - lat, lat),
                wrapped(wrapped(from.lon() + lon) + turn),
            ),
            azimuth: wrapped(wrapped(azimuth) + turn),
        })
    }
}
