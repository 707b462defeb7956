//! What can be asked for, and one line of complaint for what cannot.

use std::fmt::Display;
use std::path::{Path, PathBuf};

use clap::{Parser, value_parser};
use terrella::cube::Projection;
use terrella::{Ellipsoid, NAMED, Shift};

use crate::ellipsoid;
use crate::outcome::{Asked, ask};

/// What the command line asks for.
pub enum Request {
    /// An atlas.
    Atlas(Options),
    /// A text: the help.
    Print(String),
}

/// An atlas in detail, nothing left open.
pub struct Options {
    pub input: PathBuf,
    pub coastline: PathBuf,
    pub projections: Vec<Projection>,
    pub shift: Shift,
    pub ellipsoid: Ellipsoid<f64>,
    /// The ellipsoid as it was asked for.
    pub ellipsoid_name: String,
    /// Pixels along the edge of a face.
    pub size: u32,
    pub out: PathBuf,
}

#[derive(Parser)]
#[command(name = "atlas", about = ABOUT)]
struct Arguments {
    #[arg(long, value_name = "IMAGE", help = INPUT)]
    input: Option<PathBuf>,

    #[arg(long = "projection", value_name = "NAME", help = choice(PROJECTION, Projection::ALL))]
    projections: Vec<Projection>,

    #[arg(long, value_name = "NAME", help = choice(SHIFT, Shift::ALL), default_value_t = Shift::default())]
    shift: Shift,

    #[arg(long, value_name = "NAME", help = choice(ELLIPSOID, NAMED), default_value = "wgs84")]
    ellipsoid: String,

    #[arg(long, value_name = "N", help = SIZE, default_value_t = 512, value_parser = value_parser!(u32).range(64..=2048))]
    size: u32,

    #[arg(long, value_name = "DIR", help = OUT)]
    out: Option<PathBuf>,
}

const ABOUT: &str = "\
Draws an atlas of cube projections: a page with, for each projection, the map of
the Earth on the unfolded cube and the grid of the cube on the globe.";

const INPUT: &str = "\
Map of the whole Earth in equidistant cylindrical projection, JPEG or
PNG, twice as wide as high, longitude -180 at the left edge
[default: examples/data/earth-blue-marble-2048.jpg]";

const PROJECTION: &str = "Projection to draw, once for each; without any, all of";

const SHIFT: &str = "Latitude that is taken for the sphere's, one of";

const ELLIPSOID: &str = "\
Shape of the Earth: A,F, the semi-major axis in metres and the
flattening, such as 6378137,1/298.257223563, or one of";

const SIZE: &str = "Pixels along the edge of a face, 64 to 2048";

const OUT: &str = "Folder to write to, made if there is none [default: target/atlas]";

/// A help text that ends in a list of names, on lines of moderate length.
fn choice<T: Display>(text: &str, names: &[T]) -> String {
    let mut help = text.to_owned();
    let mut room = 0;
    for name in names.iter().map(T::to_string) {
        if name.len() < room {
            help.push(' ');
        } else {
            help.push('\n');
            room = 66;
        }
        room = room.saturating_sub(name.len() + 1);
        help.push_str(&name);
    }
    help
}

/// Reads the command line.
pub fn parse() -> Result<Request, String> {
    let arguments: Arguments = match ask()? {
        Asked::Run(arguments) => arguments,
        Asked::Help(text) => return Ok(Request::Print(text)),
    };
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let data = root.join("examples").join("data");
    let asked = |p: &Projection| arguments.projections.is_empty() || arguments.projections.contains(p);
    Ok(Request::Atlas(Options {
        input: arguments
            .input
            .unwrap_or_else(|| data.join("earth-blue-marble-2048.jpg")),
        coastline: data.join("land-110m.tsv"),
        projections: Projection::ALL.iter().copied().filter(asked).collect(),
        shift: arguments.shift,
        ellipsoid: ellipsoid::parse(&arguments.ellipsoid).map_err(|why| {
            format!(
                "invalid value '{}' for '--ellipsoid <NAME>': {why}",
                arguments.ellipsoid
            )
        })?,
        ellipsoid_name: arguments.ellipsoid,
        size: arguments.size,
        out: arguments.out.unwrap_or_else(|| root.join("target").join("atlas")),
    }))
}
