#![no_main]

use terrella_fuzz::{projection, property};

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| property::run(projection::PROPERTIES, bytes));
