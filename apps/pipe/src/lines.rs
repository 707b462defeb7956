//! The loop over standard input: which lines count, what a failure does, when to flush.

use std::fmt::Write as _;
use std::io::{self, BufRead, BufReader, ErrorKind, Read, Write};
use std::process::ExitCode;

use crate::operation::{Answer, Failure};

/// Bytes of input, and of output, at a time: what a pipe holds.
const BUFFER: usize = 1 << 16;

/// Answers every line of standard input on standard output; gives the exit code.
pub fn for_each_line(answer: &Answer) -> ExitCode {
    match all(io::stdin().lock(), io::stdout().lock(), answer) {
        Ok(true) => ExitCode::SUCCESS,
        Ok(false) => ExitCode::FAILURE,
        // Whoever read has read enough.
        Err(error) if error.kind() == ErrorKind::BrokenPipe => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("error: {error}");
            ExitCode::FAILURE
        }
    }
}

/// Answers every line; says whether all could be processed.
fn all(input: impl Read, mut output: impl Write, answer: &Answer) -> io::Result<bool> {
    let mut input = BufReader::with_capacity(BUFFER, input);
    let mut line = Vec::new();
    let mut answers = String::with_capacity(2 * BUFFER);
    let mut all = true;
    loop {
        // The next line may take its time, or wait for an answer to the last.
        if answers.len() >= BUFFER || !input.buffer().contains(&b'\n') {
            output.write_all(answers.as_bytes())?;
            output.flush()?;
            answers.clear();
        }
        line.clear();
        if input.read_until(b'\n', &mut line)? == 0 {
            return Ok(all);
        }
        let text = line.trim_ascii();
        if text.starts_with(b"#") || text.is_empty() && !answer.to_blank_lines() {
            continue;
        }
        if let Err(why) = one(text, &mut answers, answer) {
            all = false;
            write!(answers, "error: {why}").map_err(io::Error::other)?;
        }
        answers.push('\n');
    }
}

fn one(line: &[u8], answers: &mut String, answer: &Answer) -> Result<(), Failure> {
    answer.append(std::str::from_utf8(line).map_err(|_| "not UTF-8")?, answers)
}
