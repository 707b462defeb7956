//! Running a program as a script would run it, and what it leaves behind.

use std::fs;
use std::path::Path;
use std::process::{Command, Output};

fn run(program: &str, arguments: &[&str]) -> Output {
    Command::new(program)
        .args(arguments)
        .output()
        .unwrap_or_else(|why| panic!("{program}: {why}"))
}

/// What a program prints that is to succeed.
pub fn prints(program: &str, arguments: &[&str]) -> String {
    let ran = run(program, arguments);
    let complaint = String::from_utf8_lossy(&ran.stderr);
    assert!(ran.status.success(), "{program} {arguments:?}: {complaint}");
    String::from_utf8(ran.stdout).unwrap_or_else(|why| panic!("{program}: {why}"))
}

/// Asserts that a program refuses its arguments, in one line.
pub fn refuses(program: &str, arguments: &[&str]) {
    let ran = run(program, arguments);
    let complaint = String::from_utf8_lossy(&ran.stderr);
    assert!(!ran.status.success(), "{program} {arguments:?} was not refused");
    assert!(complaint.lines().count() == 1, "{program} {arguments:?}: {complaint}");
}

/// How many files of a folder end like this.
pub fn count(folder: &str, end: &str) -> usize {
    let files = fs::read_dir(folder).unwrap_or_else(|why| panic!("{folder}: {why}"));
    files
        .filter_map(|file| file.ok()?.file_name().into_string().ok())
        .filter(|name| name.ends_with(end))
        .count()
}

/// A file of a folder.
pub fn text(folder: &str, name: &str) -> String {
    let path = Path::new(folder).join(name);
    fs::read_to_string(&path).unwrap_or_else(|why| panic!("{}: {why}", path.display()))
}
