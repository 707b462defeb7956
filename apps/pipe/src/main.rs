//! The library in a pipe, for scripts, comparisons and whoever checks numbers: one line of columns in, one line out.
//!
//! ```console
//! $ printf '59.91 10.75\n# Quito\n-0.22 281.49\n91 0\n' | target/release/pipe project --projection equi-edge
//! 4    0.12448388308534873    -0.6243060621680013
//! 3    0.23194306900631995    -0.004481450598314789
//! error: latitude 91.0 is not in [-90, 90] degrees
//! ```
//!
//! `--help` lists the operations, `OPERATION --help` says which columns go in and come out.
//!
//! `operation/` has a file for each group of operations: a table of their names and columns, and under it their
//! functions. A new operation is a row and a function there. `read.rs` has what can stand in the columns of a line,
//! `write.rs` what can be written to them, `options.rs` the options.

mod command;
mod cube;
mod lines;
mod operation;
mod options;
mod read;
mod write;

use std::process::ExitCode;

fn main() -> ExitCode {
    match command::ask() {
        Ok(answer) => lines::for_each_line(&answer),
        Err(code) => code,
    }
}
