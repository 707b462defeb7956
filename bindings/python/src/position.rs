use pyo3::prelude::*;
use terrella::batch::ellipsoid::{to_ecef, to_geodetic};
use terrella::batch::{frame, latitude};
use terrella::latitude::Conversion;
use terrella::{Ellipsoid, Geodetic, LatLon, Latitude, LocalFrame};

use crate::array::{Given, Made, slices, slices_mut};
use crate::geodesic::refusal;
use crate::parallel::{Refused, run};

macro_rules! scalar {
    ($t:ident $ecef:ident $geodetic:ident $frame:ident $latitude:ident) => {
        #[pyfunction]
        fn $ecef<'py>(
            py: Python<'py>,
            ellipsoid: (f64, f64),
            threads: usize,
            given: [Given<'py, $t>; 3],
            mut made: [Made<'py, $t>; 3],
        ) -> PyResult<Refused> {
            let (given, made) = (slices(&given)?, slices_mut(&mut made)?);
            let figure = Ellipsoid::new(ellipsoid.0 as $t, ellipsoid.1 as $t).map_err(refusal)?;
            run(py, threads, given, made, |places, points| {
                to_ecef(figure, places, points)
            })
        }

        #[pyfunction]
        fn $geodetic<'py>(
            py: Python<'py>,
            ellipsoid: (f64, f64),
            threads: usize,
            given: [Given<'py, $t>; 3],
            mut made: [Made<'py, $t>; 3],
        ) -> PyResult<Refused> {
            let (given, made) = (slices(&given)?, slices_mut(&mut made)?);
            let figure = Ellipsoid::new(ellipsoid.0 as $t, ellipsoid.1 as $t).map_err(refusal)?;
            run(py, threads, given, made, |points, places| {
                to_geodetic(figure, points, places)
            })
        }

        /// Both ways between places and the axes of a frame, by the way's name.
        #[pyfunction]
        fn $frame<'py>(
            py: Python<'py>,
            way: &str,
            ellipsoid: (f64, f64),
            origin: (f64, f64, f64),
            threads: usize,
            given: [Given<'py, $t>; 3],
            mut made: [Made<'py, $t>; 3],
        ) -> PyResult<Refused> {
            let (given, made) = (slices(&given)?, slices_mut(&mut made)?);
            let figure = Ellipsoid::new(ellipsoid.0 as $t, ellipsoid.1 as $t).map_err(refusal)?;
            let place = LatLon::new(origin.0 as $t, origin.1 as $t).map_err(refusal)?;
            let axes = LocalFrame::new(figure, Geodetic::new(place, origin.2 as $t).map_err(refusal)?);
            match way {
                "to_enu" => run(py, threads, given, made, |g, m| {
                    frame::geodetic_to_enu(&axes, g, m)
                }),
                "to_ned" => run(py, threads, given, made, |g, m| {
                    frame::geodetic_to_ned(&axes, g, m)
                }),
                "to_aer" => run(py, threads, given, made, |g, m| {
                    frame::geodetic_to_aer(&axes, g, m)
                }),
                "from_enu" => run(py, threads, given, made, |g, m| {
                    frame::enu_to_geodetic(&axes, g, m)
                }),
                "from_ned" => run(py, threads, given, made, |g, m| {
                    frame::ned_to_geodetic(&axes, g, m)
                }),
                "from_aer" => run(py, threads, given, made, |g, m| {
                    frame::aer_to_geodetic(&axes, g, m)
                }),
                _ => Err(refusal(format_args!("{way:?} is no way between places and axes"))),
            }
        }

        /// From one auxiliary latitude to another, in degrees.
        #[pyfunction]
        fn $latitude<'py>(
            py: Python<'py>,
            ellipsoid: (f64, f64),
            from: &str,
            to: &str,
            threads: usize,
            given: [Given<'py, $t>; 1],
            mut made: [Made<'py, $t>; 1],
        ) -> PyResult<Refused> {
            let (given, made) = (slices(&given)?, slices_mut(&mut made)?);
            let figure = Ellipsoid::new(ellipsoid.0 as $t, ellipsoid.1 as $t).map_err(refusal)?;
            let (from, to): (Latitude, Latitude) = (from.parse().map_err(refusal)?, to.parse().map_err(refusal)?);
            let conversion = Conversion::new(figure, from, to).map_err(refusal)?;
            run(py, threads, given, made, |[from], [to]| {
                latitude::degrees(&conversion, from, to)
            })
        }
    };
}

scalar! { f64 to_ecef_f64 to_geodetic_f64 frame_f64 latitude_f64 }
scalar! { f32 to_ecef_f32 to_geodetic_f32 frame_f32 latitude_f32 }

pub fn register(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add(
        "LATITUDES",
        Latitude::ALL.iter().map(|latitude| latitude.name()).collect::<Vec<_>>(),
    )?;
    module.add_function(wrap_pyfunction!(to_ecef_f64, module)?)?;
    module.add_function(wrap_pyfunction!(to_ecef_f32, module)?)?;
    module.add_function(wrap_pyfunction!(to_geodetic_f64, module)?)?;
    module.add_function(wrap_pyfunction!(to_geodetic_f32, module)?)?;
    module.add_function(wrap_pyfunction!(frame_f64, module)?)?;
    module.add_function(wrap_pyfunction!(frame_f32, module)?)?;
    module.add_function(wrap_pyfunction!(latitude_f64, module)?)?;
    module.add_function(wrap_pyfunction!(latitude_f32, module)?)
}
