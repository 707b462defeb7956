//! Running the tool, and what a run leaves behind.

use std::io::Write;
use std::process::{Command, Stdio};
use std::thread;

/// The tool with arguments separated by blanks, its streams piped.
pub fn command(arguments: &str) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_pipe"));
    command.args(arguments.split_whitespace());
    command
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped());
    command
}

/// What a run left behind.
pub struct Run {
    pub code: i32,
    pub output: String,
    pub complaint: String,
}

pub fn run(arguments: &str, input: impl AsRef<[u8]>) -> Run {
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
pub fn answers(arguments: &str, input: impl AsRef<[u8]>) -> String {
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
pub fn complaint(arguments: &str) -> String {
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

pub fn numbers(text: &str) -> Vec<Vec<f64>> {
    let row = |line: &str| line.split('\t').map(|field| field.parse().unwrap()).collect();
    text.lines().map(row).collect()
}

/// Checks that each wrong line becomes its error and that those around it are processed.
pub fn in_place(arguments: &str, right: &str, wrong: &[(&[u8], &str)]) {
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
