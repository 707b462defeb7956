//! Work on all cores, or on as many as the variable `RUST_TEST_THREADS` says.

use std::env;
use std::panic::resume_unwind;
use std::sync::Mutex;
use std::thread::{available_parallelism, scope};

/// The results of some work on each of many items, in their order.
pub fn map<I, R: Send>(items: impl IntoIterator<Item = I, IntoIter: Send>, work: impl Fn(I) -> R + Sync) -> Vec<R> {
    let items = Mutex::new(items.into_iter().enumerate());
    let next = || items.lock().unwrap().next();
    let run = || -> Vec<(usize, R)> { std::iter::from_fn(next).map(|(at, item)| (at, work(item))).collect() };
    let mut results = Vec::new();
    scope(|scope| {
        let said = env::var("RUST_TEST_THREADS").ok().and_then(|count| count.parse().ok());
        let count = said.unwrap_or_else(|| available_parallelism().map_or(1, usize::from));
        let threads: Vec<_> = (0..count).map(|_| scope.spawn(run)).collect();
        for thread in threads {
            results.extend(thread.join().unwrap_or_else(|why| resume_unwind(why)));
        }
    });
    results.sort_unstable_by_key(|&(at, _)| at);
    results.into_iter().map(|(_, result)| result).collect()
}

/// Some work on each of many items.
pub fn for_each<I>(items: impl IntoIterator<Item = I, IntoIter: Send>, work: impl Fn(I) + Sync) {
    map(items, work);
}
