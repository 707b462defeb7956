//! Converts latitudes and longitudes on the sphere to directions, and back.

use super::InvalidBatch;
use super::admit::{Constructor, admit};
use crate::latitude::{Correction, Turn, with_correction};
use crate::math::{atan2_degrees, sin_cos_degrees};
use crate::simd::{Kernel, front, sweep};
use crate::{Direction, InvalidDirection, InvalidLatLon, LatLon, Real};

/// Latitudes and longitudes in degrees.
pub(super) struct Places;

impl<T: Real> Constructor<T, 2> for Places {
    type Error = InvalidLatLon<T>;

    #[inline(always)]
    fn keeps(&self, [lat, lon]: [T; 2]) -> bool {
        (lat.abs() <= T::of(90.0)) & (lon.abs() <= T::of(180.0))
    }

    fn admit(&self, [lat, lon]: [T; 2]) -> Result<[T; 2], Self::Error> {
        LatLon::new(lat, lon).map(|place| [place.lat(), place.lon()])
    }
}

/// Vectors, of unit length or not.
pub(super) struct Vectors;

impl<T: Real> Constructor<T, 3> for Vectors {
    type Error = InvalidDirection<T>;

    #[inline(always)]
    fn keeps(&self, [x, y, z]: [T; 3]) -> bool {
        Direction::is_unit(x, y, z)
    }

    fn admit(&self, [x, y, z]: [T; 3]) -> Result<[T; 3], Self::Error> {
        Direction::new(x, y, z).map(Direction::to_array)
    }
}

struct ToDirection<C>(C);

impl<T: Real, C: Turn<T>> Kernel<T, 2, 3> for ToDirection<C> {
    #[inline(always)]
    fn apply(&self, [lat, lon]: [T; 2]) -> [T; 3] {
        Direction::from_angles(self.0.turn(sin_cos_degrees(lat)), sin_cos_degrees(lon)).to_array()
    }
}

struct ToLatLon<C>(C);

impl<T: Real, C: Turn<T>> Kernel<T, 3, 2> for ToLatLon<C> {
    #[inline(always)]
    fn apply(&self, [x, y, z]: [T; 3]) -> [T; 2] {
        let direction = Direction::within(x, y, z);
        let (sin, cos) = self.0.turn((z, direction.cos_lat()));
        [atan2_degrees(sin, cos), direction.lon()]
    }
}

/// [`to_direction`] for places that have passed [`Places`]; the correction leads from their latitude to the
/// sphere's.
pub(super) fn turn_to_direction<T: Real>(correction: &Correction<T>, places: [&[T]; 2], directions: [&mut [T]; 3]) {
    with_correction!(correction, turn => sweep(ToDirection(*turn), places, directions));
}

/// [`to_lat_lon`] for directions that have passed [`Vectors`]; the correction leads from the sphere's
/// latitude to that of the result.
pub(super) fn turn_to_lat_lon<T: Real>(correction: &Correction<T>, directions: [&[T]; 3], places: [&mut [T]; 2]) {
    with_correction!(correction, turn => sweep(ToLatLon(*turn), directions, places));
}

/// [`to_direction`], with a correction of the latitude.
pub(super) fn corrected_to_direction<T: Real>(
    correction: &Correction<T>,
    places: [&[T]; 2],
    mut directions: [&mut [T]; 3],
) -> Result<(), InvalidBatch<InvalidLatLon<T>>> {
    let lengths = directions.each_ref().map(|column| column.len());
    admit(&Places, places, &lengths, |length, places| {
        turn_to_direction(correction, places, front(&mut directions, length));
    })
}

/// [`to_lat_lon`], with a correction of the latitude.
pub(super) fn corrected_to_lat_lon<T: Real>(
    correction: &Correction<T>,
    directions: [&[T]; 3],
    mut places: [&mut [T]; 2],
) -> Result<(), InvalidBatch<InvalidDirection<T>>> {
    let lengths = places.each_ref().map(|column| column.len());
    admit(&Vectors, directions, &lengths, |length, directions| {
        turn_to_lat_lon(correction, directions, front(&mut places, length));
    })
}

/// Converts latitudes and longitudes on the sphere, in degrees, to unit vectors, with the bits of
/// [`LatLon::to_direction`].
///
/// # Errors
/// [`InvalidBatch`] if slices have unequal lengths, or [`LatLon::new`] refuses an element. Nothing is written
/// then.
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
    corrected_to_direction(&Correction::None, places, directions)
}

/// Converts vectors of any length to latitudes and longitudes on the sphere, in degrees, with the bits of
/// [`Direction::to_lat_lon`].
///
/// # Errors
/// [`InvalidBatch`] if slices have unequal lengths, or [`Direction::new`] refuses an element. Nothing is
/// written then.
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
    corrected_to_lat_lon(&Correction::None, directions, places)
}
