//! Latitude, longitude and height.

use core::marker::PhantomData;

use super::{Axes, enu};
use crate::batch::InvalidBatch;
use crate::batch::ellipsoid::{Geodetics, InvalidGeodetic};
use crate::batch::engine::{solve, solve_by};
use crate::frame::InvalidEnu;
use crate::simd::{Behind, Door, Element, Kernel, lanes};
use crate::{Aer, Enu, Geodetic, LatLon, LocalFrame, Ned, Real};

/// From latitude, longitude and height to the axes of a frame.
#[derive(Clone, Copy)]
struct PlaceSeen<'a, T, A>(&'a LocalFrame<T>, PhantomData<A>);

impl<T: Real, A: Axes<T>> Kernel<[T; 3]> for PlaceSeen<'_, T, A> {
    type Output = [T; 3];

    #[inline(always)]
    fn apply(&self, [lat, lon, height]: [T; 3]) -> [T; 3] {
        let place = Geodetic::within(LatLon::within(lat, lon), height);
        A::from(self.0.geodetic_to_enu_inline(place)).row()
    }
}

/// From the axes of a frame to latitude, longitude and height.
#[derive(Clone, Copy)]
struct ToPlace<'a, T, A>(&'a LocalFrame<T>, PhantomData<A>);

impl<T: Real, A: Axes<T>> Element<[T; 3]> for ToPlace<'_, T, A> {
    type Output = [T; 3];
    type Error = InvalidEnu<T>;

    /// All numbers are: the result may be refused.
    #[inline(always)]
    fn keeps(&self, _: [T; 3]) -> bool {
        true
    }

    #[inline(always)]
    fn fast(&self, row: [T; 3]) -> ([T; 3], bool) {
        let (place, found) = self.0.fast_geodetic(enu::<T, A>(row));
        ([place.lat(), place.lon(), place.height()], found)
    }

    fn one(&self, row: [T; 3]) -> Result<[T; 3], InvalidEnu<T>> {
        let place = self.0.enu_to_geodetic(enu::<T, A>(row))?;
        Ok([place.lat(), place.lon(), place.height()])
    }
}

fn place_seen<T: Real, A: Axes<T>>(
    frame: &LocalFrame<T>,
    places: [&[T]; 3],
    into: [&mut [T]; 3],
) -> Result<(), InvalidBatch<InvalidGeodetic<T>>> {
    solve_by(
        places,
        into,
        |place| {
            let [lat, lon, height] = Geodetics.admit(place)?;
            let place = Geodetic::within(LatLon::within(lat, lon), height);
            Ok(A::from(frame.geodetic_to_enu(place)).row())
        },
        |places, into, tally| {
            lanes(
                Behind(Geodetics, PlaceSeen::<T, A>(frame, PhantomData)),
                places,
                into,
                tally,
            )
        },
    )
}

/// Converts geodetic latitudes and longitudes in degrees and heights in metres to metres east, north and up
/// of the origin, with the bits of [`LocalFrame::geodetic_to_enu`]: without the rounding of Earth axes.
///
/// # Errors
/// [`InvalidBatch`] if slices have unequal lengths, or [`LatLon::new`] or [`Geodetic::new`] refuses an
/// element.
///
/// ```
/// use terrella::{Ellipsoid, Geodetic, LatLon, LocalFrame, batch::frame};
/// let tower = LocalFrame::new(Ellipsoid::WGS84, Geodetic::new(LatLon::new(48.858, 2.294)?, 33.0)?);
/// let (mut east, mut north, mut up) = ([0.0; 2], [0.0; 2], [0.0; 2]);
/// let drones: [&[f64]; 3] = [&[48.858, 48.859], &[2.294, 2.294], &[33.125, 33.0]];
/// frame::geodetic_to_enu(&tower, drones, [&mut east, &mut north, &mut up])?;
/// assert_eq!((up[0], east[1], north[1].round()), (0.125, 0.0, 111.0));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[doc(alias = "geodetic2enu")]
pub fn geodetic_to_enu<T: Real>(
    frame: &LocalFrame<T>,
    places: [&[T]; 3],
    enu: [&mut [T]; 3],
) -> Result<(), InvalidBatch<InvalidGeodetic<T>>> {
    place_seen::<T, Enu<T>>(frame, places, enu)
}

/// [`geodetic_to_enu`] as north, east, down, with the bits of [`LocalFrame::geodetic_to_ned`].
///
/// # Errors
/// [`InvalidBatch`] if slices have unequal lengths, or [`LatLon::new`] or [`Geodetic::new`] refuses an
/// element.
#[doc(alias = "geodetic2ned")]
pub fn geodetic_to_ned<T: Real>(
    frame: &LocalFrame<T>,
    places: [&[T]; 3],
    ned: [&mut [T]; 3],
) -> Result<(), InvalidBatch<InvalidGeodetic<T>>> {
    place_seen::<T, Ned<T>>(frame, places, ned)
}

/// [`geodetic_to_enu`] as azimuth and elevation in degrees and range in metres, with the bits of
/// [`LocalFrame::geodetic_to_aer`].
///
/// # Errors
/// [`InvalidBatch`] if slices have unequal lengths, or [`LatLon::new`] or [`Geodetic::new`] refuses an
/// element.
#[doc(alias = "geodetic2aer")]
pub fn geodetic_to_aer<T: Real>(
    frame: &LocalFrame<T>,
    places: [&[T]; 3],
    aer: [&mut [T]; 3],
) -> Result<(), InvalidBatch<InvalidGeodetic<T>>> {
    place_seen::<T, Aer<T>>(frame, places, aer)
}

/// Converts metres east, north and up of the origin to geodetic latitudes and longitudes in degrees and
/// heights in metres, with the bits of [`LocalFrame::enu_to_geodetic`].
///
/// Points deep inside the Earth and far out in space take its slower way, one by one.
///
/// # Errors
/// [`InvalidBatch`] if slices have unequal lengths, or a component is infinite or NaN, or a point is beyond
/// the scalar's largest numbers.
///
/// ```
/// use terrella::{Ellipsoid, Geodetic, LatLon, LocalFrame, batch::frame};
/// let tower = LocalFrame::new(Ellipsoid::WGS84, Geodetic::new(LatLon::new(48.858, 2.294)?, 33.0)?);
/// let (mut lat, mut lon, mut height) = ([0.0; 2], [0.0; 2], [0.0; 2]);
/// let enu: [&[f64]; 3] = [&[0.0, 0.0], &[0.0, 100.0], &[0.125, 0.0]];
/// frame::enu_to_geodetic(&tower, enu, [&mut lat, &mut lon, &mut height])?;
/// assert_eq!((lat[0], lon[0], height[0], lon[1]), (48.858, 2.294, 33.125, 2.294));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[doc(alias = "enu2geodetic")]
pub fn enu_to_geodetic<T: Real>(
    frame: &LocalFrame<T>,
    enu: [&[T]; 3],
    places: [&mut [T]; 3],
) -> Result<(), InvalidBatch<InvalidEnu<T>>> {
    solve(ToPlace::<T, Enu<T>>(frame, PhantomData), enu, places)
}

/// [`enu_to_geodetic`] from north, east, down, with the bits of [`LocalFrame::ned_to_geodetic`].
///
/// # Errors
/// [`InvalidBatch`] if slices have unequal lengths, or a component is infinite or NaN, or a point is beyond
/// the scalar's largest numbers.
#[doc(alias = "ned2geodetic")]
pub fn ned_to_geodetic<T: Real>(
    frame: &LocalFrame<T>,
    ned: [&[T]; 3],
    places: [&mut [T]; 3],
) -> Result<(), InvalidBatch<InvalidEnu<T>>> {
    solve(ToPlace::<T, Ned<T>>(frame, PhantomData), ned, places)
}

/// [`enu_to_geodetic`] from azimuth, elevation and range, with the bits of [`LocalFrame::aer_to_geodetic`].
///
/// # Errors
/// [`InvalidBatch`] if slices have unequal lengths, or azimuth, elevation or range is infinite or NaN. The
/// error carries the components east, north and up that follow from them.
#[doc(alias = "aer2geodetic")]
pub fn aer_to_geodetic<T: Real>(
    frame: &LocalFrame<T>,
    aer: [&[T]; 3],
    places: [&mut [T]; 3],
) -> Result<(), InvalidBatch<InvalidEnu<T>>> {
    solve(ToPlace::<T, Aer<T>>(frame, PhantomData), aer, places)
}
