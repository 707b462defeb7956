use core::ffi::{CStr, c_char};

use pastey::paste;
use terrella::cube::{CubeMap, FacePoint, Projection};
use terrella::{LatLon, Shift};

use crate::ellipsoid::{terrella_ellipsoid_f32, terrella_ellipsoid_f64};
use crate::handle::{handles, init, object, put};
use crate::status::{status, terrella_status};

handles! {
    /// A map of an ellipsoid onto the faces of a cube, by any projection.
    terrella_cube_f64 [f64; 38]: CubeMap<f64, Projection>;
    /// A map of an ellipsoid onto the faces of a cube, by any projection.
    terrella_cube_f32 [f32; 38]: CubeMap<f32, Projection>;
}

/// What has a name that C gives.
///
/// # Safety
/// `name` is NULL, or a string of C.
unsafe fn named<N: core::str::FromStr>(name: *const c_char) -> Result<N, terrella_status> {
    if name.is_null() {
        return Err(terrella_status::TERRELLA_NULL);
    }
    // SAFETY: as above.
    let name = unsafe { CStr::from_ptr(name) }.to_str().unwrap_or_default();
    name.parse().map_err(|_| terrella_status::TERRELLA_UNKNOWN)
}

macro_rules! functions {
    ($($t:ident)*) => {$(paste! {
        /// Makes a map: by a projection, such as "adjusted", "s2-quadratic" or "vertex", and a shift, "geodetic",
        /// "geocentric", "parametric", "authalic", "conformal" or "rectifying".
        ///
        /// # Safety
        /// Pointers are NULL or valid; none may be NULL.
        #[unsafe(no_mangle)]
        pub unsafe extern "C" fn [<terrella_cube_init_ $t>](
            cube: *mut [<terrella_cube_ $t>],
            ellipsoid: *const [<terrella_ellipsoid_ $t>],
            shift: *const c_char,
            projection: *const c_char,
        ) -> terrella_status {
            // SAFETY: the caller's.
            status(|| unsafe {
                init(cube, || {
                    let (shift, projection) = (named::<Shift>(shift)?, named::<Projection>(projection)?);
                    Ok(CubeMap::new(*object(ellipsoid)?, shift, projection)?)
                })
            })
        }

        /// From a place in degrees to a face, 0 front (0° N 0° E), 1 right, 2 back, 3 left, 4 top, 5 bottom, and x and y in
        /// [−1, 1] on it.
        ///
        /// # Safety
        /// Pointers are NULL or valid; `cube` may not be NULL.
        #[unsafe(no_mangle)]
        pub unsafe extern "C" fn [<terrella_cube_project_ $t>](
            cube: *const [<terrella_cube_ $t>],
            lat: $t,
            lon: $t,
            face: *mut u8,
            x: *mut $t,
            y: *mut $t,
        ) -> terrella_status {
            // SAFETY: the caller's.
            status(|| unsafe {
                let point = object(cube)?.project(LatLon::new(lat, lon)?);
                put(face, point.face().index());
                put(x, point.x());
                put(y, point.y());
                Ok(())
            })
        }

        /// The inverse of `terrella_cube_project`.
        ///
        /// # Safety
        /// Pointers are NULL or valid; `cube` may not be NULL.
        #[unsafe(no_mangle)]
        pub unsafe extern "C" fn [<terrella_cube_unproject_ $t>](
            cube: *const [<terrella_cube_ $t>],
            face: u32,
            x: $t,
            y: $t,
            lat: *mut $t,
            lon: *mut $t,
        ) -> terrella_status {
            // SAFETY: the caller's.
            status(|| unsafe {
                let place = object(cube)?.unproject(FacePoint::new(crate::tile::face_of(face)?, x, y)?);
                put(lat, place.lat());
                put(lon, place.lon());
                Ok(())
            })
        }
    })*};
}

functions! { f64 f32 }
