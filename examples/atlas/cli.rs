//! What can be asked for, and one line of complaint for what cannot.

use std::path::{Path, PathBuf};

use clap::Parser;
use clap::error::ErrorKind;
use terrella::cube::Projection;
use terrella::{Ellipsoid, NAMED, Shift};

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

/// Draws an atlas of cube projections: an HTML page with, for each projection, the map of the Earth on the unfolded cube and the
/// cube's grid on the globe.
#[derive(Parser)]
#[command(name = "atlas", max_term_width = 100)]
struct Arguments {
    /// Map of the whole Earth to draw, equidistant cylindrical: JPEG or PNG, twice as wide as high, longitude -180 at the left
    /// edge, latitude 90 at the top [default: examples/data/earth-blue-marble-2048.jpg]
    #[arg(long, value_name = "IMAGE")]
    input: Option<PathBuf>,

    #[arg(long = "projection", value_name = "NAME", help = projection_help())]
    projections: Vec<Projection>,

    #[arg(long, value_name = "NAME", default_value_t = Shift::default(), help = shift_help())]
    shift: Shift,

    #[arg(long, value_name = "NAME | A,F", default_value = "wgs84", value_parser = named_ellipsoid, help = ellipsoid_help())]
    ellipsoid: (String, Ellipsoid<f64>),

    /// Pixels along the edge of a face, 64 to 2048
    #[arg(long, value_name = "N", default_value_t = 512, value_parser = clap::value_parser!(u32).range(64..=2048))]
    size: u32,

    /// Folder to write to, made if there is none [default: target/atlas]
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
}

fn projection_help() -> String {
    let names = names(Projection::ALL.iter().map(|p| p.name()));
    format!("Projection to draw, once for each; all of them if not given: {names}")
}

fn shift_help() -> String {
    let names = names(Shift::ALL.iter().map(|s| s.name()));
    format!("Which latitude is taken for the sphere's: {names}")
}

fn ellipsoid_help() -> String {
    let names = names(NAMED.iter().copied());
    format!("{names}, or a semi-major axis in metres and a flattening, such as 6378137,1/298.257223563")
}

fn names<'a>(names: impl Iterator<Item = &'a str>) -> String {
    names.collect::<Vec<_>>().join(", ")
}

/// Reads the command line.
pub fn parse() -> Result<Request, String> {
    let arguments = match Arguments::try_parse() {
        Ok(arguments) => arguments,
        Err(error) if error.kind() == ErrorKind::DisplayHelp => return Ok(Request::Print(error.to_string())),
        Err(error) => {
            let text = error.to_string();
            let line = text.lines().next().unwrap_or_default();
            return Err(line.strip_prefix("error: ").unwrap_or(line).to_owned());
        }
    };
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let data = root.join("examples").join("data");
    let asked = |p: &Projection| arguments.projections.is_empty() || arguments.projections.contains(p);
    let (ellipsoid_name, ellipsoid) = arguments.ellipsoid;
    Ok(Request::Atlas(Options {
        input: arguments
            .input
            .unwrap_or_else(|| data.join("earth-blue-marble-2048.jpg")),
        coastline: data.join("land-110m.tsv"),
        projections: Projection::ALL.iter().copied().filter(asked).collect(),
        shift: arguments.shift,
        ellipsoid,
        ellipsoid_name,
        size: arguments.size,
        out: arguments.out.unwrap_or_else(|| root.join("target").join("atlas")),
    }))
}

/// An ellipsoid by name or as `A,F`, along with what it was called.
fn named_ellipsoid(text: &str) -> Result<(String, Ellipsoid<f64>), String> {
    let ellipsoid = match text.split_once(',') {
        None => Ellipsoid::named(text).ok_or_else(|| {
            format!(
                "unknown ellipsoid; known are {}, or give A,F",
                names(NAMED.iter().copied())
            )
        })?,
        Some((a, f)) => Ellipsoid::new(number(a)?, number(f)?).map_err(|error| error.to_string())?,
    };
    Ok((text.to_owned(), ellipsoid))
}

/// A number or a fraction of two.
fn number(text: &str) -> Result<f64, String> {
    let plain = |part: &str| {
        let part = part.trim();
        part.parse::<f64>().map_err(|_| format!("`{part}` is not a number"))
    };
    match text.split_once('/') {
        Some((above, below)) => Ok(plain(above)? / plain(below)?),
        None => plain(text),
    }
}
