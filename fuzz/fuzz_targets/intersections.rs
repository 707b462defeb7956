#![no_main]

use terrella_fuzz::{intersections, property};

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| property::run(intersections::PROPERTIES, bytes));
