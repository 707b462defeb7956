//! The tool, run as a script would run it.
#![allow(
    missing_docs, clippy::unwrap_used, clippy::expect_used, clippy::panic, clippy::indexing_slicing
)] // tests

mod command_line;
mod cube;
mod earth;
mod lines;
mod refusals;
mod run;
mod values;
