//! Earth axes.

use core::marker::PhantomData;

use super::{Axes, enu};
use crate::batch::InvalidBatch;
use crate::batch::ellipsoid::Points;
use crate::batch::engine::{solve, solve_by};
use crate::simd::{Behind, Door, Element, Kernel, lanes};
use crate::{Aer, Ecef, Enu, InvalidEcef, LocalFrame, Ned, Real};

/// From Earth axes to those of a frame.
#[derive(Clone, Copy)]
struct PointSeen<'a, T, A>(&'a LocalFrame<T>, PhantomData<A>);

impl<T: Real, A: Axes<T>> Kernel<[T; 3]> for PointSeen<'_, T, A> {
    type Output = [T; 3];

    #[inline(always)]
    fn apply(&self, [x, y, z]: [T; 3]) -> [T; 3] {
        A::from(self.0.to_enu(Ecef::within(x, y, z))).row()
    }
}

/// From the axes of a frame to Earth axes.
#[derive(Clone, Copy)]
struct ToPoint<'a, T, A>(&'a LocalFrame<T>, PhantomData<A>);

impl<T: Real, A: Axes<T>> Element<[T; 3]> for ToPoint<'_, T, A> {
    type Output = [T; 3];
    type Error = InvalidEcef<T>;

    /// All numbers are: the result may be refused.
    #[inline(always)]
    fn keeps(&self, _: [T; 3]) -> bool {
        true
    }

    #[inline(always)]
    fn fast(&self, row: [T; 3]) -> ([T; 3], bool) {
        let point = self.0.point_of(enu::<T, A>(row));
        (point, Points.keeps(point))
    }

    fn one(&self, row: [T; 3]) -> Result<[T; 3], InvalidEcef<T>> {
        self.0.from_enu(enu::<T, A>(row)).map(Ecef::to_array)
    }
}

fn point_seen<T: Real, A: Axes<T>>(
    frame: &LocalFrame<T>,
    points: [&[T]; 3],
    into: [&mut [T]; 3],
) -> Result<(), InvalidBatch<InvalidEcef<T>>> {
    solve_by(
        points,
        into,
        |[x, y, z]| Ok(A::from(frame.to_enu(Ecef::new(x, y, z)?)).row()),
        |points, into, tally| {
            lanes(
                Behind(Points, PointSeen::<T, A>(frame, PhantomData)),
                points,
                into,
                tally,
            )
        },
    )
}

/// Converts points of Earth axes in metres to metres east, north and up of the origin, with the bits of
/// [`LocalFrame::to_enu`].
///
/// # Errors
/// [`InvalidBatch`] if slices have unequal lengths, or [`Ecef::new`] refuses an element.
///
/// ```
/// use terrella::{Ellipsoid, LatLon, LocalFrame, batch::frame};
/// let about = LocalFrame::new(Ellipsoid::WGS84, LatLon::new(0.0, 0.0)?.into());
/// let (mut east, mut north, mut up) = ([0.0; 2], [0.0; 2], [0.0; 2]);
/// let points: [&[f64]; 3] = [&[6_378_137.0, 6_378_237.0], &[30.0, 0.0], &[0.0, -20.0]];
/// frame::to_enu(&about, points, [&mut east, &mut north, &mut up])?;
/// assert_eq!((east, north, up), ([30.0, 0.0], [0.0, -20.0], [0.0, 100.0]));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[doc(alias = "ecef2enu")]
pub fn to_enu<T: Real>(
    frame: &LocalFrame<T>,
    points: [&[T]; 3],
    enu: [&mut [T]; 3],
) -> Result<(), InvalidBatch<InvalidEcef<T>>> {
    point_seen::<T, Enu<T>>(frame, points, enu)
}

/// [`to_enu`] as north, east, down, with the bits of [`LocalFrame::to_ned`].
///
/// # Errors
/// [`InvalidBatch`] if slices have unequal lengths, or [`Ecef::new`] refuses an element.
#[doc(alias = "ecef2ned")]
pub fn to_ned<T: Real>(
    frame: &LocalFrame<T>,
    points: [&[T]; 3],
    ned: [&mut [T]; 3],
) -> Result<(), InvalidBatch<InvalidEcef<T>>> {
    point_seen::<T, Ned<T>>(frame, points, ned)
}

/// [`to_enu`] as azimuth and elevation in degrees and range in metres, with the bits of
/// [`LocalFrame::to_aer`].
///
/// # Errors
/// [`InvalidBatch`] if slices have unequal lengths, or [`Ecef::new`] refuses an element.
///
/// ```
/// use terrella::{Ellipsoid, LatLon, LocalFrame, batch::frame};
/// let antenna = LocalFrame::new(Ellipsoid::WGS84, LatLon::new(0.0, 0.0)?.into());
/// let (mut azimuth, mut elevation, mut range) = ([0.0], [0.0], [0.0]);
/// let satellite: [&[f64]; 3] = [&[26_378_137.0], &[20e6], &[0.0]];
/// frame::to_aer(&antenna, satellite, [&mut azimuth, &mut elevation, &mut range])?;
/// assert_eq!((azimuth, elevation, range[0].round()), ([90.0], [45.0], 28_284_271.0));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[doc(alias = "ecef2aer")]
pub fn to_aer<T: Real>(
    frame: &LocalFrame<T>,
    points: [&[T]; 3],
    aer: [&mut [T]; 3],
) -> Result<(), InvalidBatch<InvalidEcef<T>>> {
    point_seen::<T, Aer<T>>(frame, points, aer)
}

/// Converts metres east, north and up of the origin to points of Earth axes, with the bits of
/// [`LocalFrame::from_enu`].
///
/// # Errors
/// [`InvalidBatch`] if slices have unequal lengths, or a point is not finite.
///
/// ```
/// use terrella::{Ellipsoid, LatLon, LocalFrame, batch::frame};
/// let about = LocalFrame::new(Ellipsoid::WGS84, LatLon::new(0.0, 0.0)?.into());
/// let (mut x, mut y, mut z) = ([0.0; 2], [0.0; 2], [0.0; 2]);
/// let enu: [&[f64]; 3] = [&[30.0, 0.0], &[0.0, -20.0], &[0.0, 100.0]];
/// frame::from_enu(&about, enu, [&mut x, &mut y, &mut z])?;
/// assert_eq!((x, y, z), ([6_378_137.0, 6_378_237.0], [30.0, 0.0], [0.0, -20.0]));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[doc(alias = "enu2ecef")]
pub fn from_enu<T: Real>(
    frame: &LocalFrame<T>,
    enu: [&[T]; 3],
    points: [&mut [T]; 3],
) -> Result<(), InvalidBatch<InvalidEcef<T>>> {
    solve(ToPoint::<T, Enu<T>>(frame, PhantomData), enu, points)
}

/// [`from_enu`] from north, east, down, with the bits of [`LocalFrame::from_ned`].
///
/// # Errors
/// [`InvalidBatch`] if slices have unequal lengths, or a point is not finite.
#[doc(alias = "ned2ecef")]
pub fn from_ned<T: Real>(
    frame: &LocalFrame<T>,
    ned: [&[T]; 3],
    points: [&mut [T]; 3],
) -> Result<(), InvalidBatch<InvalidEcef<T>>> {
    solve(ToPoint::<T, Ned<T>>(frame, PhantomData), ned, points)
}

/// [`from_enu`] from azimuth, elevation and range, with the bits of [`LocalFrame::from_aer`].
///
/// # Errors
/// [`InvalidBatch`] if slices have unequal lengths, or a point is not finite.
#[doc(alias = "aer2ecef")]
pub fn from_aer<T: Real>(
    frame: &LocalFrame<T>,
    aer: [&[T]; 3],
    points: [&mut [T]; 3],
) -> Result<(), InvalidBatch<InvalidEcef<T>>> {
    solve(ToPoint::<T, Aer<T>>(frame, PhantomData), aer, points)
}
