use pyo3::prelude::*;
use terrella::batch::map::{project, unproject};
use terrella::cube::{CubeMap, Projection};
use terrella::{Ellipsoid, Shift};

use crate::array::{Given, Made, slices, slices_mut};
use crate::geodesic::refusal;
use crate::parallel::{Refused, run};

/// A map of an ellipsoid onto the faces of a cube, in both scalars.
#[pyclass(frozen, skip_from_py_object)]
#[derive(Clone, Copy)]
pub struct Map {
    pub double: CubeMap<f64, Projection>,
    pub single: CubeMap<f32, Projection>,
}

#[pymethods]
impl Map {
    /// By the names of a projection and a shift.
    #[new]
    fn new(a: f64, f: f64, shift: &str, projection: &str) -> PyResult<Self> {
        let (shift, projection): (Shift, Projection) =
            (shift.parse().map_err(refusal)?, projection.parse().map_err(refusal)?);
        let ellipsoid = Ellipsoid::new(a, f).map_err(refusal)?;
        Ok(Self {
            double: CubeMap::new(ellipsoid, shift, projection).map_err(refusal)?,
            single: CubeMap::new(ellipsoid.to_f32(), shift, projection).map_err(refusal)?,
        })
    }
}

macro_rules! scalar {
    ($t:ident $field:ident $project:ident $unproject:ident) => {
        #[pyfunction]
        fn $project<'py>(
            py: Python<'py>,
            map: Bound<'py, Map>,
            threads: usize,
            places: [Given<'py, $t>; 2],
            mut faces: Made<'py, u8>,
            mut points: [Made<'py, $t>; 2],
        ) -> PyResult<Refused> {
            let (places, made) = (
                slices(&places)?,
                (faces.as_slice_mut()?, slices_mut(&mut points)?),
            );
            let map = &map.get().$field;
            run(py, threads, places, made, |places, (faces, points)| {
                project(map, places, faces, points)
            })
        }

        #[pyfunction]
        fn $unproject<'py>(
            py: Python<'py>,
            map: Bound<'py, Map>,
            threads: usize,
            faces: Given<'py, u8>,
            points: [Given<'py, $t>; 2],
            mut places: [Made<'py, $t>; 2],
        ) -> PyResult<Refused> {
            let (given, places) = ((faces.as_slice()?, slices(&points)?), slices_mut(&mut places)?);
            let map = &map.get().$field;
            run(py, threads, given, places, |(faces, points), places| {
                unproject(map, faces, points, places)
            })
        }
    };
}

scalar! { f64 double project_f64 unproject_f64 }
scalar! { f32 single project_f32 unproject_f32 }

pub fn register(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add_class::<Map>()?;
    module.add(
        "PROJECTIONS",
        Projection::ALL
            .iter()
            .map(|projection| projection.name())
            .collect::<Vec<_>>(),
    )?;
    module.add(
        "SHIFTS",
        Shift::ALL.iter().map(|shift| shift.name()).collect::<Vec<_>>(),
    )?;
    module.add_function(wrap_pyfunction!(project_f64, module)?)?;
    module.add_function(wrap_pyfunction!(project_f32, module)?)?;
    module.add_function(wrap_pyfunction!(unproject_f64, module)?)?;
    module.add_function(wrap_pyfunction!(unproject_f32, module)?)
}
