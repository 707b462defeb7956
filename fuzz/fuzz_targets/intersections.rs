#![no_main]

use terrella_fuzz::{property, intersections};

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| property::run(intersections::PROPERTIES, bytes));
