//! The globe: the Earth from afar, with the grid of a cube on it.

use image::{Rgb, RgbImage};
use rayon::prelude::*;
use terrella::cube::{CubeMap, Face, Projection};
use terrella::{Direction, LatLon};
use tiny_skia::{Pixmap, PremultipliedColorU8};

use crate::cross::place;
use crate::imagery::Imagery;
use crate::page;
use crate::pen::Pen;
use crate::trace::trace;

/// Cells along the edge of a face.
pub const CELLS: u32 = 12;

/// Latitude and longitude in the middle of the view: front, right and top are in sight, and the corner where they meet.
const VIEW: [f64; 2] = [26.0, 20.0];

/// Where the light comes from: right, up, toward the eye.
const LIGHT: [f64; 3] = [-0.42, 0.48, 0.77];

/// Samples along each side of a pixel.
const SUPERSAMPLING: u32 = 3;

/// The longest straight step of a line, in pixels.
const STEP: f64 = 3.0;

const GRID: Pen = Pen { color: [255, 255, 255, 130], width: 0.75 };
const EDGE_SHADE: Pen = Pen { color: [10, 16, 30, 110], width: 3.6 };
const EDGE: Pen = Pen { color: [245, 204, 125, 240], width: 1.7 };

/// The Earth from afar, in parallel rays, filling a square.
pub struct Globe {
    pixmap: Pixmap,
    /// Right, up, toward the eye, in Earth axes.
    axes: [[f64; 3]; 3],
}

impl Globe {
    /// Draws the bare globe, half as high again as a face.
    pub fn new(imagery: &Imagery, face_size: u32) -> Result<Self, String> {
        let [lat, lon] = VIEW.map(f64::to_radians);
        let globe = Self {
            pixmap: Pixmap::new(face_size * 3 / 2, face_size * 3 / 2).ok_or("the globe is too large")?,
            axes: [
                [-lon.sin(), lon.cos(), 0.0],
                [-lat.sin() * lon.cos(), -lat.sin() * lon.sin(), lat.cos()],
                [lat.cos() * lon.cos(), lat.cos() * lon.sin(), lat.sin()],
            ],
        };
        let size = globe.pixmap.width();
        let colors: Vec<_> = (0..size * size)
            .into_par_iter()
            .map(|index| globe.color(imagery, index % size, index / size))
            .collect();
        let mut pixmap = globe.pixmap;
        for (pixel, [red, green, blue]) in pixmap.pixels_mut().iter_mut().zip(colors) {
            if let Some(color) = PremultipliedColorU8::from_rgba(red, green, blue, 255) {
                *pixel = color;
            }
        }
        Ok(Self { pixmap, ..globe })
    }

    fn color(&self, imagery: &Imagery, column: u32, row: u32) -> [u8; 3] {
        let scale = 2.0 / f64::from(self.pixmap.width() * SUPERSAMPLING);
        let mut sum = [0.0; 3];
        for sample in 0..SUPERSAMPLING * SUPERSAMPLING {
            let right = (f64::from(column * SUPERSAMPLING + sample % SUPERSAMPLING) + 0.5) * scale - 1.0;
            let up = 1.0 - (f64::from(row * SUPERSAMPLING + sample / SUPERSAMPLING) + 0.5) * scale;
            let toward = 1.0 - right * right - up * up;
            let color = if toward > 0.0 {
                self.lit(imagery, [right, up, toward.sqrt()])
            } else {
                page::BACKGROUND.map(f32::from)
            };
            sum = std::array::from_fn(|channel| sum[channel] + color[channel]);
        }
        sum.map(|channel| (channel / (SUPERSAMPLING * SUPERSAMPLING) as f32).round() as u8)
    }

    /// The colour of a point of the sphere (right, up, toward the eye) in daylight, through a little air at the limb.
    fn lit(&self, imagery: &Imagery, view: [f64; 3]) -> [f32; 3] {
        let earth = std::array::from_fn(|axis| (0..3).map(|i| view[i] * self.axes[i][axis]).sum());
        let [x, y, z] = earth;
        let ground = Direction::new(x, y, z).map_or([0.0; 3], |direction| imagery.sample(direction.to_lat_lon()));
        let light = dot(view, LIGHT).max(0.0) as f32;
        let shade = 0.30 + 0.85 * light;
        let air = (1.0 - view[2] as f32).powi(4) * (0.25 + 0.75 * light);
        let sky = [120.0, 170.0, 235.0];
        std::array::from_fn(|channel| (ground[channel] * shade * (1.0 - air) + sky[channel] * air).min(255.0))
    }

    /// Whether a place is in sight, and where in pixels.
    fn project(&self, place: LatLon<f64>) -> (bool, [f64; 2]) {
        let direction = place.to_direction().to_array();
        let [right, up, toward] = self.axes.map(|axis| dot(axis, direction));
        let half = f64::from(self.pixmap.width()) / 2.0;
        (toward > 0.0, [(1.0 + right) * half, (1.0 - up) * half])
    }

    /// The globe with the cells of every face.
    pub fn with_grid(&self, map: &CubeMap<f64, Projection>) -> Result<RgbImage, String> {
        let mut pixmap = self.pixmap.clone();
        let inner: Vec<_> = (1..CELLS).flat_map(|i| self.lines(map, i)).collect();
        let edges: Vec<_> = [0, CELLS].into_iter().flat_map(|i| self.lines(map, i)).collect();
        GRID.draw(&mut pixmap, inner.iter().map(Vec::as_slice));
        EDGE_SHADE.draw(&mut pixmap, edges.iter().map(Vec::as_slice));
        EDGE.draw(&mut pixmap, edges.iter().map(Vec::as_slice));
        let size = pixmap.width();
        let pixels = pixmap.pixels();
        Ok(RgbImage::from_fn(size, size, |x, y| {
            let pixel = pixels[(y * size + x) as usize];
            Rgb([pixel.red(), pixel.green(), pixel.blue()])
        }))
    }

    /// What is in sight of the line number `i` of every face, both of those upward and of those to the right.
    fn lines(&self, map: &CubeMap<f64, Projection>, i: u32) -> Vec<Vec<[f32; 2]>> {
        let at = |i: f64| i * 2.0 / f64::from(CELLS) - 1.0;
        let fixed = at(f64::from(i));
        Face::ALL
            .into_iter()
            .flat_map(|face| {
                let upward = trace(|t| self.project(place(map, face, fixed, at(t))), CELLS as usize, STEP);
                let across = trace(|t| self.project(place(map, face, at(t), fixed)), CELLS as usize, STEP);
                upward.into_iter().chain(across)
            })
            .filter(|piece| piece.place)
            .map(|piece| piece.points.iter().map(|point| point.map(|v| v as f32)).collect())
            .collect()
    }
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}
