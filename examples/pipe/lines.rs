//! The loop over standard input: which lines count, what a failure does, when to flush.

use std::error::Error;
use std::fmt::Write as _;
use std::io::{self, BufRead, BufReader, ErrorKind, Read, Write};
use std::process::ExitCode;
use std::str::FromStr;

use terrella::Real;

use crate::row::{self, Row};

/// Bytes of input, and of output, at a time: what a pipe holds.
const BUFFER: usize = 1 << 16;

/// Answers every line of standard input on standard output; gives the exit code.
pub fn for_each_line<T, R, const N: usize>(operation: impl Fn([T; N]) -> Result<R, Box<dyn Error>>) -> ExitCode
where
    T: Real + FromStr,
    R: Row,
{
    match answer(io::stdin().lock(), io::stdout().lock(), operation) {
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
fn answer<T, R, const N: usize>(
    input: impl Read,
    mut output: impl Write,
    operation: impl Fn([T; N]) -> Result<R, Box<dyn Error>>,
) -> io::Result<bool>
where
    T: Real + FromStr,
    R: Row,
{
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
        if text.is_empty() || text.starts_with(b"#") {
            continue;
        }
        let written = match row::parse(text).and_then(&operation) {
            Ok(row) => row.write(&mut answers),
            Err(why) => {
                all = false;
                write!(answers, "error: {why}")
            }
        };
        written.map_err(io::Error::other)?;
        answers.push('\n');
    }
}
