//! Computes distances, azimuths and destinations by any [`Geodesic`] method, your own included.

use core::fmt;

mod line;
mod track;

pub use line::{along, direct_from, intermediate};
pub use track::{leg_tracks, tracks};

use super::InvalidBatch;
use super::engine::solve;
use super::position::{Pairs, Places};
use crate::geodesic::{Geodesic, GeodesicError, GeodesicTask};
use crate::simd::{Door, Element, Same, Sink, Source};
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

/// Two places in degrees.
type Pair<T> = ([T; 2], [T; 2]);

/// From two places to distance and azimuths.
struct Inverse<'a, M>(&'a M);

/// From two places to their distance. What computes the azimuths is left out by the compiler.
struct Distance<'a, M>(&'a M);

/// Latitude, longitude and azimuth of a start, and a distance.
type Way<T> = ([T; 3], [T; 1]);

/// From latitude, longitude, azimuth, distance to latitude, longitude, azimuth.
struct Direct<'a, M>(&'a M);

macro_rules! copy {
    ($($name:ident)*) => {$(
        impl<M> Clone for $name<'_, M> {
            fn clone(&self) -> Self {
                *self
            }
        }

        impl<M> Copy for $name<'_, M> {}
    )*};
}
copy!(Inverse Distance Direct);

fn place<T: Real>([lat, lon]: [T; 2]) -> Result<LatLon<T>, InvalidProblem<T>> {
    LatLon::new(lat, lon).map_err(InvalidProblem::LatLon)
}

impl<T: Real> Same<[T; 2]> {
    /// A place, as often as there are others.
    fn of(place: LatLon<T>, others: [&[T]; 2]) -> Self {
        Self::new([place.lat(), place.lon()], Source::len(&others))
    }
}

#[inline(always)]
fn within<T: Real>([lat, lon]: [T; 2]) -> LatLon<T> {
    LatLon::within(lat, lon)
}

/// Each place of a path and the next.
pub(super) fn path_legs<T>(path: [&[T]; 2]) -> ([&[T]; 2], [&[T]; 2]) {
    let from = path.map(|column| column.split_last().map_or(column, |(_, rest)| rest));
    let to = path.map(|column| column.split_first().map_or(column, |(_, rest)| rest));
    (from, to)
}

impl<T: Real, M: Geodesic<T>> Element<Pair<T>> for Inverse<'_, M> {
    type Output = [T; 3];
    type Error = InvalidProblem<T>;

    const SECOND: bool = true;

    #[inline(always)]
    fn keeps(&self, pair: Pair<T>) -> bool {
        Pairs.keeps(pair)
    }

    #[inline(always)]
    fn mend(&self, pair: Pair<T>) -> Pair<T> {
        Pairs.mend(pair)
    }

    #[inline(always)]
    fn fast(&self, (from, to): Pair<T>) -> ([T; 3], bool) {
        let (line, found) = self.0.fast_inverse(within(from), within(to));
        ([line.distance, line.azimuth1, line.azimuth2], found)
    }

    #[inline(always)]
    fn second(&self, (from, to): Pair<T>) -> ([T; 3], bool) {
        let (line, found) = self.0.far_inverse(within(from), within(to));
        ([line.distance, line.azimuth1, line.azimuth2], found)
    }

    fn one(&self, (from, to): Pair<T>) -> Result<[T; 3], InvalidProblem<T>> {
        let line = self.0.inverse(place(from)?, place(to)?);
        let line = line.map_err(InvalidProblem::Geodesic)?;
        Ok([line.distance, line.azimuth1, line.azimuth2])
    }
}

impl<T: Real, M: Geodesic<T>> Element<Pair<T>> for Distance<'_, M> {
    type Output = [T; 1];
    type Error = InvalidProblem<T>;

    const FINISHES: bool = true;
    const SECOND: bool = true;

    #[inline(always)]
    fn keeps(&self, pair: Pair<T>) -> bool {
        Pairs.keeps(pair)
    }

    #[inline(always)]
    fn mend(&self, pair: Pair<T>) -> Pair<T> {
        Pairs.mend(pair)
    }

    #[inline(always)]
    fn fast(&self, pair: Pair<T>) -> ([T; 1], bool) {
        let (from, to) = pair;
        let (distance, found) = self.0.fast_distance(within(from), within(to));
        ([distance], found)
    }

    #[inline(always)]
    fn finish(&self, [distance]: [T; 1]) -> [T; 1] {
        [self.0.finish_distance(distance)]
    }

    #[inline(always)]
    fn second(&self, pair: Pair<T>) -> ([T; 1], bool) {
        let ([distance, ..], found) = Inverse(self.0).second(pair);
        ([distance], found)
    }

    fn one(&self, (from, to): Pair<T>) -> Result<[T; 1], InvalidProblem<T>> {
        let distance = self.0.distance(place(from)?, place(to)?);
        distance.map(|distance| [distance]).map_err(InvalidProblem::Geodesic)
    }
}

impl<T: Real, M: Geodesic<T>> Element<Way<T>> for Direct<'_, M> {
    type Output = [T; 3];
    type Error = InvalidProblem<T>;

    #[inline(always)]
    fn keeps(&self, ([lat, lon, azimuth], [distance]): Way<T>) -> bool {
        Places.keeps([lat, lon]) & azimuth.is_finite() & distance.is_finite()
    }

    #[inline(always)]
    fn mend(&self, ([lat, lon, azimuth], distance): Way<T>) -> Way<T> {
        ([lat, LatLon::turned(lon), azimuth], distance)
    }

    #[inline(always)]
    fn fast(&self, ([lat, lon, azimuth], [distance]): Way<T>) -> ([T; 3], bool) {
        let (end, found) = self.0.fast_direct(LatLon::within(lat, lon), azimuth, distance);
        ([end.position.lat(), end.position.lon(), end.azimuth], found)
    }

    fn one(&self, ([lat, lon, azimuth], [distance]): Way<T>) -> Result<[T; 3], InvalidProblem<T>> {
        let end = self.0.direct(place([lat, lon])?, azimuth, distance);
        let end = end.map_err(InvalidProblem::Geodesic)?;
        Ok([end.position.lat(), end.position.lon(), end.azimuth])
    }
}

/// Inverse problems for a known method.
struct Inverses<S, D>(S, D);

impl<T: Real, S: Source<Row = Pair<T>>, D: Sink<Row = [T; 3]>> GeodesicTask<T> for Inverses<S, D> {
    type Output = Result<(), InvalidBatch<InvalidProblem<T>>>;

    fn run<M: Geodesic<T>>(self, method: &M) -> Self::Output {
        solve(Inverse(method), self.0, self.1)
    }
}

/// Distances by a known method.
struct Distances<S, D>(S, D);

impl<T: Real, S: Source<Row = Pair<T>>, D: Sink<Row = [T; 1]>> GeodesicTask<T> for Distances<S, D> {
    type Output = Result<(), InvalidBatch<InvalidProblem<T>>>;

    fn run<M: Geodesic<T>>(self, method: &M) -> Self::Output {
        solve(Distance(method), self.0, self.1)
    }
}

/// Direct problems for a known method.
struct Directs<S, D>(S, D);

impl<T: Real, S: Source<Row = Way<T>>, D: Sink<Row = [T; 3]>> GeodesicTask<T> for Directs<S, D> {
    type Output = Result<(), InvalidBatch<InvalidProblem<T>>>;

    fn run<M: Geodesic<T>>(self, method: &M) -> Self::Output {
        solve(Direct(method), self.0, self.1)
    }
}

/// Solves the inverse problem for pairs of places: latitudes and longitudes in degrees to distances in metres
/// and azimuths at both places in degrees, with the bits of [`Geodesic::inverse`].
///
/// All methods of this crate go through lanes, and your own does if it overrides [`Geodesic::fast_inverse`].
/// Pairs without a fast answer, most of them nearly antipodal, are solved one by one.
///
/// # Errors
/// [`InvalidBatch`] if slices have unequal lengths, if [`LatLon::new`] refuses a place, or if the method has no
/// answer for a pair, as [`Vincenty`](crate::geodesic::Vincenty) near the antipode.
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
    method.with(Inverses((from, to), lines))
}

/// Solves the inverse problem from one place to many: as [`inverse`] does, without a copy of the place for
/// each.
///
/// # Errors
/// Those of [`inverse`].
///
/// ```
/// use terrella::{LatLon, batch::geodesic, geodesic::GreatCircle};
/// let sphere = GreatCircle::new(6_371_000.0)?;
/// let oslo = LatLon::new(59.91, 10.75)?;
/// let (mut distance, mut there, mut back) = ([0.0; 2], [0.0; 2], [0.0; 2]);
/// geodesic::inverse_from(&sphere, oslo, [&[90.0, 59.91], &[10.75, 10.75]], [&mut distance, &mut there, &mut back])?;
/// assert_eq!((there[0], distance[1]), (0.0, 0.0));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn inverse_from<T: Real, M: Geodesic<T>>(
    method: &M,
    from: LatLon<T>,
    to: [&[T]; 2],
    lines: [&mut [T]; 3],
) -> Result<(), InvalidBatch<InvalidProblem<T>>> {
    method.with(Inverses((Same::of(from, to), to), lines))
}

/// Solves the inverse problem from many places to one: as [`inverse`] does, without a copy of the place for
/// each.
///
/// # Errors
/// Those of [`inverse`].
///
/// ```
/// use terrella::{LatLon, batch::geodesic, geodesic::GreatCircle};
/// let sphere = GreatCircle::new(6_371_000.0)?;
/// let pole = LatLon::new(90.0, 0.0)?;
/// let (mut distance, mut there, mut back) = ([0.0; 2], [0.0; 2], [0.0; 2]);
/// geodesic::inverse_to(&sphere, [&[0.0, 45.0], &[0.0, 90.0]], pole, [&mut distance, &mut there, &mut back])?;
/// assert_eq!((distance[0], there), (2.0 * distance[1], [0.0, 0.0]));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn inverse_to<T: Real, M: Geodesic<T>>(
    method: &M,
    from: [&[T]; 2],
    to: LatLon<T>,
    lines: [&mut [T]; 3],
) -> Result<(), InvalidBatch<InvalidProblem<T>>> {
    method.with(Inverses((from, Same::of(to, from)), lines))
}

/// Computes the distances in metres between pairs of places in degrees, with the bits of
/// [`Geodesic::distance`], and no azimuths.
///
/// # Errors
/// Those of [`inverse`].
///
/// ```
/// use terrella::{batch::geodesic, geodesic::GreatCircle};
/// let sphere = GreatCircle::new(6_371_000.0)?;
/// let mut distance = [0.0_f64; 2];
/// let (from, to): ([&[f64]; 2], [&[f64]; 2]) = ([&[0.0, 90.0], &[0.0, 0.0]], [&[0.0, -90.0], &[90.0, 0.0]]);
/// geodesic::distance(&sphere, from, to, &mut distance)?;
/// assert_eq!(distance.map(f64::round), [10_007_543.0, 20_015_087.0]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[doc(alias = "haversine")]
pub fn distance<T: Real, M: Geodesic<T>>(
    method: &M,
    from: [&[T]; 2],
    to: [&[T]; 2],
    distances: &mut [T],
) -> Result<(), InvalidBatch<InvalidProblem<T>>> {
    method.with(Distances((from, to), [distances]))
}

/// Computes the distances in metres from one place to many, as [`distance`] does.
///
/// # Errors
/// Those of [`inverse`].
///
/// ```
/// use terrella::{LatLon, batch::geodesic, geodesic::GreatCircle};
/// let (sphere, pole) = (GreatCircle::new(1.0)?, LatLon::new(90.0, 0.0)?);
/// let mut distance = [0.0_f64; 2];
/// geodesic::distance_from(&sphere, pole, [&[0.0, -90.0], &[10.0, 20.0]], &mut distance)?;
/// assert_eq!(distance, [core::f64::consts::FRAC_PI_2, core::f64::consts::PI]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn distance_from<T: Real, M: Geodesic<T>>(
    method: &M,
    from: LatLon<T>,
    to: [&[T]; 2],
    distances: &mut [T],
) -> Result<(), InvalidBatch<InvalidProblem<T>>> {
    method.with(Distances((Same::of(from, to), to), [distances]))
}

/// Computes the distances in metres from many places to one, as [`distance`] does.
///
/// # Errors
/// Those of [`inverse`].
///
/// ```
/// use terrella::{LatLon, batch::geodesic, geodesic::GreatCircle};
/// let (sphere, pole) = (GreatCircle::new(1.0)?, LatLon::new(90.0, 0.0)?);
/// let mut distance = [0.0_f64];
/// geodesic::distance_to(&sphere, [&[0.0], &[10.0]], pole, &mut distance)?;
/// assert_eq!(distance, [core::f64::consts::FRAC_PI_2]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn distance_to<T: Real, M: Geodesic<T>>(
    method: &M,
    from: [&[T]; 2],
    to: LatLon<T>,
    distances: &mut [T],
) -> Result<(), InvalidBatch<InvalidProblem<T>>> {
    method.with(Distances((from, Same::of(to, from)), [distances]))
}

/// Computes the lengths in metres of the legs of a path: the distance from each place to the next, as
/// [`distance`] does. There is one leg less than places.
///
/// # Errors
/// Those of [`inverse`]; an element is a leg. A place that is refused spoils two legs.
///
/// ```
/// use terrella::{batch::geodesic, geodesic::GreatCircle};
/// let sphere = GreatCircle::new(1.0)?;
/// let mut legs = [0.0_f64; 2];
/// geodesic::legs(&sphere, [&[0.0, 90.0, 0.0], &[0.0, 0.0, 90.0]], &mut legs)?;
/// assert!(legs.iter().all(|leg| (leg - core::f64::consts::FRAC_PI_2).abs() < 4e-16));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[doc(alias = "path length")]
pub fn legs<T: Real, M: Geodesic<T>>(
    method: &M,
    places: [&[T]; 2],
    distances: &mut [T],
) -> Result<(), InvalidBatch<InvalidProblem<T>>> {
    method.with(Distances(path_legs(places), [distances]))
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
    method.with(Directs(([lat, lon, azimuth], [distance]), ends))
}
