use super::azimuthal_equidistant::along;
use super::{NotOnMap, OutsideMap};
use crate::geodesic::Karney;
use crate::latitude::UnsupportedFlattening;
use crate::math::{atan, atan2_degrees, hypot};
use crate::{Ellipsoid, LatLon, Real};

/// The ellipsoidal gnomonic projection about a centre: geodesics are very nearly straight, and those through the
/// centre exactly.
///
/// x is to the east and y to the north, in metres. A place at a distance with the reduced length m and the
/// geodesic scale M is m/M from the centre. A geodesic of length r between points at most r from the centre
/// leaves the straight line by at most f r³/(8 R²) on a map of the Earth: 1.7 m for 1000 km.
///
/// The worst error on the Earth, as seen on the ground, is 15 nm (`f32`: 7 m), places up to 60° from the centre.
///
/// C. F. F. Karney, *Algorithms for geodesics*, J. Geodesy 87 (2013), section 8.
///
/// ```
/// use terrella::grid::Gnomonic;
/// use terrella::{Ellipsoid, LatLon};
/// let paris = Gnomonic::new(Ellipsoid::WGS84, LatLon::new(48.0 + 50.0 / 60.0, 2.0 + 20.0 / 60.0)?)?;
/// let [x, y] = paris.forward(LatLon::new(50.9_f64, 1.8)?)?;
/// assert_eq!(format!("{x:.3} {y:.3}"), "-37543.670 230103.214");
/// let calais = paris.inverse([x, y])?;
/// assert!((calais.lat() - 50.9).abs() < 1e-12);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Gnomonic<T> {
    karney: Karney<T>,
    a: T,
    centre: LatLon<T>,
}

impl<T: Real> Gnomonic<T> {
    /// Makes the projection of an ellipsoid about a centre.
    ///
    /// # Errors
    /// [`UnsupportedFlattening`] unless −1/9 ≤ f ≤ 1/10.
    pub fn new(ellipsoid: Ellipsoid<T>, centre: LatLon<T>) -> Result<Self, UnsupportedFlattening<T>> {
        Karney::new(ellipsoid).map(|karney| Self {
            karney,
            a: ellipsoid.a(),
            centre,
        })
    }

    /// Returns the centre.
    #[must_use]
    pub fn centre(&self) -> LatLon<T> {
        self.centre
    }

    /// Projects a place: x to the east and y to the north in metres.
    ///
    /// # Errors
    /// [`NotOnMap`] if the place is beyond the horizon, where M ≤ 0: about 90° and more from the centre.
    pub fn forward(&self, place: LatLon<T>) -> Result<[T; 2], NotOnMap<T>> {
        let way = self.karney.solve(self.centre, place);
        if way.scale12 > T::ZERO {
            Ok(along(way.inverse.azimuth1, way.reduced_length / way.scale12))
        } else {
            Err(NotOnMap(place))
        }
    }

    /// Returns the place of a point, by Newton's method for the distance.
    ///
    /// # Errors
    /// [`OutsideMap`] if x or y is infinite or NaN, or the iteration does not converge, which is next to the
    /// horizon: from some 10⁸ metres in `f64`, some 10⁷ in `f32`.
    pub fn inverse(&self, [x, y]: [T; 2]) -> Result<LatLon<T>, OutsideMap<T>> {
        let refused = OutsideMap { x, y };
        let rho = hypot(x, y);
        let line = self
            .karney
            .line(self.centre, atan2_degrees(x, y))
            .map_err(|_| refused)?;
        if !rho.is_finite() {
            return Err(refused);
        }
        // m/M = ρ where ρ is small, otherwise M/m = 1/ρ: dm/ds = M₂₁, (m/M)′ = 1/M², (M/m)′ = −1/m².
        let small = rho <= self.a;
        let mut s = self.a * atan(rho / self.a);
        let mut last = false;
        for _ in 0..STEPS {
            let point = line.at(s).map_err(|_| refused)?;
            if last {
                return Ok(point.position);
            }
            let (m, scale) = (point.reduced_length, point.scale12);
            let step = if small {
                (m / scale - rho) * scale * scale
            } else {
                (T::ONE / rho - scale / m) * m * m
            };
            s -= step;
            // The next step would be below rounding.
            last = step.abs() < T::pick(1e-8, 1e-3) * self.a;
        }
        Err(refused)
    }
}

/// Newton's method doubles the digits: five steps are the most that were seen.
const STEPS: usize = 12;
