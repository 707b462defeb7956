//! An atlas of the cube projections: a map of the Earth on every cube, every cube's grid on the Earth, and a page about them.
//!
//! `cargo run --release --example atlas` writes `target/atlas/index.html`; `-- --help` says what else it can do.

// Pixels and vertices are addressed by index; the bounds come from the loops around them.
#![allow(clippy::indexing_slicing)]

mod article;
mod catalogue;
mod cli;
mod contour;
mod cross;
mod distortion;
#[path = "../options/ellipsoid.rs"]
mod ellipsoid;
mod geography;
mod globe;
mod imagery;
mod indicatrix;
mod labels;
mod legend;
mod measure;
mod multiples;
#[path = "../options/outcome.rs"]
mod outcome;
mod page;
mod pareto;
mod pen;
mod scale;
mod table;
mod trace;

use std::fs::{self, File};
use std::io::{BufWriter, Write};
use std::path::Path;
use std::process::ExitCode;

use image::RgbImage;
use image::codecs::jpeg::JpegEncoder;
use indicatif::{ProgressBar, ProgressStyle};
use rayon::prelude::*;
use terrella::cube::{CubeMap, Face, Projection};

use cli::Options;
use cross::Geography;
use distortion::Quantity;
use globe::Globe;
use imagery::Imagery;
use page::Shown;

const JPEG_QUALITY: u8 = 88;

/// Steps of progress for a projection when its faces are drawn: globe, distortion, figures.
const STEPS_AFTER_FACES: usize = 3;

fn main() -> ExitCode {
    let done = match cli::parse() {
        Ok(cli::Request::Atlas(options)) => atlas(&options),
        Ok(cli::Request::Print(text)) => Ok(text),
        Err(message) => Err(message),
    };
    outcome::report(done)
}

/// Makes the atlas and says where it is.
fn atlas(options: &Options) -> Result<String, String> {
    let maps = options
        .projections
        .iter()
        .map(|&projection| CubeMap::new(options.ellipsoid, options.shift, projection))
        .collect::<Result<Vec<_>, _>>()
        .map_err(|error| error.to_string())?;
    let imagery = Imagery::read(&options.input, options.size)?;
    let geography = Geography {
        coastline: geography::coastline(&options.coastline)?,
        graticule: geography::graticule(),
    };
    fs::create_dir_all(&options.out).map_err(|error| cannot("create the folder", &options.out, &error))?;

    let steps = maps.len() * (Face::ALL.len() + STEPS_AFTER_FACES);
    let progress = ProgressBar::new(u64::try_from(steps).unwrap_or(u64::MAX));
    if let Ok(style) = ProgressStyle::with_template("{bar:40} {percent:>3} %  {msg}") {
        progress.set_style(style);
    }
    let globe = Globe::new(&imagery, options.size)?;
    let shown = maps
        .par_iter()
        .map(|map| {
            let projection = map.projection();
            progress.set_message(projection.name());
            let cross = cross::draw(map, &imagery, &geography, options.size, &progress)?;
            save(&cross, &options.out.join(cross_file(projection)))?;
            save(&globe.with_grid(map), &options.out.join(globe_file(projection)))?;
            progress.inc(1);
            for (quantity, picture) in distortion::draw(map, &geography.coastline, options.size)? {
                save(&picture, &options.out.join(map_file(projection, quantity)))?;
            }
            let ellipses = options.out.join(ellipses_file(projection));
            fs::write(&ellipses, indicatrix::svg(map, &geography.coastline))
                .map_err(|error| cannot("write", &ellipses, &error))?;
            progress.inc(1);
            let shown = Shown::of(map);
            progress.inc(1);
            Ok(shown)
        })
        .collect::<Result<Vec<_>, String>>()?;
    progress.finish_and_clear();

    let index = options.out.join("index.html");
    fs::write(&index, page::html(options, &shown)).map_err(|error| cannot("write", &index, &error))?;
    Ok(format!("wrote {}", index.display()))
}

/// The picture of a projection's unfolded cube.
fn cross_file(projection: Projection) -> String {
    format!("{projection}-cube.jpg")
}

/// The picture of a projection's grid on the globe.
fn globe_file(projection: Projection) -> String {
    format!("{projection}-globe.jpg")
}

/// The picture of a quantity on two faces.
fn map_file(projection: Projection, quantity: &Quantity) -> String {
    format!("{projection}-{}.jpg", quantity.key)
}

/// The picture of Tissot's ellipses.
fn ellipses_file(projection: Projection) -> String {
    format!("{projection}-ellipses.svg")
}

fn save(picture: &RgbImage, path: &Path) -> Result<(), String> {
    let file = File::create(path).map_err(|error| cannot("write", path, &error))?;
    let mut file = BufWriter::new(file);
    JpegEncoder::new_with_quality(&mut file, JPEG_QUALITY)
        .encode_image(picture)
        .map_err(|error| cannot("write", path, &error))?;
    file.flush().map_err(|error| cannot("write", path, &error))
}

/// A message about a file.
fn cannot(what: &str, path: &Path, error: &dyn std::error::Error) -> String {
    format!("cannot {what} {}: {error}", path.display())
}
