//! Laws as tests: on bytes of proptest's, and on the bytes that broke them once.

use proptest::prelude::*;
use proptest::test_runner::{Config, FileFailurePersistence, TestRunner};

use crate::bytes::Bytes;
use crate::law::Law;

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

/// The files that a fuzzer found for a room: `found/ROOM-…`.
fn found(room: &str, laws: &[Law]) {
    for entry in std::fs::read_dir(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/laws/found")).unwrap() {
        let path = entry.unwrap().path();
        if path.file_name().unwrap().to_str().unwrap().starts_with(room) {
            println!("{}", path.display());
            crate::law::run(laws, &std::fs::read(path).unwrap());
        }
    }
}

#[test]
fn what_was_found_holds() {
    for (room, laws) in crate::ROOMS {
        found(room, laws);
    }
}
