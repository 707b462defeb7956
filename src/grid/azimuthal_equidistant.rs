use super::OutsideMap;
use crate::geodesic::{Geodesic, Karney};
use crate::latitude::UnsupportedFlattening;
use crate::math::{atan2_degrees, hypot, sin_cos_degrees};
use crate::{Ellipsoid, LatLon, Real};

/// The azimuthal equidistant projection of the ellipsoid about a centre: distances and azimuths from the centre
/// are those of geodesics.
///
/// x is to the east and y to the north, in metres. Errors are those of [`Karney`]: on the Earth 15 nm (`f32`:
/// 7 m) and less within some thousand kilometres.
///
/// ```
/// use terrella::grid::AzimuthalEquidistant;
/// use terrella::{Ellipsoid, LatLon};
/// let paris = AzimuthalEquidistant::new(Ellipsoid::WGS84, LatLon::new(48.0 + 50.0 / 60.0, 2.0 + 20.0 / 60.0)?)?;
/// let [x, y] = paris.forward(LatLon::new(50.9_f64, 1.8)?);
/// assert_eq!(format!("{x:.3} {y:.3}"), "-37526.978 230000.912");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[doc(alias = "aeqd")]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct AzimuthalEquidistant<T> {
    karney: Karney<T>,
    centre: LatLon<T>,
}

impl<T: Real> AzimuthalEquidistant<T> {
    /// Makes the projection of an ellipsoid about a centre.
    ///
    /// # Errors
    /// [`UnsupportedFlattening`] unless −1/9 ≤ f ≤ 1/10.
    pub fn new(ellipsoid: Ellipsoid<T>, centre: LatLon<T>) -> Result<Self, UnsupportedFlattening<T>> {
        Karney::new(ellipsoid).map(|karney| Self { karney, centre })
    }

    /// Returns the centre.
    #[must_use]
    pub fn centre(&self) -> LatLon<T> {
        self.centre
    }

    /// Projects a place: x to the east and y to the north in metres. Places that have several shortest lines to
    /// the centre get the point of one.
    #[must_use]
    pub fn forward(&self, place: LatLon<T>) -> [T; 2] {
        let line = self.karney.way(self.centre, place);
        along(line.azimuth1, line.distance)
    }

    /// Returns the place of a point: the end of the geodesic with that azimuth and length.
    ///
    /// # Errors
    /// [`OutsideMap`] if x or y is infinite or NaN, or the distance is one that [`Karney`] refuses.
    pub fn inverse(&self, [x, y]: [T; 2]) -> Result<LatLon<T>, OutsideMap<T>> {
        let end = self.karney.direct(self.centre, atan2_degrees(x, y), hypot(x, y));
        end.map(|end| end.position).map_err(|_| OutsideMap { x, y })
    }
}

/// The point at a distance in a direction.
pub(super) fn along<T: Real>(azimuth: T, distance: T) -> [T; 2] {
    let (sin, cos) = sin_cos_degrees(azimuth);
    [distance * sin, distance * cos]
}
