//! Many points of one line.

use super::{Direct, Directs, InvalidProblem};
use crate::batch::InvalidBatch;
use crate::batch::engine::{refuse_all, solve};
use crate::geodesic::{Geodesic, GeodesicError, GeodesicTask, Line};
use crate::simd::{Element, Same};
use crate::{LatLon, Real};

/// From distances to latitude, longitude, azimuth.
#[derive(Clone, Copy)]
struct Points<T>(Line<T>);

impl<T: Real> Element<[T; 1]> for Points<T> {
    type Output = [T; 3];
    type Error = GeodesicError<T>;

    #[inline(always)]
    fn keeps(&self, [distance]: [T; 1]) -> bool {
        distance.is_finite()
    }

    #[inline(always)]
    fn fast(&self, [distance]: [T; 1]) -> ([T; 3], bool) {
        let (end, found) = self.0.fast_at(distance);
        ([end.position.lat(), end.position.lon(), end.azimuth], found)
    }

    fn one(&self, [distance]: [T; 1]) -> Result<[T; 3], GeodesicError<T>> {
        let point = self.0.at(distance)?;
        Ok([point.position.lat(), point.position.lon(), point.azimuth])
    }
}

/// Returns the points of a line at distances in metres from its start: latitudes, longitudes and azimuths of
/// travel in degrees, with the bits of [`Line::at`]. Negative distances lie behind the start.
///
/// # Errors
/// [`InvalidBatch`] if slices have unequal lengths, or [`Line::at`] refuses a distance.
///
/// ```
/// use terrella::{Ellipsoid, LatLon, batch::geodesic, geodesic::Karney};
/// let earth = Karney::new(Ellipsoid::WGS84)?;
/// let line = earth.line(LatLon::new(40.6, -73.8)?, 53.5)?;
/// let (mut lat, mut lon, mut azimuth) = ([0.0_f64; 3], [0.0; 3], [0.0; 3]);
/// geodesic::along(&line, &[0.0, 1e6, 2e6], [&mut lat, &mut lon, &mut azimuth])?;
/// assert!((lat[1] - 45.515_600).abs() < 1e-6);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn along<T: Real>(
    line: &Line<T>,
    distance: &[T],
    points: [&mut [T]; 3],
) -> Result<(), InvalidBatch<GeodesicError<T>>> {
    solve(Points(*line), [distance], points)
}

/// Solves the direct problem from one place at one azimuth in degrees to many distances in metres: as
/// [`direct`](super::direct) does, without a copy of the place and the azimuth for each. What depends on them
/// alone is computed once for 64 points.
///
/// # Errors
/// Those of [`direct`](super::direct).
///
/// ```
/// use terrella::{LatLon, batch::geodesic, geodesic::GreatCircle};
/// let sphere = GreatCircle::new(1.0)?;
/// let (mut lat, mut lon, mut azimuth) = ([0.0_f64; 2], [0.0; 2], [0.0; 2]);
/// let quarter = core::f64::consts::FRAC_PI_2;
/// let start = LatLon::new(0.0, 10.0)?;
/// geodesic::direct_from(&sphere, start, 90.0, &[quarter, -quarter], [&mut lat, &mut lon, &mut azimuth])?;
/// assert_eq!((lon, azimuth), ([100.0, -80.0], [90.0; 2]));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn direct_from<T: Real, M: Geodesic<T>>(
    method: &M,
    from: LatLon<T>,
    azimuth: T,
    distance: &[T],
    ends: [&mut [T]; 3],
) -> Result<(), InvalidBatch<InvalidProblem<T>>> {
    let start = Same::new([from.lat(), from.lon(), azimuth], distance.len());
    method.with(Directs((start, [distance]), ends))
}

/// From fractions of a line to latitude and longitude.
struct Parts<'a, T, M> {
    method: &'a M,
    from: LatLon<T>,
    azimuth: T,
    length: T,
}

impl<T: Copy, M> Clone for Parts<'_, T, M> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<T: Copy, M> Copy for Parts<'_, T, M> {}

impl<T: Real, M: Geodesic<T>> Element<[T; 1]> for Parts<'_, T, M> {
    type Output = [T; 2];
    type Error = GeodesicError<T>;

    #[inline(always)]
    fn keeps(&self, [fraction]: [T; 1]) -> bool {
        (self.length * fraction).is_finite()
    }

    #[inline(always)]
    fn fast(&self, [fraction]: [T; 1]) -> ([T; 2], bool) {
        let start = [self.from.lat(), self.from.lon(), self.azimuth];
        let ([lat, lon, _], found) = Direct(self.method).fast((start, [self.length * fraction]));
        ([lat, lon], found)
    }

    fn one(&self, [fraction]: [T; 1]) -> Result<[T; 2], GeodesicError<T>> {
        match self.method.direct(self.from, self.azimuth, self.length * fraction) {
            Ok(end) => Ok([end.position.lat(), end.position.lon()]),
            Err(GeodesicError::Distance(_)) => Err(GeodesicError::Fraction(fraction)),
            Err(why) => Err(why),
        }
    }
}

struct Intermediates<'a, T> {
    from: LatLon<T>,
    to: LatLon<T>,
    fractions: &'a [T],
    places: [&'a mut [T]; 2],
}

impl<T: Real> GeodesicTask<T> for Intermediates<'_, T> {
    type Output = Result<(), InvalidBatch<GeodesicError<T>>>;

    fn run<M: Geodesic<T>>(self, method: &M) -> Self::Output {
        let Self {
            from,
            to,
            fractions,
            places,
        } = self;
        let line = match method.inverse(from, to) {
            Ok(line) => line,
            Err(why) => return refuse_all([fractions], places, why),
        };
        let parts = Parts {
            method,
            from,
            azimuth: line.azimuth1,
            length: line.distance,
        };
        solve(parts, [fractions], places)
    }
}

/// Returns the places at fractions of the line between two places, as latitudes and longitudes in degrees:
/// waypoints of a route, or the points that make an edge denser. 0 is the first place, 1 the second; other
/// fractions lie beyond.
///
/// The bits are those of the [direct](Geodesic::direct) problem along
/// [`azimuth1`](crate::geodesic::Inverse::azimuth1), after that part of the
/// [distance](crate::geodesic::Inverse::distance): on a great circle those of
/// [`GreatCircle::intermediate`](crate::geodesic::GreatCircle::intermediate). At the fraction 1 the second
/// place is met to within the method's error. The inverse problem is solved once.
///
/// # Errors
/// [`InvalidBatch`] if slices have unequal lengths; if a fraction, or its product with the distance, is
/// infinite or NaN ([`GeodesicError::Fraction`]); and if the method refuses it. If the method has no line
/// between the places, all elements are refused.
///
/// ```
/// use terrella::{Ellipsoid, LatLon, batch::geodesic, geodesic::Karney};
/// let earth = Karney::new(Ellipsoid::<f64>::WGS84)?;
/// let (london, sydney) = (LatLon::new(51.47, -0.45)?, LatLon::new(-33.95, 151.18)?);
/// // Nine waypoints, evenly spaced.
/// let tenths: [f64; 9] = core::array::from_fn(|i| (i + 1) as f64 / 10.0);
/// let (mut lat, mut lon) = ([0.0; 9], [0.0; 9]);
/// geodesic::intermediate(&earth, london, sydney, &tenths, [&mut lat, &mut lon])?;
/// assert_eq!((lat[4].round(), lon[4].round()), (29.0, 105.0));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[doc(alias = "waypoints", alias = "densify", alias = "npts", alias = "interpolate")]
pub fn intermediate<T: Real, M: Geodesic<T>>(
    method: &M,
    from: LatLon<T>,
    to: LatLon<T>,
    fractions: &[T],
    places: [&mut [T]; 2],
) -> Result<(), InvalidBatch<GeodesicError<T>>> {
    method.with(Intermediates {
        from,
        to,
        fractions,
        places,
    })
}
