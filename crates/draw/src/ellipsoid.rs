//! The `--ellipsoid` option, for every program that has it.

use terrella::{Ellipsoid, UnknownEllipsoid};

/// Reads a name, or `A,F` with a number or a fraction for F.
///
/// # Errors
/// What is wrong, in one line.
pub fn parse(text: &str) -> Result<Ellipsoid<f64>, String> {
    match text.split_once(',') {
        Some((a, f)) => Ellipsoid::new(number(a)?, ratio(f)?).map_err(|error| error.to_string()),
        None => text
            .parse()
            .map_err(|error: UnknownEllipsoid| format!("{error}; or A,F for any other")),
    }
}

/// Reads a number or a fraction of two.
fn ratio(text: &str) -> Result<f64, String> {
    match text.split_once('/') {
        Some((above, below)) => Ok(number(above)? / number(below)?),
        None => number(text),
    }
}

fn number(text: &str) -> Result<f64, String> {
    text.trim().parse().map_err(|_| format!("{text:?} is not a number"))
}
