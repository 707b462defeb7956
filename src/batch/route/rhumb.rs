//! Rhumb lines between places, and from places.

use crate::batch::InvalidBatch;
use crate::batch::engine::{solve, solve_by};
use crate::batch::geodesic::InvalidProblem;
use crate::batch::position::{Pairs, Places};
use crate::route::{Rhumb, RhumbInverse};
use crate::simd::{Behind, Door, Element, Kernel, lanes};
use crate::{InvalidLatLon, LatLon, Real};

/// Two places in degrees.
type Pair<T> = ([T; 2], [T; 2]);

/// What is asked of a line. The rest is left out by the compiler.
trait Ask<T, const N: usize>: Copy {
    fn of(line: RhumbInverse<T>) -> [T; N];
}

#[derive(Clone, Copy)]
struct Line;

impl<T> Ask<T, 2> for Line {
    #[inline(always)]
    fn of(line: RhumbInverse<T>) -> [T; 2] {
        [line.distance, line.azimuth]
    }
}

#[derive(Clone, Copy)]
struct Under;

impl<T> Ask<T, 1> for Under {
    #[inline(always)]
    fn of(line: RhumbInverse<T>) -> [T; 1] {
        [line.area]
    }
}

/// From two places to what is asked of the line between them.
#[derive(Clone, Copy)]
struct Between<'a, T, A, const SHORT: bool, const N: usize>(&'a Rhumb<T>, A);

impl<T: Real, A: Ask<T, N>, const SHORT: bool, const N: usize> Kernel<Pair<T>> for Between<'_, T, A, SHORT, N> {
    type Output = [T; N];

    #[inline(always)]
    fn apply(&self, ([lat1, lon1], [lat2, lon2]): Pair<T>) -> [T; N] {
        let (from, to) = (LatLon::within(lat1, lon1), LatLon::within(lat2, lon2));
        A::of(self.0.solve::<SHORT>(from, to))
    }
}

/// Asks of lines between places.
fn between<T: Real, A: Ask<T, N>, const N: usize>(
    rhumb: &Rhumb<T>,
    ask: A,
    places: ([&[T]; 2], [&[T]; 2]),
    lines: [&mut [T]; N],
) -> Result<(), InvalidBatch<InvalidLatLon<T>>> {
    solve_by(
        places,
        lines,
        |([lat1, lon1], [lat2, lon2])| Ok(A::of(rhumb.inverse(LatLon::new(lat1, lon1)?, LatLon::new(lat2, lon2)?))),
        |places, lines, tally| {
            if rhumb.is_short() {
                lanes(
                    Behind(Pairs, Between::<T, A, true, N>(rhumb, ask)),
                    places,
                    lines,
                    tally,
                );
            } else {
                lanes(
                    Behind(Pairs, Between::<T, A, false, N>(rhumb, ask)),
                    places,
                    lines,
                    tally,
                );
            }
        },
    )
}

/// Measures the shortest rhumb lines between pairs of places in degrees: distances in metres and azimuths in
/// degrees, with the bits of [`Rhumb::inverse`].
///
/// # Errors
/// [`InvalidBatch`] if slices have unequal lengths, or [`LatLon::new`] refuses a place.
///
/// ```
/// use terrella::{Ellipsoid, batch::route, route::Rhumb};
/// let earth = Rhumb::new(Ellipsoid::WGS84)?;
/// let (mut distance, mut azimuth) = ([0.0_f64; 2], [0.0; 2]);
/// let from: [&[f64]; 2] = [&[0.0, 40.6], &[0.0, -73.8]];
/// let to: [&[f64]; 2] = [&[0.0, 51.6], &[1.0, -0.5]];
/// route::rhumb_inverse(&earth, from, to, [&mut distance, &mut azimuth])?;
/// assert_eq!(distance.map(f64::round), [111_319.0, 5_771_083.0]);
/// assert_eq!(azimuth.map(f64::round), [90.0, 78.0]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn rhumb_inverse<T: Real>(
    rhumb: &Rhumb<T>,
    from: [&[T]; 2],
    to: [&[T]; 2],
    lines: [&mut [T]; 2],
) -> Result<(), InvalidBatch<InvalidLatLon<T>>> {
    between(rhumb, Line, (from, to), lines)
}

/// Measures the areas in m² under the shortest rhumb lines between pairs of places in degrees, with the bits
/// of [`Rhumb::inverse`].
///
/// # Errors
/// Those of [`rhumb_inverse`].
///
/// ```
/// use terrella::{Ellipsoid, batch::route, route::Rhumb};
/// let earth = Rhumb::new(Ellipsoid::WGS84)?;
/// let mut area = [0.0_f64; 1];
/// route::rhumb_area(&earth, [&[40.6], &[-73.8]], [&[51.6], &[-0.5]], &mut area)?;
/// assert!((area[0] - 37_395_209_100_030.4).abs() < 0.1);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn rhumb_area<T: Real>(
    rhumb: &Rhumb<T>,
    from: [&[T]; 2],
    to: [&[T]; 2],
    areas: &mut [T],
) -> Result<(), InvalidBatch<InvalidLatLon<T>>> {
    between(rhumb, Under, (from, to), [areas])
}

/// Latitude, longitude and azimuth of a start, and a distance.
type Way<T> = ([T; 3], [T; 1]);

/// From there to the end.
#[derive(Clone, Copy)]
struct Direct<'a, T, const SHORT: bool>(&'a Rhumb<T>);

impl<T: Real, const SHORT: bool> Element<Way<T>> for Direct<'_, T, SHORT> {
    type Output = [T; 2];
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
    fn fast(&self, ([lat, lon, azimuth], [distance]): Way<T>) -> ([T; 2], bool) {
        self.0.fast_direct::<SHORT>(LatLon::within(lat, lon), azimuth, distance)
    }

    fn one(&self, ([lat, lon, azimuth], [distance]): Way<T>) -> Result<[T; 2], InvalidProblem<T>> {
        let from = LatLon::new(lat, lon).map_err(InvalidProblem::LatLon)?;
        let end = self
            .0
            .direct(from, azimuth, distance)
            .map_err(InvalidProblem::Geodesic)?;
        Ok([end.position.lat(), end.position.lon()])
    }
}

/// Finds where rhumb lines end: from latitudes, longitudes and azimuths in degrees and distances in metres to
/// latitudes and longitudes in degrees, with the bits of [`Rhumb::direct`].
///
/// # Errors
/// [`InvalidBatch`] if slices have unequal lengths, or [`LatLon::new`] or [`Rhumb::direct`] refuses an
/// element.
///
/// ```
/// use terrella::{Ellipsoid, batch::route, route::Rhumb};
/// let earth = Rhumb::new(Ellipsoid::WGS84)?;
/// let (mut lat, mut lon) = ([0.0_f64], [0.0]);
/// route::rhumb_direct(&earth, [&[40.6], &[-73.8]], &[77.768_389_7], &[5_771_083.38], [&mut lat, &mut lon])?;
/// assert!((lat[0] - 51.6).abs() < 1e-6 && (lon[0] + 0.5).abs() < 1e-6);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn rhumb_direct<T: Real>(
    rhumb: &Rhumb<T>,
    from: [&[T]; 2],
    azimuth: &[T],
    distance: &[T],
    ends: [&mut [T]; 2],
) -> Result<(), InvalidBatch<InvalidProblem<T>>> {
    let [lat, lon] = from;
    let ways = ([lat, lon, azimuth], [distance]);
    if rhumb.is_short() {
        solve(Direct::<T, true>(rhumb), ways, ends)
    } else {
        solve(Direct::<T, false>(rhumb), ways, ends)
    }
}
