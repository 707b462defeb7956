//! Pictures in files.

use std::fs::File;
use std::io::{BufWriter, Write};
use std::path::Path;

use image::codecs::jpeg::JpegEncoder;
use image::codecs::png::{CompressionType, FilterType, PngEncoder};
use image::{ImageResult, RgbImage};

use crate::outcome::cannot;

/// Writes a JPEG of a quality from 1 to 100.
///
/// # Errors
/// What is wrong with the file, in one line.
pub fn jpeg(picture: &RgbImage, path: &Path, quality: u8) -> Result<(), String> {
    write(path, |file| {
        JpegEncoder::new_with_quality(file, quality).encode_image(picture)
    })
}

/// Writes a PNG, as small as it gets.
///
/// # Errors
/// What is wrong with the file, in one line.
pub fn png(picture: &RgbImage, path: &Path) -> Result<(), String> {
    write(path, |file| {
        picture.write_with_encoder(PngEncoder::new_with_quality(
            file,
            CompressionType::Best,
            FilterType::Adaptive,
        ))
    })
}

fn write(path: &Path, encode: impl FnOnce(&mut BufWriter<File>) -> ImageResult<()>) -> Result<(), String> {
    let file = File::create(path).map_err(|error| cannot("write", path, &error))?;
    let mut file = BufWriter::new(file);
    encode(&mut file).map_err(|error| cannot("write", path, &error))?;
    file.flush().map_err(|error| cannot("write", path, &error))
}
