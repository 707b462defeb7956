//! The command line: what can be asked for, and how a wrong one is answered.

use std::error::Error;
use std::process::ExitCode;
use std::str::FromStr;

use clap::builder::{PossibleValuesParser, TypedValueParser};
use clap::error::ErrorKind;
use clap::{Args, CommandFactory, Parser, Subcommand, ValueEnum};
use terrella::cube::Projection;
use terrella::geodesic::Method;
use terrella::{Ellipsoid, Latitude, NAMED, Shift};

/// Reads lines of numbers from standard input and writes one line of numbers for each.
///
/// Columns are separated by blanks or tabs on input, by one tab on output. Blank lines and lines that begin with # are skipped.
///
/// A number is written with the fewest digits that read back to the same bits: with a decimal point from 1e-5 up to 1e16
/// (1.0, not 1), with an exponent outside (6.1e-17), infinity as inf. A face is a plain integer.
///
/// A line that cannot be processed becomes "error: why" in its place, and the rest goes on. Exit code 0: every line was
/// processed; 1: some was not; 2: the command line is wrong.
#[derive(Parser)]
#[command(name = "pipe", disable_help_subcommand = true)]
#[command(subcommand_value_name = "OPERATION", subcommand_help_heading = "Operations")]
pub struct CommandLine {
    /// What to compute.
    #[command(subcommand)]
    pub operation: Operation,

    /// The precision in which numbers are read, computed and written.
    #[arg(long, global = true, value_enum, default_value_t = Scalar::F64)]
    pub scalar: Scalar,
}

/// A precision.
#[derive(Clone, Copy, ValueEnum)]
pub enum Scalar {
    F64,
    F32,
}

/// What to compute, with its options.
#[derive(Subcommand)]
pub enum Operation {
    /// X Y Z -> face x y: a direction in Earth axes, a vector of any length, to the cube.
    Forward(Sphere),
    /// face x y -> X Y Z: the cube to a unit vector in Earth axes.
    Inverse(Sphere),
    /// lat lon -> face x y: degrees on the ellipsoid to the cube.
    Project(Map),
    /// face x y -> lat lon: the cube to degrees on the ellipsoid.
    Unproject(Map),
    /// One latitude -> another of the same place, in degrees; the isometric latitude is dimensionless.
    Latitude(Latitudes),
    /// lat1 lon1 lat2 lon2 -> s12 azi1 azi2: metres and degrees from one place to another.
    GeodesicInverse(Line),
    /// lat1 lon1 azi1 s12 -> lat2 lon2 azi2: where an azimuth and a distance lead.
    GeodesicDirect(Line),
    /// lat lon h -> X Y Z: degrees and metres to metres in Earth axes.
    ToEcef(Planet),
    /// X Y Z -> lat lon h: metres in Earth axes to the nearest point of the ellipsoid and the height above it.
    FromEcef(Planet),
    /// lat lon h -> east north up: metres in the local frame of an origin.
    ToEnu(Local),
    /// east north up -> lat lon h: metres in the local frame of an origin.
    FromEnu(Local),
}

/// A method on an ellipsoid.
#[derive(Args)]
pub struct Line {
    /// How geodesics are computed; methods of the sphere take that of mean radius.
    #[arg(long, value_name = "NAME", default_value = "karney", value_parser = one_of::<Method>(Method::ALL.iter().map(|m| m.name())))]
    pub method: Method,

    #[command(flatten)]
    pub planet: Planet,
}

/// A local frame.
#[derive(Args)]
pub struct Local {
    /// The origin in degrees and metres.
    #[arg(long, value_name = "LAT,LON,H", allow_hyphen_values = true, value_parser = origin)]
    pub origin: [f64; 3],

    #[command(flatten)]
    pub planet: Planet,
}

fn origin(text: &str) -> Result<[f64; 3], String> {
    let numbers: Result<Vec<f64>, _> = text.split(',').map(|part| part.trim().parse()).collect();
    let origin = numbers.map_err(|_| "not three numbers with commas between them".to_owned())?;
    <[f64; 3]>::try_from(origin).map_err(|_| "not three numbers with commas between them".to_owned())
}

/// A projection of the sphere.
#[derive(Args)]
pub struct Sphere {
    /// The projection between sphere and cube.
    #[arg(long, value_name = "NAME", value_parser = one_of::<Projection>(Projection::ALL.iter().map(|p| p.name())))]
    pub projection: Projection,
}

/// A projection of the ellipsoid.
#[derive(Args)]
pub struct Map {
    #[command(flatten)]
    pub sphere: Sphere,

    /// The latitude that is taken for that of the sphere.
    #[arg(long, value_name = "NAME", default_value_t, value_parser = one_of::<Shift>(Shift::ALL.iter().map(|s| s.name())))]
    pub shift: Shift,

    #[command(flatten)]
    pub planet: Planet,
}

/// From which latitude to which, on what.
#[derive(Args)]
pub struct Latitudes {
    /// The latitude that is read.
    #[arg(long, value_name = "NAME", value_parser = latitude())]
    pub from: Latitude,

    /// The latitude that is written.
    #[arg(long, value_name = "NAME", value_parser = latitude())]
    pub to: Latitude,

    /// Radians in and out, instead of degrees.
    #[arg(long)]
    pub radians: bool,

    #[command(flatten)]
    pub planet: Planet,
}

/// The ellipsoid, of which the chosen precision is made later.
#[derive(Args)]
pub struct Planet {
    #[arg(long, value_name = "NAME|A,F", default_value = "wgs84", value_parser = crate::ellipsoid::parse, help = planets())]
    pub ellipsoid: Ellipsoid<f64>,
}

fn planets() -> String {
    let names = NAMED.join(", ");
    format!("The ellipsoid: {names}, or semi-major axis in metres and flattening, as in 6378137,1/298.257223563")
}

fn latitude() -> impl TypedValueParser<Value = Latitude> {
    one_of(Latitude::ALL.iter().map(|l| l.name()))
}

/// Reads one of the names, which help and errors list.
fn one_of<K>(names: impl Iterator<Item = &'static str>) -> impl TypedValueParser<Value = K>
where
    K: FromStr<Err: Error + Send + Sync> + Clone + Send + Sync + 'static,
{
    PossibleValuesParser::new(names).try_map(|name| name.parse())
}

/// Prints the help that was asked for, or what is wrong, in one line; gives the exit code.
pub fn explain(error: &clap::Error) -> ExitCode {
    if !error.use_stderr() || error.kind() == ErrorKind::DisplayHelpOnMissingArgumentOrSubcommand {
        error.exit();
    }
    // The first paragraph says it all, but for the names of the operations.
    let text = error.to_string();
    let paragraph: Vec<_> = text
        .lines()
        .map(str::trim)
        .take_while(|line| !line.is_empty())
        .collect();
    let why = paragraph.join(" ");
    let why = why.trim_start_matches("error: ");
    if error.kind() == ErrorKind::InvalidSubcommand {
        let command = CommandLine::command();
        let names: Vec<_> = command.get_subcommands().map(clap::Command::get_name).collect();
        return refuse(&format!("{why} [operations: {}]", names.join(", ")));
    }
    refuse(why)
}

/// Says in one line what is wrong with the command line.
pub fn refuse(why: &str) -> ExitCode {
    eprintln!("error: {why}");
    ExitCode::from(2)
}
