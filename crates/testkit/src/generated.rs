//! Files, and parts of files, that a test makes. They are compared; `UPDATE=1 cargo test` writes them instead.

use std::path::{Path, PathBuf};
use std::{env, fs};

/// A path of the project, from its root.
fn path(name: &str) -> PathBuf {
    Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../..")).join(name)
}

fn is_update() -> bool {
    env::var_os("UPDATE").is_some()
}

/// Asserts that a file is `text`.
pub fn file(name: &str, text: &str) {
    if is_update() {
        fs::write(path(name), text).unwrap();
    }
    let found = fs::read_to_string(path(name)).unwrap_or_default();
    assert!(
        found == text,
        "{name} is not what is generated: write it with `UPDATE=1 cargo test`"
    );
}

/// Asserts that `text` is in a file, where the first line is that starts as `start`. It ends where as many
/// paragraphs end as `text` has.
pub fn section(name: &str, start: &str, text: &str) {
    let file = fs::read_to_string(path(name)).unwrap();
    let from = match file.find(&format!("\n{start}")) {
        Some(before) => before + 1,
        None => panic!("{name} has no line that starts with {start}"),
    };
    let paragraphs = text.trim_end().split("\n\n").count();
    let here: usize = file[from..]
        .split_inclusive("\n\n")
        .take(paragraphs)
        .map(str::len)
        .sum();
    let to = from + file[from..from + here].trim_end().len();
    if is_update() {
        fs::write(path(name), [&file[..from], text.trim_end(), &file[to..]].concat()).unwrap();
        return;
    }
    assert!(
        file[from..to] == *text.trim_end(),
        "{name} is not what is generated: write it with `UPDATE=1 cargo test`\n{text}"
    );
}
