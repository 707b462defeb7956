//! Distances, azimuths and destinations.

use core::fmt;

use super::InvalidBatch;
use super::admit::{Constructor, admit};
use crate::geodesic::{GeodesicError, Straight};
use crate::math::select;
use crate::simd::{BLOCK, Kernel, Sink, front, store, sweep};
use crate::{InvalidLatLon, LatLon, Real};

/// Why an element of a geodesic problem was refused.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum InvalidProblem<T> {
    /// By [`LatLon::new`].
    LatLon(InvalidLatLon<T>),
    /// By the method.
    Geodesic(GeodesicError<T>),
}

impl<T: fmt::Debug> fmt::Display for InvalidProblem<T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::LatLon(why) => why.fmt(f),
            Self::Geodesic(why) => why.fmt(f),
        }
    }
}

impl<T: fmt::Debug> core::error::Error for InvalidProblem<T> {}

/// One of the two problems, by a method: four numbers to three.
trait Problem<T: Real>: Copy {
    /// In a straight line, and whether that is the answer.
    fn ordinary(&self, input: [T; 4]) -> ([T; 3], bool);

    /// In any case, of numbers that have passed the constructor.
    fn solve(&self, input: [T; 4]) -> Result<[T; 3], GeodesicError<T>>;
}

struct Inverse<'a, M>(&'a M);

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

impl<T: Real, M: Straight<T>> Problem<T> for Inverse<'_, M> {
    #[inline(always)]
    fn ordinary(&self, [lat1, lon1, lat2, lon2]: [T; 4]) -> ([T; 3], bool) {
        let (line, found) = self
            .0
            .ordinary_inverse(LatLon::within(lat1, lon1), LatLon::within(lat2, lon2));
        ([line.distance, line.azimuth1, line.azimuth2], found)
    }

    fn solve(&self, [lat1, lon1, lat2, lon2]: [T; 4]) -> Result<[T; 3], GeodesicError<T>> {
        let line = self.0.inverse(LatLon::within(lat1, lon1), LatLon::within(lat2, lon2))?;
        Ok([line.distance, line.azimuth1, line.azimuth2])
    }
}

impl<T: Real, M: Straight<T>> Problem<T> for Direct<'_, M> {
    #[inline(always)]
    fn ordinary(&self, [lat, lon, azimuth, distance]: [T; 4]) -> ([T; 3], bool) {
        let (end, found) = self.0.ordinary_direct(LatLon::within(lat, lon), azimuth, distance);
        ([end.position.lat(), end.position.lon(), end.azimuth], found)
    }

    fn solve(&self, [lat, lon, azimuth, distance]: [T; 4]) -> Result<[T; 3], GeodesicError<T>> {
        let end = self.0.direct(LatLon::within(lat, lon), azimuth, distance)?;
        Ok([end.position.lat(), end.position.lon(), end.azimuth])
    }
}

/// The straight line, and 1 where it is the answer.
struct Line<P>(P);

impl<T: Real, P: Problem<T>> Kernel<T, 4, 4> for Line<P> {
    #[inline(always)]
    fn apply(&self, input: [T; 4]) -> [T; 4] {
        let ([a, b, c], found) = self.0.ordinary(input);
        [a, b, c, select(found, T::ONE, T::ZERO)]
    }
}

/// Where the answers go, and the problems they are of: those without a straight line are solved one by one.
struct Mended<'a, T, P> {
    problem: P,
    index: usize,
    inputs: [&'a [T]; 4],
    results: [&'a mut [T]; 3],
    /// The first problem without an answer.
    refused: &'a mut Option<(usize, GeodesicError<T>)>,
}

impl<T: Real, P: Problem<T>> Sink<T, 4> for Mended<'_, T, P> {
    #[inline(always)]
    fn store(&mut self, [a, b, c, found]: &[[T; BLOCK]; 4]) {
        if found.iter().fold(true, |all, &flag| all & (flag == T::ONE)) {
            let [x, y, z] = &mut self.results;
            store(x, a);
            store(y, b);
            store(z, c);
            for column in &mut self.inputs {
                *column = column.get(BLOCK..).unwrap_or_default();
            }
            self.index += BLOCK;
        } else {
            self.mend([a, b, c], found);
        }
    }
}

impl<T: Real, P: Problem<T>> Mended<'_, T, P> {
    #[cold]
    #[inline(never)]
    fn mend(&mut self, [a, b, c]: [&[T; BLOCK]; 3], found: &[T; BLOCK]) {
        let (mut a, mut b, mut c) = (*a, *b, *c);
        let [i1, i2, i3, i4] = self.inputs;
        let inputs = i1.iter().zip(i2).zip(i3).zip(i4);
        let results = a.iter_mut().zip(&mut b).zip(&mut c);
        for (offset, (((((i1, i2), i3), i4), ((a, b), c)), found)) in inputs.zip(results).zip(found).enumerate() {
            if *found != T::ONE {
                match self.problem.solve([*i1, *i2, *i3, *i4]) {
                    Ok(answer) => [*a, *b, *c] = answer,
                    Err(why) => {
                        [*a, *b, *c] = [T::of(f64::NAN); 3];
                        *self.refused = self.refused.or(Some((self.index + offset, why)));
                    }
                }
            }
        }
        self.store(&[a, b, c, [T::ONE; BLOCK]]);
    }
}

/// Two places.
struct Pairs;

impl<T: Real> Constructor<T, 4> for Pairs {
    type Error = InvalidProblem<T>;

    #[inline(always)]
    fn keeps(&self, [lat1, lon1, lat2, lon2]: [T; 4]) -> bool {
        let (quarter, half) = (T::of(90.0), T::of(180.0));
        (lat1.abs() <= quarter) & (lon1.abs() <= half) & (lat2.abs() <= quarter) & (lon2.abs() <= half)
    }

    fn admit(&self, [lat1, lon1, lat2, lon2]: [T; 4]) -> Result<[T; 4], Self::Error> {
        let from = LatLon::new(lat1, lon1).map_err(InvalidProblem::LatLon)?;
        let to = LatLon::new(lat2, lon2).map_err(InvalidProblem::LatLon)?;
        Ok([from.lat(), from.lon(), to.lat(), to.lon()])
    }
}

/// A place, an azimuth and a distance.
struct Starts<'a, M>(&'a M);

impl<T: Real, M: Straight<T>> Constructor<T, 4> for Starts<'_, M> {
    type Error = InvalidProblem<T>;

    #[inline(always)]
    fn keeps(&self, [lat, lon, azimuth, distance]: [T; 4]) -> bool {
        (lat.abs() <= T::of(90.0)) & (lon.abs() <= T::of(180.0)) & azimuth.is_finite() & self.0.reaches(distance)
    }

    fn admit(&self, [lat, lon, azimuth, distance]: [T; 4]) -> Result<[T; 4], Self::Error> {
        let from = LatLon::new(lat, lon).map_err(InvalidProblem::LatLon)?;
        self.0
            .direct(from, azimuth, distance)
            .map_err(InvalidProblem::Geodesic)?;
        Ok([from.lat(), from.lon(), azimuth, distance])
    }
}

fn solve<T: Real, P: Problem<T>, D: Constructor<T, 4, Error = InvalidProblem<T>>>(
    problem: P,
    constructor: &D,
    inputs: [&[T]; 4],
    mut results: [&mut [T]; 3],
) -> Result<(), InvalidBatch<InvalidProblem<T>>> {
    let lengths = results.each_ref().map(|column| column.len());
    let mut refused = None;
    let mut index = 0;
    admit(constructor, inputs, &lengths, |length, inputs| {
        let mended = Mended {
            problem,
            index,
            inputs,
            results: front(&mut results, length),
            refused: &mut refused,
        };
        sweep(Line(problem), inputs, mended);
        index += length;
    })?;
    match refused {
        Some((index, why)) => Err(InvalidBatch::Element {
            index,
            why: InvalidProblem::Geodesic(why),
        }),
        None => Ok(()),
    }
}

/// Latitudes and longitudes of two places (degrees) to distances (metres) and azimuths at both (degrees):
/// [`Geodesic::inverse`](crate::geodesic::Geodesic::inverse) by [`Karney`](crate::geodesic::Karney) or
/// [`Vincenty`](crate::geodesic::Vincenty).
///
/// Places that have no straight line of arithmetic, nearly antipodal ones for the most part, are treated one
/// by one.
///
/// # Errors
/// [`InvalidBatch`] for unequal lengths, and for what [`LatLon::new`] refuses; nothing is written then. For a
/// pair between which [`Vincenty`](crate::geodesic::Vincenty) does not converge, too: there the results are
/// NaN, and all others are written.
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
pub fn inverse<T: Real, M: Straight<T>>(
    method: &M,
    from: [&[T]; 2],
    to: [&[T]; 2],
    lines: [&mut [T]; 3],
) -> Result<(), InvalidBatch<InvalidProblem<T>>> {
    let ([lat1, lon1], [lat2, lon2]) = (from, to);
    solve(Inverse(method), &Pairs, [lat1, lon1, lat2, lon2], lines)
}

/// Latitudes, longitudes and azimuths (degrees) and distances (metres) to latitudes, longitudes and azimuths there (degrees):
/// [`Geodesic::direct`](crate::geodesic::Geodesic::direct) by [`Karney`](crate::geodesic::Karney) or
/// [`Vincenty`](crate::geodesic::Vincenty).
///
/// # Errors
/// [`InvalidBatch`] for unequal lengths, and for what [`LatLon::new`] and the method refuse; nothing is written then.
///
/// ```
/// use terrella::{Ellipsoid, batch::geodesic, geodesic::Karney};
/// let earth = Karney::new(Ellipsoid::WGS84)?;
/// let (mut lat, mut lon, mut azimuth) = ([0.0_f64], [0.0_f64], [0.0]);
/// geodesic::direct(&earth, [&[40.6], &[-73.8]], &[53.5], &[5.85e6], [&mut lat, &mut lon, &mut azimuth])?;
/// assert!((lat[0] - 49.0).abs() < 0.1 && (lon[0] - 2.5).abs() < 0.1);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn direct<T: Real, M: Straight<T>>(
    method: &M,
    from: [&[T]; 2],
    azimuth: &[T],
    distance: &[T],
    ends: [&mut [T]; 3],
) -> Result<(), InvalidBatch<InvalidProblem<T>>> {
    let [lat, lon] = from;
    solve(Direct(method), &Starts(method), [lat, lon, azimuth, distance], ends)
}
