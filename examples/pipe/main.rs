//! The library in a pipe, for scripts, comparisons and whoever checks numbers: one line of numbers in, one line out.
//!
//! ```console
//! $ printf '59.91 10.75\n# Quito\n-0.22 281.49\n91 0\n' | cargo run -q --release --example pipe -- project --projection equi-edge
//! 4    0.12448388308534873    -0.6243060621680013
//! 3    0.23194306900631995    -0.004481450598314789
//! error: latitude 91 is not in [-90, 90] degrees
//! ```
//!
//! `--help` says what lines and numbers look like, `OPERATION --help` which columns go in and come out. A new operation is one
//! variant in `command.rs` and one arm in `operation.rs`.

mod command;
#[path = "../options/ellipsoid.rs"]
mod ellipsoid;
mod lines;
mod operation;
mod row;

use std::process::ExitCode;

use clap::Parser;
use command::{CommandLine, Scalar};

fn main() -> ExitCode {
    let CommandLine { scalar, operation } = match CommandLine::try_parse() {
        Ok(command_line) => command_line,
        Err(error) => return command::explain(&error),
    };
    let outcome = match scalar {
        Scalar::F64 => operation::run::<f64>(operation),
        Scalar::F32 => operation::run::<f32>(operation),
    };
    outcome.unwrap_or_else(|why| command::refuse(&why.to_string()))
}
