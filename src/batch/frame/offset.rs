//! Differences in latitude, longitude and height.

use core::convert::Infallible;

use super::Axes;
use crate::batch::InvalidBatch;
use crate::batch::engine::{solve, solve_by};
use crate::frame::{GeodeticOffset, InvalidEnu};
use crate::simd::{Element, Kernel, sweep};
use crate::{Enu, LocalFrame, Real};

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
