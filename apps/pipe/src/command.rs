//! The command line: what can be asked for, and how a wrong one is answered.

use std::process::ExitCode;

use clap::builder::EnumValueParser;
use clap::error::ErrorKind;
use clap::{Arg, ArgMatches, Command};

use crate::operation::{Answer, Failure, GROUPS, Operation, Scalar};

const ABOUT: &str = "\
Reads lines of columns from standard input and writes one line of columns for each.

Columns are separated by blanks or tabs on input, by one tab on output. Lines that begin with # are skipped, and blank
ones where an operation needs a column. Latitudes, longitudes and azimuths are in degrees, lengths in metres; X Y Z are
Earth axes.

A number is written with the fewest digits that read back to the same bits: with a decimal point from 1e-5 up to 1e16
(1.0, not 1), with an exponent outside (6.1e-17), infinity as inf. Faces, levels and pixels are plain integers, cells
hexadecimal.

A line that cannot be processed becomes \"error: why\" in its place, and the rest goes on. Exit code 0: every line was
processed; 1: some was not; 2: the command line is wrong.";

/// Reads the command line; the exit code where there is nothing to answer.
pub fn ask() -> Result<Answer, ExitCode> {
    let matches = command().try_get_matches().map_err(|error| explain(&error))?;
    start(&matches).map_err(|why| refuse(&why.to_string()))
}

fn start(matches: &ArgMatches) -> Result<Answer, Failure> {
    let (name, options) = matches.subcommand().ok_or("no operation")?;
    let operation = operations().find(|operation| operation.name == name);
    let scalar = options.get_one("scalar").copied().unwrap_or(Scalar::F64);
    (operation.ok_or("unknown operation")?.start)(options, scalar)
}

fn operations() -> impl Iterator<Item = &'static Operation> {
    GROUPS.iter().flat_map(|group| group.operations)
}

fn command() -> Command {
    let scalar = Arg::new("scalar")
        .long("scalar")
        .help("The precision in which numbers are read, computed and written")
        .global(true)
        .value_parser(EnumValueParser::<Scalar>::new())
        .default_value("f64");
    let groups: Vec<_> = GROUPS.iter().map(ToString::to_string).collect();
    Command::new("pipe")
        .about(ABOUT)
        .arg(scalar)
        .disable_help_subcommand(true)
        .subcommand_required(true)
        .arg_required_else_help(true)
        .subcommand_value_name("OPERATION")
        .subcommands(
            operations().map(|operation| (operation.options)(Command::new(operation.name)).about(operation.columns)),
        )
        .help_template("{about-with-newline}\n{usage-heading} {usage}\n\nOptions:\n{options}\n\n{after-help}")
        .after_help(groups.join("\n"))
}

/// Prints the help that was asked for, or what is wrong, in one line; gives the exit code.
fn explain(error: &clap::Error) -> ExitCode {
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
        let names: Vec<_> = operations().map(|operation| operation.name).collect();
        return refuse(&format!("{why} [operations: {}]", names.join(", ")));
    }
    refuse(why)
}

/// Says in one line what is wrong with the command line.
fn refuse(why: &str) -> ExitCode {
    eprintln!("error: {why}");
    ExitCode::from(2)
}
