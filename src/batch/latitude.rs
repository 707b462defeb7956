//! Converts geodetic latitudes and longitudes to directions and back by a [`Shifted`], and latitudes from one
//! kind to another by a [`Conversion`].

use core::marker::PhantomData;

use super::InvalidBatch;
use super::engine::solve_by;
use super::position::{Vectors, to_direction_in_lanes, to_lat_lon_in_lanes};
use crate::latitude::{
    Angle, Conversion, Degrees, InvalidLatitude, Radians, Turn, conformal, corrected, isometric, with_correction,
};
use crate::simd::{Behind, CHUNK, Door, Kernel, Tally, front, lanes};
use crate::{Direction, InvalidDirection, InvalidLatLon, LatLon, Latitude, Real, Shifted};

/// Converts geodetic latitudes and longitudes in degrees to unit vectors on the sphere, with the bits of
/// [`Shifted::to_direction`].
///
/// # Errors
/// [`InvalidBatch`] if slices have unequal lengths, or [`LatLon::new`] refuses an
/// element.
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
    solve_by(
        places,
        directions,
        |[lat, lon]| Ok(shifted.to_direction(LatLon::new(lat, lon)?).to_array()),
        |places, directions, tally| {
            let [correction, _] = shifted.corrections();
            to_direction_in_lanes(&correction, places, directions, tally);
        },
    )
}

/// Converts vectors of any length to geodetic latitudes and longitudes in degrees, with the bits of
/// [`Shifted::to_lat_lon`].
///
/// # Errors
/// [`InvalidBatch`] if slices have unequal lengths, or [`Direction::new`] refuses an
/// element.
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
    solve_by(
        directions,
        places,
        |[x, y, z]| {
            let place = shifted.to_lat_lon(Direction::new(x, y, z)?);
            Ok([place.lat(), place.lon()])
        },
        |directions, places, tally| {
            let [_, correction] = shifted.corrections();
            to_lat_lon_in_lanes(&correction, Vectors { known: false }, directions, places, tally);
        },
    )
}

/// Latitudes whose absolute value is at most a limit.
#[derive(Clone, Copy)]
struct Latitudes<T>(T);

impl<T: Real> Door<[T; 1]> for Latitudes<T> {
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

#[derive(Clone, Copy)]
struct Same;

impl<T: Real> Kernel<[T; 1]> for Same {
    type Output = [T; 1];

    #[inline(always)]
    fn apply(&self, value: [T; 1]) -> [T; 1] {
        value
    }
}

#[derive(Clone, Copy)]
struct Conformal<A>(PhantomData<A>);

impl<T: Real, A: Angle> Kernel<[T; 1]> for Conformal<A> {
    type Output = [T; 1];

    #[inline(always)]
    fn apply(&self, [value]: [T; 1]) -> [T; 1] {
        [conformal::<T, A>(value)]
    }
}

#[derive(Clone, Copy)]
struct Corrected<C, A>(C, PhantomData<A>);

impl<T: Real, C: Turn<T>, A: Angle> Kernel<[T; 1]> for Corrected<C, A> {
    type Output = [T; 1];

    #[inline(always)]
    fn apply(&self, [value]: [T; 1]) -> [T; 1] {
        [corrected::<T, A>(value, &self.0)]
    }
}

#[derive(Clone, Copy)]
struct Isometric<C, A>(C, PhantomData<A>);

impl<T: Real, C: Turn<T>, A: Angle> Kernel<[T; 1]> for Isometric<C, A> {
    type Output = [T; 1];

    #[inline(always)]
    fn apply(&self, [value]: [T; 1]) -> [T; 1] {
        [isometric::<T, A>(value, &self.0)]
    }
}

/// Converts in steps, through the geodetic latitude, so that there is a loop for each correction and not for
/// each pair of them. What the first step refuses is NaN, and stays so.
fn in_lanes<T: Real, A: Angle>(
    conversion: &Conversion<T>,
    values: &[T],
    results: &mut [T],
    tally: &mut Tally<InvalidLatitude<T>>,
) {
    let [from, to] = conversion.ends();
    let [to_geodetic, from_geodetic] = conversion.corrections();
    let admitted = Latitudes(conversion.limit::<A>());
    if from == to {
        lanes(Behind(admitted, Same), [values], [results], tally);
        return;
    }
    let known = Latitudes(T::of(f64::INFINITY));
    let ignored = &mut Tally::new();
    let mut results = [results];
    for values in values.chunks(CHUNK) {
        let [results] = front(&mut results, values.len());
        let (mut start, mut geodetic) = ([T::ZERO; CHUNK], [T::ZERO; CHUNK]);
        let start = start.get_mut(..values.len()).unwrap_or_default();
        let geodetic = geodetic.get_mut(..values.len()).unwrap_or_default();
        with_correction!(&to_geodetic, turn => {
            let kernel = Corrected(*turn, PhantomData::<A>);
            if from == Latitude::Isometric {
                lanes(Behind(admitted, Conformal(PhantomData::<A>)), [values], [&mut *start], tally);
                lanes(Behind(known, kernel), [&*start], [&mut *geodetic], ignored);
            } else {
                lanes(Behind(admitted, kernel), [values], [&mut *geodetic], tally);
            }
        });
        with_correction!(&from_geodetic, turn => if to == Latitude::Isometric {
            let kernel = Isometric(*turn, PhantomData::<A>);
            lanes(Behind(known, kernel), [&*geodetic], [results], ignored);
        } else {
            let kernel = Corrected(*turn, PhantomData::<A>);
            lanes(Behind(known, kernel), [&*geodetic], [results], ignored);
        });
    }
}

/// Converts latitudes in degrees from one kind to another, with the bits of [`Conversion::degrees`].
///
/// # Errors
/// [`InvalidBatch`] if slices have unequal lengths, or [`Conversion::degrees`] refuses an element.
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
    solve_by(
        [values],
        [results],
        |[value]| conversion.degrees(value).map(|result| [result]),
        |[values], [results], tally| in_lanes::<T, Degrees>(conversion, values, results, tally),
    )
}

/// Converts latitudes in radians from one kind to another, with the bits of [`Conversion::radians`].
///
/// # Errors
/// [`InvalidBatch`] if slices have unequal lengths, or [`Conversion::radians`] refuses an element.
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
    solve_by(
        [values],
        [results],
        |[value]| conversion.radians(value).map(|result| [result]),
        |[values], [results], tally| in_lanes::<T, Radians>(conversion, values, results, tally),
    )
}
