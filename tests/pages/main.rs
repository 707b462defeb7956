//! What the pages README.md, ARCHITECTURE.md and VALIDATION.md show: made here, and held.
#![allow(missing_docs, clippy::unwrap_used, clippy::indexing_slicing, clippy::panic)] // a test may fail loudly

mod architecture;
mod budgets;
mod calls;
mod cover;
