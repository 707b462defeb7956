//! The map that is drawn on the cubes, and its colour at any latitude and longitude.

use std::path::Path;

use image::{ImageReader, RgbImage};
use terrella::LatLon;

use crate::outcome::cannot;

/// A map of the whole Earth, equidistant cylindrical.
pub struct Imagery {
    width: usize,
    height: usize,
    pixels: Vec<[u8; 3]>,
}

impl Imagery {
    /// Samples taken along each side of a pixel that is drawn.
    pub const SUPERSAMPLING: u32 = 2;

    /// Reads a map for faces of `size` pixels.
    pub fn read(path: &Path, size: u32) -> Result<Self, String> {
        let picture = ImageReader::open(path)
            .and_then(ImageReader::with_guessed_format)
            .map_err(|error| cannot("read", path, &error))?
            .decode()
            .map_err(|error| cannot("read", path, &error))?
            .into_rgb8();
        let (width, height) = picture.dimensions();
        if u64::from(width) != 2 * u64::from(height) {
            return Err(format!(
                "{} is {width} by {height} pixels; a map of the whole Earth is twice as wide as high",
                path.display()
            ));
        }
        let mut imagery = Self::from(&picture);
        // Supersampling covers what is left of the minification; finer detail would only alias.
        let samples_around = (4 * size * Self::SUPERSAMPLING) as usize;
        while imagery.width > samples_around && imagery.height % 2 == 0 {
            imagery = imagery.halved();
        }
        Ok(imagery)
    }

    /// Half as wide and high, by averages of two by two.
    fn halved(&self) -> Self {
        let (width, height) = (self.width / 2, self.height / 2);
        let average = |index: usize| {
            let first = 2 * (index / width) * self.width + 2 * (index % width);
            let block = [first, first + 1, first + self.width, first + self.width + 1];
            std::array::from_fn(|channel| {
                let sum: u32 = block.iter().map(|&at| u32::from(self.pixels[at][channel])).sum();
                ((sum + 2) / 4) as u8
            })
        };
        Self {
            width,
            height,
            pixels: (0..width * height).map(average).collect(),
        }
    }

    /// The colour at a place, between the four pixels around it; channels from 0 to 255.
    pub fn sample(&self, place: LatLon<f64>) -> [f32; 3] {
        // Pixel centres are at halves. One turn is added so that what is cut off is below the point.
        let x = (place.lon() / 360.0 + 1.5) * self.width as f64 - 0.5;
        let y = ((0.5 - place.lat() / 180.0) * self.height as f64 - 0.5).clamp(0.0, (self.height - 1) as f64);
        let (column, row) = (x as usize, y as usize);
        let (right, down) = ((x - column as f64) as f32, (y - row as f64) as f32);
        let columns = [column % self.width, (column + 1) % self.width];
        let rows = [row, (row + 1).min(self.height - 1)];
        let [[a, b], [c, d]] = rows.map(|row| columns.map(|column| self.pixels[row * self.width + column]));
        std::array::from_fn(|channel| {
            let [a, b, c, d] = [a, b, c, d].map(|pixel| f32::from(pixel[channel]));
            let (upper, lower) = (a + (b - a) * right, c + (d - c) * right);
            upper + (lower - upper) * down
        })
    }
}

impl From<&RgbImage> for Imagery {
    fn from(picture: &RgbImage) -> Self {
        Self {
            width: picture.width() as usize,
            height: picture.height() as usize,
            pixels: picture.pixels().map(|pixel| pixel.0).collect(),
        }
    }
}
