//! Speed and largest error of everything that terrella computes, one by one and in batch, on charts with its rivals.
//!
//! `taskset -c 1 cargo run --release -p frontier`; see `README.md`.

// What measures may stop at what cannot be; columns are addressed by index, the bounds come from the loops around them.
#![allow(
    clippy::expect_used, clippy::panic, clippy::unwrap_used, clippy::indexing_slicing, missing_docs
)]

mod bars;
mod bench;
mod chart;
mod charts;
mod claims;
mod cli;
mod distance;
mod position;
mod projection;
mod scene;
mod set;
mod table;
mod truth;

use std::path::Path;
use std::process::ExitCode;
use std::{fs, io};

use draw::outcome;
use draw::raster::{self, Fonts};
use timing::points;
use timing::record::{self, Record};

use bars::Bars;
use bench::Bench;
use cli::Options;

fn main() -> ExitCode {
    outcome::run(cli::parse(), |options| run(&options))
}

/// Measures and draws; returns the table of bars and where the files are.
fn run(options: &Options) -> Result<String, String> {
    let out = options.out.as_path();
    fs::create_dir_all(out).map_err(|error| cannot(out, &error))?;
    let ours = measured(options)?;
    let (theirs, now) = rivals(options)?;
    let bars = Bars {
        ours: &ours,
        theirs: &theirs,
    };
    let table = table::markdown(&bars.all(), &|record| {
        now.iter().any(|other| other.key() == record.key())
    });
    write(&out.join("bars.md"), table.as_bytes())?;

    let records: Vec<Record> = ours.iter().chain(&theirs).cloned().collect();
    let fonts = Fonts::find();
    if fonts.is_empty() {
        eprintln!("no font on this machine: the PNG files are without text, the SVG files are whole");
    }
    let mut documents: Vec<(&str, String)> = charts::all(&records)
        .iter()
        .map(|chart| {
            let svg = chart::draw(chart.title, &options.caption, &chart.panels, chart.height);
            (chart.file, svg.document(chart.title, &chart::DAY))
        })
        .collect();
    documents.push(("scene", scene::document(&scene::draw(&records, &options.caption)?)));
    for (file, document) in documents {
        let png = raster::png(&document, &fonts)?;
        write(&out.join(format!("{file}.svg")), document.as_bytes())?;
        write(&out.join(format!("{file}.png")), &png)?;
    }
    let broken = claims::broken(&ours);
    if broken.is_empty() {
        Ok(format!("{table}\nwrote {}", out.display()))
    } else {
        Err(broken.join("; "))
    }
}

/// Terrella's records: those measured now, and those that the folder has and that stay.
fn measured(options: &Options) -> Result<Vec<Record>, String> {
    let file = options.out.join("frontier.csv");
    let mut bench = Bench {
        points: if options.quick { 4096 } else { points::N },
        repetitions: if options.quick { 2 } else { timing::REPETITIONS },
        only: options.only.clone(),
        records: Vec::new(),
    };
    if !options.draw {
        distance::run::<f64>(&mut bench);
        distance::run::<f32>(&mut bench);
        position::run::<f64>(&mut bench);
        position::run::<f32>(&mut bench);
        projection::run::<f64>(&mut bench);
        projection::run::<f32>(&mut bench);
        scene::run::<f64>(&mut bench);
        scene::run::<f32>(&mut bench);
        eprintln!();
    }
    let mut records = bench.records;
    if file.exists() {
        let stays = |old: &Record| options.draw || options.add || !old.key().join(",").contains(&options.only);
        let old = record::read(&file).map_err(|error| cannot(&file, &error))?;
        records.extend(old.into_iter().filter(stays));
    }
    let mut records = record::merge(&records);
    records.sort_by(|a, b| a.key().cmp(&b.key()));
    // Emptied first: records are appended.
    write(&file, b"")?;
    record::append(&file, &records).map_err(|error| cannot(&file, &error))?;
    Ok(records)
}

/// The rivals' records, and those among them that were measured just now.
fn rivals(options: &Options) -> Result<(Vec<Record>, Vec<Record>), String> {
    let read = |file: &Path| record::read(file).map_err(|error| cannot(file, &error));
    let kept = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../benches/peers/peers.csv");
    let kept = if kept.exists() { read(&kept)? } else { Vec::new() };
    let now = options.peers.as_deref().map_or(Ok(Vec::new()), read)?;
    let replaced = |old: &Record| now.iter().any(|new| new.key() == old.key());
    let mut records: Vec<Record> = kept.into_iter().filter(|old| !replaced(old)).collect();
    records.extend(now.iter().cloned());
    Ok((records, now))
}

fn write(file: &Path, bytes: &[u8]) -> Result<(), String> {
    fs::write(file, bytes).map_err(|error| cannot(file, &error))
}

fn cannot(what: &Path, error: &io::Error) -> String {
    format!("{}: {error}", what.display())
}
