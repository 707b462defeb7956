//! Where there is land.

use std::fs;
use std::path::Path;

use terrella::Direction;

use draw::outcome::cannot;

use crate::geography::vertex;

/// Columns of longitude: half a degree each.
const COLUMNS: usize = 720;

/// The land, as the latitudes at which the meridian in the middle of each column crosses a coast, from south to
/// north.
pub struct Land(Vec<Vec<f64>>);

impl Land {
    /// Reads coasts: a heading, then `ring longitude latitude` a line. A ring that goes around a pole needs no
    /// detour along the border of the map.
    pub fn read(path: &Path) -> Result<Self, String> {
        let text = fs::read_to_string(path).map_err(|error| cannot("read", path, &error))?;
        let rows: Vec<_> = text
            .lines()
            .filter(|row| !row.starts_with('#'))
            .skip(1)
            .filter_map(vertex)
            .collect();
        let mut columns = vec![Vec::new(); COLUMNS];
        for ends in rows.windows(2) {
            let ((ring, from), (next, to)) = (ends[0], ends[1]);
            if ring != next {
                continue;
            }
            let turns = ((to.lon() - from.lon()) / 360.0).round();
            let (west, step) = (from.lon(), to.lon() - 360.0 * turns - from.lon());
            let column = |lon: f64| (lon + 180.0) * COLUMNS as f64 / 360.0 - 0.5;
            let (first, last) = (column(west.min(west + step)), column(west.max(west + step)));
            // Each end belongs to one of the two steps that meet there.
            for index in first.ceil() as i64..last.ceil() as i64 {
                let along = ((index as f64 + 0.5) * 360.0 / COLUMNS as f64 - 180.0 - west) / step;
                let lat = from.lat() + along * (to.lat() - from.lat());
                columns[index.rem_euclid(COLUMNS as i64) as usize].push(lat);
            }
        }
        for column in &mut columns {
            column.sort_by(f64::total_cmp);
        }
        Ok(Self(columns))
    }

    /// Whether a place is on land: from there to the north pole, which is at sea, an odd number of coasts is
    /// crossed.
    pub fn holds(&self, normal: Direction<f64>) -> bool {
        let place = normal.to_lat_lon();
        let column = ((place.lon() + 180.0) * COLUMNS as f64 / 360.0) as usize % COLUMNS;
        let coasts = &self.0[column];
        let south = coasts.partition_point(|&lat| lat < place.lat());
        (coasts.len() - south) % 2 == 1
    }
}

#[cfg(test)]
mod tests {
    use super::Land;
    use terrella::{Direction, Ellipsoid, LatLon, Shift, Shifted};

    fn land() -> Land {
        Land::read(&draw::data::file("land-110m.tsv")).unwrap_or_else(|why| unreachable!("{why}"))
    }

    #[test]
    fn continents_and_oceans() {
        let land = land();
        let sphere = Shifted::new(Ellipsoid::WGS84, Shift::Geodetic).unwrap_or_else(|_| unreachable!("an ellipsoid"));
        let holds = |lat, lon| land.holds(sphere.to_direction(LatLon::new(lat, lon).unwrap_or_default()));
        for (lat, lon) in [
            (48.0, 2.5),
            (0.0, 20.0),
            (-25.0, 135.0),
            (-89.9, 10.0),
            (66.0, 179.0),
            (72.0, -40.0),
        ] {
            assert!(holds(lat, lon), "{lat} {lon} is land");
        }
        for (lat, lon) in [(89.9, 0.0), (0.0, -30.0), (40.0, 180.0), (-60.0, -180.0), (35.0, 18.0)] {
            assert!(!holds(lat, lon), "{lat} {lon} is sea");
        }
    }

    #[test]
    fn three_tenths_of_the_planet() {
        let land = land();
        let places = 40_000;
        let dry = (0..places)
            .filter(|&i| {
                // Evenly, on a spiral.
                let z = f64::from(2 * i + 1) / f64::from(places) - 1.0;
                let (sin, cos) = (2.399_963_229_728_653 * f64::from(i)).sin_cos();
                let axial = (1.0 - z * z).sqrt();
                Direction::new(axial * cos, axial * sin, z).is_ok_and(|place| land.holds(place))
            })
            .count();
        let share = dry as f64 / f64::from(places);
        assert!((0.28..0.30).contains(&share), "{share}");
    }
}
