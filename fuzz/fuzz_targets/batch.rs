#![no_main]

use terrella_fuzz::{batch, law};

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| law::run(batch::LAWS, bytes));
