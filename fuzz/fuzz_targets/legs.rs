#![no_main]

use terrella_fuzz::{legs, property};

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| property::run(legs::PROPERTIES, bytes));
