//! The atlas, small, and what it refuses.

use terrella::cube::Projection;
use testkit::program::{count, prints, refuses, text};

const ATLAS: &str = env!("CARGO_BIN_EXE_atlas");

#[test]
fn every_projection_has_its_pictures() {
    let out = concat!(env!("CARGO_TARGET_TMPDIR"), "/atlas");
    prints(ATLAS, &["--size", "64", "--out", out]);
    for kind in [
        "cube.jpg", "globe.jpg", "ellipses.svg", "aspect.jpg", "sides.jpg", "area.jpg", "deformation.jpg",
    ] {
        assert_eq!(count(out, &format!("-{kind}")), Projection::ALL.len(), "{kind}");
    }
    let page = text(out, "index.html");
    assert_eq!(page.matches("class=\"chart\"").count(), 2);
    // A row in the ranking for each projection, with every rank and figure.
    let (_, ranking) = page.split_once("<table class=\"ranks\">").unwrap_or_default();
    let (ranking, _) = ranking.split_once("</table>").unwrap_or_default();
    assert_eq!(ranking.matches("<tr><th scope=\"row\">").count(), Projection::ALL.len());
    assert_eq!(ranking.matches("<small>").count(), Projection::ALL.len() * 20);
    assert!(!ranking.contains("NaN") && !ranking.contains("inf"));
    assert!(page.contains("</html>"));
}

#[test]
fn what_cannot_be_drawn_is_refused_in_one_line() {
    refuses(ATLAS, &["--projection", "nowhere"]);
    refuses(ATLAS, &["--input", "no-such-file.jpg"]);
    refuses(ATLAS, &["--out", "/dev/null/atlas"]);
    refuses(ATLAS, &["--ellipsoid", "1,2"]);
}
