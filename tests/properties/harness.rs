//! Laws as tests, on bytes of proptest's.

use proptest::prelude::*;
use proptest::test_runner::{Config, FileFailurePersistence, RngAlgorithm, TestRng, TestRunner};

use testkit::bytes::Bytes;

/// How many inputs of a property are tried.
const CASES: u32 = 4000;

/// Bytes that failed are written here, and tried first ever after.
const REGRESSIONS: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/properties/regressions.txt");

/// Asserts a property on many bytes, the same at every run: what is new is for the fuzzer to find.
pub fn holds(property: fn(&mut Bytes<'_>)) {
    let config = Config {
        cases: CASES,
        failure_persistence: Some(Box::new(FileFailurePersistence::Direct(REGRESSIONS))),
        ..Config::default()
    };
    let bytes = proptest::collection::vec(any::<u8>(), 96);
    let judged =
        TestRunner::new_with_rng(config, TestRng::deterministic_rng(RngAlgorithm::ChaCha)).run(&bytes, |bytes| {
            property(&mut Bytes::new(&bytes));
            Ok(())
        });
    if let Err(failure) = judged {
        panic!("{failure}");
    }
}
