//! The operations: each a name, its columns, its options, and a function from them to what answers a line.

mod angle;
mod cell;
mod closest;
mod cube;
mod fence;
mod frame;
mod geodesic;
mod grid;
mod healpix;
mod horizon;
mod intersection;
mod latitude;
mod polygon;
mod position;
mod rhumb;
mod sphere;
mod text;

use std::error::Error;
use std::fmt;

use clap::{ArgMatches, Command, ValueEnum};

use crate::read::{Count, Fields, Read};
use crate::write::{Columns, Row};

/// Why a line, or all of them, cannot be answered.
pub type Failure = Box<dyn Error>;

/// A precision.
#[derive(Clone, Copy, ValueEnum)]
pub enum Scalar {
    F64,
    F32,
}

/// Operations on one subject.
pub struct Group {
    pub title: &'static str,
    pub operations: &'static [Operation],
}

/// All operations, as `--help` lists them.
pub const GROUPS: &[Group] = &[
    geodesic::GROUP,
    polygon::GROUP,
    rhumb::GROUP,
    closest::GROUP,
    fence::GROUP,
    sphere::GROUP,
    position::GROUP,
    text::GROUP,
    frame::GROUP,
    latitude::GROUP,
    grid::GROUP,
    cube::GROUP,
    cell::GROUP,
    healpix::GROUP,
    horizon::GROUP,
    intersection::GROUP,
    angle::GROUP,
];

/// What can be asked for.
pub struct Operation {
    pub name: &'static str,
    /// What a line holds and what comes back.
    pub columns: &'static str,
    /// Adds its options to a command.
    pub options: fn(Command) -> Command,
    /// Makes of the options what answers a line.
    pub start: fn(&ArgMatches, Scalar) -> Result<Answer, Failure>,
}

/// A group's title and table: name, columns, and a function `f::<T>(options)`, or `f::<T, A<T>, …>(options)`, with the
/// type of its options.
macro_rules! group {
    ($title:literal: $($name:literal $columns:literal, $function:ident $(<$($type:ident),+>)? ($options:ty);)+) => {
        $crate::operation::Group {
            title: $title,
            operations: &[$($crate::operation::Operation {
                name: $name,
                columns: $columns,
                options: <$options as clap::Args>::augment_args,
                start: |matches, scalar| {
                    let options = <$options as clap::FromArgMatches>::from_arg_matches(matches)?;
                    match scalar {
                        $crate::operation::Scalar::F64 => $function::<f64 $($(, $type<f64>)+)?>(options),
                        $crate::operation::Scalar::F32 => $function::<f32 $($(, $type<f32>)+)?>(options),
                    }
                },
            }),+],
        }
    };
}
use group;

/// Appends the answer to a line.
type Line = dyn Fn(&str, &mut String) -> Result<(), Failure>;

/// What answers a line.
pub struct Answer {
    columns: Count,
    line: Box<Line>,
}

impl Answer {
    /// Whether a blank line is one to answer.
    pub fn to_blank_lines(&self) -> bool {
        self.columns.allows_none()
    }

    /// Appends the answer to a line, and nothing where it fails.
    pub fn append(&self, line: &str, answers: &mut String) -> Result<(), Failure> {
        (self.line)(line, answers)
    }
}

/// Answers from what is read of the columns of a line.
fn answer<C: Read, R: Row>(operation: impl Fn(C) -> Result<R, Failure> + 'static) -> Result<Answer, Failure> {
    Ok(Answer {
        columns: C::COLUMNS,
        line: Box::new(move |line, answers| {
            let row = operation(Fields::read(line)?)?;
            Ok(row.write(&mut Columns::new(answers))?)
        }),
    })
}

/// The table of a group: names and columns of its operations.
impl fmt::Display for Group {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(f, "{}:", self.title)?;
        self.operations
            .iter()
            .try_for_each(|operation| writeln!(f, "  {:<20} {}", operation.name, operation.columns))
    }
}
