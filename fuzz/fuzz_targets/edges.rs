#![no_main]

use terrella_fuzz::{edges, law};

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| law::run(edges::LAWS, bytes));
