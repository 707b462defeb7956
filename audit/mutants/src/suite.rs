//! The tests of the woven library, and what each reaches.

use std::collections::BTreeSet;
use std::ffi::OsStr;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

use cargo_metadata::Message;

use crate::Failure;
use crate::compile::cargo;

pub struct Test {
    program: PathBuf,
    tree: PathBuf,
    name: String,
    /// `program::name`.
    pub title: String,
}

impl Test {
    fn command(&self) -> Command {
        let mut command = Command::new(&self.program);
        command.current_dir(&self.tree).args(["--exact", &self.name]);
        // Functions are not optimised, and what they choose from takes stack.
        command
            .env("RUST_TEST_THREADS", "1")
            .env("RUST_MIN_STACK", "1000000000");
        command.stdout(Stdio::null()).stderr(Stdio::null());
        command
    }

    /// Whether the library as it is passes, how long it takes, and the places of mutants that are reached.
    pub fn reach(&self) -> Result<Option<(Duration, BTreeSet<usize>)>, Failure> {
        let start = Instant::now();
        if !self.command().status()?.success() {
            return Ok(None);
        }
        let time = start.elapsed();
        let reached = self.tree.join(format!("{}.reached", self.title));
        self.command().env("REACHED", &reached).status()?;
        let places = fs::read_to_string(reached)?
            .lines()
            .map(str::parse)
            .collect::<Result<_, _>>()?;
        Ok(Some((time, places)))
    }

    /// Whether it fails for a mutant, or does not end in time.
    pub fn catches(&self, mutant: usize, time: Duration) -> std::io::Result<bool> {
        let seconds = (10 * time + Duration::from_secs(5)).as_secs().to_string();
        let status = self
            .command()
            .env("MUTANT", mutant.to_string())
            .env("SECONDS", seconds)
            .status()?;
        Ok(!status.success())
    }
}

/// Compiles the tests, but those of documentation, and lists those that are not ignored.
pub fn compile(tree: &Path) -> Result<Vec<Test>, Failure> {
    let mut cargo = cargo(tree);
    cargo.env("CARGO_PROFILE_DEV_DEBUG", "0");
    compile_by(cargo, tree, BTreeSet::new())
}

/// Compiles tests of these programs, or of all.
pub fn compile_by(mut cargo: Command, tree: &Path, programs: BTreeSet<&str>) -> Result<Vec<Test>, Failure> {
    let which: Vec<&str> = if programs.is_empty() {
        vec!["--tests"]
    } else {
        programs.into_iter().flat_map(|program| ["--test", program]).collect()
    };
    let said = cargo
        .args(["test", "--no-run", "--message-format", "json"])
        .args(which)
        .stderr(Stdio::inherit())
        .output()?;
    let mut tests = Vec::new();
    for message in Message::parse_stream(&*said.stdout) {
        if let Message::CompilerArtifact(artifact) = message?
            && artifact.profile.test
            && let Some(program) = artifact.executable
        {
            for name in list(&program, &[])?.difference(&list(&program, &["--ignored"])?) {
                let title = format!("{}::{name}", artifact.target.name);
                tests.push(Test {
                    program: program.clone().into(),
                    tree: tree.into(),
                    name: name.clone(),
                    title,
                });
            }
        }
    }
    Ok(tests)
}

fn list(program: impl AsRef<OsStr>, only: &[&str]) -> std::io::Result<BTreeSet<String>> {
    let said = Command::new(program)
        .args(["--list", "--format", "terse"])
        .args(only)
        .output()?;
    let lines = String::from_utf8_lossy(&said.stdout);
    Ok(lines
        .lines()
        .filter_map(|line| line.strip_suffix(": test"))
        .map(str::to_owned)
        .collect())
}
