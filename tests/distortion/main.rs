//! Derivatives against truth, and what follows from them: Tissot's indicatrix, texels, surveys.
#![allow(
    missing_docs, clippy::unwrap_used, clippy::expect_used, clippy::panic, clippy::indexing_slicing
)] // tests

mod corner;
mod derivatives;
mod dual;
mod equal_area;
mod paper;
mod sphere;
mod survey;
#[allow(dead_code)] // shared
#[path = "../accuracy/table.rs"]
mod table;
mod texture;
mod tissot;
#[allow(dead_code)] // shared
#[path = "../accuracy/truth.rs"]
mod truth;
