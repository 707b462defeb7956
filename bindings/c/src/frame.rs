use pastey::paste;
use terrella::{Aer, Enu, Geodetic, LatLon, LocalFrame, Ned};

use crate::ellipsoid::{terrella_ellipsoid_f32, terrella_ellipsoid_f64};
use crate::handle::{handles, init, object, put};
use crate::status::{status, terrella_status};

handles! {
    /// Axes about an origin.
    terrella_frame_f64 [f64; 14]: LocalFrame<f64>;
    /// Axes about an origin.
    terrella_frame_f32 [f32; 14]: LocalFrame<f32>;
}

/// Both ways of one kind of axes.
macro_rules! axes {
    ($t:ident $($name:ident $type:ident $a:ident $b:ident $c:ident $doc:literal;)*) => {$(paste! {
        #[doc = concat!(" From a place in degrees and a height in metres to ", $doc, ".")]
        ///
        /// # Safety
        /// Pointers are NULL or valid; `frame` may not be NULL.
        #[unsafe(no_mangle)]
        pub unsafe extern "C" fn [<terrella_frame_to_ $name _ $t>](
            frame: *const [<terrella_frame_ $t>],
            lat: $t,
            lon: $t,
            height: $t,
            $a: *mut $t,
            $b: *mut $t,
            $c: *mut $t,
        ) -> terrella_status {
            // SAFETY: the caller's.
            status(|| unsafe {
                let place = Geodetic::new(LatLon::new(lat, lon)?, height)?;
                let seen = object(frame)?.[<geodetic_to_ $name>](place);
                put($a, seen.$a);
                put($b, seen.$b);
                put($c, seen.$c);
                Ok(())
            })
        }

        #[doc = concat!(" From ", $doc, " to a place in degrees and a height in metres.")]
        ///
        /// # Safety
        /// Pointers are NULL or valid; `frame` may not be NULL.
        #[unsafe(no_mangle)]
        pub unsafe extern "C" fn [<terrella_frame_from_ $name _ $t>](
            frame: *const [<terrella_frame_ $t>],
            $a: $t,
            $b: $t,
            $c: $t,
            lat: *mut $t,
            lon: *mut $t,
            height: *mut $t,
        ) -> terrella_status {
            // SAFETY: the caller's.
            status(|| unsafe {
                let place = object(frame)?.[<$name _to_geodetic>]($type { $a, $b, $c })?;
                put(lat, place.lat());
                put(lon, place.lon());
                put(height, place.height());
                Ok(())
            })
        }
    })*};
}

macro_rules! functions {
    ($($t:ident)*) => {$(paste! {
        /// Makes the axes about an origin, in degrees and metres.
        ///
        /// # Safety
        /// Pointers are NULL or valid; neither may be NULL.
        #[unsafe(no_mangle)]
        pub unsafe extern "C" fn [<terrella_frame_init_ $t>](
            frame: *mut [<terrella_frame_ $t>],
            ellipsoid: *const [<terrella_ellipsoid_ $t>],
            lat: $t,
            lon: $t,
            height: $t,
        ) -> terrella_status {
            // SAFETY: the caller's.
            status(|| unsafe {
                init(frame, || {
                    let origin = Geodetic::new(LatLon::new(lat, lon)?, height)?;
                    Ok(LocalFrame::new(*object(ellipsoid)?, origin))
                })
            })
        }

        axes! {
            $t
            enu Enu east north up "east, north and up, in metres";
            ned Ned north east down "north, east and down, in metres";
            aer Aer azimuth elevation range
                "azimuth clockwise from north and elevation, in degrees, and range in metres";
        }
    })*};
}

functions! { f64 f32 }
