#![no_main]

use terrella_fuzz::{property, legs};

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| property::run(legs::PROPERTIES, bytes));
