//! Converts geodetic latitudes and longitudes to directions and back by a [`Shifted`], and latitudes from one
//! kind to another by a [`Conversion`].

use core::marker::PhantomData;

use super::InvalidBatch;
use super::admit::{Constructor, admit};
use super::position::{corrected_to_direction, corrected_to_lat_lon};
use crate::latitude::{
    Angle, Conversion, Correction, Degrees, InvalidLatitude, Radians, Turn, conformal, corrected, isometric,
    with_correction,
};
use crate::simd::{CHUNK, Kernel, front, sweep};
use crate::{InvalidDirection, InvalidLatLon, Latitude, Real, Shifted};

/// Converts geodetic latitudes and longitudes in degrees to unit vectors on the sphere, with the bits of
/// [`Shifted::to_direction`].
///
/// # Errors
/// [`InvalidBatch`] if slices have unequal lengths, or [`LatLon::new`](crate::LatLon::new) refuses an
/// element. Nothing is written then.
///
/// ```
/// use terrella::{Ellipsoid, LatLon, Shift, Shifted, batch::latitude};
/// let earth = Shifted::new(Ellipsoid::WGS84, Shift::Geocentric)?;
/// let (mut x, mut y, mut z) = ([0.0], [0.0], [0.0]);
/// latitude::to_direction(&earth, [&[45.0], &[10.0]], [&mut x, &mut y, &mut z])?;
/// assert_eq!([x[0], y[0], z[0]], earth.to_direction(LatLon::new(45.0, 10.0)?).to_array());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn to_direction<T: Real>(
    shifted: &Shifted<T>,
    places: [&[T]; 2],
    directions: [&mut [T]; 3],
) -> Result<(), InvalidBatch<InvalidLatLon<T>>> {
    let [correction, _] = shifted.corrections();
    corrected_to_direction(&correction, places, directions)
}

/// Converts vectors of any length to geodetic latitudes and longitudes in degrees, with the bits of
/// [`Shifted::to_lat_lon`].
///
/// # Errors
/// [`InvalidBatch`] if slices have unequal lengths, or [`Direction::new`](crate::Direction::new) refuses an
/// element. Nothing is written then.
///
/// ```
/// use terrella::{Ellipsoid, Shift, Shifted, batch::latitude};
/// let earth = Shifted::new(Ellipsoid::WGS84, Shift::Geocentric)?;
/// let (mut lat, mut lon) = ([0.0], [0.0]);
/// latitude::to_lat_lon(&earth, [&[0.0], &[1.0], &[1.0]], [&mut lat, &mut lon])?;
/// assert!((lat[0] - 45.192_423_f64).abs() < 1e-6 && lon == [90.0]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn to_lat_lon<T: Real>(
    shifted: &Shifted<T>,
    directions: [&[T]; 3],
    places: [&mut [T]; 2],
) -> Result<(), InvalidBatch<InvalidDirection<T>>> {
    let [_, correction] = shifted.corrections();
    corrected_to_lat_lon(&correction, directions, places)
}

/// Latitudes whose absolute value is at most a limit.
struct Latitudes<T>(T);

impl<T: Real> Constructor<T, 1> for Latitudes<T> {
    type Error = InvalidLatitude<T>;

    #[inline(always)]
    fn keeps(&self, [value]: [T; 1]) -> bool {
        value.abs() <= self.0
    }

    fn admit(&self, [value]: [T; 1]) -> Result<[T; 1], Self::Error> {
        if self.keeps([value]) {
            Ok([value])
        } else {
            Err(InvalidLatitude(value))
        }
    }
}

struct Conformal<A>(PhantomData<A>);

impl<T: Real, A: Angle> Kernel<T, 1, 1> for Conformal<A> {
    #[inline(always)]
    fn apply(&self, [value]: [T; 1]) -> [T; 1] {
        [conformal::<T, A>(value)]
    }
}

struct Corrected<C, A>(C, PhantomData<A>);

impl<T: Real, C: Turn<T>, A: Angle> Kernel<T, 1, 1> for Corrected<C, A> {
    #[inline(always)]
    fn apply(&self, [value]: [T; 1]) -> [T; 1] {
        [corrected::<T, A>(value, &self.0)]
    }
}

struct Isometric<C, A>(C, PhantomData<A>);

impl<T: Real, C: Turn<T>, A: Angle> Kernel<T, 1, 1> for Isometric<C, A> {
    #[inline(always)]
    fn apply(&self, [value]: [T; 1]) -> [T; 1] {
        [isometric::<T, A>(value, &self.0)]
    }
}

fn correct<T: Real, A: Angle>(correction: &Correction<T>, from: &[T], to: &mut [T]) {
    with_correction!(correction, turn => sweep(Corrected(*turn, PhantomData::<A>), [from], [to]));
}

/// `copy_from_slice` for as many elements as both slices have; it cannot panic.
fn copy<T: Real>(from: &[T], to: &mut [T]) {
    for (slot, &value) in to.iter_mut().zip(from) {
        *slot = value;
    }
}

/// Converts in steps, through the geodetic latitude, so that there is a loop for each correction and not for
/// each pair of them.
fn convert<T: Real, A: Angle>(
    conversion: &Conversion<T>,
    values: &[T],
    results: &mut [T],
) -> Result<(), InvalidBatch<InvalidLatitude<T>>> {
    let [from, to] = conversion.ends();
    let [to_geodetic, from_geodetic] = conversion.corrections();
    let mut results = [results];
    let lengths = results.each_ref().map(|column| column.len());
    admit(
        &Latitudes(conversion.limit::<A>()),
        [values],
        &lengths,
        |_, [values]| {
            for values in values.chunks(CHUNK) {
                let [results] = front(&mut results, values.len());
                if from == to {
                    copy(values, results);
                    continue;
                }
                let mut start = [T::ZERO; CHUNK];
                let mut geodetic = [T::ZERO; CHUNK];
                let start = start.get_mut(..values.len()).unwrap_or_default();
                let geodetic = geodetic.get_mut(..values.len()).unwrap_or_default();
                if from == Latitude::Isometric {
                    sweep(Conformal(PhantomData::<A>), [values], [&mut *start]);
                } else {
                    copy(values, start);
                }
                correct::<T, A>(&to_geodetic, start, geodetic);
                if to == Latitude::Isometric {
                    with_correction!(&from_geodetic, turn => sweep(Isometric(*turn, PhantomData::<A>), [&*geodetic], [results]));
                } else {
                    correct::<T, A>(&from_geodetic, geodetic, results);
                }
            }
        },
    )
}

/// Converts latitudes in degrees from one kind to another, with the bits of [`Conversion::degrees`].
///
/// # Errors
/// [`InvalidBatch`] if slices have unequal lengths, or [`Conversion::degrees`] refuses an element. Nothing is
/// written then.
///
/// ```
/// use terrella::{Ellipsoid, Latitude, batch::latitude, latitude::Conversion};
/// let authalic = Conversion::new(Ellipsoid::WGS84, Latitude::Geodetic, Latitude::Authalic)?;
/// let mut result = [0.0; 2];
/// latitude::degrees(&authalic, &[45.0, 90.0], &mut result)?;
/// assert_eq!(result, [authalic.degrees(45.0)?, 90.0]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn degrees<T: Real>(
    conversion: &Conversion<T>,
    values: &[T],
    results: &mut [T],
) -> Result<(), InvalidBatch<InvalidLatitude<T>>> {
    convert::<T, Degrees>(conversion, values, results)
}

/// Converts latitudes in radians from one kind to another, with the bits of [`Conversion::radians`].
///
/// # Errors
/// [`InvalidBatch`] if slices have unequal lengths, or [`Conversion::radians`] refuses an element. Nothing is
/// written then.
///
/// ```
/// use terrella::{Ellipsoid, Latitude, batch::latitude, latitude::Conversion};
/// let isometric = Conversion::new(Ellipsoid::WGS84, Latitude::Geodetic, Latitude::Isometric)?;
/// let mut result = [0.0];
/// latitude::radians(&isometric, &[0.5], &mut result)?;
/// assert_eq!(result, [isometric.radians(0.5)?]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn radians<T: Real>(
    conversion: &Conversion<T>,
    values: &[T],
    results: &mut [T],
) -> Result<(), InvalidBatch<InvalidLatitude<T>>> {
    convert::<T, Radians>(conversion, values, results)
}
