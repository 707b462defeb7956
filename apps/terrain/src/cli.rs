//! What can be asked for, and one line of complaint for what cannot.

use std::path::PathBuf;

use clap::{Arg, Command, value_parser};
use draw::data;
use draw::outcome::{Asked, ask, given};
use terrella::Shift;
use terrella::cube::Projection;

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

fn command() -> Command {
    let argument = |name: &'static str, value: &'static str| Arg::new(name).long(name).value_name(value);
    Command::new("terrain").about(ABOUT).args([
        argument("projection", "NAME")
            .help(PROJECTION)
            .default_value(Projection::Quadrilateralized.name())
            .value_parser(str::parse::<Projection>),
        argument("shift", "NAME")
            .help(SHIFT)
            .default_value(Shift::Geocentric.name())
            .value_parser(str::parse::<Shift>),
        argument("size", "N")
            .help(SIZE)
            .default_value("640")
            .value_parser(value_parser!(u32).range(64..=1920)),
        argument("out", "DIR").help(OUT).value_parser(value_parser!(PathBuf)),
    ])
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
pub fn parse() -> Result<Asked<Options>, String> {
    Ok(match ask(command())? {
        Asked::Run(arguments) => Asked::Run(Options {
            elevation: data::file("jacksboro-dem.pgm"),
            imagery: data::file("earth-blue-marble-2048.jpg"),
            projection: given(&arguments, "projection")?,
            shift: given(&arguments, "shift")?,
            size: given(&arguments, "size")?,
            out: given(&arguments, "out").unwrap_or_else(|_| data::target("terrain")),
        }),
        Asked::Help(text) => Asked::Help(text),
    })
}
