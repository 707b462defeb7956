//! The height of the ground anywhere: a real model of a small piece of it, around that its mirror image, and a long slope down to the ellipsoid.

use std::path::Path;

use terrella::LatLon;
use terrella::terrain::Heights;

use draw::outcome::cannot;

/// The outer edges of the model and its samples, in degrees.
const NORTH: f64 = 36.732_916_67;
const WEST: f64 = -84.413_75;
const STEP: f64 = 3.0 / 3600.0;

/// Metres in a degree of latitude, and of longitude here: for the slope around the model only.
const DEGREE: [f64; 2] = [110_960.0, 89_480.0];

/// Metres from the model in which its mirror image gives way to its mean, and that to the ellipsoid.
const EDGE: f64 = 60_000.0;
const SLOPE: f64 = 150_000.0;

/// Cubic interpolation may overshoot: the weights of four samples add up to 1.25 in magnitude, in two dimensions to the square of that.
const OVERSHOOT: f64 = 1.5625;

/// Samples in rows from the north.
struct Model {
    columns: usize,
    rows: usize,
    values: Vec<u16>,
}

/// Heights in metres above the ellipsoid.
pub struct Elevation {
    model: Model,
    mean: f64,
    highest: f64,
}

impl Elevation {
    /// Reads the model.
    pub fn read(path: &Path) -> Result<Self, String> {
        let picture = image::open(path).map_err(|error| cannot("read", path, &error))?;
        let model = Model {
            columns: picture.width() as usize,
            rows: picture.height() as usize,
            values: picture.into_luma16().into_raw(),
        };
        let sum: f64 = model.values.iter().copied().map(f64::from).sum();
        let mut elevation = Self {
            mean: sum / model.values.len() as f64,
            highest: 0.0,
            model,
        };
        elevation.highest = elevation.reach([0, elevation.model.columns - 1], [0, elevation.model.rows - 1])[1];
        Ok(elevation)
    }

    /// The height at a place, and how much of it is the model's or its image's.
    pub fn at(&self, place: LatLon<f64>) -> (f64, f64) {
        let outside = self.metres_outside(place);
        if outside >= SLOPE {
            return (0.0, 0.0);
        }
        let inside = self.cubic((place.lon() - WEST) / STEP - 0.5, (NORTH - place.lat()) / STEP - 0.5);
        let (edge, slope) = (smooth(outside / EDGE), smooth(outside / SLOPE));
        ((inside + (self.mean - inside) * edge) * (1.0 - slope), 1.0 - edge)
    }

    /// Metres up per metre east and north, over a stretch of so many metres.
    pub fn slopes(&self, place: LatLon<f64>, stretch: f64) -> [f64; 2] {
        if self.metres_outside(place) >= SLOPE {
            return [0.0; 2];
        }
        let half = [0.5 * stretch / DEGREE[0], 0.5 * stretch / DEGREE[1]];
        let height = |north: f64, east: f64| {
            let (lat, lon) = (place.lat() + north * half[0], place.lon() + east * half[1]);
            LatLon::new(lat, lon).map_or(0.0, |place| self.at(place).0)
        };
        [
            (height(0.0, 1.0) - height(0.0, -1.0)) / stretch,
            (height(1.0, 0.0) - height(-1.0, 0.0)) / stretch,
        ]
    }

    /// The range of heights within so many degrees of latitude and longitude of a place.
    pub fn range(&self, place: LatLon<f64>, [lat, lon]: [f64; 2]) -> Heights<f64> {
        let south = NORTH - STEP * self.model.rows as f64;
        let east = WEST + STEP * self.model.columns as f64;
        let low = [place.lat() - lat, place.lon() - lon];
        let high = [place.lat() + lat, place.lon() + lon];
        let margin = DEGREE.map(|metres| SLOPE / metres);
        let is_apart = |by: [f64; 2]| {
            low[0] > NORTH + by[0] || high[0] < south - by[0] || low[1] > east + by[1] || high[1] < WEST - by[1]
        };
        let is_inside = low[0] >= south && high[0] <= NORTH && low[1] >= WEST && high[1] <= east;
        let [low, high] = if is_apart(margin) {
            [0.0; 2]
        } else if is_inside {
            // The samples that the interpolation takes.
            let around = |from: f64, to: f64, count: usize| {
                let first = (from / STEP - 0.5).floor() - 1.0;
                let last = (to / STEP - 0.5).floor() + 2.0;
                [first, last].map(|index| (index.max(0.0) as usize).min(count - 1))
            };
            self.reach(
                around(low[1] - WEST, high[1] - WEST, self.model.columns),
                around(NORTH - high[0], NORTH - low[0], self.model.rows),
            )
        } else {
            [0.0, self.highest]
        };
        Heights::new(low, high).unwrap_or_default()
    }

    /// The range of all heights.
    pub fn whole(&self) -> Heights<f64> {
        Heights::new(0.0, self.highest).unwrap_or_default()
    }

    /// The range of the interpolation between samples.
    fn reach(&self, [left, right]: [usize; 2], [top, bottom]: [usize; 2]) -> [f64; 2] {
        let rows = (top..=bottom).map(|row| &self.model.values[row * self.model.columns..][left..=right]);
        let (low, high) = rows
            .flatten()
            .fold((u16::MAX, 0), |(low, high), &v| (low.min(v), high.max(v)));
        let [low, high] = [low, high].map(f64::from);
        let (middle, half) = (0.5 * (low + high), 0.5 * OVERSHOOT * (high - low));
        [middle - half, middle + half]
    }

    /// How far outside the model a place is.
    fn metres_outside(&self, place: LatLon<f64>) -> f64 {
        let (south, east) = (
            NORTH - STEP * self.model.rows as f64,
            WEST + STEP * self.model.columns as f64,
        );
        let north = (place.lat() - NORTH).max(south - place.lat()).max(0.0) * DEGREE[0];
        let across = (place.lon() - east).max(WEST - place.lon()).max(0.0) * DEGREE[1];
        (north * north + across * across).sqrt()
    }

    /// Catmull and Rom's interpolation at a column and row; outside, of the mirror image.
    fn cubic(&self, x: f64, y: f64) -> f64 {
        let split = |x: f64, count: usize| {
            let (last, count) = (count as isize - 1, count as f64);
            let folded = (x + 0.5).rem_euclid(2.0 * count);
            let x = folded.min(2.0 * count - folded) - 0.5;
            let whole = x.floor();
            let at = |step: isize| {
                let index = whole as isize + step;
                // Before the first sample is the first again, as in a mirror on the edge.
                let index = if index < 0 { -1 - index } else { index };
                index.min(2 * last + 1 - index) as usize
            };
            ([at(-1), at(0), at(1), at(2)], weights(x - whole))
        };
        let (columns, across) = split(x, self.model.columns);
        let (rows, down) = split(y, self.model.rows);
        let row = |row: usize| {
            let of = |k: usize| across[k] * f64::from(self.model.values[row * self.model.columns + columns[k]]);
            of(0) + of(1) + of(2) + of(3)
        };
        down[0] * row(rows[0]) + down[1] * row(rows[1]) + down[2] * row(rows[2]) + down[3] * row(rows[3])
    }
}

fn weights(t: f64) -> [f64; 4] {
    [
        0.5 * t * (-1.0 + t * (2.0 - t)),
        1.0 + 0.5 * t * t * (3.0 * t - 5.0),
        0.5 * t * (1.0 + t * (4.0 - 3.0 * t)),
        0.5 * t * t * (t - 1.0),
    ]
}

/// From 0 to 1 without a kink.
fn smooth(t: f64) -> f64 {
    let t = t.min(1.0);
    t * t * (3.0 - 2.0 * t)
}
