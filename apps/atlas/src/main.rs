//! An atlas of the cube projections: a map of the Earth on every cube, every cube's grid on the Earth, and a page about them.
//!
//! `cargo run --release -p atlas` writes `target/atlas/index.html`; `-- --help` says what else it can do.

// Pixels and vertices are addressed by index; the bounds come from the loops around them.
#![allow(clippy::indexing_slicing)]

mod article;
mod cli;
mod contour;
mod cross;
mod distortion;
mod geography;
mod globe;
mod indicatrix;
mod land;
mod legend;
mod multiples;
mod orientation;
mod page;
mod pareto;
mod pen;
mod ranking;
mod scale;
mod table;
mod trace;

use std::fs;
use std::process::ExitCode;

use draw::imagery::Imagery;
use draw::outcome::{self, cannot};
use draw::parallel::{self, Progress};
use draw::picture::jpeg;
use terrella::cube::{CubeMap, Face, Projection};

use cli::Options;
use cross::Geography;
use distortion::Quantity;
use globe::Globe;
use land::Land;
use page::Shown;

const JPEG_QUALITY: u8 = 88;

/// Steps of progress for a projection when its faces are drawn: globe, distortion, figures.
const STEPS_AFTER_FACES: usize = 3;

fn main() -> ExitCode {
    outcome::run(cli::parse(), |options| atlas(&options))
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
    let land = Land::read(&options.coastline)?;
    fs::create_dir_all(&options.out).map_err(|error| cannot("create the folder", &options.out, &error))?;

    let globe = Globe::new(&imagery, options.size)?;
    let progress = Progress::new(maps.len() * (Face::ALL.len() + STEPS_AFTER_FACES));
    let shown = parallel::map(&maps, |map| {
        let projection = map.projection();
        let out = |name: String| options.out.join(name);
        let cross = cross::draw(map, &imagery, &geography, options.size, &progress)?;
        jpeg(&cross, &out(cross_file(projection)), JPEG_QUALITY)?;
        jpeg(&globe.with_grid(map), &out(globe_file(projection)), JPEG_QUALITY)?;
        progress.step();
        for (quantity, picture) in distortion::draw(map, &geography.coastline, options.size)? {
            jpeg(&picture, &out(map_file(projection, quantity)), JPEG_QUALITY)?;
        }
        let ellipses = out(ellipses_file(projection));
        fs::write(&ellipses, indicatrix::svg(map, &geography.coastline))
            .map_err(|error| cannot("write", &ellipses, &error))?;
        progress.step();
        let shown = Shown::of(map, &land);
        progress.step();
        Ok::<_, String>(shown)
    })?;

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
