//! What can be asked for, and one line of complaint for what cannot.

use std::path::{Path, PathBuf};

use clap::{Parser, value_parser};
use terrella::Shift;
use terrella::cube::Projection;

use crate::outcome::{Asked, ask};

/// What the command line asks for.
pub enum Request {
    /// The frames and the page.
    Frames(Options),
    /// A text: the help.
    Print(String),
}

/// What is drawn, and where it goes.
pub struct Options {
    pub elevation: PathBuf,
    pub imagery: PathBuf,
    pub projection: Projection,
    pub shift: Shift,
    /// Pixels across a frame.
    pub size: u32,
    pub out: PathBuf,
}

#[derive(Parser)]
#[command(name = "terrain", about = ABOUT)]
struct Arguments {
    #[arg(long, value_name = "NAME", help = PROJECTION, default_value_t = Projection::Quadrilateralized)]
    projection: Projection,

    #[arg(long, value_name = "NAME", help = SHIFT, default_value_t = Shift::Geocentric)]
    shift: Shift,

    #[arg(long, value_name = "N", help = SIZE, default_value_t = 640, value_parser = value_parser!(u32).range(64..=1920))]
    size: u32,

    #[arg(long, value_name = "DIR", help = OUT)]
    out: Option<PathBuf>,
}

const ABOUT: &str = "\
Draws an approach to real terrain on a cube-mapped Earth, from 10 000 km to
200 m above ground: in single precision, in double precision, and the
difference; and what reading heights along a sphere's normal does.";

const PROJECTION: &str = "Projection of the cube";

const SHIFT: &str = "Latitude that is taken for the sphere's";

const SIZE: &str = "Pixels across a frame, 64 to 1920";

const OUT: &str = "Folder to write to, made if there is none [default: target/terrain]";

/// Reads the command line.
pub fn parse() -> Result<Request, String> {
    let arguments: Arguments = match ask()? {
        Asked::Run(arguments) => arguments,
        Asked::Help(text) => return Ok(Request::Print(text)),
    };
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let data = root.join("examples").join("data");
    Ok(Request::Frames(Options {
        elevation: data.join("jacksboro-dem.pgm"),
        imagery: data.join("earth-blue-marble-2048.jpg"),
        projection: arguments.projection,
        shift: arguments.shift,
        size: arguments.size,
        out: arguments.out.unwrap_or_else(|| root.join("target").join("terrain")),
    }))
}
