//! How the programs begin and end: one line for every error, no panic for a closed pipe.

use std::error::Error;
use std::io::{self, Write};
use std::path::Path;
use std::process::ExitCode;

use clap::error::ErrorKind;
use clap::{ArgMatches, Command};

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
pub fn ask(command: Command) -> Result<Asked<ArgMatches>, String> {
    match command.try_get_matches() {
        Ok(arguments) => Ok(Asked::Run(arguments)),
        Err(error) if error.kind() == ErrorKind::DisplayHelp => Ok(Asked::Help(error.to_string())),
        Err(error) => {
            let text = error.to_string();
            let line = text.lines().next().unwrap_or_default();
            Err(line.strip_prefix("error: ").unwrap_or(line).to_owned())
        }
    }
}

/// An argument that has a default or was given.
///
/// # Errors
/// If it has none and was not.
pub fn given<T: Clone + Send + Sync + 'static>(arguments: &ArgMatches, name: &str) -> Result<T, String> {
    let value = arguments.get_one::<T>(name);
    value.cloned().ok_or_else(|| format!("'--{name}' is missing"))
}

/// Runs what was asked for, or prints the help; gives the exit code.
pub fn run<A>(asked: Result<Asked<A>, String>, program: impl FnOnce(A) -> Result<String, String>) -> ExitCode {
    report(asked.and_then(|asked| match asked {
        Asked::Run(arguments) => program(arguments),
        Asked::Help(text) => Ok(text),
    }))
}

/// Prints what was done, or what went wrong; gives the exit code.
fn report(done: Result<String, String>) -> ExitCode {
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

/// A message about a file.
pub fn cannot(what: &str, path: &Path, error: &dyn Error) -> String {
    format!("cannot {what} {}: {error}", path.display())
}
