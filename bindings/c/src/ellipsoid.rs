use core::ffi::{CStr, c_char};

use pastey::paste;
use terrella::{Ecef, Ellipsoid, Geodetic, LatLon};

use crate::handle::{handles, init, object, put};
use crate::status::{status, terrella_status};

handles! {
    /// An ellipsoid of revolution.
    terrella_ellipsoid_f64 [f64; 2]: Ellipsoid<f64>;
    /// An ellipsoid of revolution.
    terrella_ellipsoid_f32 [f32; 2]: Ellipsoid<f32>;
}

macro_rules! functions {
    ($($t:ident)*) => {$(paste! {
        /// Makes the ellipsoid of a semi-major axis in metres and a flattening (a − b)/a.
        ///
        /// # Safety
        /// Pointers are NULL or valid; `ellipsoid` may not be NULL.
        #[unsafe(no_mangle)]
        pub unsafe extern "C" fn [<terrella_ellipsoid_init_ $t>](
            ellipsoid: *mut [<terrella_ellipsoid_ $t>],
            a: $t,
            f: $t,
        ) -> terrella_status {
            // SAFETY: the caller's.
            status(|| unsafe { init(ellipsoid, || Ok(Ellipsoid::new(a, f)?)) })
        }

        /// Makes the ellipsoid of a name, such as "wgs84", "grs80" or "moon".
        ///
        /// # Safety
        /// Pointers are NULL or valid; neither may be NULL.
        #[unsafe(no_mangle)]
        pub unsafe extern "C" fn [<terrella_ellipsoid_named_ $t>](
            ellipsoid: *mut [<terrella_ellipsoid_ $t>],
            name: *const c_char,
        ) -> terrella_status {
            // SAFETY: the caller's.
            status(|| unsafe {
                init(ellipsoid, || {
                    if name.is_null() {
                        return Err(terrella_status::TERRELLA_NULL);
                    }
                    let name = CStr::from_ptr(name).to_str().unwrap_or_default();
                    Ellipsoid::named(name).map_err(|_| terrella_status::TERRELLA_UNKNOWN)
                })
            })
        }

        /// From latitude and longitude in degrees and height in metres to Earth axes in metres: x toward 0° N 0° E, y toward
        /// 0° N 90° E, z toward the north pole. Within 1 nm (f32: 0.5 m) below 100 km.
        ///
        /// # Safety
        /// Pointers are NULL or valid; `ellipsoid` may not be NULL.
        #[unsafe(no_mangle)]
        pub unsafe extern "C" fn [<terrella_ellipsoid_to_ecef_ $t>](
            ellipsoid: *const [<terrella_ellipsoid_ $t>],
            lat: $t,
            lon: $t,
            height: $t,
            x: *mut $t,
            y: *mut $t,
            z: *mut $t,
        ) -> terrella_status {
            // SAFETY: the caller's.
            status(|| unsafe {
                let point = object(ellipsoid)?.to_ecef(Geodetic::new(LatLon::new(lat, lon)?, height)?);
                put(x, point.x());
                put(y, point.y());
                put(z, point.z());
                Ok(())
            })
        }

        /// The inverse of `terrella_ellipsoid_to_ecef`. Within 2.2 nm (f32: 1.2 m) below 100 km.
        ///
        /// # Safety
        /// Pointers are NULL or valid; `ellipsoid` may not be NULL.
        #[unsafe(no_mangle)]
        pub unsafe extern "C" fn [<terrella_ellipsoid_to_geodetic_ $t>](
            ellipsoid: *const [<terrella_ellipsoid_ $t>],
            x: $t,
            y: $t,
            z: $t,
            lat: *mut $t,
            lon: *mut $t,
            height: *mut $t,
        ) -> terrella_status {
            // SAFETY: the caller's.
            status(|| unsafe {
                let place = object(ellipsoid)?.to_geodetic(Ecef::new(x, y, z)?);
                put(lat, place.lat());
                put(lon, place.lon());
                put(height, place.height());
                Ok(())
            })
        }
    })*};
}

functions! { f64 f32 }
