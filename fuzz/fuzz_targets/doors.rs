#![no_main]

use terrella_fuzz::{doors, law};

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| law::run(doors::LAWS, bytes));
