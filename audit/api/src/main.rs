//! Prints the public API that a rustdoc JSON file describes, an item a line: `api FILE`.

use std::collections::HashSet;
use std::error::Error;
use std::path::PathBuf;

fn main() -> Result<(), Box<dyn Error>> {
    let file: PathBuf = std::env::args_os().nth(1).ok_or("usage: api FILE")?.into();
    // Left out is what every type has: blanket implementations and auto traits.
    let api = public_api::Builder::from_rustdoc_json(file)
        .omit_blanket_impls(true)
        .omit_auto_trait_impls(true)
        .build()?;
    let of_a_trait = |line: &str| line.starts_with("impl") && line.contains(" for ");
    let implementations: HashSet<_> = api
        .items()
        .filter(|item| of_a_trait(&item.to_string()))
        .map(|item| item.id())
        .collect();
    for item in api.items() {
        let line = item.to_string();
        // The functions of an implementation are those of its trait.
        let implied = line.starts_with("pub fn ") && item.parent_id().is_some_and(|id| implementations.contains(&id));
        // The compiler's own trait, of each type with a derived PartialEq.
        let internal = line.contains("StructuralPartialEq for ");
        if !(implied || internal) {
            // What it asks of private fields is no concern of callers.
            let (line, _) = line
                .split_once(" where ")
                .filter(|_| line.contains("defmt::"))
                .unwrap_or((&line, ""));
            println!("{}", shortened(line));
        }
    }
    Ok(())
}

/// The line with `nalgebra::Vector3` for `nalgebra::base::alias::Vector3`: where another crate keeps an item
/// may change with its version, and with the machine.
fn shortened(line: &str) -> String {
    let in_path = |c: char| c.is_alphanumeric() || c == '_' || c == ':';
    let mut short = String::new();
    let mut rest = line;
    while let Some(start) = rest.find(in_path) {
        let (before, path) = rest.split_at(start);
        let (path, after) = path.split_at(path.find(|c| !in_path(c)).unwrap_or(path.len()));
        short.push_str(before);
        let ours = ["core::", "terrella::"].iter().any(|ours| path.starts_with(ours));
        match (path.split_once("::"), path.rsplit_once("::")) {
            (Some((first, _)), Some((_, last))) if !ours && !first.is_empty() && !last.is_empty() => {
                short.push_str(&format!("{first}::{last}"));
            }
            _ => short.push_str(path),
        }
        rest = after;
    }
    short + rest
}
