//! What terrella and its rivals are timed on and with: points, a clock, and a measurement's line of a table.

mod clock;
pub mod points;
pub mod record;

pub use clock::{REPETITIONS, Timing, time};
