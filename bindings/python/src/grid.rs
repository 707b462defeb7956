use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use terrella::grid::{GridPosition, Hemisphere, Mgrs, UtmUps, Zone};
use terrella::{Ellipsoid, LatLon};

use crate::array::{Given, Made, slices, slices_mut};
use crate::geodesic::refusal;

/// One row after the other: zones differ from place to place. What is refused is NaN, or an empty text.
fn grid(ellipsoid: (f64, f64)) -> PyResult<UtmUps<f64>> {
    UtmUps::new(Ellipsoid::new(ellipsoid.0, ellipsoid.1).map_err(refusal)?).map_err(refusal)
}

/// Zones (0 is UPS), whether northern, eastings and northings of places.
#[pyfunction]
fn utm<'py>(
    ellipsoid: (f64, f64),
    places: [Given<'py, f64>; 2],
    mut bytes: [Made<'py, u8>; 2],
    mut positions: [Made<'py, f64>; 2],
) -> PyResult<usize> {
    let grid = grid(ellipsoid)?;
    let ([lat, lon], [zones, norths], [eastings, northings]) =
        (slices(&places)?, slices_mut(&mut bytes)?, slices_mut(&mut positions)?);
    let mut refused = 0;
    for row in 0..lat.len() {
        let position = LatLon::new(lat[row], lon[row])
            .ok()
            .and_then(|place| grid.forward(place).ok());
        refused += usize::from(position.is_none());
        let (zone, north, easting, northing) = position.map_or((0, false, f64::NAN, f64::NAN), |position| {
            let north = position.hemisphere == Hemisphere::North;
            (position.zone.number(), north, position.easting, position.northing)
        });
        (zones[row], norths[row], eastings[row], northings[row]) = (zone, north.into(), easting, northing);
    }
    Ok(refused)
}

/// Places of zones, whether northern, eastings and northings.
#[pyfunction]
fn from_utm<'py>(
    ellipsoid: (f64, f64),
    bytes: [Given<'py, u8>; 2],
    positions: [Given<'py, f64>; 2],
    mut places: [Made<'py, f64>; 2],
) -> PyResult<usize> {
    let grid = grid(ellipsoid)?;
    let ([zones, norths], [eastings, northings], [lat, lon]) =
        (slices(&bytes)?, slices(&positions)?, slices_mut(&mut places)?);
    let mut refused = 0;
    for row in 0..zones.len() {
        let place = Zone::new(zones[row]).ok().and_then(|zone| {
            let hemisphere = if norths[row] == 0 {
                Hemisphere::South
            } else {
                Hemisphere::North
            };
            grid.inverse(GridPosition::new(zone, hemisphere, eastings[row], northings[row]))
                .ok()
        });
        refused += usize::from(place.is_none());
        (lat[row], lon[row]) = place.map_or((f64::NAN, f64::NAN), |place| (place.lat(), place.lon()));
    }
    Ok(refused)
}

/// The text of a place's square.
#[pyfunction]
fn mgrs(ellipsoid: (f64, f64), lat: f64, lon: f64, precision: u8) -> PyResult<String> {
    let place = LatLon::new(lat, lon).map_err(refusal)?;
    Ok(Mgrs::of(&grid(ellipsoid)?, place, precision)
        .map_err(refusal)?
        .to_string())
}

/// The place in the middle of a square.
#[pyfunction]
fn from_mgrs(ellipsoid: (f64, f64), text: &str) -> PyResult<(f64, f64)> {
    let square: Mgrs = text
        .parse()
        .map_err(|why| PyValueError::new_err(format!("{text:?}: {why}")))?;
    let place = grid(ellipsoid)?.inverse(square.centre()).map_err(refusal)?;
    Ok((place.lat(), place.lon()))
}

pub fn register(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add_function(wrap_pyfunction!(utm, module)?)?;
    module.add_function(wrap_pyfunction!(from_utm, module)?)?;
    module.add_function(wrap_pyfunction!(mgrs, module)?)?;
    module.add_function(wrap_pyfunction!(from_mgrs, module)?)
}
