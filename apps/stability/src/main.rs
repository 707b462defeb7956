//! Where the methods of distance hold and where they do not: error against distance, maps about the antipode, the way back
//! from Earth-centred coordinates, and a comparison with other crates.
//!
//! `cargo run --release -p stability` writes `target/stability/index.html`; `-- --help` says what else it can do.

// Cells, bins and scalars are addressed by index; the bounds come from the loops around them.
#![allow(clippy::indexing_slicing)]

mod antipode;
mod cli;
mod comparison;
mod distance;
mod page;
mod pair;
mod reference;
mod scale;
mod section;
mod solver;

use std::fs;
use std::io::{self, Write};
use std::path::Path;
use std::process::ExitCode;

use draw::outcome::{self, cannot};
use draw::raster::{self, Fonts};
use draw::svg::{self, Svg};

use cli::Options;
use page::Picture;
use pair::Truth;

fn main() -> ExitCode {
    outcome::run(cli::parse(), |options| pictures(&options))
}

/// Makes the pictures and the page; returns the comparison and where the page is.
fn pictures(options: &Options) -> Result<String, String> {
    let out = options.out.as_path();
    fs::create_dir_all(out).map_err(|error| cannot("create the folder", out, &error))?;
    let fonts = Fonts::find();
    if fonts.is_empty() {
        let _ = writeln!(
            io::stderr(),
            "no font on this machine: the PNG files are without text, the SVG files are whole"
        );
    }
    let truth = Truth::earth();
    let ours = solver::ours().map_err(|error| error.to_string())?;
    let theirs = solver::theirs();
    let side = options.side();
    let drawn = [
        (&page::DISTANCE, distance::draw(&ours, &truth, options.pairs_per_bin())),
        (&page::ANTIPODE, antipode::errors(&ours, &truth, side)?),
        (&page::STEPS, antipode::steps(side)?),
        (&page::SECTION, section::draw(side)?),
    ];
    for (picture, svg) in &drawn {
        save(picture, svg, out, &fonts)?;
    }
    let rows = comparison::compare(&ours, &theirs, &truth, options.pairs());
    let index = out.join("index.html");
    let page = page::html(&drawn.map(|(picture, _)| picture), &rows, options.pairs());
    fs::write(&index, page).map_err(|error| cannot("write", &index, &error))?;
    Ok(format!(
        "{}\n\n{}\nwrote {}",
        comparison::caption(options.pairs()),
        comparison::markdown(&rows),
        index.display()
    ))
}

/// Writes a picture as SVG and as PNG.
fn save(picture: &Picture, svg: &Svg, out: &Path, fonts: &Fonts) -> Result<(), String> {
    let document = svg.document(picture.title, &svg::NIGHT);
    let [svg_file, png_file] = ["svg", "png"].map(|kind| out.join(format!("{}.{kind}", picture.file)));
    fs::write(&svg_file, &document).map_err(|error| cannot("write", &svg_file, &error))?;
    let png = raster::png(&document, fonts).map_err(|error| format!("cannot draw {}: {error}", png_file.display()))?;
    fs::write(&png_file, png).map_err(|error| cannot("write", &png_file, &error))
}
