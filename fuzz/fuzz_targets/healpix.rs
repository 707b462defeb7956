#![no_main]

use terrella_fuzz::{healpix, property};

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| property::run(healpix::PROPERTIES, bytes));
