#![no_main]

use terrella_fuzz::{cover, property};

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| property::run(cover::PROPERTIES, bytes));
