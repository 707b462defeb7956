//! An approach to real terrain, drawn in single and in double precision: what is between the two, and what leaning heights would do.
//!
//! `cargo run --release -p terrain` writes `target/terrain/index.html`; `-- --help` says what else it can do.

// Pixels, samples and vertices are addressed by index; the bounds come from the loops around them.
#![allow(clippy::indexing_slicing)]

mod air;
mod approach;
mod cli;
mod difference;
mod elevation;
mod frame;
mod ground;
mod mesh;
mod page;
mod raster;
mod scalar;
mod scale;

use std::fmt::Write as _;
use std::fs;
use std::path::Path;
use std::process::ExitCode;

use draw::imagery::Imagery;
use draw::outcome::{self, cannot};
use draw::parallel::{self, Progress};
use draw::picture;
use image::RgbImage;
use terrella::Ellipsoid;
use terrella::cube::CubeMap;

use approach::{STATIONS, View};
use cli::Options;
use elevation::Elevation;
use frame::{Frame, World};

const JPEG_QUALITY: u8 = 90;

fn main() -> ExitCode {
    outcome::run(cli::parse(), |options| approach(&options))
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
    let progress = Progress::new(STATIONS.len());
    let stations: Vec<_> = STATIONS.into_iter().enumerate().collect();
    let frames = parallel::map(&stations, |&(index, station)| {
        let view = View::new(map.shifted().ellipsoid(), &world.elevation, station)?;
        let frame = world.frame(&view, options.size)?;
        save(&frame, index, out)?;
        progress.step();
        Ok::<_, String>(frame)
    })?;

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
    let jpeg = |of: &RgbImage, kind| picture::jpeg(of, &out.join(jpeg_file(index, kind)), JPEG_QUALITY);
    let png = |of: &RgbImage, kind| picture::png(of, &out.join(png_file(index, kind)));
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
