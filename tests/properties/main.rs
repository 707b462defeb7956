//! Laws that hold for any input, each defined once: here proptest looks for what breaks them, in `fuzz/` libFuzzer does.
#![allow(
    missing_docs, clippy::unwrap_used, clippy::expect_used, clippy::panic, clippy::indexing_slicing
)] // tests

mod areas;
mod batch;
mod bytes;
mod double;
mod edges;
mod geodesic;
mod harness;
mod nearest;
mod position;
mod projection;
#[allow(dead_code)] // the fuzzer's part
mod property;
mod reference;
mod scalar;
#[allow(dead_code)] // shared
#[path = "../accuracy/table.rs"]
mod table;
#[allow(dead_code)] // shared
#[path = "../accuracy/truth.rs"]
mod truth;
#[allow(dead_code)] // shared
#[path = "../cube/unfolded.rs"]
mod unfolded;
mod validation;
mod vector;
