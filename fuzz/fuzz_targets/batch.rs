#![no_main]

use terrella_fuzz::{batch, property};

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| property::run(batch::PROPERTIES, bytes));
