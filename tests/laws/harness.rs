//! Laws as tests, on bytes of proptest's.

use proptest::prelude::*;
use proptest::test_runner::{Config, FileFailurePersistence, TestRunner};

use crate::bytes::Bytes;

/// How many inputs of a law are tried.
const CASES: u32 = 4000;

/// Bytes that failed are written here, and tried first ever after.
const REGRESSIONS: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/laws/regressions.txt");

/// Asserts a law on many bytes.
pub fn holds(law: fn(&mut Bytes<'_>)) {
    let config = Config {
        cases: CASES,
        failure_persistence: Some(Box::new(FileFailurePersistence::Direct(REGRESSIONS))),
        ..Config::default()
    };
    let bytes = proptest::collection::vec(any::<u8>(), 96);
    let judged = TestRunner::new(config).run(&bytes, |bytes| {
        law(&mut Bytes::new(&bytes));
        Ok(())
    });
    if let Err(failure) = judged {
        panic!("{failure}");
    }
}
