use super::auxiliary::nearly_round;
use super::karney::Series;
use super::ordinary::Ordinary;
use super::{Direct, Geodesic, GeodesicError, Inverse, Straight};
use crate::latitude::UnsupportedFlattening;
use crate::{Ellipsoid, LatLon, Real};

/// Vincenty's formulas (1975), with longer series and with Newton's steps for his iteration: nothing is lost near the antipode.
///
/// T. Vincenty, "Direct and inverse solutions of geodesics on the ellipsoid with application of nested equations", Survey Review 23.
/// The equations are his, the series those in Helmert's ε (k₁ in his later notes), longer: C. F. F. Karney,
/// "Algorithms for geodesics", J. Geodesy 87 (2013), equations 17, 18, 24 and 25.
///
/// His iteration λ ← L + f sin α ∫… fails near the antipode, where a small change of λ turns the azimuth. Here λ follows from Newton's steps on
/// the same equation, told from the supplements of λ and L where the ends are 170° apart or more; in `f64` all but the last of the others with
/// short series.
///
/// | worst error, up to the antipode | `f64` | `f32` |
/// |---|---|---|
/// | distance, azimuths × reduced length, position of lines to 20 000 km, \|f\| ≤ 1/150 | 2.0e-8 m | 7 m, 7e-7 of the distance |
/// | all of them, \|f\| ≤ 1/60 | 1.0e-6 m | 8 m |
///
/// A longer line, of several circuits, adds 2e-16 (1e-7) of its length and as much of the series' error as it is longer.
///
/// Three evaluations are usual (`f32`: two), and 40 allowed. An inverse is never wrong: what does not close is
/// [`GeodesicError::NotConverged`]. No pair of places is known for which that happens, in `f64` or in `f32`; 10⁷ of the hardest were tried.
///
/// Coincident places: distance 0, azimuths 0. A distance below 10⁻¹⁴³ m (10⁻¹² m) may be 0, too. At a pole an azimuth counts from the
/// meridian of the given longitude. Of several shortest lines one is taken.
///
/// ```
/// use terrella::geodesic::{Geodesic, Vincenty};
/// use terrella::{Ellipsoid, LatLon};
/// let earth = Vincenty::new(Ellipsoid::<f64>::wgs84())?;
/// let (from, to) = (LatLon::new(0.0, 0.0)?, LatLon::new(0.5, 179.7)?);
/// let way = earth.inverse(from, to)?;
/// assert_eq!(format!("{:.4} {:.8}", way.distance, way.azimuth1), "19944127.4208 15.55688279");
/// let there = earth.direct(from, way.azimuth1, way.distance)?.position;
/// assert!((there.lat() - to.lat()).abs() < 1e-13 && (there.lon() - to.lon()).abs() < 1e-12);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Vincenty<T> {
    ordinary: Ordinary<T>,
}

impl<T: Real> Vincenty<T> {
    /// For an ellipsoid.
    ///
    /// # Errors
    /// [`UnsupportedFlattening`] if |f| > 1/60.
    pub fn new(ellipsoid: Ellipsoid<T>) -> Result<Self, UnsupportedFlattening<T>> {
        let ellipsoid = nearly_round(ellipsoid)?;
        Ok(Self {
            ordinary: Ordinary::new(ellipsoid, &Series::new(ellipsoid)),
        })
    }

    /// How often the longitude is evaluated between two places, or none if it does not converge: what they cost near the antipode.
    #[must_use]
    pub fn evaluations(&self, from: LatLon<T>, to: LatLon<T>) -> Option<usize> {
        self.ordinary.whole(from, to).map(|line| line.evaluations)
    }
}

impl<T: Real> Geodesic<T> for Vincenty<T> {
    #[inline]
    fn inverse(&self, from: LatLon<T>, to: LatLon<T>) -> Result<Inverse<T>, GeodesicError<T>> {
        let inverse = self.ordinary.inverse(from, to);
        inverse.ok_or(GeodesicError::NotConverged(from, to))
    }

    #[inline]
    fn direct(&self, from: LatLon<T>, azimuth: T, distance: T) -> Result<Direct<T>, GeodesicError<T>> {
        let (there, found) = self.ordinary.few_direct(from, azimuth, distance);
        if found {
            return Ok(there);
        }
        self.ordinary.direct(from, azimuth, distance)
    }
}

impl<T: Real> Straight<T> for Vincenty<T> {
    #[inline(always)]
    fn ordinary_inverse(&self, from: LatLon<T>, to: LatLon<T>) -> (Inverse<T>, bool) {
        self.ordinary.near_inverse(from, to)
    }

    #[inline(always)]
    fn ordinary_direct(&self, from: LatLon<T>, azimuth: T, distance: T) -> (Direct<T>, bool) {
        self.ordinary.few_direct(from, azimuth, distance)
    }

    #[inline(always)]
    fn reaches(&self, distance: T) -> bool {
        self.ordinary.reaches(distance)
    }
}
