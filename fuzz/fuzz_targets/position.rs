#![no_main]

use terrella_fuzz::{law, position};

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| law::run(position::LAWS, bytes));
