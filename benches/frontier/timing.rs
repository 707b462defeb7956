//! The clock: nanoseconds per point of a pass over a set.

use std::time::Instant;

/// Nanoseconds per point.
#[derive(Clone, Copy, Debug)]
pub struct Timing {
    /// The least of all repetitions.
    pub min: f64,
    /// Their median.
    pub median: f64,
}

/// Passes that are timed, beside one that is not.
pub const REPETITIONS: usize = 15;

/// Times `pass`, which works through a set of `points` and hands what it computes to `std::hint::black_box` or writes it
/// to a slice that outlives the call. The first pass is not timed; a pass of less than a millisecond is repeated within
/// the clock until it is longer.
pub fn time(points: usize, repetitions: usize, mut pass: impl FnMut()) -> Timing {
    let mut seconds = |passes: usize| {
        let start = Instant::now();
        for _ in 0..passes {
            pass();
        }
        start.elapsed().as_secs_f64()
    };
    seconds(1);
    let passes = (1e-3 / seconds(1)).ceil().max(1.0) as usize;
    let mut each: Vec<f64> = (0..repetitions.max(1)).map(|_| seconds(passes)).collect();
    each.sort_by(f64::total_cmp);
    let scale = 1e9 / (passes * points) as f64;
    Timing {
        min: each[0] * scale,
        median: each[each.len() / 2] * scale,
    }
}
