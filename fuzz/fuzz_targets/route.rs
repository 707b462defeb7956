#![no_main]

use terrella_fuzz::{property, route};

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| property::run(route::PROPERTIES, bytes));
