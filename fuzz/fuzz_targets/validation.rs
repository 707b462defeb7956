#![no_main]

use terrella_fuzz::{property, validation};

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| property::run(validation::PROPERTIES, bytes));
