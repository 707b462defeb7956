//! What can be asked for, and one line of complaint for what cannot.

use std::fmt::Display;
use std::path::PathBuf;

use clap::{Arg, ArgAction, Command, value_parser};
use draw::outcome::{Asked, ask, given};
use draw::{data, ellipsoid};
use terrella::cube::Projection;
use terrella::{Ellipsoid, NAMED, Shift};

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

fn command() -> Command {
    let argument = |name: &'static str, value: &'static str| Arg::new(name).long(name).value_name(value);
    Command::new("atlas").about(ABOUT).args([
        argument("input", "IMAGE")
            .help(INPUT)
            .value_parser(value_parser!(PathBuf)),
        argument("projection", "NAME")
            .help(choice(PROJECTION, Projection::ALL))
            .action(ArgAction::Append)
            .value_parser(str::parse::<Projection>),
        argument("shift", "NAME")
            .help(choice(SHIFT, Shift::ALL))
            .default_value(Shift::default().name())
            .value_parser(str::parse::<Shift>),
        argument("ellipsoid", "NAME")
            .help(choice(ELLIPSOID, NAMED))
            .default_value("wgs84"),
        argument("size", "N")
            .help(SIZE)
            .default_value("512")
            .value_parser(value_parser!(u32).range(64..=2048)),
        argument("out", "DIR").help(OUT).value_parser(value_parser!(PathBuf)),
    ])
}

const ABOUT: &str = "\
Draws an atlas of cube projections: a page with, for each projection, the map of
the Earth on the unfolded cube and the grid of the cube on the globe.";

const INPUT: &str = "\
Map of the whole Earth in equidistant cylindrical projection, JPEG or
PNG, twice as wide as high, longitude -180 at the left edge
[default: crates/draw/data/earth-blue-marble-2048.jpg]";

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
pub fn parse() -> Result<Asked<Options>, String> {
    let arguments = match ask(command())? {
        Asked::Run(arguments) => arguments,
        Asked::Help(text) => return Ok(Asked::Help(text)),
    };
    let path = |name: &str| arguments.get_one::<PathBuf>(name).cloned();
    let asked: Vec<Projection> = arguments.get_many("projection").unwrap_or_default().copied().collect();
    let ellipsoid_name: String = given(&arguments, "ellipsoid")?;
    Ok(Asked::Run(Options {
        input: path("input").unwrap_or_else(|| data::file("earth-blue-marble-2048.jpg")),
        coastline: data::file("land-110m.tsv"),
        projections: Projection::ALL
            .iter()
            .copied()
            .filter(|p| asked.is_empty() || asked.contains(p))
            .collect(),
        shift: given(&arguments, "shift")?,
        ellipsoid: ellipsoid::parse(&ellipsoid_name)
            .map_err(|why| format!("invalid value '{ellipsoid_name}' for '--ellipsoid <NAME>': {why}"))?,
        ellipsoid_name,
        size: given(&arguments, "size")?,
        out: path("out").unwrap_or_else(|| data::target("atlas")),
    }))
}
