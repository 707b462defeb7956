//! Maps of what a projection does, one for each quantity: the top above the front.

use image::{Rgb, RgbImage};
use terrella::cube::{CubeMap, Face, Projection};
use terrella::distortion::Jacobian;
use tiny_skia::{Pixmap, PremultipliedColorU8};

use crate::contour::contour;
use crate::cross::{on, pieces};
use crate::geography::Line;
use crate::pen::Pen;
use crate::scale::Scale;
use draw::page;
use testkit::measure::{Surveys, sphere, texel};

/// What a texel is measured for.
pub struct Quantity {
    /// In file names and ids.
    pub key: &'static str,
    pub name: &'static str,
    /// How the maps of it are read, in the page's language.
    pub reading: &'static str,
    pub scale: Scale,
    value: fn(&Units, &Jacobian<f64>) -> f64,
    /// The smallest and the largest of a survey, in words.
    pub range: fn(&Surveys) -> String,
}

/// What areas are told in.
struct Units {
    /// Width times height of the central texel.
    central: f64,
    /// The area that a texel has where all have the same.
    share: f64,
}

/// All that is drawn.
pub const QUANTITIES: &[Quantity] = &[
    Quantity {
        key: "aspect",
        name: "Aspect",
        reading: "Width over height of a texel on the ground, δ<sub>aspect</sub>. White is as wide as high; orange is wider, blue is higher.",
        scale: Scale::Ratio(1),
        value: |_, texel| texel.aspect(),
        range: |s| format!("{:.2} – {:.2}", s.worst.aspect().min(), s.worst.aspect().max()),
    },
    Quantity {
        key: "sides",
        name: "Width × height",
        reading: "Width times height of a texel on the ground over that of the texel in the middle of the front, δ<sub>area</sub>. White is as large \
                  as there; orange is larger, blue is smaller. Where the grid is askew it is more than the texel’s area.",
        scale: Scale::Ratio(2),
        value: |units, texel| texel.sides() / units.central,
        range: |s| {
            let least = if s.is_conformal() { 0.0 } else { s.worst.sides().min() };
            format!("{least:.2} – {:.2}", s.worst.sides().max())
        },
    },
    Quantity {
        key: "area",
        name: "True area",
        reading: "The area of a texel on the ground over its fair share, which is what it would be if all had the same. White is \
                  the fair share; orange covers more ground, blue less.",
        scale: Scale::Ratio(2),
        value: |units, texel| texel.area() / units.share,
        range: |s| {
            let ratio = s.area_ratio();
            if ratio.is_finite() {
                format!("ratio {ratio:.2}")
            } else {
                "ratio ∞".into()
            }
        },
    },
    Quantity {
        key: "deformation",
        name: "Deformation",
        reading: "The most that an angle changes between the ground and the face, Tissot’s ω. Dark blue is true to shape; the more yellow, \
                  the more a small circle is drawn out.",
        scale: Scale::Degrees(50),
        value: |_, texel| texel.deformation(),
        range: |s| format!("to {:.1}°", s.worst.deformation().max()),
    },
];

/// Faces from above to below.
const FACES: [Face; 2] = [Face::Top, Face::Front];

/// Pixels along the edge of a face, of so many on the unfolded cube. Even: no pixel's centre is on a midline.
pub const fn face_size(size: u32) -> u32 {
    size * 5 / 16 * 2
}

/// How far from the diagonals the pixels on them are measured, so that all are on one side of a crease.
const ASIDE: f64 = 1e-6;

/// The pens of lines on a scale.
struct Pens {
    coast: Pen,
    line: Pen,
    /// Where a ratio is 1.
    unity: Pen,
}

const ON_LIGHT: Pens = Pens {
    coast: Pen::new([18, 22, 30, 190], 1.4),
    line: Pen::new([18, 22, 30, 70], 1.0),
    unity: Pen::new([18, 22, 30, 110], 2.2),
};

const ON_DARK: Pens = Pens {
    coast: Pen::new([255, 255, 255, 190], 1.4),
    line: Pen::new([255, 255, 255, 75], 1.0),
    unity: Pen::new([255, 255, 255, 75], 1.0),
};

/// Draws the maps of a projection, in the order of [`QUANTITIES`].
pub fn draw(
    map: &CubeMap<f64, Projection>,
    coastline: &[Line],
    size: u32,
) -> Result<Vec<(&'static Quantity, RgbImage)>, String> {
    let size = face_size(size);
    let coast = pieces(map, coastline, size);
    let ground = sphere(map.projection());
    let unit = ground.unit();
    let units = Units {
        central: ground.central_texel(),
        share: unit * unit,
    };
    let texels = FACES.map(|face| {
        let at = |index: u32| f64::from(2 * index + 1) / f64::from(size) - 1.0;
        (0..size * size)
            .map(|index| texel(&ground, face, [at(index % size), ASIDE - at(index / size)]))
            .collect::<Vec<_>>()
    });
    QUANTITIES
        .iter()
        .map(|quantity| {
            let mut picture = RgbImage::from_pixel(size, 2 * size, Rgb(page::BACKGROUND));
            for ((row, face), texels) in (0..).zip(FACES).zip(&texels) {
                let value = |texel: &Option<Jacobian<f64>>| texel.map_or(f64::NAN, |t| (quantity.value)(&units, &t));
                let field: Vec<f64> = texels.iter().map(value).collect();
                let pixmap = paint(quantity.scale, &field, on(face, &coast), size)?;
                for (index, pixel) in (0..).zip(pixmap.pixels()) {
                    let color = Rgb([pixel.red(), pixel.green(), pixel.blue()]);
                    picture.put_pixel(index % size, row * size + index / size, color);
                }
            }
            Ok((quantity, picture))
        })
        .collect()
}

fn paint<'a>(
    scale: Scale,
    field: &[f64],
    coast: impl Iterator<Item = &'a [[f32; 2]]>,
    size: u32,
) -> Result<Pixmap, String> {
    let mut pixmap = Pixmap::new(size, size).ok_or("a map is too large")?;
    for (pixel, value) in pixmap.pixels_mut().iter_mut().zip(field) {
        let [red, green, blue] = scale.color(scale.position(*value));
        if let Some(color) = PremultipliedColorU8::from_rgba(red, green, blue, 255) {
            *pixel = color;
        }
    }
    let pens = match scale {
        Scale::Ratio(_) => ON_LIGHT,
        Scale::Degrees(_) => ON_DARK,
    };
    for value in scale.lines() {
        let pen = if value == 1.0 { pens.unity } else { pens.line };
        let line = contour(field, size as usize, value);
        pen.draw(&mut pixmap, line.iter().map(|segment| segment.as_slice()));
    }
    pens.coast.draw(&mut pixmap, coast);
    Ok(pixmap)
}
