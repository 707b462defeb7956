#![no_main]

use terrella_fuzz::{property, text};

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| property::run(text::PROPERTIES, bytes));
