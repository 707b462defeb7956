//! The approach to the terrain, small: its pictures, its figures, and what it refuses.

#![allow(clippy::panic)] // a test may fail loudly

use testkit::program::{count, prints, refuses, text};

const TERRAIN: &str = env!("CARGO_BIN_EXE_terrain");

/// The number after some words.
fn number_after(said: &str, words: &str) -> f64 {
    let line = said.lines().find_map(|line| line.strip_prefix(words));
    let number = line.and_then(|rest| rest.split_whitespace().next()?.parse().ok());
    number.unwrap_or_else(|| panic!("no number after {words:?} in {said}"))
}

#[test]
fn single_precision_is_within_a_millimetre_nearby_and_a_millionth_beyond() {
    let out = concat!(env!("CARGO_TARGET_TMPDIR"), "/terrain");
    let said = prints(TERRAIN, &["--size", "64", "--out", out]);
    let near = number_after(&said, "within 1 km: at most ");
    let beyond = number_after(&said, "beyond: at most ");
    assert!(near > 0.0 && near <= 1.1, "{near} mm");
    assert!(beyond > 0.0 && beyond <= 1.0, "{beyond} millionths");
    for (kind, expected) in [
        ("single.jpg", 10),
        ("double.jpg", 10),
        ("rounding.png", 10),
        ("leaning.jpg", 4),
        ("lean.png", 4),
        ("naive.jpg", 2),
        ("naive-rounding.png", 2),
    ] {
        let others = if kind == "rounding.png" {
            count(out, "naive-rounding.png")
        } else {
            0
        };
        assert_eq!(count(out, &format!("-{kind}")) - others, expected, "{kind}");
    }
    let page = text(out, "index.html");
    assert_eq!(page.matches("<figure>").count(), 16);
    assert!(page.contains("</html>"));
}

#[test]
fn what_cannot_be_drawn_is_refused_in_one_line() {
    refuses(TERRAIN, &["--projection", "nowhere"]);
    refuses(TERRAIN, &["--shift", "3"]);
    refuses(TERRAIN, &["--size", "63"]);
    refuses(TERRAIN, &["--out", "/dev/null/terrain"]);
}
