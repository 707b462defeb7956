//! Whether a NaN among a function's results is noticed: planted in every function that gives numbers, in `f64` and in `f32`, first in one result
//! of 128, and where no test fails, in one of 8, and in all.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use crate::plant::{self, Function, STEP};
use crate::survival::{self, Fate};
use crate::{Failure, add_modules, suite};

const SCALARS: [&str; 2] = ["f64", "f32"];
const PARTS: [&str; 3] = ["1 in 128", "1 in 8", "all"];

/// `names` are what names of the tests to ask begin with, the program's first: `accuracy`, `geodesic::karney`. All, if there is none.
pub fn run(tree: &Path, report: &str, names: &[String]) -> Result<(), Failure> {
    let functions = plant(tree)?;
    // As the tests are compiled otherwise, so that what they depend on is.
    let mut cargo = Command::new("cargo");
    cargo.current_dir(tree);
    let programs: BTreeSet<&str> = names.iter().filter_map(|name| name.split("::").next()).collect();
    let mut tests = suite::compile_by(cargo, tree, programs)?;
    let asked = |title: &str, name: &String| title.starts_with(name.as_str());
    tests.retain(|test| names.is_empty() || names.iter().any(|name| asked(&test.title, name)));
    let known = survival::known(&tests)?;

    // The number of a NaN is its own place: whether it is reached depends on the scalar.
    let mut fates: BTreeMap<usize, (usize, Fate)> = BTreeMap::new();
    let mut left: Vec<usize> = (0..functions.len())
        .flat_map(|function| (0..SCALARS.len()).map(move |scalar| STEP * function + scalar))
        .collect();
    for part in 0..PARTS.len() {
        let places = left.iter().map(|first| (first + 2 * part, first + 2 * part)).collect();
        for (number, fate) in survival::of_each(&places, &known)? {
            fates.insert(number - 2 * part, (part, fate));
        }
        left.retain(|first| matches!(fates[first].1, Fate::Survived));
    }

    let mut rows = String::new();
    let mut counts = BTreeMap::new();
    for (first, (part, fate)) in &fates {
        let Function { name, is_public } = &functions[first / STEP];
        let (scalar, part) = (SCALARS[first % 2], PARTS[*part]);
        let public = if *is_public { "public" } else { "private" };
        rows += &format!("{public}\t{scalar}\t{part}\t{fate}\t{name}\n");
        let kind = match fate {
            Fate::Caught(_) => format!("noticed, {part}"),
            Fate::NotReached => "no number, or reached by no test".into(),
            _ => "not noticed".into(),
        };
        if matches!(fate, Fate::Survived) {
            println!("NOT NOTICED: {scalar} {public} {name}");
        }
        *counts.entry((*is_public, kind)).or_insert(0) += 1;
    }
    fs::write(report, rows)?;
    for ((is_public, kind), count) in counts {
        println!("{count:6} {} {kind}", if is_public { "public " } else { "private" });
    }
    Ok(())
}

/// Plants in every source of the tree.
fn plant(tree: &Path) -> Result<Vec<Function>, Failure> {
    let mut functions = Vec::new();
    for path in sources(&tree.join("src"))? {
        let file = path.strip_prefix(tree)?.to_string_lossy().into_owned();
        let planted = plant::plant(&file, &fs::read_to_string(&path)?, &mut functions)
            .map_err(|error| format!("{file}: {error}"))?;
        fs::write(&path, planted)?;
    }
    add_modules(tree, STEP * functions.len(), &[("planted", include_str!("planted.rs"))])?;
    Ok(functions)
}

fn sources(folder: &Path) -> std::io::Result<Vec<PathBuf>> {
    let mut all = Vec::new();
    for entry in fs::read_dir(folder)? {
        let path = entry?.path();
        if path.is_dir() {
            all.extend(sources(&path)?);
        } else if path.extension().is_some_and(|name| name == "rs") {
            all.push(path);
        }
    }
    all.sort();
    Ok(all)
}
