//! Drawing with the vocabulary of SVG: a document, its text, lines, images and axes.

use std::fmt::Write as _;

use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;
use image::codecs::png::{CompressionType, FilterType, PngEncoder};
use image::{ExtendedColorType, ImageEncoder as _, RgbImage};

use crate::page::escaped;

/// How a document looks.
pub struct Theme {
    /// Rules of CSS.
    pub style: &'static str,
    pub background: &'static str,
}

/// Light on dark.
pub const NIGHT: Theme = Theme {
    style: "\
text{font-family:'Liberation Sans','DejaVu Sans',Arial,sans-serif;font-size:15px;fill:#d5dae3}\
.small{font-size:13px;fill:#8d97a7}\
.title{font-size:17px}\
.middle{text-anchor:middle}.end{text-anchor:end}\
.grid{stroke:#1f2733;stroke-width:1}\
.frame{fill:none;stroke:#3a4556;stroke-width:1}\
.line{fill:none;stroke-width:2;stroke-linejoin:round;stroke-linecap:round}\
.dashed{stroke-dasharray:6 4;stroke-width:1.6}\
.lead{fill:none;stroke-width:1;stroke-opacity:0.45}",
    background: "#0d1118",
};

/// A picture.
pub struct Svg {
    width: f64,
    height: f64,
    body: String,
}

impl Svg {
    pub fn new(width: f64, height: f64) -> Self {
        Self {
            width,
            height,
            body: String::new(),
        }
    }

    /// The document, with a title for those who cannot see it.
    pub fn document(&self, title: &str, theme: &Theme) -> String {
        let Self { width, height, body } = self;
        let Theme { style, background } = theme;
        format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {width} {height}\" width=\"{width}\" height=\"{height}\" \
             role=\"img\">\n<title>{}</title>\n<style>{style}</style>\n\
             <rect width=\"{width}\" height=\"{height}\" fill=\"{background}\"/>\n{body}</svg>\n",
            escaped(title)
        )
    }

    /// Any element.
    pub fn add(&mut self, element: std::fmt::Arguments<'_>) {
        // Writing to a string does not fail.
        let _ = self.body.write_fmt(element);
        self.body.push('\n');
    }

    pub fn text(&mut self, [x, y]: [f64; 2], class: &str, text: &str) {
        self.add(format_args!(
            "<text x=\"{x:.1}\" y=\"{y:.1}\" class=\"{class}\">{}</text>",
            escaped(text)
        ));
    }

    /// Text that reads upward.
    pub fn upright(&mut self, [x, y]: [f64; 2], class: &str, text: &str) {
        self.add(format_args!(
            "<text transform=\"translate({x:.1} {y:.1}) rotate(-90)\" class=\"{class}\">{}</text>",
            escaped(text)
        ));
    }

    pub fn coloured_text(&mut self, [x, y]: [f64; 2], colour: &str, text: &str) {
        self.add(format_args!(
            "<text x=\"{x:.1}\" y=\"{y:.1}\" style=\"fill:{colour}\">{}</text>",
            escaped(text)
        ));
    }

    pub fn grid_line(&mut self, [x1, y1]: [f64; 2], [x2, y2]: [f64; 2]) {
        self.add(format_args!(
            "<line x1=\"{x1:.1}\" y1=\"{y1:.1}\" x2=\"{x2:.1}\" y2=\"{y2:.1}\" class=\"grid\"/>"
        ));
    }

    pub fn polyline(&mut self, points: &[[f64; 2]], class: &str, colour: &str) {
        let mut path = String::new();
        for [x, y] in points {
            let _ = write!(path, "{x:.1},{y:.1} ");
        }
        self.add(format_args!(
            "<polyline points=\"{}\" class=\"{class}\" stroke=\"{colour}\"/>",
            path.trim_end()
        ));
    }

    pub fn frame(&mut self, area: Area) {
        let Area { x, y, width, height } = area;
        self.add(format_args!(
            "<rect x=\"{x:.1}\" y=\"{y:.1}\" width=\"{width:.1}\" height=\"{height:.1}\" class=\"frame\"/>"
        ));
    }

    pub fn fill(&mut self, area: Area, colour: &str, opacity: f64) {
        let Area { x, y, width, height } = area;
        self.add(format_args!(
            "<rect x=\"{x:.1}\" y=\"{y:.1}\" width=\"{width:.1}\" height=\"{height:.1}\" fill=\"{colour}\" \
             fill-opacity=\"{opacity:.2}\"/>"
        ));
    }

    /// Pixels, as they are.
    pub fn image(&mut self, area: Area, image: &RgbImage) -> Result<(), String> {
        let mut bytes = Vec::new();
        PngEncoder::new_with_quality(&mut bytes, CompressionType::Best, FilterType::NoFilter)
            .write_image(image.as_raw(), image.width(), image.height(), ExtendedColorType::Rgb8)
            .map_err(|error| format!("cannot encode a map: {error}"))?;
        let Area { x, y, width, height } = area;
        self.add(format_args!(
            "<image preserveAspectRatio=\"none\" x=\"{x:.1}\" y=\"{y:.1}\" width=\"{width:.1}\" height=\"{height:.1}\" \
             style=\"image-rendering:pixelated\" href=\"data:image/png;base64,{}\"/>",
            STANDARD.encode(bytes)
        ));
        Ok(())
    }
}

/// A rectangle of the picture.
#[derive(Clone, Copy)]
pub struct Area {
    pub x: f64,
    pub y: f64,
    pub width: f64,
    pub height: f64,
}

impl Area {
    pub fn right(self) -> f64 {
        self.x + self.width
    }

    pub fn bottom(self) -> f64 {
        self.y + self.height
    }
}

/// A logarithmic axis, from one power of ten to another, over a stretch of the picture.
#[derive(Clone, Copy)]
pub struct LogAxis {
    /// The exponents at the two ends.
    pub exponents: [f64; 2],
    /// Where the ends are.
    pub ends: [f64; 2],
}

impl LogAxis {
    /// Where a value is; what is beyond an end, at that end.
    pub fn at(&self, value: f64) -> f64 {
        let ([from, to], [start, end]) = (self.exponents, self.ends);
        let along = (value.log10() - from) / (to - from);
        start + (end - start) * along.clamp(0.0, 1.0)
    }

    /// The powers of ten on the axis whose exponents are multiples of a number.
    pub fn powers(&self, every: i32) -> impl Iterator<Item = i32> {
        let [a, b] = self.exponents;
        let (low, high) = (a.min(b).ceil() as i32, a.max(b).floor() as i32);
        (low..=high).filter(move |exponent| exponent.rem_euclid(every) == 0)
    }
}
