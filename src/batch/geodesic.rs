//! Computes distances, azimuths and destinations by any [`Geodesic`] method, your own included.

use core::fmt;

use super::InvalidBatch;
use super::admit::{Constructor, admit};
use crate::geodesic::{Geodesic, GeodesicError};
use crate::math::select;
use crate::simd::{BLOCK, Kernel, Sink, front, store, sweep};
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

/// The inverse or the direct problem, by one method: from four numbers to three.
trait Problem<T: Real>: Copy {
    /// Three numbers by the method's fast way, and whether they are the answer.
    fn fast(&self, input: [T; 4]) -> ([T; 3], bool);

    /// The answer for numbers that have passed the constructor.
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

impl<T: Real, M: Geodesic<T>> Problem<T> for Inverse<'_, M> {
    #[inline(always)]
    fn fast(&self, [lat1, lon1, lat2, lon2]: [T; 4]) -> ([T; 3], bool) {
        let (line, found) = self
            .0
            .fast_inverse(LatLon::within(lat1, lon1), LatLon::within(lat2, lon2));
        ([line.distance, line.azimuth1, line.azimuth2], found)
    }

    fn solve(&self, [lat1, lon1, lat2, lon2]: [T; 4]) -> Result<[T; 3], GeodesicError<T>> {
        let line = self.0.inverse(LatLon::within(lat1, lon1), LatLon::within(lat2, lon2))?;
        Ok([line.distance, line.azimuth1, line.azimuth2])
    }
}

impl<T: Real, M: Geodesic<T>> Problem<T> for Direct<'_, M> {
    #[inline(always)]
    fn fast(&self, [lat, lon, azimuth, distance]: [T; 4]) -> ([T; 3], bool) {
        let (end, found) = self.0.fast_direct(LatLon::within(lat, lon), azimuth, distance);
        ([end.position.lat(), end.position.lon(), end.azimuth], found)
    }

    fn solve(&self, [lat, lon, azimuth, distance]: [T; 4]) -> Result<[T; 3], GeodesicError<T>> {
        let end = self.0.direct(LatLon::within(lat, lon), azimuth, distance)?;
        Ok([end.position.lat(), end.position.lon(), end.azimuth])
    }
}

/// The numbers of [`Problem::fast`], and 1 where they are the answer.
struct Fast<P>(P);

impl<T: Real, P: Problem<T>> Kernel<T, 4, 4> for Fast<P> {
    #[inline(always)]
    fn apply(&self, input: [T; 4]) -> [T; 4] {
        let ([a, b, c], found) = self.0.fast(input);
        [a, b, c, select(found, T::ONE, T::ZERO)]
    }
}

/// Stores answers. Problems without a fast answer are solved one by one.
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

impl<T: Real, M: Geodesic<T>> Constructor<T, 4> for Starts<'_, M> {
    type Error = InvalidProblem<T>;

    #[inline(always)]
    fn keeps(&self, [lat, lon, azimuth, distance]: [T; 4]) -> bool {
        (lat.abs() <= T::of(90.0))
            & (lon.abs() <= T::of(180.0))
            & azimuth.is_finite()
            & (distance.abs() <= self.0.reach())
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
        sweep(Fast(problem), inputs, mended);
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

/// Solves the inverse problem for pairs of places: latitudes and longitudes in degrees to distances in metres
/// and azimuths at both places in degrees, with the bits of [`Geodesic::inverse`].
///
/// The fastest methods in a batch are those that override [`Geodesic::fast_inverse`] or are without branches:
/// [`Karney`](crate::geodesic::Karney), [`Vincenty`](crate::geodesic::Vincenty) and the closed formulas.
/// Pairs without a fast answer, most of them nearly antipodal, are solved one by one.
///
/// # Errors
/// [`InvalidBatch`] if slices have unequal lengths, or [`LatLon::new`] refuses a place; nothing is written
/// then. Also if the method has no answer for a pair, as [`Vincenty`](crate::geodesic::Vincenty) near the
/// antipode: its results are NaN, all others are written, and the error names the first such pair.
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
    solve(Inverse(method), &Pairs, [lat1, lon1, lat2, lon2], lines)
}

/// Solves the direct problem for places: latitudes, longitudes and azimuths in degrees and distances in
/// metres to latitudes, longitudes and azimuths of the destinations in degrees, with the bits of
/// [`Geodesic::direct`].
///
/// # Errors
/// [`InvalidBatch`] if slices have unequal lengths, or [`LatLon::new`] or the method refuses an element;
/// nothing is written then.
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
    solve(Direct(method), &Starts(method), [lat, lon, azimuth, distance], ends)
}
