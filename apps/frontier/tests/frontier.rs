//! The charts of speed and error, small: every error is within its claim, or the program fails. Times are not looked at.

use testkit::program::{count, prints, refuses, text};

const FRONTIER: &str = env!("CARGO_BIN_EXE_frontier");

#[test]
fn errors_are_as_claimed_and_everything_is_drawn() {
    let out = concat!(env!("CARGO_TARGET_TMPDIR"), "/frontier");
    prints(FRONTIER, &["--quick", "--out", out]);
    for chart in ["distances", "projections", "positions", "scene"] {
        assert!(text(out, &format!("{chart}.svg")).contains("</svg>"), "{chart}");
        assert_eq!(count(out, &format!("{chart}.png")), 1, "{chart}");
    }
    let records = text(out, "frontier.csv");
    for kind in [
        "distance,inverse,terrella,karney,f32,batch",
        "projection,quadrilateralized forward,terrella",
        "position,ecef to geodetic,terrella",
    ] {
        let has = |line: &str| line.starts_with(kind);
        assert!(records.lines().any(has), "no record of {kind}");
    }
}

#[test]
fn what_cannot_be_drawn_is_refused_in_one_line() {
    refuses(FRONTIER, &["--draw", "--out", "/dev/null/frontier"]);
}
