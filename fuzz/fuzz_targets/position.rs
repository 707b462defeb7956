#![no_main]

use terrella_fuzz::{position, property};

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| property::run(position::PROPERTIES, bytes));
