//! The command line: names, options, help.

use terrella::cube::Projection;
use terrella::{Latitude, NAMED, Shift};

use crate::run::{answers, complaint, run};

#[test]
fn unknown_names_are_answered_with_the_known() {
    let listed = |arguments: &str, names: &[&str]| {
        let complaint = complaint(arguments);
        for name in names {
            assert!(complaint.contains(name), "{arguments}: {complaint} lacks {name}");
        }
    };
    let projections: Vec<_> = Projection::ALL.iter().map(|p| p.name()).collect();
    let shifts: Vec<_> = Shift::ALL.iter().map(|s| s.name()).collect();
    let latitudes: Vec<_> = Latitude::ALL.iter().map(|l| l.name()).collect();
    for operation in ["forward", "inverse", "project", "unproject"] {
        listed(&format!("{operation} --projection mercator"), &projections);
    }
    listed("project --projection square --shift isometric", &shifts);
    listed("latitude --from isometric --to astronomical", &latitudes);
    listed("latitude --from astronomical --to isometric", &latitudes);
    listed("project --projection square --ellipsoid flat", NAMED);
    listed("forward --projection square --scalar f16", &["f64", "f32"]);
    listed("backward", &["forward", "inverse", "project", "unproject", "latitude"]);
}

#[test]
fn wrong_command_lines_are_refused() {
    for (arguments, why) in [
        ("forward", "--projection"),
        ("forward --projection", "tangential"),
        ("forward --projection square --shift authalic", "--shift"),
        ("latitude --from geodetic", "--to"),
        ("forward --projection square --front 0,0", "expected 3 numbers"),
        ("forward --projection square --front 91,0,0", "latitude 91.0"),
        ("forward --projection square --top 0,0,inf", "departs from one by NaN"),
        ("forward --projection square --front 0,0,0 --top 0,0,0", "--top"),
        ("forward --projection square --stretch 17", "got 17.0"),
        ("project --projection square --ellipsoid 1,2", "flattening 2"),
        ("project --projection square --ellipsoid 1,1/0", "flattening inf"),
        ("project --projection square --ellipsoid 0,0", "semi-major axis 0"),
        ("project --projection square --ellipsoid 1,1/x", "\"x\" is not a number"),
        (
            "project --projection square --ellipsoid 1,2,3",
            "\"2,3\" is not a number",
        ),
        ("project --projection square --ellipsoid 1,0.5", "flattening 0.5"),
        (
            "project --projection square --ellipsoid 1e300,0 --scalar f32",
            "semi-major axis 1e300",
        ),
    ] {
        let complaint = complaint(arguments);
        assert!(complaint.contains(why), "{arguments}: {complaint} lacks {why}");
    }
    assert_eq!(run("", "").code, 2);
}

#[test]
fn help_lists_what_there_is() {
    let general = answers("--help", "");
    for word in [
        "forward", "inverse", "project", "unproject", "latitude", "geodesic-inverse", "geodesic-direct", "to-ecef",
        "from-ecef", "to-enu", "from-enu", "f64, f32", "error: why",
    ] {
        assert!(general.contains(word), "{word}");
    }
    let project = answers("project --help", "");
    let projections = Projection::ALL.iter().map(|p| p.name());
    for name in projections
        .chain(Shift::ALL.iter().map(|s| s.name()))
        .chain(NAMED.iter().copied())
    {
        assert!(project.contains(name), "{name}");
    }
}

#[test]
fn ellipsoids_are_named_or_spelled_out() {
    let positions = "59.91 10.75\n-33.3 200\n";
    for scalar in ["f64", "f32"] {
        let on = |ellipsoid: &str| {
            answers(
                &format!("project --projection conformal --scalar {scalar} {ellipsoid}"),
                positions,
            )
        };
        let wgs84 = on("");
        assert_eq!(wgs84, on("--ellipsoid wgs84"));
        assert_eq!(wgs84, on("--ellipsoid 6378137,1/298.257223563"));
        assert_eq!(
            wgs84,
            on("--shift authalic --ellipsoid=6378137.0,0.0033528106647474805")
        );
        assert_ne!(wgs84, on("--ellipsoid mars"));
        assert_ne!(wgs84, on("--shift conformal"));
        let sphere = on("--ellipsoid 1737400,0");
        assert_eq!(sphere, on("--ellipsoid moon"));
        assert_eq!(sphere, on("--ellipsoid wgs84 --shift geodetic"));
    }
    // A fraction is divided in f64, then rounded: 1/3 in f32 is 0.33333334.
    let third = |f: &str| {
        answers(
            &format!("latitude --from geodetic --to parametric --scalar f32 --ellipsoid 1,{f}"),
            positions.split_whitespace().next().unwrap(),
        )
    };
    assert_eq!(third("1/3"), third("0.33333334"));
}
