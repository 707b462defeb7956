use pyo3::prelude::*;
use terrella::Ellipsoid;
use terrella::batch::area::polygons;
use terrella::geodesic::Area;

use crate::array::{Given, Made, slices, slices_mut};
use crate::geodesic::refusal;
use crate::parallel::{Columns, Refused, run};

/// Offsets of rings: n + 1 of them are n rows, and two parts share the one between them.
struct Rings<'a>(&'a [i64]);

impl Columns for Rings<'_> {
    fn rows(&self) -> usize {
        self.0.len().saturating_sub(1)
    }

    fn cut(self, rows: usize) -> (Self, Self) {
        (Self(&self.0[..=rows]), Self(&self.0[rows..]))
    }
}

/// Areas and perimeters of rings, from offsets into corners.
#[pyfunction]
fn rings_f64<'py>(
    py: Python<'py>,
    ellipsoid: (f64, f64),
    threads: usize,
    offsets: Given<'py, i64>,
    corners: [Given<'py, f64>; 2],
    mut made: [Made<'py, f64>; 2],
) -> PyResult<Refused> {
    let (corners, made) = (slices(&corners)?, slices_mut(&mut made)?);
    let area = Area::new(Ellipsoid::new(ellipsoid.0, ellipsoid.1).map_err(refusal)?).map_err(refusal)?;
    run(
        py,
        threads,
        Rings(offsets.as_slice()?),
        made,
        |Rings(offsets), [areas, perimeters]| polygons(&area, offsets, corners, areas, perimeters),
    )
}

pub fn register(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add_function(wrap_pyfunction!(rings_f64, module)?)
}
