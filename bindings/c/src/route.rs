use pastey::paste;
use terrella::LatLon;
use terrella::route::{Fence, Legs, Reach, Rhumb, Side};

use crate::ellipsoid::{terrella_ellipsoid_f32, terrella_ellipsoid_f64};
use crate::geodesic::{terrella_great_circle_f32, terrella_great_circle_f64, terrella_karney_f32, terrella_karney_f64};
use crate::handle::{Row, handles, init, init_row, object, objects, put};
use crate::status::{status, terrella_status};

handles! {
    /// Rhumb lines: lines of constant azimuth.
    terrella_rhumb_f64 [f64; 69]: Rhumb<f64>;
    /// Rhumb lines: lines of constant azimuth.
    terrella_rhumb_f32 [f32; 69]: Rhumb<f32>;
}

/// A place that was checked: a corner of a fence.
#[repr(C)]
pub struct terrella_place_f64 {
    words: [f64; 2],
}

/// A place that was checked: a corner of a fence.
#[repr(C)]
pub struct terrella_place_f32 {
    words: [f32; 2],
}

// SAFETY: two numbers, of which any can be read.
unsafe impl Row for terrella_place_f64 {
    type Object = LatLon<f64>;
}

// SAFETY: the same.
unsafe impl Row for terrella_place_f32 {
    type Object = LatLon<f32>;
}

/// Which part of a leg is closest to a place.
#[repr(i32)]
#[derive(Clone, Copy)]
pub enum terrella_reach {
    /// Its start: the place is before it.
    TERRELLA_BEFORE = -1,
    /// A place between its ends.
    TERRELLA_WITHIN = 0,
    /// Its end: the place is past it.
    TERRELLA_PAST = 1,
}

/// On which side of a fence a place is.
#[repr(i32)]
#[derive(Clone, Copy)]
pub enum terrella_side {
    /// Outside.
    TERRELLA_OUTSIDE = -1,
    /// On the edge.
    TERRELLA_EDGE = 0,
    /// Inside.
    TERRELLA_INSIDE = 1,
}

/// Legs and fences on a surface: `surface! { scalar name; … }`.
macro_rules! surface {
    ($($t:ident $surface:ident;)*) => {$(paste! {
        /// The closest place of a leg to a place, all in degrees: its distance in metres, and how many metres from the leg's
        /// start it is.
        ///
        /// # Safety
        /// Pointers are NULL or valid; `surface` may not be NULL.
        #[unsafe(no_mangle)]
        pub unsafe extern "C" fn [<terrella_ $surface _closest_ $t>](
            surface: *const [<terrella_ $surface _ $t>],
            lat1: $t,
            lon1: $t,
            lat2: $t,
            lon2: $t,
            lat: $t,
            lon: $t,
            distance: *mut $t,
            closest_lat: *mut $t,
            closest_lon: *mut $t,
            along: *mut $t,
            reach: *mut terrella_reach,
        ) -> terrella_status {
            // SAFETY: the caller's.
            status(|| unsafe {
                let [from, to] = [LatLon::new(lat1, lon1)?, LatLon::new(lat2, lon2)?];
                let closest = object(surface)?.closest(LatLon::new(lat, lon)?, from, to);
                put(distance, closest.distance);
                put(closest_lat, closest.position.lat());
                put(closest_lon, closest.position.lon());
                put(along, closest.along);
                put(reach, match closest.reach {
                    Reach::BeforeStart => terrella_reach::TERRELLA_BEFORE,
                    Reach::Within => terrella_reach::TERRELLA_WITHIN,
                    Reach::PastEnd => terrella_reach::TERRELLA_PAST,
                });
                Ok(())
            })
        }

        /// How far a place is to the right of a leg and along it, in metres, all places in degrees.
        ///
        /// # Safety
        /// Pointers are NULL or valid; `surface` may not be NULL.
        #[unsafe(no_mangle)]
        pub unsafe extern "C" fn [<terrella_ $surface _track_ $t>](
            surface: *const [<terrella_ $surface _ $t>],
            lat1: $t,
            lon1: $t,
            lat2: $t,
            lon2: $t,
            lat: $t,
            lon: $t,
            across: *mut $t,
            along: *mut $t,
        ) -> terrella_status {
            // SAFETY: the caller's.
            status(|| unsafe {
                let [from, to] = [LatLon::new(lat1, lon1)?, LatLon::new(lat2, lon2)?];
                let track = object(surface)?.track(LatLon::new(lat, lon)?, from, to);
                put(across, track.across);
                put(along, track.along);
                Ok(())
            })
        }

        /// On which side of a ring a place is, and how far from its edge: metres, negative inside. The inside is the
        /// smaller part of the Earth. Ask only for what is needed: the distance takes more time.
        ///
        /// # Safety
        /// Pointers are NULL or valid; `surface` may not be NULL, nor `ring`, of `count` places that
        /// `terrella_place_init` has made.
        #[unsafe(no_mangle)]
        pub unsafe extern "C" fn [<terrella_ $surface _fence_ $t>](
            surface: *const [<terrella_ $surface _ $t>],
            ring: *const [<terrella_place_ $t>],
            count: usize,
            lat: $t,
            lon: $t,
            side: *mut terrella_side,
            distance: *mut $t,
        ) -> terrella_status {
            // SAFETY: the caller's.
            status(|| unsafe {
                let rings = [objects(ring, count)?];
                let fence = Fence::new(object(surface)?, &rings);
                let place = LatLon::new(lat, lon)?;
                if !side.is_null() {
                    put(side, match fence.side(place) {
                        Side::Outside => terrella_side::TERRELLA_OUTSIDE,
                        Side::Edge => terrella_side::TERRELLA_EDGE,
                        Side::Inside => terrella_side::TERRELLA_INSIDE,
                    });
                }
                if !distance.is_null() {
                    put(distance, fence.distance(place));
                }
                Ok(())
            })
        }
    })*};
}

surface! {
    f64 karney;
    f32 karney;
    f64 great_circle;
    f32 great_circle;
}

macro_rules! functions {
    ($($t:ident)*) => {$(paste! {
        /// Checks a place in degrees and keeps it: a corner of a fence.
        ///
        /// # Safety
        /// Pointers are NULL or valid; `place` may not be NULL.
        #[unsafe(no_mangle)]
        pub unsafe extern "C" fn [<terrella_place_init_ $t>](
            place: *mut [<terrella_place_ $t>],
            lat: $t,
            lon: $t,
        ) -> terrella_status {
            // SAFETY: the caller's.
            status(|| unsafe { init_row(place, LatLon::new(lat, lon)?) })
        }

        /// Makes rhumb lines of an ellipsoid.
        ///
        /// # Safety
        /// Pointers are NULL or valid; neither may be NULL.
        #[unsafe(no_mangle)]
        pub unsafe extern "C" fn [<terrella_rhumb_init_ $t>](
            rhumb: *mut [<terrella_rhumb_ $t>],
            ellipsoid: *const [<terrella_ellipsoid_ $t>],
        ) -> terrella_status {
            // SAFETY: the caller's.
            status(|| unsafe { init(rhumb, || Ok(Rhumb::new(*object(ellipsoid)?)?)) })
        }

        /// The rhumb line between two places in degrees: its length in metres, and its azimuth in degrees.
        ///
        /// # Safety
        /// Pointers are NULL or valid; `rhumb` may not be NULL.
        #[unsafe(no_mangle)]
        pub unsafe extern "C" fn [<terrella_rhumb_inverse_ $t>](
            rhumb: *const [<terrella_rhumb_ $t>],
            lat1: $t,
            lon1: $t,
            lat2: $t,
            lon2: $t,
            distance: *mut $t,
            azimuth: *mut $t,
        ) -> terrella_status {
            // SAFETY: the caller's.
            status(|| unsafe {
                let line = object(rhumb)?.inverse(LatLon::new(lat1, lon1)?, LatLon::new(lat2, lon2)?);
                put(distance, line.distance);
                put(azimuth, line.azimuth);
                Ok(())
            })
        }
    })*};
}

functions! { f64 f32 }
