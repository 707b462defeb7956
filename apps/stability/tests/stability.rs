//! The pictures of stability, small, and what is refused.

use testkit::program::{count, prints, refuses, text};

const STABILITY: &str = env!("CARGO_BIN_EXE_stability");

#[test]
fn there_are_four_pictures_and_a_page() {
    let out = concat!(env!("CARGO_TARGET_TMPDIR"), "/stability");
    let said = prints(STABILITY, &["--samples", "10", "--out", out]);
    assert!(said.contains("| terrella, Karney | f64 |"), "{said}");
    assert_eq!([count(out, ".svg"), count(out, ".png")], [4, 4]);
    assert!(text(out, "index.html").contains("</html>"));
}

#[test]
fn what_cannot_be_drawn_is_refused_in_one_line() {
    refuses(STABILITY, &["--samples", "3"]);
    refuses(STABILITY, &["--out", "/dev/null/stability"]);
}
