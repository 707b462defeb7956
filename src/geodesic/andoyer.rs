use super::auxiliary::{Ends, Start, nearly_round};
use super::degrees::{heading, northward_between_poles, wrapped};
use super::{Direct, Geodesic, GeodesicError, Inverse};
use crate::latitude::UnsupportedFlattening;
use crate::math::sin_cos;
use crate::{Ellipsoid, LatLon, Real};

/// Andoyer and Lambert's correction: the great circle between the reduced latitudes, and the flattening to the first order. For
/// any distance, in closed form.
///
/// s = a(σ − f/2 cos²α (σ + sin σ cos 2σₘ)), in Vincenty's symbols; W. D. Lambert, "The distance between two widely
/// separated points on the surface of the Earth" (1942), where it is written with half angles. The azimuths are turned by
/// the longitude f σ sin α that the sphere lacks.
///
/// Worst error on the Earth at any latitude, in metres:
///
/// | distance | distance | azimuths × reduced length | position, direct |
/// |---|---|---|---|
/// | s ≤ 5000 km | 1.5e-6 s | 4e-6 s | 6e-6 s |
/// | 10 000 km | 15 | 45 | 40 |
/// | 15 000 km | 70 | 200 | 50 |
/// | 18 000 km | 280 | 600 | 40 |
/// | 19 000 km | 600 | 1300 | 40 |
/// | to the antipode | 3.5e4 | 2.2e5 | 40 |
/// | any number of times around | – | – | 1.5e-6 s |
///
/// On other ellipsoids it grows with f², and on a sphere it is that of [`GreatCircle`](super::GreatCircle). `f32` adds 7e-7 of the distance.
///
/// ```
/// use terrella::geodesic::{Andoyer, Geodesic};
/// use terrella::{Ellipsoid, LatLon};
/// let earth = Andoyer::new(Ellipsoid::<f64>::WGS84)?;
/// let way = earth.inverse(LatLon::new(59.91, 10.75)?, LatLon::new(-0.18, -78.47)?)?; // 9979.771 km
/// assert_eq!(format!("{:.1}", way.distance / 1e3), "9979.8");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Andoyer<T> {
    a: T,
    f: T,
    axes: T,
}

impl<T: Real> Andoyer<T> {
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
            f: ellipsoid.f(),
            axes: T::ONE - ellipsoid.f(),
        }
    }
}

impl<T: Real> Geodesic<T> for Andoyer<T> {
    /// Never an error.
    #[inline]
    fn inverse(&self, from: LatLon<T>, to: LatLon<T>) -> Result<Inverse<T>, GeodesicError<T>> {
        let ends = Ends::new(self.axes, from, to);
        let arc = ends.arc(ends.lon);
        let lacking = T::of(0.5) * self.f * arc.cos2_alpha * (arc.sigma + arc.sin_sigma * arc.cos_middle);
        let (azimuth1, azimuth2) = ends.azimuths_after(&arc, self.f * arc.sin_alpha * arc.sigma);
        let line = Inverse {
            distance: self.a * (arc.sigma - lacking),
            azimuth1,
            azimuth2,
        };
        Ok(northward_between_poles(from, to, line))
    }

    #[inline]
    fn direct(&self, from: LatLon<T>, azimuth: T, distance: T) -> Result<Direct<T>, GeodesicError<T>> {
        let start = Start::new(self.axes, from, heading(azimuth, distance)?);
        // With the λ reached s = a(σ(1 − f) + f/2 cos²α (σ − sin σ cos 2σₘ)); solved for σ to the first order.
        let half = T::of(0.5) * self.f * start.cos2_alpha;
        let radius = self.a * (self.axes + half);
        let whole = distance / radius;
        if !whole.is_finite() {
            return Err(GeodesicError::quotient(distance, radius));
        }
        let tau = whole.remainder(T::of(2.0 * core::f64::consts::PI));
        let turn = sin_cos(tau);
        let sigma = tau + half * turn.0 * start.cos_middle(turn);
        let end = start.end(self.axes, sin_cos(sigma));
        let shift = self.f * start.sin_alpha * (sigma + (whole - tau));
        let lon = end.lon - (shift * T::of(180.0 / core::f64::consts::PI)).remainder(T::of(360.0));
        Ok(Direct {
            position: LatLon::within(end.lat, wrapped(wrapped(lon) + from.lon())),
            azimuth: end.azimuth,
        })
    }
}
