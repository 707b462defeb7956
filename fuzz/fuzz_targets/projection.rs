#![no_main]

use terrella_fuzz::{law, projection};

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| law::run(projection::LAWS, bytes));
