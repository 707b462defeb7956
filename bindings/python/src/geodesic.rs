use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use terrella::batch::geodesic::{along, direct, distance, inverse};
use terrella::geodesic::{AnyMethod, Karney, Method};
use terrella::{Ellipsoid, LatLon};

use crate::array::{Given, Made, slices, slices_mut};
use crate::parallel::{Refused, run};

/// A method on an ellipsoid, in both scalars.
#[pyclass(frozen, skip_from_py_object)]
#[derive(Clone, Copy)]
pub struct Solver {
    double: AnyMethod<f64>,
    single: AnyMethod<f32>,
}

/// The error of Python with our words.
pub fn refusal(why: impl std::fmt::Display) -> PyErr {
    PyValueError::new_err(why.to_string())
}

#[pymethods]
impl Solver {
    /// By its name, on an ellipsoid, about a place if it needs one.
    #[new]
    fn new(method: &str, a: f64, f: f64, about: Option<(f64, f64)>) -> PyResult<Self> {
        let method: Method = method.parse().map_err(refusal)?;
        let ellipsoid = Ellipsoid::new(a, f).map_err(refusal)?;
        let single = ellipsoid.to_f32();
        Ok(match about {
            None => Self {
                double: method.on(ellipsoid).map_err(refusal)?,
                single: method.on(single).map_err(refusal)?,
            },
            Some((lat, lon)) => {
                let place = LatLon::new(lat, lon).map_err(refusal)?;
                let rounded = LatLon::new(lat as f32, lon as f32).map_err(refusal)?;
                Self {
                    double: method.about(ellipsoid, place).map_err(refusal)?,
                    single: method.about(single, rounded).map_err(refusal)?,
                }
            }
        })
    }
}

macro_rules! functions {
    ($t:ident $field:ident $inverse:ident $distance:ident $direct:ident) => {
        #[pyfunction]
        fn $inverse<'py>(
            py: Python<'py>,
            solver: Bound<'py, Solver>,
            threads: usize,
            given: [Given<'py, $t>; 4],
            mut made: [Made<'py, $t>; 3],
        ) -> PyResult<Refused> {
            let (given, made) = (slices(&given)?, slices_mut(&mut made)?);
            let method = &solver.get().$field;
            run(py, threads, given, made, |[lat1, lon1, lat2, lon2], lines| {
                inverse(method, [lat1, lon1], [lat2, lon2], lines)
            })
        }

        #[pyfunction]
        fn $distance<'py>(
            py: Python<'py>,
            solver: Bound<'py, Solver>,
            threads: usize,
            given: [Given<'py, $t>; 4],
            mut made: [Made<'py, $t>; 1],
        ) -> PyResult<Refused> {
            let (given, made) = (slices(&given)?, slices_mut(&mut made)?);
            let method = &solver.get().$field;
            run(py, threads, given, made, |[lat1, lon1, lat2, lon2], [metres]| {
                distance(method, [lat1, lon1], [lat2, lon2], metres)
            })
        }

        #[pyfunction]
        fn $direct<'py>(
            py: Python<'py>,
            solver: Bound<'py, Solver>,
            threads: usize,
            given: [Given<'py, $t>; 4],
            mut made: [Made<'py, $t>; 3],
        ) -> PyResult<Refused> {
            let (given, made) = (slices(&given)?, slices_mut(&mut made)?);
            let method = &solver.get().$field;
            run(py, threads, given, made, |[lat, lon, azimuth, distance], ends| {
                direct(method, [lat, lon], azimuth, distance, ends)
            })
        }
    };
}

functions! { f64 double inverse_f64 distance_f64 direct_f64 }
functions! { f32 single inverse_f32 distance_f32 direct_f32 }

/// Places along Karney's line from a place at an azimuth.
#[pyfunction]
fn along_f64<'py>(
    py: Python<'py>,
    ellipsoid: (f64, f64),
    start: (f64, f64, f64),
    threads: usize,
    given: [Given<'py, f64>; 1],
    mut made: [Made<'py, f64>; 3],
) -> PyResult<Refused> {
    let (given, made) = (slices(&given)?, slices_mut(&mut made)?);
    let ellipsoid = Ellipsoid::new(ellipsoid.0, ellipsoid.1).map_err(refusal)?;
    let from = LatLon::new(start.0, start.1).map_err(refusal)?;
    let line = Karney::new(ellipsoid)
        .map_err(refusal)?
        .line(from, start.2)
        .map_err(refusal)?;
    run(py, threads, given, made, |[distance], points| {
        along(&line, distance, points)
    })
}

/// Semi-major axis and flattening of the ellipsoid of a name.
#[pyfunction]
fn ellipsoid(name: &str) -> PyResult<(f64, f64)> {
    let ellipsoid = Ellipsoid::<f64>::named(name).map_err(refusal)?;
    Ok((ellipsoid.a(), ellipsoid.f()))
}

pub fn register(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add_class::<Solver>()?;
    module.add(
        "METHODS",
        Method::ALL.iter().map(|method| method.name()).collect::<Vec<_>>(),
    )?;
    module.add("ELLIPSOIDS", terrella::NAMED.to_vec())?;
    module.add_function(wrap_pyfunction!(ellipsoid, module)?)?;
    module.add_function(wrap_pyfunction!(inverse_f64, module)?)?;
    module.add_function(wrap_pyfunction!(inverse_f32, module)?)?;
    module.add_function(wrap_pyfunction!(distance_f64, module)?)?;
    module.add_function(wrap_pyfunction!(distance_f32, module)?)?;
    module.add_function(wrap_pyfunction!(direct_f64, module)?)?;
    module.add_function(wrap_pyfunction!(direct_f32, module)?)?;
    module.add_function(wrap_pyfunction!(along_f64, module)?)
}
