#![no_main]

use terrella_fuzz::{edges, property};

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| property::run(edges::PROPERTIES, bytes));
