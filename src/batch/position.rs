//! Converts latitudes and longitudes on the sphere to directions, and back.

use super::InvalidBatch;
use super::engine::solve_by;
use crate::latitude::{Correction, Turn, with_correction};
use crate::math::{atan2_degrees, sin_cos_degrees};
use crate::simd::{Behind, Door, Kernel, Tally, lanes};
use crate::{Direction, InvalidDirection, InvalidLatLon, LatLon, Real};

/// Latitudes and longitudes in degrees.
#[derive(Clone, Copy)]
pub(super) struct Places;

impl<T: Real> Door<[T; 2]> for Places {
    type Error = InvalidLatLon<T>;

    #[inline(always)]
    fn keeps(&self, [lat, lon]: [T; 2]) -> bool {
        (lat.abs() <= T::of(90.0)) & (lon.abs() <= T::of(180.0))
    }

    #[inline(always)]
    fn mend(&self, [lat, lon]: [T; 2]) -> [T; 2] {
        [lat, LatLon::turned(lon)]
    }

    fn admit(&self, [lat, lon]: [T; 2]) -> Result<[T; 2], Self::Error> {
        LatLon::new(lat, lon).map(|place| [place.lat(), place.lon()])
    }
}

/// Two places each.
#[derive(Clone, Copy)]
pub(super) struct Pairs;

impl<T: Real> Door<([T; 2], [T; 2])> for Pairs {
    type Error = InvalidLatLon<T>;

    #[inline(always)]
    fn keeps(&self, (from, to): ([T; 2], [T; 2])) -> bool {
        Places.keeps(from) & Places.keeps(to)
    }

    #[inline(always)]
    fn mend(&self, (from, to): ([T; 2], [T; 2])) -> ([T; 2], [T; 2]) {
        (Places.mend(from), Places.mend(to))
    }

    fn admit(&self, (from, to): ([T; 2], [T; 2])) -> Result<([T; 2], [T; 2]), Self::Error> {
        Ok((Places.admit(from)?, Places.admit(to)?))
    }
}

/// Vectors, of unit length or not.
#[derive(Clone, Copy)]
pub(super) struct Vectors {
    /// Whether they come from a batch: directions, or NaN where it refused.
    pub(super) known: bool,
}

impl<T: Real> Door<[T; 3]> for Vectors {
    type Error = InvalidDirection<T>;

    #[inline(always)]
    fn keeps(&self, [x, y, z]: [T; 3]) -> bool {
        Direction::is_unit(x, y, z) | (self.known & x.is_finite())
    }

    #[inline(always)]
    fn mend(&self, vector: [T; 3]) -> [T; 3] {
        if self.known {
            vector
        } else {
            Direction::normalised(vector)
        }
    }

    fn admit(&self, [x, y, z]: [T; 3]) -> Result<[T; 3], Self::Error> {
        Direction::new(x, y, z).map(Direction::to_array)
    }
}

#[derive(Clone, Copy)]
pub(super) struct ToDirection<C>(C);

impl<T: Real, C: Turn<T>> Kernel<[T; 2]> for ToDirection<C> {
    type Output = [T; 3];

    #[inline(always)]
    fn apply(&self, [lat, lon]: [T; 2]) -> [T; 3] {
        Direction::from_angles(self.0.turn(sin_cos_degrees(lat)), sin_cos_degrees(lon)).to_array()
    }
}

#[derive(Clone, Copy)]
pub(super) struct ToLatLon<C>(C);

impl<T: Real, C: Turn<T>> Kernel<[T; 3]> for ToLatLon<C> {
    type Output = [T; 2];

    #[inline(always)]
    fn apply(&self, [x, y, z]: [T; 3]) -> [T; 2] {
        let direction = Direction::within(x, y, z);
        let (sin, cos) = self.0.turn((z, direction.cos_lat()));
        [atan2_degrees(sin, cos), direction.lon()]
    }
}
/// Places to directions in lanes; the correction leads from their latitude to the sphere's.
pub(super) fn to_direction_in_lanes<T: Real>(
    correction: &Correction<T>,
    places: [&[T]; 2],
    directions: [&mut [T]; 3],
    tally: &mut Tally<InvalidLatLon<T>>,
) {
    with_correction!(correction, turn => lanes(Behind(Places, ToDirection(*turn)), places, directions, tally));
}

/// Vectors to places in lanes; the correction leads from the sphere's latitude to that of the result.
pub(super) fn to_lat_lon_in_lanes<T: Real>(
    correction: &Correction<T>,
    vectors: Vectors,
    columns: [&[T]; 3],
    places: [&mut [T]; 2],
    tally: &mut Tally<InvalidDirection<T>>,
) {
    with_correction!(correction, turn => lanes(Behind(vectors, ToLatLon(*turn)), columns, places, tally));
}

/// Converts latitudes and longitudes on the sphere, in degrees, to unit vectors, with the bits of
/// [`LatLon::to_direction`].
///
/// # Errors
/// [`InvalidBatch`] if slices have unequal lengths, or [`LatLon::new`] refuses an element.
///
/// ```
/// use terrella::batch::position;
/// let (mut x, mut y, mut z) = ([0.0; 2], [0.0; 2], [0.0; 2]);
/// position::to_direction([&[0.0, 90.0], &[90.0, 0.0]], [&mut x, &mut y, &mut z])?;
/// assert_eq!((x, y, z), ([0.0, 0.0], [1.0, 0.0], [0.0, 1.0]));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn to_direction<T: Real>(
    places: [&[T]; 2],
    directions: [&mut [T]; 3],
) -> Result<(), InvalidBatch<InvalidLatLon<T>>> {
    solve_by(
        places,
        directions,
        |[lat, lon]| Ok(LatLon::new(lat, lon)?.to_direction().to_array()),
        |places, directions, tally| to_direction_in_lanes(&Correction::None, places, directions, tally),
    )
}

/// Converts vectors of any length to latitudes and longitudes on the sphere, in degrees, with the bits of
/// [`Direction::to_lat_lon`].
///
/// # Errors
/// [`InvalidBatch`] if slices have unequal lengths, or [`Direction::new`] refuses an element.
///
/// ```
/// use terrella::batch::position;
/// let (mut lat, mut lon) = ([0.0; 2], [0.0; 2]);
/// position::to_lat_lon([&[0.0, 3.0], &[-1.0, 3.0], &[0.0, 0.0]], [&mut lat, &mut lon])?;
/// assert_eq!((lat, lon), ([0.0, 0.0], [-90.0, 45.0]));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn to_lat_lon<T: Real>(
    directions: [&[T]; 3],
    places: [&mut [T]; 2],
) -> Result<(), InvalidBatch<InvalidDirection<T>>> {
    solve_by(
        directions,
        places,
        |[x, y, z]| {
            let place = Direction::new(x, y, z)?.to_lat_lon();
            Ok([place.lat(), place.lon()])
        },
        |directions, places, tally| {
            to_lat_lon_in_lanes(&Correction::None, Vectors { known: false }, directions, places, tally);
        },
    )
}
