//! The clock: nanoseconds per point of a pass over a set.

use std::ops::Range;
use std::time::Instant;

/// Nanoseconds per point.
#[derive(Clone, Copy, Debug)]
pub struct Timing {
    /// Each block of points at its quickest of all passes.
    pub min: f64,
    /// Each block at its median.
    pub median: f64,
}

/// Passes over a set that are timed, beside one that is not.
pub const REPETITIONS: usize = 15;

/// Seconds after which a slow pass is repeated no more, once it was timed [`FEWEST`] times.
const ENOUGH: f64 = 0.5;

/// See [`ENOUGH`].
const FEWEST: usize = 5;

/// Seconds that a block takes, about: well above what the clock costs and below what a scheduler lets another program run.
const BLOCK: f64 = 3e-4;

/// Times `pass`, which works through the points of a range and hands what it computes to `std::hint::black_box` or writes
/// it to slices that outlive the call. Ranges follow each other through all `points`, so a branch predictor sees the whole
/// set before any point comes again, and another program on the same core spoils a block and not the whole pass.
/// The first pass warms up.
pub fn time(points: usize, repetitions: usize, mut pass: impl FnMut(Range<usize>)) -> Timing {
    let mut seconds = |range: Range<usize>| {
        let start = Instant::now();
        pass(range);
        start.elapsed().as_secs_f64()
    };
    let first = seconds(0..points);
    let block = ((BLOCK / first * points as f64) as usize).clamp(1024.min(points), points);
    let mut blocks = vec![Vec::new(); points.div_ceil(block)];
    let (mut passes, mut clock) = (0, 0.0);
    while passes < repetitions.max(1) && (passes < FEWEST || clock < ENOUGH) {
        for (k, times) in blocks.iter_mut().enumerate() {
            let elapsed = seconds(k * block..((k + 1) * block).min(points));
            times.push(elapsed);
            clock += elapsed;
        }
        passes += 1;
    }
    blocks.iter_mut().for_each(|times| times.sort_by(f64::total_cmp));
    let sum = |rank: usize| blocks.iter().map(|times| times[rank]).sum::<f64>() * 1e9 / points as f64;
    Timing {
        min: sum(0),
        median: sum(passes / 2),
    }
}
