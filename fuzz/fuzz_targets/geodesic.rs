#![no_main]

use terrella_fuzz::{geodesic, law};

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| law::run(geodesic::LAWS, bytes));
