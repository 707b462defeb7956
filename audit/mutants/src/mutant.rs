//! A mutant, as `cargo mutants --list --json` tells it.

use serde::Deserialize;

#[derive(Deserialize)]
pub struct Mutant {
    pub file: String,
    pub genre: Genre,
    pub name: String,
    pub replacement: String,
    pub span: Span,
}

#[derive(Clone, Copy, Deserialize, PartialEq)]
pub enum Genre {
    BinaryOperator,
    FnValue,
    MatchArm,
    UnaryOperator,
    #[serde(other)]
    Other,
}

#[derive(Deserialize)]
pub struct Span {
    pub start: Place,
}

/// Both from 1.
#[derive(Clone, Copy, Deserialize, Eq, Ord, PartialEq, PartialOrd)]
pub struct Place {
    pub line: usize,
    pub column: usize,
}

impl From<proc_macro2::LineColumn> for Place {
    fn from(place: proc_macro2::LineColumn) -> Self {
        Self {
            line: place.line,
            column: place.column + 1,
        }
    }
}
