//! Properties as tests, on random bytes.

use std::panic::{AssertUnwindSafe, catch_unwind};

use crate::bytes::Bytes;

/// How many inputs of a property are tried.
const CASES: u32 = 4000;

/// Asserts a property on the bytes of `regressions.txt`, then on random bytes, the same at every run: what is new
/// is for the fuzzer to find.
pub fn holds(property: fn(&mut Bytes<'_>)) {
    let fails = |bytes: &[u8]| catch_unwind(AssertUnwindSafe(|| property(&mut Bytes::new(bytes)))).is_err();
    let mut rng = fastrand::Rng::with_seed(0x5445_5252_454c_4c41);
    let random = (0..CASES).map(|_| {
        let mut bytes = vec![0; 96];
        rng.fill(&mut bytes);
        bytes
    });
    for bytes in regressions().chain(random) {
        if fails(&bytes) {
            let least = shrunk(bytes, &fails);
            // Once more, so that its message is the last.
            fails(&least);
            let text: String = least.iter().map(|byte| format!("{byte:02x}")).collect();
            panic!("the property fails on these bytes, a line for crates/testkit/src/regressions.txt:\n{text}");
        }
    }
}

fn regressions() -> impl Iterator<Item = Vec<u8>> {
    let lines = include_str!("regressions.txt").lines();
    lines.filter(|line| !line.starts_with('#')).map(|line| {
        let bytes = (0..line.len()).step_by(2);
        bytes
            .map(|at| u8::from_str_radix(&line[at..at + 2], 16).unwrap())
            .collect()
    })
}

/// Bytes that fail too, with as many zeros as can be had, and none at the end.
fn shrunk(mut bytes: Vec<u8>, fails: &dyn Fn(&[u8]) -> bool) -> Vec<u8> {
    for length in [32, 8, 4, 1] {
        for start in (0..bytes.len()).step_by(length) {
            let mut fewer = bytes.clone();
            fewer.iter_mut().skip(start).take(length).for_each(|byte| *byte = 0);
            if fewer != bytes && fails(&fewer) {
                bytes = fewer;
            }
        }
    }
    let end = bytes.iter().rposition(|&byte| byte != 0).map_or(0, |last| last + 1);
    bytes.truncate(end);
    bytes
}
