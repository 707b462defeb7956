//! Speed and largest error of other libraries, on the points and truth data that terrella's own `frontier` uses.
//!
//! `peers [--runs N] [--quick] [--only TEXT] [--add] [--csv FILE]`: N runs in processes of their own, joined; written to FILE,
//! `peers.csv` beside this crate's manifest unless told. With `--only`, records whose key has the text; others that the file
//! has stay. With `--quick`, one pass is timed: errors are right, times are not. With `--add`, the file's records are joined as one more run.
//! `peers --table [--csv FILE]` prints the file as the tables of `README.md`.

use std::path::PathBuf;
use std::process::Command;

mod bench;
mod distance;
mod pass;
mod position;
mod projection;
mod shim;
mod table;
mod truth;

use bench::{Bench, Task};
use pass::Set;
use shim::Shim;
use timing::record;
use truth::Exact;

/// The unit of angles that a library takes and gives. What is not timed converts.
#[derive(Clone, Copy, PartialEq)]
pub enum Unit {
    /// As the truth files.
    Degrees,
    /// Truth inputs are rounded to radians.
    Radians,
}

impl Unit {
    /// A set in degrees in this unit: the columns named.
    pub fn of(self, set: Set, columns: &[usize]) -> Set {
        match self {
            Self::Degrees => set,
            Self::Radians => columns
                .iter()
                .fold(set, |set, &column| set.map(column, f64::to_radians)),
        }
    }

    /// A result in degrees, without rounding.
    pub fn degrees(self, value: f64) -> Exact {
        match self {
            Self::Degrees => value.into(),
            Self::Radians => Exact::degrees(value),
        }
    }
}

/// Runs a pass of a shim that calls the library once per point.
pub fn one_by_one(bench: &mut Bench, task: &Task, shim: &Shim, method: &str, pass: &str) {
    bench.run(task, &shim.library, method, "one by one", &shim.pass(pass));
}

/// Name and version of a crate, as locked.
pub fn crate_version(name: &str) -> String {
    let lock = include_str!("../Cargo.lock");
    let entry = lock
        .split("[[package]]")
        .find(|entry| entry.contains(&format!("\nname = \"{name}\"\n")));
    let version = entry.and_then(|entry| entry.split("version = \"").nth(1)?.split('"').next());
    format!("{name} {}", version.expect("a locked dependency"))
}

fn main() -> std::io::Result<()> {
    let mut arguments = std::env::args().skip(1);
    let (mut runs, mut only) = (1, String::new());
    let (mut add, mut one_run, mut table, mut quick) = (false, false, false, false);
    let mut csv = PathBuf::from(concat!(env!("CARGO_MANIFEST_DIR"), "/peers.csv"));
    while let Some(argument) = arguments.next() {
        let mut value = || arguments.next().unwrap_or_else(|| panic!("{argument} wants a value"));
        match argument.as_str() {
            "--runs" => runs = value().parse().expect("a number of runs"),
            "--only" => only = value(),
            "--csv" => csv = value().into(),
            "--one-run" => one_run = true,
            "--add" => add = true,
            "--quick" => quick = true,
            "--table" => table = true,
            _ => panic!("unknown: {argument}"),
        }
    }
    if table {
        return record::read(&csv).map(|records| table::print(&records));
    }
    if one_run {
        let mut bench = Bench {
            only,
            repetitions: if quick { 1 } else { timing::REPETITIONS },
            records: Vec::new(),
        };
        projection::run(&mut bench);
        position::run(&mut bench);
        distance::run(&mut bench);
        return record::append(&csv, &bench.records);
    }
    let fresh = csv.with_extension("runs.csv");
    for run in 1..=runs {
        eprintln!("run {run} of {runs}");
        let mut child = Command::new(std::env::current_exe()?);
        let status = child
            .args(["--one-run", "--only", &only, "--csv"])
            .arg(&fresh)
            .args(quick.then_some("--quick"))
            .status()?;
        assert!(status.success(), "run {run}: {status}");
    }
    let mut records = record::read(&fresh)?;
    if csv.exists() {
        let stays = |old: &record::Record| add || !old.key().join(",").contains(&only);
        records.extend(record::read(&csv)?.into_iter().filter(stays));
    }
    let mut records = record::merge(&records);
    records.sort_by(|a, b| a.key().cmp(&b.key()));
    std::fs::remove_file(&fresh)?;
    if csv.exists() {
        std::fs::remove_file(&csv)?;
    }
    record::append(&csv, &records)
}
