#![no_main]

use terrella_fuzz::{position, law};

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| law::run(position::LAWS, bytes));
