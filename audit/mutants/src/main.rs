//! Every mutant that `cargo mutants` lists, woven into one program and chosen by a variable of the environment: a mutant costs the tests
//! that reach it, until one fails, and no compilation.

mod compile;
mod mutant;
mod nan;
mod plant;
mod suite;
mod survival;
mod weave;

use std::collections::{BTreeMap, BTreeSet};
use std::error::Error;
use std::path::Path;
use std::{env, fs};

use mutant::Mutant;
use survival::Fate;

pub type Failure = Box<dyn Error + Send + Sync>;

fn main() -> Result<(), Failure> {
    let arguments: Vec<String> = env::args().skip(1).collect();
    match arguments.as_slice() {
        [nan, tree, report, programs @ ..] if nan == "nan" => nan::run(Path::new(tree), report, programs),
        [list, tree, report] => mutants(list, Path::new(tree), report),
        _ => Err("usage: mutants LIST.json TREE REPORT.tsv | mutants nan TREE REPORT.tsv [TESTS]…".into()),
    }
}

fn mutants(list: &str, tree: &Path, report: &str) -> Result<(), Failure> {
    let mutants: Vec<Mutant> = serde_json::from_str(&fs::read_to_string(list)?)?;

    let (places, refused) = weave(&mutants, tree)?;
    let mut fates = {
        let tests = suite::compile(tree)?;
        survival::of_each(&places, &survival::known(&tests)?)?
    };
    for number in 0..mutants.len() {
        let unwoven = if refused.contains(&number) {
            Fate::NotCompiled
        } else {
            Fate::NotWoven
        };
        fates.entry(number).or_insert(unwoven);
    }

    let mut counts = BTreeMap::new();
    let mut rows = String::new();
    for (number, fate) in &fates {
        let name = &mutants[*number].name;
        rows += &format!("{fate}\t{name}\n");
        *counts.entry(fate.kind()).or_insert(0) += 1;
        if let Fate::Survived | Fate::NotReached = fate {
            println!("{fate}: {name}");
        }
    }
    fs::write(report, rows)?;
    for (kind, count) in counts {
        println!("{count:6} {kind}");
    }
    Ok(())
}

/// Weaves into the tree what compiles: for each mutant the place where it is chosen, by the first mutant that is chosen there; and what
/// does not compile.
fn weave(mutants: &[Mutant], tree: &Path) -> Result<(BTreeMap<usize, usize>, BTreeSet<usize>), Failure> {
    let mut sources = BTreeMap::new();
    for mutant in mutants {
        sources.insert(&mutant.file, fs::read_to_string(tree.join(&mutant.file))?);
    }
    add_modules(tree, mutants.len(), &[])?;

    let mut refused = BTreeSet::new();
    loop {
        let mut places = BTreeMap::new();
        for (file, source) in &sources {
            let here = mutants
                .iter()
                .enumerate()
                .filter(|(number, mutant)| mutant.file == **file && !refused.contains(number));
            fs::write(tree.join(file), weave::weave(source, here, &mut places)?)?;
        }
        let more = compile::refused(tree)?;
        if more.is_empty() {
            return Ok((places, refused));
        }
        refused.extend(more);
    }
}

/// Adds to the library what chooses between so many mutants, and other modules.
fn add_modules(tree: &Path, mutants: usize, others: &[(&str, &str)]) -> Result<(), Failure> {
    let chosen = include_str!("chosen.rs").replace("MUTANTS: usize = 0", &format!("MUTANTS: usize = {mutants}"));
    let root = tree.join("src/lib.rs");
    let mut library = fs::read_to_string(&root)?;
    for (name, text) in others.iter().chain([&("chosen", &*chosen)]) {
        library += &format!("\npub mod {name};\n");
        fs::write(tree.join(format!("src/{name}.rs")), text)?;
    }
    fs::write(root, library)?;
    Ok(())
}
