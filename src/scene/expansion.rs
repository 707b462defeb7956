use crate::math::sin_cos_degrees;
use crate::{Ellipsoid, Enu, Geodetic, LatLon, Real};

/// Converts positions to east, north and up of an origin by a Taylor series in latitude, longitude and
/// height: a dozen multiplications, no sine.
///
/// With ρ = (N + h) cos φ and μ = M + h at the origin, and with the differences Δφ, Δλ in radians and Δh in
/// metres:
///
/// | | first order | second order adds |
/// |---|---|---|
/// | east | ρ Δλ | −μ sin φ Δφ Δλ + cos φ Δλ Δh |
/// | north | μ Δφ | ½ρ sin φ Δλ² + ½M′ Δφ² + Δφ Δh |
/// | up | Δh | −½μ Δφ² − ½ρ cos φ Δλ² |
///
/// [`Scene::positions`](super::Scene::positions) states the errors.
///
/// ```
/// use terrella::scene::Expansion;
/// use terrella::{Ellipsoid, Geodetic, LatLon};
/// let field = Geodetic::new(LatLon::new(47.4_f32, 8.55)?, 430.0)?;
/// let about = Expansion::local(Ellipsoid::WGS84, field);
/// // Degrees north and east, and metres up, of the field.
/// let drone = Geodetic::new(LatLon::new(0.001, 0.002)?, 60.0)?;
/// let enu = about.second_order(drone);
/// assert!((enu.east - 150.982).abs() < 1e-3 && (enu.north - 111.189).abs() < 1e-3);
/// assert!((enu.up - 59.997).abs() < 1e-3);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Expansion<T> {
    origin: Geodetic<T>,
    rho: T,
    mu: T,
    sin: T,
    cos: T,
    /// M′, by latitude in radians.
    slope: T,
}

impl<T: Real> Expansion<T> {
    /// Creates the series about an origin.
    #[must_use]
    pub fn new(ellipsoid: Ellipsoid<T>, origin: Geodetic<T>) -> Self {
        Self {
            origin,
            ..Self::local(ellipsoid, origin)
        }
    }

    /// Creates the series about an origin, for positions that are given as degrees north and east, and metres
    /// up, of it.
    #[must_use]
    pub fn local(ellipsoid: Ellipsoid<T>, origin: Geodetic<T>) -> Self {
        let (sin, cos) = sin_cos_degrees(origin.lat());
        let e2 = ellipsoid.e2();
        let w2 = T::ONE - e2 * sin * sin;
        let n = ellipsoid.a() / w2.sqrt();
        let m = n * (T::ONE - e2) / w2;
        Self {
            origin: Geodetic::within(LatLon::within(T::ZERO, T::ZERO), T::ZERO),
            rho: (n + origin.height()) * cos,
            mu: m + origin.height(),
            sin,
            cos,
            slope: T::of(3.0) * m * e2 * sin * cos / w2,
        }
    }

    /// Δφ, Δλ in radians, Δh.
    #[inline(always)]
    fn difference(&self, position: Geodetic<T>) -> [T; 3] {
        let degree = T::of(core::f64::consts::PI / 180.0);
        let lon = crate::frame::turn(self.origin.lon(), position.lon());
        [
            (position.lat() - self.origin.lat()) * degree,
            lon * degree,
            position.height() - self.origin.height(),
        ]
    }

    /// Returns east, north and up in metres to the first order.
    #[must_use]
    #[inline(always)]
    pub fn first_order(&self, position: Geodetic<T>) -> Enu<T> {
        let [lat, lon, up] = self.difference(position);
        Enu {
            east: self.rho * lon,
            north: self.mu * lat,
            up,
        }
    }

    /// Returns east, north and up in metres to the second order.
    #[must_use]
    #[inline(always)]
    pub fn second_order(&self, position: Geodetic<T>) -> Enu<T> {
        let [lat, lon, up] = self.difference(position);
        let half = T::of(0.5);
        let bend = half * self.rho * lon * lon;
        Enu {
            east: lon * (self.rho - self.mu * self.sin * lat + self.cos * up),
            north: lat * (self.mu + half * self.slope * lat + up) + self.sin * bend,
            up: up - half * self.mu * lat * lat - self.cos * bend,
        }
    }
}
