//! What operations refuse, each line in place, in one line; and that nothing at all ends a run.

use crate::run::{complaint, in_place, run};
use crate::values::cases;

#[test]
fn numbers_of_columns() {
    in_place(
        "solve",
        "1 2 3 4",
        &[
            (b"1 2 3", "fields: 4 expected, 3 found"),
            (b"1 2 3 4 5", "fields: 4 expected, 5 found"),
        ],
    );
    in_place(
        "polygon",
        "1 2 3 4 5 6",
        &[(b"1 2 3", "fields: 0, 2, 4, … expected, 3 found")],
    );
    in_place(
        "polygon-edges",
        "0 0 90 1",
        &[(b"1 2 3", "fields: 2, 4, 6, … expected, 3 found")],
    );
    in_place("cell-parent", "14", &[(b"14 0 0", "fields: 1 to 2 expected, 3 found")]);
    in_place("radii", "mars", &[(b"mars moon", "fields: 0 to 1 expected, 2 found")]);
}

#[test]
fn places_and_vectors() {
    let latitude = "latitude 91.0 is not in [-90, 90] degrees";
    for (command, right) in [
        ("solve", "1 2 3 4"),
        ("line", "1 2 3 4"),
        ("line-between", "1 2 3 4 0.5"),
        ("line-toward", "1 2 3 4 5"),
        ("gnomonic", "1 2 3 4"),
        ("polygon", "1 2 3 4"),
        ("polygon-edges", "1 2 3 4"),
        ("polyline", "1 2 3 4"),
        ("contains", "1 2 3 4"),
        ("gc-mid", "1 2 3 4"),
        ("gc-frac", "1 2 3 4 0.5"),
        ("intersect", "1 2 30 4 5 60"),
        ("intersect-segments", "1 2 3 4 5 6 7 8"),
        ("direction", "1 2"),
        ("up", "1 2"),
        ("geodetic-to-ned", "1 2 3 4 5 6"),
        ("aer-to-geodetic", "1 2 3 4 5 6"),
        ("vector-to-enu", "1 2 3 4 5"),
    ] {
        let wrong = right.replacen('1', "91", 1);
        in_place(command, right, &[(wrong.as_bytes(), latitude)]);
        let wrong = right.replacen('1', "nan", 1);
        in_place(
            command,
            right,
            &[(wrong.as_bytes(), "latitude NaN is not in [-90, 90] degrees")],
        );
    }
    in_place(
        "gc-inverse",
        "1 2 3 4 5",
        &[(b"0 2 3 4 5", "semi-major axis 0.0 is not in [1e-15, 1e15] metres")],
    );
    in_place("latlon", "1 2 3", &[(b"0 0 0", "(0.0, 0.0, 0.0) has no direction")]);
    in_place("wrap", "1", &[(b"inf", "longitude inf is not finite")]);
    in_place("gnomonic", "0 0 1 1", &[(b"0 0 0 91", "the map does not reach 0, 91")]);
    in_place("line", "1 2 3 4", &[(b"1 2 nan 4", "azimuth NaN is not finite")]);
    in_place("radii", "moon", &[(b"1,2", "flattening 2.0 is not in [-1000, 1)")]);
}

#[test]
fn faces_and_cells() {
    in_place(
        "from-numbered --numbering fits --projection square",
        "0 0.5 0.5",
        &[
            (b"6 0 0", "face 6 is not in 0 to 5"),
            (b"0.5 0 0", "\"0.5\" is not a whole number, or too large"),
            (b"256 0 0", "\"256\" is not a whole number, or too large"),
            (b"0 1.5 0", "(1.5, 0.0) is not in [-1, 1]²"),
        ],
    );
    in_place(
        "cell",
        "1 2 3",
        &[
            (b"91 2 3", "latitude 91.0 is not in [-90, 90] degrees"),
            (b"1 2 31", "level 31 is not in 0 to 30"),
            (b"1 2 -1", "\"-1\" is not a whole number, or too large"),
        ],
    );
    in_place(
        "token",
        "94",
        &[
            (b"876b%20e99", "' ' is not a hexadecimal digit"),
            (b"876bee99%0A", "'\\n' is not a hexadecimal digit"),
            (b"%4", "% without two digits"),
            (b"%zz", "% without two digits"),
            (b"%ff", "invalid utf-8 sequence of 1 bytes from index 0"),
            (b"f", "0xf000000000000000 is not the key of a tile"),
            (b"12345678123456781", "expected a token of 1 to 16 bytes, got 17"),
        ],
    );
    in_place(
        "key",
        "3000000000000000",
        &[
            (b"0", "0x0000000000000000 is not the key of a tile"),
            (b"x", "\"x\" is no id"),
        ],
    );
    in_place(
        "cell-parent",
        "14",
        &[
            (b"3", "a face has no parent"),
            (b"14 2", "level 2 is finer than the cell's, 1"),
            (b"14 31", "level 31 is not in 0 to 30"),
        ],
    );
    in_place(
        "cell-children",
        "14",
        &[(b"0000000000000001", "a leaf has no children")],
    );
    in_place(
        "cell-vertex",
        "14 0",
        &[(b"14 1", "level 1 is not coarser than the cell's, 1")],
    );
    in_place(
        "cell-all",
        "14 1",
        &[
            (b"14 31", "level 31 is more than 10 finer than the cell's, 1"),
            (b"2ef59bd352b93ac3 31", "level 31 is not in 0 to 30"),
        ],
    );
}

#[test]
fn options() {
    for (arguments, why) in [
        ("solve --ellipsoid 1,0.5", "flattening 0.5"),
        ("polygon --ellipsoid flat", "unknown ellipsoid"),
        ("polygon --method karney", "--method"),
        ("numbered --projection square", "--numbering"),
        ("numbered --numbering esri --projection square", "opengl"),
        ("cell --projection flat", "s2-quadratic"),
        ("wrap --ellipsoid wgs84", "--ellipsoid"),
        ("gc-mid 1 2 3 4", "unexpected argument"),
        ("solve --scalar f16", "f32"),
    ] {
        let complaint = complaint(arguments);
        assert!(complaint.contains(why), "{arguments}: {complaint} lacks {why}");
    }
}

#[test]
fn every_line_is_answered_whatever_it_holds() {
    let fields = [
        "nan", "inf", "-inf", "1e308", "-1e308", "1e30", "1e-320", "0", "-0", "1", "29", "30", "90", "-90", "180",
        "1e5", "1.5", "x", "%", "%00", "ffffffffffffffff", "3", "1000000000000000", "99999999999999999999", "wgs84",
        "\u{fc}",
    ];
    for case in cases() {
        let columns: Vec<_> = case.line.split(' ').collect();
        let mut lines: Vec<_> = fields.map(|field| vec![field; columns.len()].join(" ")).to_vec();
        for column in 0..columns.len() {
            for field in fields {
                let mut line = columns.clone();
                line[column] = field;
                lines.push(line.join(" "));
            }
        }
        for scalar in ["f64", "f32"] {
            let run = run(&format!("{} --scalar {scalar}", case.command), lines.join("\n"));
            assert!(
                run.code <= 1 && run.complaint.is_empty(),
                "{}: {}",
                case.command,
                run.complaint
            );
            assert_eq!(run.output.lines().count(), lines.len(), "{}", case.command);
        }
    }
}

#[test]
fn grids() {
    in_place(
        "from-utm",
        "31 n 500000 0",
        &[
            (b"61 n 500000 0", "zone 61 is not in 0 to 60"),
            (b"31 x 500000 0", "\"x\" is not n or s"),
            (b"31 n 1000001 0", "easting 1000001.0 is outside the grid"),
            (b"0 n 2000000 0", "northing 0.0 is outside the grid"),
        ],
    );
    in_place(
        "from-mgrs",
        "31NEA",
        &[
            (b"61NEA", "zone 61 is not in 1 to 60"),
            (b"31IEA", "'I' is not the letter of a band"),
            (b"31NEA123", "3 digits, not as many for easting as for northing"),
            (b"31NEV", "row V is not in band N"),
        ],
    );
    in_place(
        "utm --zone 31",
        "0 3",
        &[(
            b"0 64",
            "longitude 64.0 is more than 60 degrees from the zone's meridian",
        )],
    );
    assert!(complaint("mgrs --precision 12").contains("precision 12 is above 11"));
    assert!(complaint("utm --zone 61").contains("zone 61 is not in 0 to 60"));
    in_place(
        "from-tm",
        "0 1 1",
        &[(b"0 2e7 1", "point (20000000.0, 1.0) is outside the map")],
    );
    in_place("laea", "0 0 0 1", &[(b"0 0 0 180", "the map does not reach 0, 180")]);
}
