#![no_main]

use terrella_fuzz::{geodesic, property};

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| property::run(geodesic::PROPERTIES, bytes));
