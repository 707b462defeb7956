//! What can be asked for, and one line of complaint for what cannot.

use std::path::{Path, PathBuf};

use clap::Parser;

use crate::outcome::{Asked, ask};

/// What the command line asks for.
pub enum Request {
    /// To measure and draw.
    Run(Options),
    /// A text: the help.
    Print(String),
}

/// How much to measure, and where it goes.
pub struct Options {
    pub quick: bool,
    pub add: bool,
    pub draw: bool,
    pub only: String,
    pub caption: String,
    pub peers: Option<PathBuf>,
    pub out: PathBuf,
}

#[derive(Parser)]
#[command(name = "frontier", about = ABOUT)]
struct Arguments {
    #[arg(
        long,
        help = "Few points and passes: the files and the errors are right, the times are not"
    )]
    quick: bool,

    #[arg(
        long,
        help = "Join the records of the folder's frontier.csv: the least times of all runs"
    )]
    add: bool,

    #[arg(long, help = "Measure nothing: draw the folder's frontier.csv again")]
    draw: bool,

    #[arg(
        long,
        value_name = "TEXT",
        default_value = "",
        help = "Measure only what has the text in its key, keep the folder's other records"
    )]
    only: String,

    #[arg(
        long,
        value_name = "TEXT",
        default_value = "",
        help = "Machine and date, to stand under the charts"
    )]
    caption: String,

    #[arg(
        long,
        value_name = "FILE",
        help = "Rivals that were measured just now, instead of those in benches/peers/peers.csv"
    )]
    peers: Option<PathBuf>,

    #[arg(
        long,
        value_name = "DIR",
        help = "Folder to write to, made if there is none [default: target/frontier]"
    )]
    out: Option<PathBuf>,

    /// Cargo gives it to every bench.
    #[arg(long, hide = true)]
    bench: bool,
}

const ABOUT: &str = "\
Times everything that terrella computes, one by one and in batch, measures its
largest error, and draws it beside its rivals.";

/// Reads the command line.
pub fn parse() -> Result<Request, String> {
    let Arguments {
        quick,
        add,
        draw,
        only,
        caption,
        peers,
        out,
        bench: _,
    } = match ask()? {
        Asked::Run(arguments) => arguments,
        Asked::Help(text) => return Ok(Request::Print(text)),
    };
    let out = out.unwrap_or_else(|| Path::new(env!("CARGO_MANIFEST_DIR")).join("target/frontier"));
    Ok(Request::Run(Options {
        quick,
        add,
        draw,
        only,
        caption,
        peers,
        out,
    }))
}
