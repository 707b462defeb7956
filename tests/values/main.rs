//! What positions are as values: their text, and the way from one scalar to the other.
#![allow(
    missing_docs, clippy::unwrap_used, clippy::expect_used, clippy::panic, clippy::indexing_slicing
)] // a test may fail loudly

mod constants;
mod display;
mod dms;
mod nmea;
mod parse;
mod precision;
