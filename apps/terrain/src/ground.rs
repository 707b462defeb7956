//! What is known of a tile before anything is computed of it: places, heights, slopes and colours of its samples.

use std::f64::consts::FRAC_PI_2;

use terrella::LatLon;
use terrella::cube::{CubeMap, Projection};
use terrella::terrain::{Enclosure, Heights, Tile};

use crate::elevation::Elevation;
use draw::imagery::Imagery;

/// Samples along the edge of a tile.
pub const SAMPLES: u32 = 129;

/// How much brighter than the imagery the ground is drawn.
const BRIGHTER: f32 = 1.35;

/// Where the model is, colours by height from the valleys to the ridges: two pixels of the imagery are as wide as all of it.
const RELIEF: [[f32; 3]; 2] = [[0.40, 0.50, 0.26], [0.62, 0.53, 0.40]];
const RELIEF_HEIGHTS: [f64; 2] = [250.0, 1_000.0];

/// The samples of a tile, in rows from below.
pub struct Ground {
    pub places: Vec<LatLon<f64>>,
    /// Metres above the ellipsoid.
    pub heights: Vec<f64>,
    /// Metres up per metre east and north.
    pub slopes: Vec<[f64; 2]>,
    /// Red, green and blue from 0 to 1.
    pub colours: Vec<[f32; 3]>,
}

impl Ground {
    /// Of a tile, with the relief in its own colours as far as `tint` says, from 0 to 1.
    pub fn new(
        map: &CubeMap<f64, Projection>,
        tile: Tile,
        elevation: &Elevation,
        imagery: &Imagery,
        tint: f64,
    ) -> Self {
        let last = SAMPLES - 1;
        let spacing = FRAC_PI_2 * map.shifted().ellipsoid().a() / (f64::from(last) * f64::from(1_u32 << tile.level()));
        let count = (SAMPLES * SAMPLES) as usize;
        let mut ground = Self {
            places: Vec::with_capacity(count),
            heights: Vec::with_capacity(count),
            slopes: Vec::with_capacity(count),
            colours: Vec::with_capacity(count),
        };
        for index in 0..SAMPLES * SAMPLES {
            let place = map.unproject(tile.node([index % SAMPLES, index / SAMPLES], last));
            let (height, share) = elevation.at(place);
            ground.places.push(place);
            ground.heights.push(height);
            ground.slopes.push(elevation.slopes(place, spacing.max(60.0)));
            let [low, high] = RELIEF_HEIGHTS;
            let along = ((height - low) / (high - low)).clamp(0.0, 1.0) as f32;
            let relief = (tint * share) as f32;
            let picture = imagery.sample(place);
            ground.colours.push(std::array::from_fn(|k| {
                let colour = RELIEF[0][k] + along * (RELIEF[1][k] - RELIEF[0][k]);
                let seen = BRIGHTER * picture[k] / 255.0;
                seen + relief * (colour - seen)
            }));
        }
        ground
    }
}

/// The range of heights in a tile.
pub fn heights(enclosure: &Enclosure<f64, Projection>, elevation: &Elevation, tile: Tile) -> Heights<f64> {
    let map = enclosure.map();
    let sphere = enclosure.of(tile, Heights::default()).sphere();
    let middle = map.unproject(tile.centre());
    // The foot of the middle is within the sphere, and so is every other place: twice its radius, on a sphere smaller than the Earth.
    let angle = (2.0 * sphere.radius / map.shifted().ellipsoid().b() * 1.01).to_degrees();
    let widest = (middle.lat().abs() + angle).to_radians().cos();
    let lon = if angle < 45.0 && widest > 0.02 {
        angle / widest
    } else {
        360.0
    };
    elevation.range(middle, [angle, lon])
}
