use pastey::paste;
use terrella::LatLon;
use terrella::geodesic::Area;

use crate::ellipsoid::{terrella_ellipsoid_f32, terrella_ellipsoid_f64};
use crate::handle::{handles, init, object, put};
use crate::status::{status, terrella_status};

handles! {
    /// The measure of areas on an ellipsoid.
    terrella_area_f64 [f64; 188]: Area<f64>;
    /// The measure of areas on an ellipsoid.
    terrella_area_f32 [u64; 96]: Area<f32>;
}

macro_rules! functions {
    ($($t:ident)*) => {$(paste! {
        /// Makes the measure of areas on an ellipsoid.
        ///
        /// # Safety
        /// Pointers are NULL or valid; neither may be NULL.
        #[unsafe(no_mangle)]
        pub unsafe extern "C" fn [<terrella_area_init_ $t>](
            area: *mut [<terrella_area_ $t>],
            ellipsoid: *const [<terrella_ellipsoid_ $t>],
        ) -> terrella_status {
            // SAFETY: the caller's.
            status(|| unsafe { init(area, || Ok(Area::new(*object(ellipsoid)?)?)) })
        }

        /// The area in m² and the perimeter in metres of a polygon with geodesic edges: positive counter-clockwise. The last
        /// corner is joined to the first.
        ///
        /// # Safety
        /// Pointers are NULL or valid; `area` may not be NULL, nor `lat` and `lon`, of `count` degrees each, unless `count`
        /// is 0.
        #[unsafe(no_mangle)]
        pub unsafe extern "C" fn [<terrella_area_polygon_ $t>](
            area: *const [<terrella_area_ $t>],
            lat: *const $t,
            lon: *const $t,
            count: usize,
            square_metres: *mut $t,
            perimeter: *mut $t,
        ) -> terrella_status {
            // SAFETY: the caller's.
            status(|| unsafe {
                let mut polygon = object(area)?.polygon();
                if count > 0 && (lat.is_null() || lon.is_null()) {
                    return Err(terrella_status::TERRELLA_NULL);
                }
                for corner in 0..count {
                    polygon.add(LatLon::new(lat.add(corner).read(), lon.add(corner).read())?);
                }
                put(square_metres, polygon.area());
                put(perimeter, polygon.perimeter());
                Ok(())
            })
        }
    })*};
}

functions! { f64 f32 }
