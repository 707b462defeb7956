use core::slice::from_raw_parts;

use pastey::paste;
use terrella::batch::{InvalidBatch, ellipsoid, geodesic};

use crate::ellipsoid::{terrella_ellipsoid_f32, terrella_ellipsoid_f64};
use crate::geodesic::{terrella_karney_f32, terrella_karney_f64};
use crate::handle::object;
use crate::status::{status, terrella_status};

/// Elements a block. Results of a block are written after all of it was read, so that arrays may be the same.
const BLOCK: usize = 512;

/// Runs blocks of arrays of C through a function of slices: I arrays in, which may not be NULL, and O arrays out, which may.
///
/// # Safety
/// Arrays that are not NULL have `count` elements.
unsafe fn blocks<T: Copy + Default, E: Into<terrella_status>, const I: usize, const O: usize>(
    given: [*const T; I],
    made: [*mut T; O],
    count: usize,
    first_refused: *mut usize,
    body: impl Fn([&[T]; I], [&mut [T]; O]) -> Result<(), InvalidBatch<E>>,
) -> Result<(), terrella_status> {
    if count > 0 && given.iter().any(|array| array.is_null()) {
        return Err(terrella_status::TERRELLA_NULL);
    }
    let size = count.saturating_mul(size_of::<T>());
    let apart = |a: usize, b: usize| a.abs_diff(b) >= size;
    for (index, &result) in made.iter().enumerate().filter(|(_, result)| !result.is_null()) {
        let same_or_apart = |&array: &*const T| array.addr() == result.addr() || apart(array.addr(), result.addr());
        let others_apart = |other: &*mut T| other.is_null() || apart(other.addr(), result.addr());
        if !given.iter().all(same_or_apart) || !made.iter().skip(index + 1).all(others_apart) {
            return Err(terrella_status::TERRELLA_OVERLAP);
        }
    }
    let mut results = [[T::default(); BLOCK]; O];
    let mut first = None;
    let mut start = 0;
    while start < count {
        let here = BLOCK.min(count - start);
        // SAFETY: as above.
        let block = given.map(|array| unsafe { from_raw_parts(array.add(start), here) });
        let columns = results
            .each_mut()
            .map(|column| column.get_mut(..here).unwrap_or_default());
        if let Err(InvalidBatch::Elements { first: at, why, .. }) = body(block, columns) {
            first.get_or_insert((start + at, why.into()));
        }
        for (array, column) in made.into_iter().zip(&results) {
            if !array.is_null() {
                // SAFETY: as above, and the column is ours.
                unsafe { core::ptr::copy_nonoverlapping(column.as_ptr(), array.add(start), here) };
            }
        }
        start += here;
    }
    let Some((at, _)) = first else { return Ok(()) };
    // SAFETY: as above.
    unsafe { crate::handle::put(first_refused, at) };
    Err(terrella_status::TERRELLA_ELEMENTS)
}

macro_rules! functions {
    ($($t:ident)*) => {$(paste! {
        /// `terrella_karney_inverse` for arrays of `count` elements, several at a time where the machine has vectors. What is
        /// refused becomes NaN, and the index of the first such goes to `first_refused`, which is not written if nothing is
        /// refused. Arrays for results may be arrays that are given, or apart from all. It takes 12 kB of stack (f32: 6), with
        /// vectors more.
        ///
        /// # Safety
        /// Arrays given may not be NULL; results may.
        #[unsafe(no_mangle)]
        pub unsafe extern "C" fn [<terrella_karney_inverse_all_ $t>](
            karney: *const [<terrella_karney_ $t>],
            count: usize,
            lat1: *const $t,
            lon1: *const $t,
            lat2: *const $t,
            lon2: *const $t,
            distance: *mut $t,
            azimuth1: *mut $t,
            azimuth2: *mut $t,
            first_refused: *mut usize,
        ) -> terrella_status {
            // SAFETY: the caller's.
            status(|| unsafe {
                let karney = object(karney)?;
                let given = [lat1, lon1, lat2, lon2];
                blocks(given, [distance, azimuth1, azimuth2], count, first_refused, |[lat1, lon1, lat2, lon2], lines| {
                    geodesic::inverse(karney, [lat1, lon1], [lat2, lon2], lines)
                })
            })
        }

        /// `terrella_karney_direct` for arrays, in the manner of `terrella_karney_inverse_all`.
        ///
        /// # Safety
        /// Arrays given may not be NULL; results may.
        #[unsafe(no_mangle)]
        pub unsafe extern "C" fn [<terrella_karney_direct_all_ $t>](
            karney: *const [<terrella_karney_ $t>],
            count: usize,
            lat1: *const $t,
            lon1: *const $t,
            azimuth1: *const $t,
            distance: *const $t,
            lat2: *mut $t,
            lon2: *mut $t,
            azimuth2: *mut $t,
            first_refused: *mut usize,
        ) -> terrella_status {
            // SAFETY: the caller's.
            status(|| unsafe {
                let karney = object(karney)?;
                let given = [lat1, lon1, azimuth1, distance];
                blocks(given, [lat2, lon2, azimuth2], count, first_refused, |[lat, lon, azimuth, distance], ends| {
                    geodesic::direct(karney, [lat, lon], azimuth, distance, ends)
                })
            })
        }

        /// `terrella_ellipsoid_to_ecef` for arrays, in the manner of `terrella_karney_inverse_all`.
        ///
        /// # Safety
        /// Arrays given may not be NULL; results may.
        #[unsafe(no_mangle)]
        pub unsafe extern "C" fn [<terrella_ellipsoid_to_ecef_all_ $t>](
            ellipsoid: *const [<terrella_ellipsoid_ $t>],
            count: usize,
            lat: *const $t,
            lon: *const $t,
            height: *const $t,
            x: *mut $t,
            y: *mut $t,
            z: *mut $t,
            first_refused: *mut usize,
        ) -> terrella_status {
            // SAFETY: the caller's.
            status(|| unsafe {
                let figure = *object(ellipsoid)?;
                blocks([lat, lon, height], [x, y, z], count, first_refused, |places, points| {
                    ellipsoid::to_ecef(figure, places, points)
                })
            })
        }

        /// `terrella_ellipsoid_to_geodetic` for arrays, in the manner of `terrella_karney_inverse_all`.
        ///
        /// # Safety
        /// Arrays given may not be NULL; results may.
        #[unsafe(no_mangle)]
        pub unsafe extern "C" fn [<terrella_ellipsoid_to_geodetic_all_ $t>](
            ellipsoid: *const [<terrella_ellipsoid_ $t>],
            count: usize,
            x: *const $t,
            y: *const $t,
            z: *const $t,
            lat: *mut $t,
            lon: *mut $t,
            height: *mut $t,
            first_refused: *mut usize,
        ) -> terrella_status {
            // SAFETY: the caller's.
            status(|| unsafe {
                let figure = *object(ellipsoid)?;
                blocks([x, y, z], [lat, lon, height], count, first_refused, |points, places| {
                    ellipsoid::to_geodetic(figure, points, places)
                })
            })
        }
    })*};
}

functions! { f64 f32 }
