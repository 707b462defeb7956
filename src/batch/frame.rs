//! Converts positions to east, north and up of an origin, and back, by a [`LocalFrame`]; also to north, east
//! and down, and to azimuth, elevation and range.

use core::convert::Infallible;
use core::marker::PhantomData;

use super::InvalidBatch;
use super::ellipsoid::{Geodetics, InvalidGeodetic, Points};
use super::engine::{solve, solve_by};
use crate::frame::{GeodeticOffset, InvalidEnu};
use crate::simd::{Behind, Door, Element, Kernel, lanes, sweep};
use crate::{Aer, Ecef, Enu, Geodetic, InvalidEcef, LatLon, LocalFrame, Ned, Real};

/// Three numbers from an origin: [`Enu`], [`Ned`] or [`Aer`].
trait Axes<T>: From<Enu<T>> + Into<Enu<T>> + Copy {
    fn of(row: [T; 3]) -> Self;

    fn row(self) -> [T; 3];
}

macro_rules! axes {
    ($($name:ident { $a:ident, $b:ident, $c:ident })*) => {$(
        impl<T: Real> Axes<T> for $name<T> {
            #[inline(always)]
            fn of([$a, $b, $c]: [T; 3]) -> Self {
                Self { $a, $b, $c }
            }

            #[inline(always)]
            fn row(self) -> [T; 3] {
                [self.$a, self.$b, self.$c]
            }
        }
    )*};
}

axes! {
    Enu { east, north, up }
    Ned { north, east, down }
    Aer { azimuth, elevation, range }
}

/// The components of an [`Enu`] that is given in other axes.
#[inline(always)]
fn enu<T: Real, A: Axes<T>>(row: [T; 3]) -> Enu<T> {
    A::of(row).into()
}

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

/// From east, north and up to an offset in latitude, longitude and height.
#[derive(Clone, Copy)]
struct ToOffset<'a, T>(&'a LocalFrame<T>);

impl<T: Real> Element<[T; 3]> for ToOffset<'_, T> {
    type Output = [T; 3];
    type Error = InvalidEnu<T>;

    /// All numbers are: the result may be refused.
    #[inline(always)]
    fn keeps(&self, _: [T; 3]) -> bool {
        true
    }

    #[inline(always)]
    fn fast(&self, row: [T; 3]) -> ([T; 3], bool) {
        let (GeodeticOffset { lat, lon, height }, found) = self.0.fast_offset(Enu::of(row));
        ([lat, lon, height], found)
    }

    fn one(&self, row: [T; 3]) -> Result<[T; 3], InvalidEnu<T>> {
        let GeodeticOffset { lat, lon, height } = self.0.enu_to_offset(Enu::of(row))?;
        Ok([lat, lon, height])
    }
}

/// From an offset in latitude, longitude and height to east, north and up.
#[derive(Clone, Copy)]
struct OffsetSeen<'a, T>(&'a LocalFrame<T>);

impl<T: Real> Kernel<[T; 3]> for OffsetSeen<'_, T> {
    type Output = [T; 3];

    #[inline(always)]
    fn apply(&self, [lat, lon, height]: [T; 3]) -> [T; 3] {
        self.0.offset_to_enu_inline(GeodeticOffset { lat, lon, height }).row()
    }
}

/// Vectors from Earth axes to those of a frame.
#[derive(Clone, Copy)]
struct VectorSeen<'a, T>(&'a LocalFrame<T>);

impl<T: Real> Kernel<[T; 3]> for VectorSeen<'_, T> {
    type Output = [T; 3];

    #[inline(always)]
    fn apply(&self, vector: [T; 3]) -> [T; 3] {
        self.0.vector_to_enu(vector).row()
    }
}

/// Vectors from the axes of a frame to Earth axes.
#[derive(Clone, Copy)]
struct ToVector<'a, T>(&'a LocalFrame<T>);

impl<T: Real> Kernel<[T; 3]> for ToVector<'_, T> {
    type Output = [T; 3];

    #[inline(always)]
    fn apply(&self, row: [T; 3]) -> [T; 3] {
        self.0.vector_from_enu(Enu::of(row))
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

/// Converts metres east, north and up of the origin to differences from it in latitude and longitude in
/// degrees and in height in metres, with the bits of [`LocalFrame::enu_to_offset`].
///
/// # Errors
/// [`InvalidBatch`] if slices have unequal lengths, or a component is infinite or NaN, or a point is beyond
/// the scalar's largest numbers.
///
/// ```
/// use terrella::{Ellipsoid, LatLon, LocalFrame, batch::frame};
/// let pad = LocalFrame::new(Ellipsoid::WGS84, LatLon::new(28.5_f32, -80.6)?.into());
/// let (mut offset, mut back) = ([[0.0]; 3], [[0.0]; 3]);
/// let [lat, lon, height] = &mut offset;
/// frame::enu_to_offset(&pad, [&[120.0], &[0.001], &[60.0]], [lat, lon, height])?;
/// let [east, north, up] = &mut back;
/// frame::offset_to_enu(&pad, offset.each_ref().map(|c| &c[..]), [east, north, up])?;
/// assert!((back[0][0] - 120.0).abs() < 1e-5 && (back[1][0] - 0.001).abs() < 1e-5);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn enu_to_offset<T: Real>(
    frame: &LocalFrame<T>,
    enu: [&[T]; 3],
    offsets: [&mut [T]; 3],
) -> Result<(), InvalidBatch<InvalidEnu<T>>> {
    solve(ToOffset(frame), enu, offsets)
}

/// Converts differences from the origin in latitude and longitude in degrees and in height in metres to
/// metres east, north and up of it, with the bits of [`LocalFrame::offset_to_enu`]. [`enu_to_offset`] has an
/// example.
///
/// # Errors
/// [`InvalidBatch::Lengths`] if slices have unequal lengths. No element is refused.
pub fn offset_to_enu<T: Real>(
    frame: &LocalFrame<T>,
    offsets: [&[T]; 3],
    enu: [&mut [T]; 3],
) -> Result<(), InvalidBatch<Infallible>> {
    solve_by(
        offsets,
        enu,
        |row| Ok(OffsetSeen(frame).apply(row)),
        |offsets, enu, _| sweep(OffsetSeen(frame), offsets, enu),
    )
}

/// Rotates vectors, such as velocities, from Earth axes to those of the frame, with the bits of
/// [`LocalFrame::vector_to_enu`].
///
/// # Errors
/// [`InvalidBatch::Lengths`] if slices have unequal lengths. No element is refused.
///
/// ```
/// use terrella::{Ellipsoid, LatLon, LocalFrame, batch::frame};
/// let about = LocalFrame::new(Ellipsoid::WGS84, LatLon::new(0.0, 90.0)?.into());
/// let (mut east, mut north, mut up) = ([0.0], [0.0], [0.0]);
/// frame::vector_to_enu(&about, [&[-1.0], &[3.0], &[2.0]], [&mut east, &mut north, &mut up])?;
/// assert_eq!((east, north, up), ([1.0], [2.0], [3.0]));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn vector_to_enu<T: Real>(
    frame: &LocalFrame<T>,
    vectors: [&[T]; 3],
    enu: [&mut [T]; 3],
) -> Result<(), InvalidBatch<Infallible>> {
    solve_by(
        vectors,
        enu,
        |row| Ok(VectorSeen(frame).apply(row)),
        |vectors, enu, _| sweep(VectorSeen(frame), vectors, enu),
    )
}

/// Rotates vectors from the axes of the frame to Earth axes, with the bits of
/// [`LocalFrame::vector_from_enu`]: the inverse of [`vector_to_enu`].
///
/// # Errors
/// [`InvalidBatch::Lengths`] if slices have unequal lengths. No element is refused.
pub fn vector_from_enu<T: Real>(
    frame: &LocalFrame<T>,
    enu: [&[T]; 3],
    vectors: [&mut [T]; 3],
) -> Result<(), InvalidBatch<Infallible>> {
    solve_by(
        enu,
        vectors,
        |row| Ok(ToVector(frame).apply(row)),
        |enu, vectors, _| sweep(ToVector(frame), enu, vectors),
    )
}
