//! The example `pipe`, run as a script would run it.
#![allow(
    missing_docs, clippy::unwrap_used, clippy::expect_used, clippy::panic, clippy::indexing_slicing
)] // tests

use std::io::{BufRead, BufReader, Write};
use std::path::PathBuf;
use std::process::{Command, Stdio};
use std::sync::mpsc;
use std::thread;
use std::time::{Duration, Instant};

use terrella::cube::Projection;
use terrella::geodesic::Method;
use terrella::{Latitude, NAMED, Shift};

/// target/PROFILE/examples/pipe, next to this test's own target/PROFILE/deps.
fn executable() -> PathBuf {
    let mut path = std::env::current_exe().unwrap();
    path.pop();
    path.pop();
    path.push("examples");
    path.push(format!("pipe{}", std::env::consts::EXE_SUFFIX));
    assert!(
        path.exists(),
        "{} is not there: `cargo test` builds it, `cargo test --test` does not; run `cargo build --example pipe` (same profile)",
        path.display()
    );
    path
}

/// The example with arguments separated by blanks, its streams piped.
fn command(arguments: &str) -> Command {
    let mut command = Command::new(executable());
    command.args(arguments.split_whitespace());
    command
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped());
    command
}

/// What a run left behind.
struct Run {
    code: i32,
    output: String,
    complaint: String,
}

fn run(arguments: &str, input: impl AsRef<[u8]>) -> Run {
    let mut child = command(arguments).spawn().unwrap();
    let mut stdin = child.stdin.take().unwrap();
    let input = input.as_ref();
    let output = thread::scope(|scope| {
        // A run that ends early closes its input.
        scope.spawn(move || drop(stdin.write_all(input)));
        child.wait_with_output().unwrap()
    });
    Run {
        code: output.status.code().expect("ended by a signal"),
        output: String::from_utf8(output.stdout).unwrap(),
        complaint: String::from_utf8(output.stderr).unwrap(),
    }
}

/// The output of a run in which all goes well.
fn answers(arguments: &str, input: impl AsRef<[u8]>) -> String {
    let run = run(arguments, input);
    assert_eq!(
        (run.code, run.complaint.as_str()),
        (0, ""),
        "{arguments}:\n{}",
        run.output
    );
    run.output
}

/// The complaint about a wrong command line.
fn complaint(arguments: &str) -> String {
    let Run {
        code,
        output,
        complaint,
    } = run(arguments, "");
    assert_eq!((code, output.as_str()), (2, ""), "{arguments}: {complaint}");
    assert!(
        complaint.starts_with("error: ") && complaint.lines().count() == 1,
        "{arguments}: {complaint}"
    );
    complaint
}

fn numbers(text: &str) -> Vec<Vec<f64>> {
    let row = |line: &str| line.split('\t').map(|field| field.parse().unwrap()).collect();
    text.lines().map(row).collect()
}

fn text(rows: impl IntoIterator<Item = [f64; 3]>) -> String {
    rows.into_iter().map(|[a, b, c]| format!("{a} {b} {c}\n")).collect()
}

/// Unit vectors all over the sphere, on a spiral.
fn directions() -> impl Iterator<Item = [f64; 3]> {
    (0..2000).map(|i| {
        let z = 1.0 - f64::from(2 * i + 1) / 2000.0;
        let (sin, cos) = (f64::from(i) * 2.399_963_229_728_653).sin_cos();
        let r = (1.0 - z * z).sqrt();
        [r * cos, r * sin, z]
    })
}

fn unit([x, y, z]: [f64; 3]) -> [f64; 3] {
    let length = (x * x + y * y + z * z).sqrt();
    [x / length, y / length, z / length]
}

#[test]
fn every_projection_closes_its_round_trip() {
    for (scalar, tolerance) in [("f64", 1e-15), ("f32", 5e-7)] {
        let rounded = |v: f64| if scalar == "f32" { f64::from(v as f32) } else { v };
        let directions: Vec<_> = directions().map(|d| d.map(rounded)).collect();
        for projection in Projection::ALL {
            // The published pair of polynomials, which miss each other.
            let tolerance = if *projection == Projection::Cobe {
                6e-4
            } else {
                tolerance
            };
            let options = format!("--projection {projection} --scalar {scalar}");
            let on_cube = answers(&format!("forward {options}"), text(directions.iter().copied()));
            let back = numbers(&answers(&format!("inverse {options}"), on_cube));
            assert_eq!(back.len(), directions.len());
            for (&direction, back) in directions.iter().zip(back) {
                let expected = unit(direction);
                let miss = (0..3).map(|i| (back[i] - expected[i]).powi(2)).sum::<f64>().sqrt();
                assert!(miss <= tolerance, "{options}: {direction:?} comes back as {back:?}");
            }
        }
    }
}

#[test]
fn every_shift_closes_its_round_trip() {
    let positions = "-89.999 -179.5\n-45 12.25\n0 0\n1e-9 90\n41.8 45\n59.91 10.75\n90 0\n";
    for shift in Shift::ALL {
        for ellipsoid in ["wgs84", "moon", "1,1/10", "1,-1/9"] {
            let options = format!("--projection equi-edge --shift {shift} --ellipsoid {ellipsoid}");
            let back = answers(
                &format!("unproject {options}"),
                answers(&format!("project {options}"), positions),
            );
            for (line, back) in positions.lines().zip(numbers(&back)) {
                let lat: f64 = line.split(' ').next().unwrap().parse().unwrap();
                assert!(
                    (back[0] - lat).abs() < 5e-14,
                    "{options}: {line} comes back as {back:?}"
                );
            }
        }
    }
}

#[test]
fn axes_are_exact() {
    let axes = "1 0 0\n0 1 0\n-1 0 0\n0 -1 0\n0 0 1\n0 0 -1\n";
    for projection in Projection::ALL {
        for scalar in ["f64", "f32"] {
            let options = format!("--projection {projection} --scalar {scalar}");
            let on_cube = answers(&format!("forward {options}"), axes);
            for (face, row) in numbers(&on_cube).into_iter().enumerate() {
                assert_eq!(row, [face as f64, 0.0, 0.0], "{options}");
            }
            let back = answers(&format!("inverse {options}"), on_cube);
            for (axis, row) in axes.lines().zip(numbers(&back)) {
                let axis: Vec<f64> = axis.split(' ').map(|v| v.parse().unwrap()).collect();
                assert_eq!(row, axis, "{options}");
            }
        }
    }
}

#[test]
fn ties_go_to_y_then_z_then_x() {
    for projection in Projection::ALL.iter().filter(|&&p| p != Projection::Healpix) {
        let on_cube = answers(
            &format!("forward --projection {projection}"),
            "1 1 0\n0 1 -1\n1 0 1\n-1 0 -1\n-2 2 0.5\n1 1 1\n1 -1 -1\n",
        );
        let faces: Vec<_> = numbers(&on_cube).iter().map(|row| row[0]).collect();
        assert_eq!(faces, [1.0, 1.0, 4.0, 5.0, 1.0, 1.0, 3.0], "{projection}");
    }
    assert_eq!(
        answers("forward --projection tangential", "1 1 1\n2 -2 1\n1 0.5 1"),
        "1\t-1.0\t1.0\n3\t1.0\t0.5\n4\t0.5\t-1.0\n"
    );
}

#[test]
fn numbers_have_no_more_digits_than_their_scalar() {
    let input = "3 1 1.5e-6\n1e300 0 1e300\n";
    assert_eq!(
        answers("forward --projection tangential", input),
        "0\t0.3333333333333333\t5e-7\n4\t0.0\t-1.0\n"
    );
    let run = run("--scalar f32 forward --projection tangential", input);
    let (first, second) = run.output.split_once('\n').unwrap();
    assert_eq!(first, "0\t0.33333334\t5e-7");
    assert_eq!((run.code, second), (1, "error: (inf, 0.0, inf) has no direction\n"));
}

#[test]
fn comments_and_blank_lines_are_skipped() {
    let input: &[u8] = b"# x y z\n\n1 0 0\n   \t\n  # more \xff\n#\n\t1  1\t4  \n";
    assert_eq!(
        answers("forward --projection tangential", input),
        "0\t0.0\t0.0\n4\t0.25\t-0.25\n"
    );
}

#[test]
fn line_ends_of_every_kind_are_read() {
    let forward = |input| answers("forward --projection tangential", input);
    assert_eq!(forward("1 0 0\r\n\r\n# \r\n2 0 1\r\n"), "0\t0.0\t0.0\n0\t0.0\t0.5\n");
    assert_eq!(forward("1 0 0\n2 0 1"), "0\t0.0\t0.0\n0\t0.0\t0.5\n");
    assert_eq!(forward("2 0 1\r"), "0\t0.0\t0.5\n");
    assert_eq!(forward(""), "");
    assert_eq!(forward("\n"), "");
}

/// Checks that each wrong line becomes its error and that those around it are processed.
fn in_place(arguments: &str, right: &str, wrong: &[(&[u8], &str)]) {
    let expected_right = answers(arguments, right);
    let mut input = right.as_bytes().to_vec();
    let mut expected = expected_right.clone();
    for (line, error) in wrong {
        input.extend_from_slice(b"\n");
        input.extend_from_slice(line);
        input.extend_from_slice(b"\n");
        input.extend_from_slice(right.as_bytes());
        expected += &format!("error: {error}\n{expected_right}");
    }
    let run = run(arguments, input);
    assert_eq!(run.output, expected, "{arguments}");
    assert_eq!((run.code, run.complaint.as_str()), (1, ""), "{arguments}");
}

#[test]
fn errors_stay_in_place() {
    in_place(
        "forward --projection vertex",
        "1 2 3",
        &[
            (b"1 2", "fields: 3 expected, 2 found"),
            (b"1 2 3 four", "fields: 3 expected, 4 found"),
            (b"1,2,3", "fields: 3 expected, 1 found"),
            (b"1 two 3", "\"two\" is not a number"),
            (b"1 2 3;", "\"3;\" is not a number"),
            (b"1 2 \x07", "\"\\u{7}\" is not a number"),
            (b"1 2 \xc3\x28", "not UTF-8"),
            (b"0 0 0", "(0.0, 0.0, 0.0) has no direction"),
            (b"nan 0 1", "(NaN, 0.0, 1.0) has no direction"),
            (b"1 inf 1", "(1.0, inf, 1.0) has no direction"),
        ],
    );
    let face_point: [(&[u8], &str); 7] = [
        (b"6 0 0", "face 6 is not an integer in 0 to 5"),
        (b"-1 0 0", "face -1 is not an integer in 0 to 5"),
        (b"0.5 0 0", "face 0.5 is not an integer in 0 to 5"),
        (b"nan 0 0", "face NaN is not an integer in 0 to 5"),
        (b"top 0 0", "\"top\" is not a number"),
        (b"0 1.5 0", "(1.5, 0.0) is not in [-1, 1]²"),
        (b"0 0 nan", "(0.0, NaN) is not in [-1, 1]²"),
    ];
    in_place("inverse --projection square", "5 -1 1", &face_point);
    in_place("unproject --projection square", "5.0 -1 1", &face_point);
    in_place(
        "project --projection square",
        "90 540",
        &[
            (b"90.5 0", "latitude 90.5 is not in [-90, 90] degrees"),
            (b"nan 0", "latitude NaN is not in [-90, 90] degrees"),
            (b"0 inf", "longitude inf is not finite"),
        ],
    );
    in_place(
        "latitude --from geodetic --to authalic",
        "-90",
        &[
            (b"-91", "-91.0 is no latitude between the poles"),
            (b"inf", "inf is no latitude between the poles"),
            (b"1 2", "fields: 1 expected, 2 found"),
        ],
    );
}

#[test]
fn geodesics_and_positions() {
    // The worked example of GeographicLib: Wellington to Salamanca.
    let pair = "-41.32 174.81 40.96 -5.5";
    let row = &numbers(&answers("geodesic-inverse", pair))[0];
    let expected = [19_959_679.267_353_82, 161.067_669_986_16, 18.825_195_123_25];
    assert!(row.iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-8), "{row:?}");
    for method in Method::ALL {
        let there = answers(&format!("geodesic-direct --method {method}"), "40 -75 30 10000");
        let row = &numbers(&there)[0];
        assert!(
            (row[0] - 40.077_98).abs() < 3e-4 && (row[1] + 74.941_38).abs() < 3e-4,
            "{method}: {there}"
        );
        let back = format!("40 -75 {} {}", row[0], row[1]);
        let distance = numbers(&answers(&format!("geodesic-inverse --method {method}"), back))[0][0];
        assert!((distance - 10_000.0).abs() < 0.05, "{method}: {distance}");
    }
    in_place(
        "geodesic-direct",
        "40 -75 30 10000",
        &[
            (b"40 -75 nan 1", "azimuth NaN is not finite"),
            (b"40 -75 0 inf", "distance inf is not finite"),
        ],
    );
    assert_eq!(
        answers("to-ecef", "90 0 100\n0 90 -7\n"),
        "0.0\t0.0\t6356852.314245179\n0.0\t6378130.0\t0.0\n"
    );
    let row = &numbers(&answers("from-ecef", "0 0 6356852.314245179"))[0];
    assert!(row[..2] == [90.0, 0.0] && (row[2] - 100.0).abs() < 1e-9, "{row:?}");
    assert_eq!(
        answers("to-enu --origin 0,90,5 --ellipsoid 1000,0", "0 90 12"),
        "0.0\t0.0\t7.0\n"
    );
    let enu = answers("to-enu --origin -40,-75,0", "-40.1 -75.2 100");
    let back = &numbers(&answers("from-enu --origin -40,-75,0", enu))[0];
    assert!((back[0] + 40.1).abs() < 1e-13 && (back[1] + 75.2).abs() < 1e-13 && (back[2] - 100.0).abs() < 1e-8);
    assert!(complaint("to-enu --origin 1,2").contains("three numbers"));
    assert!(complaint("to-enu --origin 91,0,0").contains("latitude 91.0 is not in"));
    assert!(complaint("geodesic-inverse --method bessel").contains("karney"));
}

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

#[test]
fn latitudes_are_in_degrees_or_in_radians() {
    for kind in Latitude::ALL.iter().filter(|&&k| k != Latitude::Isometric) {
        let degrees = numbers(&answers(
            &format!("latitude --from geodetic --to {kind}"),
            "-90\n0\n52.5",
        ));
        let radians = answers(
            &format!("latitude --radians --from geodetic --to {kind}"),
            format!("{}\n0\n{}", -std::f64::consts::FRAC_PI_2, 52.5_f64.to_radians()),
        );
        assert_eq!((degrees[0][0], degrees[1][0]), (-90.0, 0.0), "{kind}");
        for (degrees, radians) in degrees.iter().zip(numbers(&radians)) {
            assert!(
                (degrees[0].to_radians() - radians[0]).abs() < 5e-16,
                "{kind}: {degrees:?}, {radians:?}"
            );
        }
    }
    assert_eq!(
        answers("latitude --from geodetic --to authalic", "45"),
        "44.87170287343394\n"
    );
}

#[test]
fn the_isometric_latitude_of_a_pole_is_infinite() {
    assert_eq!(
        answers("latitude --from geodetic --to isometric", "90\n-90\n0"),
        "inf\n-inf\n0.0\n"
    );
    assert_eq!(
        answers("latitude --from isometric --to rectifying", "inf\n-inf\n0"),
        "90.0\n-90.0\n0.0\n"
    );
    let radians = answers(
        "latitude --from isometric --to conformal --radians --scalar f32",
        "inf\n-infinity",
    );
    assert_eq!(radians, "1.5707964\n-1.5707964\n");
    // Dimensionless, whatever the unit of the other.
    let degrees = numbers(&answers("latitude --from isometric --to geodetic", "0.75"));
    let radians = numbers(&answers("latitude --from isometric --to geodetic --radians", "0.75"));
    assert!((degrees[0][0].to_radians() - radians[0][0]).abs() < 5e-16);
}

#[test]
fn a_line_is_answered_before_the_next_is_there() {
    let mut child = command("forward --projection tangential").spawn().unwrap();
    let mut stdin = child.stdin.take().unwrap();
    let stdout = BufReader::new(child.stdout.take().unwrap());
    let (sender, receiver) = mpsc::channel();
    thread::spawn(move || stdout.lines().for_each(|line| sender.send(line.unwrap()).unwrap()));
    let answer = || receiver.recv_timeout(Duration::from_secs(20)).expect("no answer");
    stdin.write_all(b"2 1 0\n").unwrap();
    assert_eq!(answer(), "0\t0.5\t0.0");
    // The beginning of the next line keeps nothing back.
    stdin.write_all(b"4 1 0\n8 1").unwrap();
    assert_eq!(answer(), "0\t0.25\t0.0");
    stdin.write_all(b" 0\n").unwrap();
    assert_eq!(answer(), "0\t0.125\t0.0");
    drop(stdin);
    assert!(child.wait().unwrap().success());
}

#[test]
fn a_reader_that_leaves_ends_the_run_quietly() {
    let mut child = command("forward --projection tangential").spawn().unwrap();
    drop(child.stdout.take());
    let mut stdin = child.stdin.take().unwrap();
    while stdin.write_all(b"1 2 3\n").is_ok() {}
    let output = child.wait_with_output().unwrap();
    assert_eq!(
        (output.status.code(), output.stderr.as_slice()),
        (Some(0), b"".as_slice())
    );
}

#[test]
fn two_million_lines_take_less_than_a_minute() {
    let input = text(directions()).repeat(100);
    let start = Instant::now();
    assert_eq!(
        answers("forward --projection quadrilateralized", input).lines().count(),
        200_000
    );
    assert!(
        start.elapsed() < Duration::from_secs(6),
        "200 000 lines in {:?}",
        start.elapsed()
    );
}
