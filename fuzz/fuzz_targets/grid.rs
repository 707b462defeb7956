#![no_main]

use terrella_fuzz::{grid, property};

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| property::run(grid::PROPERTIES, bytes));
