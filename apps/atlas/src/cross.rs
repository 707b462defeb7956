//! The unfolded cube.

use draw::parallel::Progress;
use image::{Rgb, RgbImage};
use terrella::LatLon;
use terrella::cube::{CubeMap, Face, FacePoint, Projection};
use tiny_skia::{Pixmap, PremultipliedColorU8};

use crate::geography::Line;
use crate::pen::Pen;
use crate::trace::{Piece, trace};
use draw::imagery::Imagery;
use draw::page;

/// The lines that are drawn on the imagery.
pub struct Geography {
    pub coastline: Vec<Line>,
    pub graticule: Vec<Line>,
}

const GRATICULE_SHADE: Pen = Pen::new([10, 16, 30, 26], 2.0);
const GRATICULE: Pen = Pen::new([255, 255, 255, 58], 0.9);
const COAST_SHADE: Pen = Pen::new([10, 16, 30, 75], 2.4);
const COAST: Pen = Pen::new([255, 240, 205, 190], 1.1);
const EDGE: Pen = Pen::new([255, 255, 255, 80], 1.2);

/// The longest straight step of a line, in pixels.
const STEP: f64 = 3.0;

/// Column and row of a face on the cross.
pub const fn cell(face: Face) -> (u32, u32) {
    match face {
        Face::Top => (1, 0),
        Face::Left => (0, 1),
        Face::Front => (1, 1),
        Face::Right => (2, 1),
        Face::Back => (3, 1),
        Face::Bottom => (1, 2),
    }
}

/// Draws the cross: top above front, bottom below it, and left, front, right, back in a row.
pub fn draw(
    map: &CubeMap<f64, Projection>,
    imagery: &Imagery,
    geography: &Geography,
    size: u32,
    progress: &Progress,
) -> Result<RgbImage, String> {
    let coastline = pieces(map, &geography.coastline, size);
    let graticule = pieces(map, &geography.graticule, size);
    let faces = Face::ALL
        .iter()
        .map(|&face| {
            let mut pixmap = Pixmap::new(size, size).ok_or("a face is too large")?;
            paint(map, imagery, face, &mut pixmap);
            GRATICULE_SHADE.draw(&mut pixmap, on(face, &graticule));
            GRATICULE.draw(&mut pixmap, on(face, &graticule));
            COAST_SHADE.draw(&mut pixmap, on(face, &coastline));
            COAST.draw(&mut pixmap, on(face, &coastline));
            let end = size as f32;
            let outline: &[[f32; 2]] = &[[0.0, 0.0], [end, 0.0], [end, end], [0.0, end], [0.0, 0.0]];
            EDGE.draw(&mut pixmap, std::iter::once(outline));
            progress.step();
            Ok((face, pixmap))
        })
        .collect::<Result<Vec<_>, &str>>()?;

    let mut cross = RgbImage::from_pixel(4 * size, 3 * size, Rgb(page::BACKGROUND));
    for (face, pixmap) in faces {
        let (column, row) = cell(face);
        for (index, pixel) in (0..).zip(pixmap.pixels()) {
            let (x, y) = (column * size + index % size, row * size + index / size);
            cross.put_pixel(x, y, Rgb([pixel.red(), pixel.green(), pixel.blue()]));
        }
    }
    Ok(cross)
}

/// The place on the Earth of a point of a face.
pub fn place(map: &CubeMap<f64, Projection>, face: Face, x: f64, y: f64) -> LatLon<f64> {
    FacePoint::new(face, x, y).map_or_else(|_| LatLon::default(), |point| map.unproject(point))
}

fn paint(map: &CubeMap<f64, Projection>, imagery: &Imagery, face: Face, pixmap: &mut Pixmap) {
    let size = pixmap.width();
    let fine = Imagery::SUPERSAMPLING;
    let scale = 2.0 / f64::from(size * fine);
    for (index, pixel) in (0..).zip(pixmap.pixels_mut()) {
        let (column, row) = (index % size, index / size);
        let mut sum = [0.0; 3];
        for sample in 0..fine * fine {
            let x = (f64::from(column * fine + sample % fine) + 0.5) * scale - 1.0;
            let y = 1.0 - (f64::from(row * fine + sample / fine) + 0.5) * scale;
            let color = imagery.sample(place(map, face, x, y));
            sum = std::array::from_fn(|channel| sum[channel] + color[channel]);
        }
        let [red, green, blue] = sum.map(|channel| (channel / (fine * fine) as f32).round() as u8);
        if let Some(color) = PremultipliedColorU8::from_rgba(red, green, blue, 255) {
            *pixel = color;
        }
    }
}

/// A line on one face, in pixels of a square.
pub type FaceLine = (Face, Vec<[f32; 2]>);

pub fn pieces(map: &CubeMap<f64, Projection>, lines: &[Line], size: u32) -> Vec<FaceLine> {
    let half = f64::from(size) / 2.0;
    let curve = |line: &Line, t: f64| {
        let point = map.project(line.at(t));
        (point.face(), [(point.x() + 1.0) * half, (1.0 - point.y()) * half])
    };
    let pixels = |piece: Piece<Face>| (piece.place, piece.points.iter().map(|p| p.map(|v| v as f32)).collect());
    lines
        .iter()
        .flat_map(|line| trace(|t| curve(line, t), line.steps(), STEP))
        .map(pixels)
        .collect()
}

pub fn on(face: Face, lines: &[FaceLine]) -> impl Iterator<Item = &[[f32; 2]]> {
    lines
        .iter()
        .filter(move |(on, _)| *on == face)
        .map(|(_, line)| line.as_slice())
}
