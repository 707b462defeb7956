//! How the examples that draw begin and end: one line for every error, no panic for a closed pipe.

use std::io::{self, Write};
use std::process::ExitCode;

use clap::Parser;
use clap::error::ErrorKind;

/// What the command line asked for.
pub enum Asked<A> {
    /// To be run with these arguments.
    Run(A),
    /// The help text.
    Help(String),
}

/// Reads the command line.
///
/// # Errors
/// What is wrong with it, in one line.
pub fn ask<A: Parser>() -> Result<Asked<A>, String> {
    match A::try_parse() {
        Ok(arguments) => Ok(Asked::Run(arguments)),
        Err(error) if error.kind() == ErrorKind::DisplayHelp => Ok(Asked::Help(error.to_string())),
        Err(error) => {
            let text = error.to_string();
            let line = text.lines().next().unwrap_or_default();
            Err(line.strip_prefix("error: ").unwrap_or(line).to_owned())
        }
    }
}

/// Prints what was done, or what went wrong; gives the exit code.
pub fn report(done: Result<String, String>) -> ExitCode {
    // A closed pipe at the other end is no reason to panic, so the results of writing are let go.
    match done {
        Ok(text) => {
            let _ = writeln!(io::stdout(), "{}", text.trim_end());
            ExitCode::SUCCESS
        }
        Err(message) => {
            let line = message.split_whitespace().collect::<Vec<_>>().join(" ");
            let _ = writeln!(io::stderr(), "error: {line}");
            ExitCode::FAILURE
        }
    }
}
