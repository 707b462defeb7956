//! Colour for the logarithm of a length, and hatching for none.

use colorous::VIRIDIS;
use image::{Rgb, RgbImage};

use draw::svg::{Area, LogAxis, Svg};

/// Steps of colour: enough to look continuous, few enough for a picture to compress.
const STEPS: f64 = 64.0;
/// Pixels along the side of a map at least.
const PIXELS: u32 = 400;
/// The width of a stripe of the hatching and the next gap, in pixels.
const STRIPE: u32 = 10;

/// Colours from one power of ten to another.
#[derive(Clone, Copy)]
pub struct Scale {
    pub exponents: [f64; 2],
    /// A power of ten in words.
    pub unit: fn(i32) -> String,
}

impl Scale {
    fn colour(self, value: f64) -> Rgb<u8> {
        let [from, to] = self.exponents;
        let along = ((value.log10() - from) / (to - from)).clamp(0.0, 1.0);
        let colour = VIRIDIS.eval_continuous((along * STEPS).round() / STEPS);
        Rgb([colour.r, colour.g, colour.b])
    }

    /// A square of cells, row by row from the top; hatched where there is no value.
    pub fn map(self, side: u32, cells: &[Option<f64>]) -> RgbImage {
        let zoom = PIXELS.div_ceil(side);
        RgbImage::from_fn(side * zoom, side * zoom, |x, y| {
            let cell = (y / zoom) as usize * side as usize + (x / zoom) as usize;
            match cells.get(cell).copied().flatten() {
                Some(value) => self.colour(value),
                None => hatching(x, y),
            }
        })
    }

    /// The legend of the colours.
    pub fn legend(self, svg: &mut Svg, area: Area, title: &str) -> Result<(), String> {
        let [from, to] = self.exponents;
        let width = STEPS as u32 * 4;
        let bar = RgbImage::from_fn(width, 1, |x, _| {
            let along = (f64::from(x) + 0.5) / f64::from(width);
            self.colour(10f64.powf(from + along * (to - from)))
        });
        svg.image(area, &bar)?;
        let axis = LogAxis {
            exponents: self.exponents,
            ends: [area.x, area.right()],
        };
        let every = if to - from > 8.0 { 3 } else { 1 };
        for exponent in axis.powers(every) {
            let x = axis.at(10f64.powi(exponent));
            let class = match f64::from(exponent) {
                e if e == from => "small",
                e if e == to => "small end",
                _ => "small middle",
            };
            svg.text([x, area.bottom() + 18.0], class, &(self.unit)(exponent));
        }
        svg.text([area.x, area.y - 8.0], "small", title);
        Ok(())
    }
}

fn hatching(x: u32, y: u32) -> Rgb<u8> {
    if (x + y) % STRIPE < STRIPE / 2 {
        Rgb([0xd9, 0x5f, 0x5f])
    } else {
        Rgb([0x1b, 0x12, 0x17])
    }
}

/// A sample of the hatching.
pub fn hatch_legend(svg: &mut Svg, area: Area, title: &str) -> Result<(), String> {
    let swatch = RgbImage::from_fn(52, 28, hatching);
    svg.image(area, &swatch)?;
    svg.text([area.right() + 8.0, area.bottom() - 2.0], "small", title);
    Ok(())
}
