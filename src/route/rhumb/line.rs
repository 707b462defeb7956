use super::{Rhumb, RhumbEnd};
use crate::geodesic::GeodesicError;
use crate::math::{atan2_degrees, hypot};
use crate::{LatLon, Real};

/// A rhumb line from a place: for points along it.
///
/// [`Rhumb::line`] makes one from an azimuth, [`Rhumb::line_between`] from one place to another. Points are
/// as exact as those of [`Rhumb::direct`]. The line between two places keeps its azimuth by sine and cosine,
/// and so reaches the second one within a few roundings.
///
/// ```
/// use terrella::route::Rhumb;
/// use terrella::{Ellipsoid, LatLon};
/// let earth = Rhumb::new(Ellipsoid::WGS84)?;
/// let (honolulu, yokohama) = (LatLon::new(21.3_f64, -157.9)?, LatLon::new(35.4, 139.7)?);
/// let line = earth.line_between(honolulu, yokohama);
/// // The longitude runs on over −180.
/// assert!((line.at(line.length())?.longitude - -220.3).abs() < 1e-12);
/// let middle = line.at(0.5 * line.length())?;
/// assert!((middle.position.lat() - 28.353_6).abs() < 1e-4);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct RhumbLine<T> {
    rhumb: Rhumb<T>,
    from: LatLon<T>,
    heading: (T, T),
    length: T,
}

impl<T: Real> RhumbLine<T> {
    /// The line by the sine and cosine of its azimuth.
    pub(super) fn new(rhumb: Rhumb<T>, from: LatLon<T>, heading: (T, T)) -> Self {
        Self {
            rhumb,
            from,
            heading,
            length: T::ZERO,
        }
    }

    /// The line to a place so many metres along it east and north.
    pub(super) fn between(rhumb: Rhumb<T>, from: LatLon<T>, [east, north]: [T; 2]) -> Self {
        let length = hypot(east, north);
        let heading = if length > T::ZERO {
            (east / length, north / length)
        } else {
            (T::ZERO, T::ONE)
        };
        Self {
            rhumb,
            from,
            heading,
            length,
        }
    }

    /// Returns the place from which the line starts.
    #[must_use]
    pub fn start(&self) -> LatLon<T> {
        self.from
    }

    /// Returns the azimuth in degrees clockwise from north, in [−180, 180].
    #[must_use]
    pub fn azimuth(&self) -> T {
        let (sin, cos) = self.heading;
        atan2_degrees(sin, cos)
    }

    /// Returns the distance in metres between the two places that made the line; 0 of a line by its azimuth.
    #[must_use]
    pub fn length(&self) -> T {
        self.length
    }

    /// Returns the point at a distance in metres from the start; a negative distance lies behind it.
    ///
    /// # Errors
    /// Those of [`Rhumb::direct`].
    pub fn at(&self, distance: T) -> Result<RhumbEnd<T>, GeodesicError<T>> {
        self.rhumb.along(self.from, self.heading, distance)
    }
}
