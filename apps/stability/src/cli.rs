//! What can be asked for, and one line of complaint for what cannot.

use std::path::{Path, PathBuf};

use clap::{Parser, value_parser};

use crate::outcome::{Asked, ask};

/// What the command line asks for.
pub enum Request {
    /// The pictures and the page.
    Pictures(Options),
    /// A text: the help.
    Print(String),
}

/// How much to compute, and where it goes.
pub struct Options {
    pub samples: u32,
    pub out: PathBuf,
}

impl Options {
    /// Pairs in each of the comparison's two sets.
    pub fn pairs(&self) -> usize {
        self.samples as usize * 1000
    }

    /// Pairs in each tenth of a decade of distance.
    pub fn pairs_per_bin(&self) -> usize {
        self.samples as usize
    }

    /// Cells along the side of a map.
    pub fn side(&self) -> u32 {
        (400 * self.samples).isqrt()
    }
}

#[derive(Parser)]
#[command(name = "stability", about = ABOUT)]
struct Arguments {
    #[arg(long, value_name = "N", help = SAMPLES, default_value_t = 100, value_parser = value_parser!(u32).range(4..=400))]
    samples: u32,

    #[arg(long, value_name = "DIR", help = OUT)]
    out: Option<PathBuf>,
}

const ABOUT: &str = "\
Draws where each method of distance holds and where it does not: error against
distance, maps about the antipode, the way back from Earth-centred coordinates,
and a comparison with other crates.";

const SAMPLES: &str = "\
Pairs of places for each tenth of a decade of distance, 4 to 400; the
comparison takes 1000 times as many, a map 400 times as many cells";

const OUT: &str = "Folder to write to, made if there is none [default: target/stability]";

/// Reads the command line.
pub fn parse() -> Result<Request, String> {
    let arguments: Arguments = match ask()? {
        Asked::Run(arguments) => arguments,
        Asked::Help(text) => return Ok(Request::Print(text)),
    };
    let target = Path::new(env!("CARGO_MANIFEST_DIR")).join("target");
    Ok(Request::Pictures(Options {
        samples: arguments.samples,
        out: arguments.out.unwrap_or_else(|| target.join("stability")),
    }))
}
