//! An approach to real terrain, drawn in single and in double precision: what is between the two, and what leaning heights would do.
//!
//! `cargo run --release --example terrain` writes `target/terrain/index.html`; `-- --help` says what else it can do.

// Pixels, samples and vertices are addressed by index; the bounds come from the loops around them.
#![allow(clippy::indexing_slicing)]

mod air;
mod approach;
mod cli;
mod difference;
mod elevation;
mod frame;
mod ground;
#[path = "../atlas/imagery.rs"]
mod imagery;
mod mesh;
#[path = "../options/outcome.rs"]
mod outcome;
mod page;
mod pgm;
mod raster;
mod scalar;
mod scale;

use std::fmt::Write as _;
use std::fs::{self, File};
use std::io::{BufWriter, Write as _};
use std::path::Path;
use std::process::ExitCode;

use image::codecs::jpeg::JpegEncoder;
use image::codecs::png::{CompressionType, FilterType, PngEncoder};
use image::{ImageResult, RgbImage};
use indicatif::{ProgressBar, ProgressStyle};
use rayon::prelude::*;
use terrella::Ellipsoid;
use terrella::cube::CubeMap;

use approach::{STATIONS, View};
use cli::Options;
use elevation::Elevation;
use frame::{Frame, World};
use imagery::Imagery;

const JPEG_QUALITY: u8 = 90;

fn main() -> ExitCode {
    let done = match cli::parse() {
        Ok(cli::Request::Frames(options)) => approach(&options),
        Ok(cli::Request::Print(text)) => Ok(text),
        Err(message) => Err(message),
    };
    outcome::report(done)
}

/// Draws all frames and the page; returns the figures and where the page is.
fn approach(options: &Options) -> Result<String, String> {
    let out = options.out.as_path();
    let map = CubeMap::new(Ellipsoid::WGS84, options.shift, options.projection).map_err(|error| error.to_string())?;
    let elevation = Elevation::read(&options.elevation)?;
    // As fine as it is.
    let imagery = Imagery::read(&options.imagery, u32::MAX / 16)?;
    fs::create_dir_all(out).map_err(|error| cannot("create the folder", out, &error))?;

    let world = World::new(map, elevation, imagery);
    let progress = ProgressBar::new(STATIONS.len() as u64);
    if let Ok(style) = ProgressStyle::with_template("{bar:40} {percent:>3} %") {
        progress.set_style(style);
    }
    let frames = STATIONS
        .into_par_iter()
        .enumerate()
        .map(|(index, station)| {
            let view = View::new(map.shifted().ellipsoid(), &world.elevation, station)?;
            let frame = world.frame(&view, options.size)?;
            save(&frame, index, out)?;
            progress.inc(1);
            Ok(frame)
        })
        .collect::<Result<Vec<_>, String>>()?;
    progress.finish_and_clear();

    let index = out.join("index.html");
    let page = page::html(options, &map, &frames)?;
    fs::write(&index, page).map_err(|error| cannot("write", &index, &error))?;
    Ok(format!("{}wrote {}", table(&frames), index.display()))
}

/// The figures of all frames.
fn table(frames: &[Frame]) -> String {
    let mut text = "above ground      tiles  levels   largest    median  unlike pixels\n".to_owned();
    for frame in frames {
        let [coarsest, finest] = frame.levels;
        // Writing to a string does not fail.
        let _ = writeln!(
            text,
            "{:>12} {:>10} {:>3} to {:<2} {:>8} {:>9} {:>14}",
            scale::length(frame.height),
            frame.tiles,
            coarsest,
            finest,
            scale::length(frame.rounded.largest()),
            scale::length(frame.rounded.median()),
            frame.unlike
        );
    }
    let most = |of: fn(&Frame) -> f64| frames.iter().map(of).fold(0.0, testkit::maximum);
    let (near, beyond) = (most(|frame| frame.rounded.near), most(|frame| frame.rounded.beyond));
    let _ = writeln!(text, "within 1 km: at most {:.3} mm", 1e3 * near);
    let _ = writeln!(text, "beyond: at most {:.3} millionths of the distance", 1e6 * beyond);
    text
}

/// The pictures of a frame.
fn save(frame: &Frame, index: usize, out: &Path) -> Result<(), String> {
    let jpeg = |picture: &RgbImage, kind| {
        write(&out.join(jpeg_file(index, kind)), |file| {
            JpegEncoder::new_with_quality(file, JPEG_QUALITY).encode_image(picture)
        })
    };
    let png = |picture: &RgbImage, kind| {
        write(&out.join(png_file(index, kind)), |file| {
            picture.write_with_encoder(PngEncoder::new_with_quality(
                file,
                CompressionType::Best,
                FilterType::Adaptive,
            ))
        })
    };
    jpeg(&frame.single, "single")?;
    jpeg(&frame.double, "double")?;
    png(&frame.rounding, "rounding")?;
    if let Some(naive) = &frame.naive {
        jpeg(&naive.picture, "naive")?;
        png(&naive.apart, "naive-rounding")?;
    }
    if let Some(leaning) = &frame.leaning {
        jpeg(&leaning.picture, "leaning")?;
        png(&leaning.apart, "lean")?;
    }
    Ok(())
}

fn jpeg_file(index: usize, kind: &str) -> String {
    format!("{index:02}-{kind}.jpg")
}

fn png_file(index: usize, kind: &str) -> String {
    format!("{index:02}-{kind}.png")
}

fn write(path: &Path, encode: impl FnOnce(&mut BufWriter<File>) -> ImageResult<()>) -> Result<(), String> {
    let file = File::create(path).map_err(|error| cannot("write", path, &error))?;
    let mut file = BufWriter::new(file);
    encode(&mut file).map_err(|error| cannot("write", path, &error))?;
    file.flush().map_err(|error| cannot("write", path, &error))
}

/// A message about a file.
fn cannot(what: &str, path: &Path, error: &dyn std::error::Error) -> String {
    format!("cannot {what} {}: {error}", path.display())
}
