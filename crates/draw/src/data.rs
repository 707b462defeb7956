//! Where the data is that the programs draw, and where they write.

use std::path::{Path, PathBuf};

/// A file of `crates/draw/data`.
pub fn file(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("data").join(name)
}

/// The folder `target/NAME` of the repository.
pub fn target(name: &str) -> PathBuf {
    let here = Path::new(env!("CARGO_MANIFEST_DIR"));
    here.ancestors().nth(2).unwrap_or(here).join("target").join(name)
}
