//! The globe: the Earth from afar, with the grid of a cube on it.

use image::{Rgb, RgbImage};
use terrella::cube::{CubeMap, Face, Projection};
use terrella::{Direction, LatLon};
use tiny_skia::{Pixmap, PremultipliedColorU8};

use crate::cross::place;
use crate::pen::Pen;
use crate::trace::trace;
use draw::imagery::Imagery;
use draw::{page, parallel};

/// Cells along the edge of a face.
pub const CELLS: u32 = 12;

/// Cells along the edge of a face where the globe is small.
const FEW_CELLS: u32 = 8;

/// Latitude and longitude in the middle of the view: front, right and top are in sight, and the corner where they meet.
const VIEW: [f64; 2] = [26.0, 20.0];

/// Where the light comes from: right, up, toward the eye.
const LIGHT: [f64; 3] = [-0.42, 0.48, 0.77];

/// Samples along each side of a pixel.
const SUPERSAMPLING: u32 = 3;

/// The longest straight step of a line, in pixels.
const STEP: f64 = 3.0;

const GRID: Pen = Pen::new([255, 255, 255, 130], 0.75);
const EDGE_SHADE: Pen = Pen::new([10, 16, 30, 110], 3.6);
const EDGE: Pen = Pen::new([245, 204, 125, 240], 1.7);

/// The Earth from afar, in parallel rays, filling a square.
pub struct Globe {
    pixmap: Pixmap,
    view: View,
}

impl Globe {
    /// Draws the bare globe, half as high again as a face.
    pub fn new(imagery: &Imagery, face_size: u32) -> Result<Self, String> {
        let size = face_size * 3 / 2;
        let mut pixmap = Pixmap::new(size, size).ok_or("the globe is too large")?;
        let view = View::new();
        let rows: Vec<u32> = (0..size).collect();
        let colours = parallel::map(&rows, |&row| {
            let colour = |column| view.color(imagery, size, [column, row]);
            Ok::<Vec<_>, String>((0..size).map(colour).collect())
        })?;
        for (pixel, [red, green, blue]) in pixmap.pixels_mut().iter_mut().zip(colours.into_iter().flatten()) {
            if let Some(color) = PremultipliedColorU8::from_rgba(red, green, blue, 255) {
                *pixel = color;
            }
        }
        Ok(Self { pixmap, view })
    }

    /// The globe with the cells of every face.
    pub fn with_grid(&self, map: &CubeMap<f64, Projection>) -> RgbImage {
        let mut pixmap = self.pixmap.clone();
        let size = pixmap.width();
        let grid = self.view.grid(map, CELLS, f64::from(size), STEP);
        GRID.draw(&mut pixmap, grid.inner.iter().map(Vec::as_slice));
        EDGE_SHADE.draw(&mut pixmap, grid.edges.iter().map(Vec::as_slice));
        EDGE.draw(&mut pixmap, grid.edges.iter().map(Vec::as_slice));
        let pixels = pixmap.pixels();
        RgbImage::from_fn(size, size, |x, y| {
            let pixel = pixels[(y * size + x) as usize];
            Rgb([pixel.red(), pixel.green(), pixel.blue()])
        })
    }
}

/// The grid of a cube on a small globe, of a few cells: lines in a square of `size`.
pub fn sketch(map: &CubeMap<f64, Projection>, size: u16) -> Grid {
    let size = f64::from(size);
    View::new().grid(map, FEW_CELLS, size, size / 16.0)
}

/// What is in sight of the grid of a cube.
pub struct Grid {
    pub inner: Vec<Vec<[f32; 2]>>,
    pub edges: Vec<Vec<[f32; 2]>>,
}

/// Where the globe is looked at from: what is to the right, up and toward the eye, in Earth axes.
struct View {
    axes: [[f64; 3]; 3],
}

impl View {
    fn new() -> Self {
        let [lat, lon] = VIEW.map(f64::to_radians);
        Self {
            axes: [
                [-lon.sin(), lon.cos(), 0.0],
                [-lat.sin() * lon.cos(), -lat.sin() * lon.sin(), lat.cos()],
                [lat.cos() * lon.cos(), lat.cos() * lon.sin(), lat.sin()],
            ],
        }
    }

    /// The colour of a pixel of a picture of `size`.
    fn color(&self, imagery: &Imagery, size: u32, [column, row]: [u32; 2]) -> [u8; 3] {
        let scale = 2.0 / f64::from(size * SUPERSAMPLING);
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
    fn lit(&self, imagery: &Imagery, point: [f64; 3]) -> [f32; 3] {
        let [x, y, z] = std::array::from_fn(|axis| (0..3).map(|i| point[i] * self.axes[i][axis]).sum());
        let ground = Direction::new(x, y, z).map_or([0.0; 3], |direction| imagery.sample(direction.to_lat_lon()));
        let light = dot(point, LIGHT).max(0.0) as f32;
        let shade = 0.22 + 0.95 * light;
        let air = (1.0 - point[2] as f32).powi(4) * (0.25 + 0.75 * light);
        let sky = [120.0, 170.0, 235.0];
        std::array::from_fn(|channel| (ground[channel] * shade * (1.0 - air) + sky[channel] * air).min(255.0))
    }

    fn grid(&self, map: &CubeMap<f64, Projection>, cells: u32, size: f64, step: f64) -> Grid {
        // Line number i of every face, of those upward and of those to the right.
        let lines = |i: u32| {
            let at = move |i: f64| i * 2.0 / f64::from(cells) - 1.0;
            let fixed = at(f64::from(i));
            let seen = move |place| self.project(place, size);
            Face::ALL.into_iter().flat_map(move |face| {
                let upward = trace(|t| seen(place(map, face, fixed, at(t))), cells as usize, step);
                let across = trace(|t| seen(place(map, face, at(t), fixed)), cells as usize, step);
                upward.into_iter().chain(across)
            })
        };
        let in_sight = |numbers: &mut dyn Iterator<Item = u32>| {
            numbers
                .flat_map(lines)
                .filter(|piece| piece.place)
                .map(|piece| piece.points.iter().map(|point| point.map(|v| v as f32)).collect())
                .collect()
        };
        Grid {
            inner: in_sight(&mut (1..cells)),
            edges: in_sight(&mut [0, cells].into_iter()),
        }
    }

    /// Whether a place is in sight, and where in a picture of `size`.
    fn project(&self, place: LatLon<f64>, size: f64) -> (bool, [f64; 2]) {
        let direction = place.to_direction().to_array();
        let [right, up, toward] = self.axes.map(|axis| dot(axis, direction));
        let half = size / 2.0;
        (toward > 0.0, [(1.0 + right) * half, (1.0 - up) * half])
    }
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}
