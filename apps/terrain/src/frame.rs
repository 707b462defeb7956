//! One frame: the tiles that are seen, drawn in single precision, in double precision, and with heights along a sphere's normal.

use image::{Rgb, RgbImage};
use terrella::cube::{CubeMap, Projection};
use terrella::terrain::{Detail, Enclosure, Patches, Selection, Tile};

use crate::air;
use crate::approach::{ASPECT, View};
use crate::difference::Difference;
use crate::elevation::Elevation;
use crate::ground::{self, Ground, SAMPLES};
use crate::mesh::{self, ACROSS, Mesh, node};
use crate::raster::Canvas;
use crate::scalar::{Scalar, dot, lowered};
use crate::scale::Scale;
use draw::imagery::Imagery;
use draw::page::BACKGROUND;

/// Samples along each side of a pixel.
const SUPERSAMPLING: u32 = 2;

/// Pixels for each sample of the terrain, at most (Lambers & Kolb 2012), and the finest level: of samples 5 m apart.
const RATIO: f64 = 1.5;
const FINEST: u8 = 14;

/// Where the imagery is too coarse for the relief to be left without colours of its own, in metres above ground.
const TINTED: f64 = 120_000.0;

/// From these heights down, leaning heights and naive single precision are drawn too: metres above ground.
const LEAN_SEEN: f64 = 10_000.0;
const NAIVE_SEEN: f64 = 1_000.0;

/// What single precision differs by, and what leaning heights do.
pub const ROUNDING: Scale = Scale { exponents: [-5, 1] };
pub const LEANING: Scale = Scale { exponents: [-1, 1] };

/// What frames are drawn of.
pub struct World {
    pub elevation: Elevation,
    patches: Patches<Projection>,
    enclosure: Enclosure<f64, Projection>,
    imagery: Imagery,
    /// By level, in metres.
    skirts: Vec<f64>,
}

/// Pictures and figures.
pub struct Frame {
    /// Metres above the ground.
    pub height: f64,
    pub tiles: usize,
    pub levels: [u8; 2],
    pub single: RgbImage,
    pub double: RgbImage,
    pub rounding: RgbImage,
    pub rounded: Difference,
    /// Pixels of the first two that are not of the same colour.
    pub unlike: usize,
    /// Single precision without the crate, and heights along a sphere's normal: only where the eye is near enough to see it.
    pub naive: Option<Contrast>,
    pub leaning: Option<Contrast>,
}

/// The same terrain, but wrong.
pub struct Contrast {
    pub picture: RgbImage,
    /// How far the ground is from where it should be.
    pub apart: RgbImage,
    pub difference: Difference,
    /// Pixels that are not of the colour that they should have.
    pub unlike: usize,
}

impl World {
    pub fn new(map: CubeMap<f64, Projection>, elevation: Elevation, imagery: Imagery) -> Self {
        let patches = Patches::new(map);
        let range = elevation.whole();
        Self {
            patches,
            enclosure: Enclosure::new(map),
            skirts: (0..=FINEST).map(|level| patches.skirt(level, SAMPLES, range)).collect(),
            elevation,
            imagery,
        }
    }

    /// Draws a frame so many pixels wide.
    pub fn frame(&self, view: &View, width: u32) -> Result<Frame, String> {
        let size = [width, width * ASPECT[1] / ASPECT[0]].map(|count| count * SUPERSAMPLING);
        let camera = view.camera(size).map_err(|error| error.to_string())?;
        let detail = Detail::new(SAMPLES, RATIO, FINEST).map_err(|error| error.to_string())?;
        let heights = |tile| ground::heights(&self.enclosure, &self.elevation, tile);
        let tiles: Vec<Tile> = Selection::new(&self.enclosure, camera, detail, heights).collect();

        let map = self.enclosure.map();
        let tint = 0.75 / (1.0 + (view.height / TINTED).powi(2));
        let mut single = Canvas::<f32>::new(size);
        let mut double = Canvas::<f64>::new(size);
        let mut lean = (view.height <= LEAN_SEEN).then(|| Canvas::<f64>::new(size));
        let mut naive = (view.height <= NAIVE_SEEN).then(|| Canvas::<f32>::new(size));
        let [mut rounded, mut leant, mut naively] = [0; 3].map(|_| Difference::default());
        for &tile in &tiles {
            let ground = Ground::new(&map, tile, &self.elevation, &self.imagery, tint);
            let skirt = self.skirts[usize::from(tile.level())];
            let truth = mesh::double(&map, &ground, view.eye, skirt);
            let ours = mesh::single(&self.patches, tile, &ground, view.eye, skirt)?;
            let apart = rounded.add(&ours, &truth);
            draw(&mut single, view, &ours, &ground, &apart);
            draw(&mut double, view, &truth, &ground, &apart);
            if let Some(naive) = &mut naive {
                let mesh = mesh::naive(&truth, view.eye);
                let apart = naively.add(&mesh, &truth);
                draw(naive, view, &mesh, &ground, &apart);
            }
            if let Some(lean) = &mut lean {
                let leaning = mesh::leaning(&map, &ground, view.eye, skirt);
                let apart = leant.add(&leaning, &truth);
                draw(lean, view, &leaning, &ground, &apart);
            }
        }
        let levels = tiles.iter().map(|tile| tile.level());
        let [single, exact] = [colours(&single, view), colours(&double, view)];
        let leaning = lean.map(|canvas| Contrast::new(&canvas, view, &exact, LEANING, leant));
        let naive = naive.map(|canvas| Contrast::new(&canvas, view, &exact, ROUNDING, naively));
        Ok(Frame {
            height: view.height,
            tiles: tiles.len(),
            levels: levels.fold([u8::MAX, 0], |[low, high], level| [low.min(level), high.max(level)]),
            unlike: unlike(&single, &exact),
            single,
            rounding: lengths(&double, ROUNDING),
            double: exact,
            rounded,
            naive,
            leaning,
        })
    }
}

impl Contrast {
    fn new<T: Scalar>(canvas: &Canvas<T>, view: &View, exact: &RgbImage, scale: Scale, difference: Difference) -> Self {
        let picture = colours(canvas, view);
        Self {
            apart: lengths(canvas, scale),
            difference,
            unlike: unlike(&picture, exact),
            picture,
        }
    }
}

/// How many pixels have not the same colour.
fn unlike(a: &RgbImage, b: &RgbImage) -> usize {
    a.pixels().zip(b.pixels()).filter(|(a, b)| a != b).count()
}

/// Draws a mesh.
fn draw<T: Scalar>(canvas: &mut Canvas<T>, view: &View, mesh: &Mesh<T>, ground: &Ground, apart: &[f32]) {
    let rows = view.rows().map(lowered::<T>);
    let sun = lowered::<T>(view.sun);
    let height = view.height as f32;
    let corners: Vec<_> = (0..ACROSS * ACROSS)
        .map(|index| {
            let ([m, n], _) = node(index);
            let (sample, index) = ((n * SAMPLES + m) as usize, index as usize);
            let (vertex, normal) = (mesh.vertices[index], mesh.normals[index]);
            let away = dot(vertex, vertex).sqrt();
            let [red, green, blue] = air::ground(
                ground.colours[sample],
                dot(mesh.slopes[index], sun).single(),
                dot(normal, sun).single(),
                (-(dot(vertex, normal) / away)).single(),
                height,
                away.single(),
            );
            let clip = rows.map(|row| dot(row, vertex));
            canvas.corner(clip, [red, green, blue, apart[index]])
        })
        .collect();
    for row in 0..ACROSS - 1 {
        for column in 0..ACROSS - 1 {
            let first = (row * ACROSS + column) as usize;
            let above = first + ACROSS as usize;
            let [a, b, c, d] = [first, first + 1, above + 1, above].map(|index| corners[index]);
            canvas.triangle([a, b, c]);
            canvas.triangle([a, c, d]);
        }
    }
}

/// The picture, with the sky where nothing is.
fn colours<T: Scalar>(canvas: &Canvas<T>, view: &View) -> RgbImage {
    let [right, up, forward] = view.axes;
    let upward = {
        let eye = view.eye.to_array();
        let length = mesh::distance(eye);
        eye.map(|v| v / length)
    };
    let side = |at: u32, count: u32| (2.0 * f64::from(at) + 1.0) / f64::from(count) - 1.0;
    pooled(canvas, |column, row| match canvas.at(column, row) {
        Some([red, green, blue, _]) => [red, green, blue],
        None => {
            let (x, y) = (side(column, canvas.width), -side(row, canvas.height));
            let ray: [f64; 3] = std::array::from_fn(|k| forward[k] + x * right[k] + y * up[k]);
            let rising = dot(ray, upward) / mesh::distance(ray);
            air::sky(
                view.height as f32,
                rising as f32,
                BACKGROUND.map(|v| f32::from(v) / 255.0),
            )
        }
    })
}

/// The differences as colours.
fn lengths<T: Scalar>(canvas: &Canvas<T>, scale: Scale) -> RgbImage {
    pooled(canvas, |column, row| {
        let colour = canvas
            .at(column, row)
            .map_or(BACKGROUND, |[_, _, _, metres]| scale.colour(metres));
        colour.map(|v| f32::from(v) / 255.0)
    })
}

/// Means of the samples of each pixel.
fn pooled<T>(canvas: &Canvas<T>, colour: impl Fn(u32, u32) -> [f32; 3]) -> RgbImage {
    RgbImage::from_fn(canvas.width / SUPERSAMPLING, canvas.height / SUPERSAMPLING, |x, y| {
        let mut sum = [0.0; 3];
        for sample in 0..SUPERSAMPLING * SUPERSAMPLING {
            let column = x * SUPERSAMPLING + sample % SUPERSAMPLING;
            let row = y * SUPERSAMPLING + sample / SUPERSAMPLING;
            let colour = colour(column, row);
            sum = std::array::from_fn(|k| sum[k] + colour[k].min(1.0));
        }
        Rgb(sum.map(|v| (255.0 * v / (SUPERSAMPLING * SUPERSAMPLING) as f32).round() as u8))
    })
}
