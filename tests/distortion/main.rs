//! Derivatives against truth, and what follows from them: Tissot's indicatrix, texels, surveys.
#![allow(
    missing_docs, clippy::unwrap_used, clippy::expect_used, clippy::panic, clippy::indexing_slicing
)] // tests

mod cells;
mod corner;
mod criteria;
mod derivatives;
mod dual;
mod equal_area;
mod kinks;
mod lambers;
mod land;
mod paper;
mod sphere;
mod survey;
mod texture;
mod tissot;
