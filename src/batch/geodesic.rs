//! Computes distances, azimuths and destinations by any [`Geodesic`] method, your own included.

use core::fmt;

use super::InvalidBatch;
use super::engine::solve;
use super::position::Places;
use crate::geodesic::{Geodesic, GeodesicError};
use crate::simd::{Door, Element};
use crate::{InvalidLatLon, LatLon, Real};

/// Why an element of a geodesic problem was refused.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum InvalidProblem<T> {
    /// [`LatLon::new`] refuses the latitude or longitude.
    LatLon(InvalidLatLon<T>),
    /// The method refuses the problem.
    Geodesic(GeodesicError<T>),
}

impl<T: fmt::Debug + fmt::Display> fmt::Display for InvalidProblem<T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::LatLon(why) => why.fmt(f),
            Self::Geodesic(why) => why.fmt(f),
        }
    }
}

impl<T: fmt::Debug + fmt::Display> core::error::Error for InvalidProblem<T> {}

/// From latitude, longitude, latitude, longitude to distance and azimuths.
struct Inverse<'a, M>(&'a M);

/// From latitude, longitude, azimuth, distance to latitude, longitude, azimuth.
struct Direct<'a, M>(&'a M);

impl<M> Clone for Inverse<'_, M> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<M> Copy for Inverse<'_, M> {}

impl<M> Clone for Direct<'_, M> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<M> Copy for Direct<'_, M> {}

fn place<T: Real>(lat: T, lon: T) -> Result<LatLon<T>, InvalidProblem<T>> {
    LatLon::new(lat, lon).map_err(InvalidProblem::LatLon)
}

impl<T: Real, M: Geodesic<T>> Element<[T; 4]> for Inverse<'_, M> {
    type Output = [T; 3];
    type Error = InvalidProblem<T>;

    #[inline(always)]
    fn keeps(&self, [lat1, lon1, lat2, lon2]: [T; 4]) -> bool {
        Places.keeps([lat1, lon1]) & Places.keeps([lat2, lon2])
    }

    #[inline(always)]
    fn mend(&self, [lat1, lon1, lat2, lon2]: [T; 4]) -> [T; 4] {
        [lat1, LatLon::turned(lon1), lat2, LatLon::turned(lon2)]
    }

    #[inline(always)]
    fn fast(&self, [lat1, lon1, lat2, lon2]: [T; 4]) -> ([T; 3], bool) {
        let (line, found) = self
            .0
            .fast_inverse(LatLon::within(lat1, lon1), LatLon::within(lat2, lon2));
        ([line.distance, line.azimuth1, line.azimuth2], found)
    }

    fn one(&self, [lat1, lon1, lat2, lon2]: [T; 4]) -> Result<[T; 3], InvalidProblem<T>> {
        let (from, to) = (place(lat1, lon1)?, place(lat2, lon2)?);
        let line = self.0.inverse(from, to).map_err(InvalidProblem::Geodesic)?;
        Ok([line.distance, line.azimuth1, line.azimuth2])
    }
}

impl<T: Real, M: Geodesic<T>> Element<[T; 4]> for Direct<'_, M> {
    type Output = [T; 3];
    type Error = InvalidProblem<T>;

    #[inline(always)]
    fn keeps(&self, [lat, lon, azimuth, distance]: [T; 4]) -> bool {
        Places.keeps([lat, lon]) & azimuth.is_finite() & distance.is_finite()
    }

    #[inline(always)]
    fn mend(&self, [lat, lon, azimuth, distance]: [T; 4]) -> [T; 4] {
        [lat, LatLon::turned(lon), azimuth, distance]
    }

    #[inline(always)]
    fn fast(&self, [lat, lon, azimuth, distance]: [T; 4]) -> ([T; 3], bool) {
        let (end, found) = self.0.fast_direct(LatLon::within(lat, lon), azimuth, distance);
        ([end.position.lat(), end.position.lon(), end.azimuth], found)
    }

    fn one(&self, [lat, lon, azimuth, distance]: [T; 4]) -> Result<[T; 3], InvalidProblem<T>> {
        let end = self.0.direct(place(lat, lon)?, azimuth, distance);
        let end = end.map_err(InvalidProblem::Geodesic)?;
        Ok([end.position.lat(), end.position.lon(), end.azimuth])
    }
}

/// Solves the inverse problem for pairs of places: latitudes and longitudes in degrees to distances in metres
/// and azimuths at both places in degrees, with the bits of [`Geodesic::inverse`].
///
/// The fastest methods in a batch are those that override [`Geodesic::fast_inverse`] or are without branches:
/// [`Karney`](crate::geodesic::Karney), [`Vincenty`](crate::geodesic::Vincenty) and the closed formulas.
/// Pairs without a fast answer, most of them nearly antipodal, are solved one by one.
///
/// # Errors
/// [`InvalidBatch`] if slices have unequal lengths (nothing is written), if [`LatLon::new`] refuses a place, or
/// if the method has no answer for a pair, as [`Vincenty`](crate::geodesic::Vincenty) near the antipode (the
/// results of such pairs are NaN, all others are written).
///
/// ```
/// use terrella::{Ellipsoid, batch::geodesic, geodesic::Karney};
/// let earth = Karney::new(Ellipsoid::WGS84)?;
/// let (mut distance, mut there, mut back) = ([0.0; 2], [0.0; 2], [0.0; 2]);
/// let from: [&[f64]; 2] = [&[0.0, 40.6], &[0.0, -73.8]];
/// let to: [&[f64]; 2] = [&[0.0, 51.6], &[1.0, -0.5]];
/// geodesic::inverse(&earth, from, to, [&mut distance, &mut there, &mut back])?;
/// assert_eq!(distance.map(|d| d.round()), [111_319.0, 5_551_759.0]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn inverse<T: Real, M: Geodesic<T>>(
    method: &M,
    from: [&[T]; 2],
    to: [&[T]; 2],
    lines: [&mut [T]; 3],
) -> Result<(), InvalidBatch<InvalidProblem<T>>> {
    let ([lat1, lon1], [lat2, lon2]) = (from, to);
    solve(Inverse(method), [lat1, lon1, lat2, lon2], lines)
}

/// Solves the direct problem for places: latitudes, longitudes and azimuths in degrees and distances in
/// metres to latitudes, longitudes and azimuths of the destinations in degrees, with the bits of
/// [`Geodesic::direct`].
///
/// # Errors
/// [`InvalidBatch`] if slices have unequal lengths, or [`LatLon::new`] or the method refuses an element.
///
/// ```
/// use terrella::{Ellipsoid, batch::geodesic, geodesic::Karney};
/// let earth = Karney::new(Ellipsoid::WGS84)?;
/// let (mut lat, mut lon, mut azimuth) = ([0.0_f64], [0.0_f64], [0.0]);
/// geodesic::direct(&earth, [&[40.6], &[-73.8]], &[53.5], &[5.85e6], [&mut lat, &mut lon, &mut azimuth])?;
/// assert!((lat[0] - 49.0).abs() < 0.1 && (lon[0] - 2.5).abs() < 0.1);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn direct<T: Real, M: Geodesic<T>>(
    method: &M,
    from: [&[T]; 2],
    azimuth: &[T],
    distance: &[T],
    ends: [&mut [T]; 3],
) -> Result<(), InvalidBatch<InvalidProblem<T>>> {
    let [lat, lon] = from;
    solve(Direct(method), [lat, lon, azimuth, distance], ends)
}
