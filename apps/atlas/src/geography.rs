//! The lines of a map: coasts, parallels and meridians.

use std::fs;
use std::path::Path;

use terrella::LatLon;

use draw::outcome::cannot;

/// Vertices (longitude, latitude) in degrees, joined by lines that are straight in both. No step is longer than half a turn:
/// the longitudes run on past 180 instead.
pub struct Line(Vec<[f64; 2]>);

impl Line {
    /// Steps from vertex to vertex.
    pub fn steps(&self) -> usize {
        self.0.len() - 1
    }

    /// The place after `t` steps.
    pub fn at(&self, t: f64) -> LatLon<f64> {
        let step = (t as usize).min(self.steps() - 1);
        let along = t - step as f64;
        let ([from_lon, from_lat], [to_lon, to_lat]) = (self.0[step], self.0[step + 1]);
        let lon = from_lon + along * (to_lon - from_lon);
        let lat = from_lat + along * (to_lat - from_lat);
        LatLon::new(lat.clamp(-90.0, 90.0), lon).unwrap_or_default()
    }
}

/// Reads coasts: a heading, then `ring longitude latitude` a line.
pub fn coastline(path: &Path) -> Result<Vec<Line>, String> {
    let text = fs::read_to_string(path).map_err(|error| cannot("read", path, &error))?;
    let rows = text
        .lines()
        .enumerate()
        .filter(|(_, row)| !row.starts_with('#'))
        .skip(1);
    let mut lines = Vec::new();
    let mut line: Vec<[f64; 2]> = Vec::new();
    let mut last: Option<(u32, LatLon<f64>)> = None;
    for (number, row) in rows {
        let (ring, place) = vertex(row).ok_or_else(|| {
            format!(
                "{}: line {} is no ring, longitude, latitude",
                path.display(),
                number + 1
            )
        })?;
        let joined = last.is_some_and(|(last_ring, from)| last_ring == ring && !is_artificial(from, place));
        if !joined {
            finish(&mut line, &mut lines);
        }
        let turns = line
            .last()
            .map_or(0.0, |[lon, _]| ((lon - place.lon()) / 360.0).round());
        line.push([place.lon() + 360.0 * turns, place.lat()]);
        last = Some((ring, place));
    }
    finish(&mut line, &mut lines);
    Ok(lines)
}

/// The ring and the place of a line.
pub fn vertex(row: &str) -> Option<(u32, LatLon<f64>)> {
    let mut columns = row.split('\t');
    let ring = columns.next()?.parse().ok()?;
    let lon = columns.next()?.parse().ok()?;
    let lat = columns.next()?.parse().ok()?;
    Some((ring, LatLon::new(lat, lon).ok()?))
}

/// Whether a step runs along the border of the flat map, where land was cut in two: there is no coast.
fn is_artificial(from: LatLon<f64>, to: LatLon<f64>) -> bool {
    from.lon().abs() == 180.0 && to.lon().abs() == 180.0
}

fn finish(line: &mut Vec<[f64; 2]>, lines: &mut Vec<Line>) {
    let line = std::mem::take(line);
    if line.len() > 1 {
        lines.push(Line(line));
    }
}

/// Degrees from one line of the graticule to the next.
const SPACING: u16 = 15;

/// Parallels and meridians. Only every sixth meridian goes on to the poles, where they would crowd.
pub fn graticule() -> Vec<Line> {
    let parallels = (1..180 / SPACING).map(|i| {
        let lat = f64::from(i * SPACING) - 90.0;
        Line((-60..=60).map(|lon| [3.0 * f64::from(lon), lat]).collect())
    });
    let meridians = (0..360 / SPACING).map(|i| {
        let lon = f64::from(i * SPACING) - 180.0;
        let end = if i % 6 == 0 { 30 } else { 25 };
        Line((-end..=end).map(|lat| [lon, 3.0 * f64::from(lat)]).collect())
    });
    parallels.chain(meridians).collect()
}
