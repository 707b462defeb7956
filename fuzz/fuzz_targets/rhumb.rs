#![no_main]

use terrella_fuzz::{property, rhumb};

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| property::run(rhumb::PROPERTIES, bytes));
