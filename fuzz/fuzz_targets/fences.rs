#![no_main]

use terrella_fuzz::{fences, property};

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| property::run(fences::PROPERTIES, bytes));
