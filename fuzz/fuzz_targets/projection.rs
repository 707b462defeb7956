#![no_main]

use terrella_fuzz::{projection, law};

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| law::run(projection::LAWS, bytes));
