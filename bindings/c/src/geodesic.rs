use pastey::paste;
use terrella::LatLon;
use terrella::geodesic::{AndoyerSecond, Geodesic, GreatCircle, Karney, Line, Vincenty};

use crate::ellipsoid::{terrella_ellipsoid_f32, terrella_ellipsoid_f64};
use crate::handle::{handles, init, object, put};
use crate::status::{status, terrella_status};

handles! {
    /// Karney's geodesics: exact between any two places.
    terrella_karney_f64 [f64; 108]: Karney<f64>;
    /// Karney's geodesics.
    terrella_karney_f32 [u64; 55]: Karney<f32>;
    /// Vincenty's formulas (1975), which may not converge between nearly antipodal places.
    terrella_vincenty_f64 [f64; 4]: Vincenty<f64>;
    /// Vincenty's formulas (1975).
    terrella_vincenty_f32 [f32; 4]: Vincenty<f32>;
    /// Andoyer's formula to the second order in the flattening.
    terrella_andoyer_second_f64 [f64; 4]: AndoyerSecond<f64>;
    /// Andoyer's formula to the second order in the flattening.
    terrella_andoyer_second_f32 [f32; 4]: AndoyerSecond<f32>;
    /// Great circles of a sphere.
    terrella_great_circle_f64 [f64; 1]: GreatCircle<f64>;
    /// Great circles of a sphere.
    terrella_great_circle_f32 [f32; 1]: GreatCircle<f32>;
    /// A geodesic from a place at an azimuth, along which many places are found.
    terrella_line_f64 [f64; 150]: Line<f64>;
    /// A geodesic from a place at an azimuth.
    terrella_line_f32 [u64; 76]: Line<f32>;
}

/// The functions of a method: `methods! { method Type "claim"; … }`.
macro_rules! methods {
    ($($method:ident $type:ident $claim:literal;)*) => {
        methods! { @each f64 $($method $type $claim;)* }
        methods! { @each f32 $($method $type $claim;)* }
    };
    (@each $t:ident $($method:ident $type:ident $claim:literal;)*) => {$(paste! {
        /// Makes the method on an ellipsoid.
        ///
        /// # Safety
        /// Pointers are NULL or valid; neither may be NULL.
        #[unsafe(no_mangle)]
        pub unsafe extern "C" fn [<terrella_ $method _init_ $t>](
            method: *mut [<terrella_ $method _ $t>],
            ellipsoid: *const [<terrella_ellipsoid_ $t>],
        ) -> terrella_status {
            // SAFETY: the caller's.
            status(|| unsafe { init(method, || Ok($type::new(*object(ellipsoid)?)?)) })
        }

        solves! { $t $method $claim }
    })*};
}

/// What all methods have.
macro_rules! solves {
    ($t:ident $method:ident $claim:literal) => {
        paste! {
            /// From two places in degrees to the distance in metres and the azimuths at both, in degrees clockwise from north.
            ///
            #[doc = concat!(" ", $claim)]
            ///
            /// # Safety
            /// Pointers are NULL or valid; `method` may not be NULL.
            #[unsafe(no_mangle)]
            pub unsafe extern "C" fn [<terrella_ $method _inverse_ $t>](
                method: *const [<terrella_ $method _ $t>],
                lat1: $t,
                lon1: $t,
                lat2: $t,
                lon2: $t,
                distance: *mut $t,
                azimuth1: *mut $t,
                azimuth2: *mut $t,
            ) -> terrella_status {
                // SAFETY: the caller's.
                status(|| unsafe {
                    let line = object(method)?.inverse(LatLon::new(lat1, lon1)?, LatLon::new(lat2, lon2)?)?;
                    put(distance, line.distance);
                    put(azimuth1, line.azimuth1);
                    put(azimuth2, line.azimuth2);
                    Ok(())
                })
            }

            /// The distance alone, which takes less time.
            ///
            /// # Safety
            /// Pointers are NULL or valid; `method` may not be NULL.
            #[unsafe(no_mangle)]
            pub unsafe extern "C" fn [<terrella_ $method _distance_ $t>](
                method: *const [<terrella_ $method _ $t>],
                lat1: $t,
                lon1: $t,
                lat2: $t,
                lon2: $t,
                distance: *mut $t,
            ) -> terrella_status {
                // SAFETY: the caller's.
                status(|| unsafe {
                    let metres = object(method)?.distance(LatLon::new(lat1, lon1)?, LatLon::new(lat2, lon2)?)?;
                    put(distance, metres);
                    Ok(())
                })
            }

            /// From a place in degrees, an azimuth in degrees and a distance in metres to the place there, and the azimuth
            /// of travel at it.
            ///
            #[doc = concat!(" ", $claim)]
            ///
            /// # Safety
            /// Pointers are NULL or valid; `method` may not be NULL.
            #[unsafe(no_mangle)]
            pub unsafe extern "C" fn [<terrella_ $method _direct_ $t>](
                method: *const [<terrella_ $method _ $t>],
                lat1: $t,
                lon1: $t,
                azimuth1: $t,
                distance: $t,
                lat2: *mut $t,
                lon2: *mut $t,
                azimuth2: *mut $t,
            ) -> terrella_status {
                // SAFETY: the caller's.
                status(|| unsafe {
                    let end = object(method)?.direct(LatLon::new(lat1, lon1)?, azimuth1, distance)?;
                    put(lat2, end.position.lat());
                    put(lon2, end.position.lon());
                    put(azimuth2, end.azimuth);
                    Ok(())
                })
            }
        }
    };
}

methods! {
    karney Karney "Within 7 nm on the Earth between any two places, in f32 within 4 m.";
    vincenty Vincenty "Within 0.1 mm where it converges.";
    andoyer_second AndoyerSecond "Within 2e-9 of the distance to 3000 km; from 10 000 km on 0.2 m and more.";
}

macro_rules! others {
    ($($t:ident)*) => {$(paste! {
        /// Makes the method on a sphere of a radius in metres; 6371008.8 is the Earth's mean.
        ///
        /// # Safety
        /// Pointers are NULL or valid; `method` may not be NULL.
        #[unsafe(no_mangle)]
        pub unsafe extern "C" fn [<terrella_great_circle_init_ $t>](
            method: *mut [<terrella_great_circle_ $t>],
            radius: $t,
        ) -> terrella_status {
            // SAFETY: the caller's.
            status(|| unsafe { init(method, || Ok(GreatCircle::new(radius)?)) })
        }

        solves! { $t great_circle "Exact on the sphere: within 8e-16 of the distance, in f32 4.2e-7." }

        /// Makes the geodesic from a place at an azimuth, all in degrees.
        ///
        /// # Safety
        /// Pointers are NULL or valid; neither may be NULL.
        #[unsafe(no_mangle)]
        pub unsafe extern "C" fn [<terrella_line_init_ $t>](
            line: *mut [<terrella_line_ $t>],
            karney: *const [<terrella_karney_ $t>],
            lat: $t,
            lon: $t,
            azimuth: $t,
        ) -> terrella_status {
            // SAFETY: the caller's.
            status(|| unsafe { init(line, || Ok(object(karney)?.line(LatLon::new(lat, lon)?, azimuth)?)) })
        }

        /// The place at a distance in metres along a line, and the azimuth of travel at it, in degrees.
        ///
        /// # Safety
        /// Pointers are NULL or valid; `line` may not be NULL.
        #[unsafe(no_mangle)]
        pub unsafe extern "C" fn [<terrella_line_at_ $t>](
            line: *const [<terrella_line_ $t>],
            distance: $t,
            lat: *mut $t,
            lon: *mut $t,
            azimuth: *mut $t,
        ) -> terrella_status {
            // SAFETY: the caller's.
            status(|| unsafe {
                let point = object(line)?.at(distance)?;
                put(lat, point.position.lat());
                put(lon, point.position.lon());
                put(azimuth, point.azimuth);
                Ok(())
            })
        }
    })*};
}

others! { f64 f32 }
