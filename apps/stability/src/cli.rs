//! What can be asked for, and one line of complaint for what cannot.

use std::path::PathBuf;

use clap::{Arg, Command, value_parser};
use draw::data;
use draw::outcome::{Asked, ask, given};

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

fn command() -> Command {
    Command::new("stability").about(ABOUT).args([
        Arg::new("samples")
            .long("samples")
            .value_name("N")
            .help(SAMPLES)
            .default_value("100")
            .value_parser(value_parser!(u32).range(4..=400)),
        Arg::new("out")
            .long("out")
            .value_name("DIR")
            .help(OUT)
            .value_parser(value_parser!(PathBuf)),
    ])
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
pub fn parse() -> Result<Asked<Options>, String> {
    Ok(match ask(command())? {
        Asked::Run(arguments) => Asked::Run(Options {
            samples: given(&arguments, "samples")?,
            out: given(&arguments, "out").unwrap_or_else(|_| data::target("stability")),
        }),
        Asked::Help(text) => Asked::Help(text),
    })
}
