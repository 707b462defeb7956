use pyo3::prelude::*;
use terrella::Ellipsoid;
use terrella::batch::healpix::{centre, containing};
use terrella::batch::terrain::{from_key, places_to_key, to_key};
use terrella::healpix::OnEllipsoid;
use terrella::terrain::{Covering, Hilbert, Key, LatLonBox, Tile};

use crate::array::{Given, Made, slices, slices_mut};
use crate::cube::Map;
use crate::geodesic::refusal;
use crate::parallel::{Refused, run};

/// Keys of the tiles of a level that contain places.
#[pyfunction]
fn keys<'py>(
    py: Python<'py>,
    map: Bound<'py, Map>,
    level: u8,
    threads: usize,
    places: [Given<'py, f64>; 2],
    mut keys: [Made<'py, u64>; 1],
) -> PyResult<Refused> {
    let (places, keys) = (slices(&places)?, slices_mut(&mut keys)?);
    if level > Tile::MAX_LEVEL {
        return Err(refusal(format_args!(
            "level {level} is not in 0 to {}",
            Tile::MAX_LEVEL
        )));
    }
    let map = &map.get().double;
    run(py, threads, places, keys, |places, [keys]| {
        places_to_key::<Hilbert, _, _>(map, level, places, keys)
    })
}

/// Keys of tiles.
#[pyfunction]
fn tiles_to_keys<'py>(
    py: Python<'py>,
    threads: usize,
    bytes: [Given<'py, u8>; 2],
    squares: [Given<'py, u32>; 2],
    mut keys: [Made<'py, u64>; 1],
) -> PyResult<Refused> {
    let (given, keys) = ((slices(&bytes)?, slices(&squares)?), slices_mut(&mut keys)?);
    run(py, threads, given, keys, |([faces, levels], squares), [keys]| {
        to_key::<Hilbert, u8>(faces, levels, squares, keys)
    })
}

/// Tiles of keys.
#[pyfunction]
fn keys_to_tiles<'py>(
    py: Python<'py>,
    threads: usize,
    keys: [Given<'py, u64>; 1],
    mut bytes: [Made<'py, u8>; 2],
    mut squares: [Made<'py, u32>; 2],
) -> PyResult<Refused> {
    let (keys, made) = (slices(&keys)?, (slices_mut(&mut bytes)?, slices_mut(&mut squares)?));
    run(py, threads, keys, made, |[keys], ([faces, levels], squares)| {
        from_key::<Hilbert, u8>(keys, faces, levels, squares)
    })
}

/// South, west, north and east of the box that holds a tile.
#[pyfunction]
fn bounds(map: Bound<'_, Map>, key: u64) -> PyResult<(f64, f64, f64, f64)> {
    let tile = Tile::from(Key::<Hilbert>::new(key).map_err(refusal)?);
    let bounds = LatLonBox::of_tile(&map.get().double, tile);
    Ok((bounds.south(), bounds.west(), bounds.north(), bounds.east()))
}

/// Keys of the tiles that cover a box, at most so many.
#[pyfunction]
#[allow(clippy::too_many_arguments)] // the package names them
fn cover(
    map: Bound<'_, Map>,
    south: f64,
    west: f64,
    north: f64,
    east: f64,
    level: u8,
    inner: bool,
    mixed: bool,
    limit: usize,
) -> PyResult<Vec<u64>> {
    let region = LatLonBox::new(south, west, north, east).map_err(refusal)?;
    let mut covering = Covering::new(map.get().double, region, level).map_err(refusal)?;
    if inner {
        covering = covering.inner();
    }
    if mixed {
        covering = covering.mixed();
    }
    let mut keys = Vec::new();
    for tile in covering {
        if keys.len() == limit {
            return Err(refusal(format_args!(
                "more than {limit} tiles cover this box at level {level}"
            )));
        }
        keys.push(Key::<Hilbert>::from(tile).bits());
    }
    keys.sort_unstable();
    Ok(keys)
}

/// Numbers of HEALPix's pixels of a depth that contain places, in the nested scheme.
#[pyfunction]
fn healpix_containing<'py>(
    py: Python<'py>,
    ellipsoid: (f64, f64),
    depth: u8,
    threads: usize,
    places: [Given<'py, f64>; 2],
    mut numbers: [Made<'py, u64>; 1],
) -> PyResult<Refused> {
    let (places, numbers) = (slices(&places)?, slices_mut(&mut numbers)?);
    let surface = surface(ellipsoid)?;
    run(py, threads, places, numbers, |places, [numbers]| {
        containing(&surface, depth, places, numbers)
    })
}

/// Centres of pixels.
#[pyfunction]
fn healpix_centre<'py>(
    py: Python<'py>,
    ellipsoid: (f64, f64),
    depth: u8,
    threads: usize,
    numbers: [Given<'py, u64>; 1],
    mut places: [Made<'py, f64>; 2],
) -> PyResult<Refused> {
    let (numbers, places) = (slices(&numbers)?, slices_mut(&mut places)?);
    let surface = surface(ellipsoid)?;
    run(py, threads, numbers, places, |[numbers], places| {
        centre(&surface, depth, numbers, places)
    })
}

fn surface(ellipsoid: (f64, f64)) -> PyResult<OnEllipsoid<f64>> {
    OnEllipsoid::new(Ellipsoid::new(ellipsoid.0, ellipsoid.1).map_err(refusal)?).map_err(refusal)
}

pub fn register(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add_function(wrap_pyfunction!(keys, module)?)?;
    module.add_function(wrap_pyfunction!(tiles_to_keys, module)?)?;
    module.add_function(wrap_pyfunction!(keys_to_tiles, module)?)?;
    module.add_function(wrap_pyfunction!(bounds, module)?)?;
    module.add_function(wrap_pyfunction!(cover, module)?)?;
    module.add_function(wrap_pyfunction!(healpix_containing, module)?)?;
    module.add_function(wrap_pyfunction!(healpix_centre, module)?)
}
