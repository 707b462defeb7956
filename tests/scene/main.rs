//! What scenes choose, against the truth: no bound is exceeded, none is idle, and nothing dearer than needed is taken.
#![allow(
    clippy::unwrap_used, clippy::expect_used, clippy::panic, clippy::indexing_slicing, missing_docs
)]

mod areas;
mod cost;
mod distances;
mod draw;
mod figure;
mod geodetics;
mod positions;
mod refusals;
mod search;
mod unchecked;
