//! Lines: which count, what becomes of wrong ones, and when they are answered.

use std::io::{BufRead, BufReader, Write};
use std::sync::mpsc;
use std::thread;
use std::time::{Duration, Instant};

use crate::run::{answers, command, in_place, run};

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
            (b"-91", "latitude -91.0 is not between the poles"),
            (b"inf", "latitude inf is not between the poles"),
            (b"1 2", "fields: 1 expected, 2 found"),
        ],
    );
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
    let input = "0.25 -0.5 0.125\n0.5 0.75 -0.25\n".repeat(100_000);
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
