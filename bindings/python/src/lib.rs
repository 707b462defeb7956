//! terrella for Python: NumPy's arrays as the crate's slices, and no arithmetic. The package in `python/terrella` gives shapes
//! and names to what is here.
//!
//! | file | what is in it |
//! |---|---|
//! | `parallel` | slices in parts, one a thread, without Python's lock |
//! | `array` | NumPy's arrays as slices |
//! | the others | the functions of a room, for each scalar |

mod area;
mod array;
mod cube;
mod geodesic;
mod grid;
mod parallel;
mod position;
mod tile;

use pyo3::prelude::*;

#[pymodule]
fn _terrella(module: &Bound<'_, PyModule>) -> PyResult<()> {
    area::register(module)?;
    cube::register(module)?;
    geodesic::register(module)?;
    grid::register(module)?;
    position::register(module)?;
    tile::register(module)
}
