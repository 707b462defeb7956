//! The same for many things, on all cores.

use std::io::{self, IsTerminal, Write};
use std::num::NonZero;
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::thread;

/// What a function gives for each of them, in their order; the error of the first that has one.
///
/// # Errors
/// Those of the function.
pub fn map<I: Sync, O: Send, E: Send>(items: &[I], function: impl Fn(&I) -> Result<O, E> + Sync) -> Result<Vec<O>, E> {
    let next = AtomicUsize::new(0);
    let done = Mutex::new(Vec::with_capacity(items.len()));
    let work = || {
        while let index = next.fetch_add(1, Ordering::Relaxed)
            && let Some(item) = items.get(index)
        {
            let result = function(item);
            // Another thread that panicked takes the program with it when the scope ends.
            done.lock()
                .unwrap_or_else(|poisoned| poisoned.into_inner())
                .push((index, result));
        }
    };
    let cores = thread::available_parallelism().map_or(1, NonZero::get);
    thread::scope(|scope| {
        for _ in 1..cores.min(items.len()) {
            scope.spawn(work);
        }
        work();
    });
    let mut done = done.into_inner().unwrap_or_else(|poisoned| poisoned.into_inner());
    done.sort_by_key(|(index, _)| *index);
    done.into_iter().map(|(_, result)| result).collect()
}

/// How far a program is, on its terminal; nothing where there is none.
pub struct Progress {
    steps: usize,
    done: AtomicUsize,
    is_seen: bool,
}

impl Progress {
    pub fn new(steps: usize) -> Self {
        Self {
            steps,
            done: AtomicUsize::new(0),
            is_seen: io::stderr().is_terminal(),
        }
    }

    /// One step more.
    pub fn step(&self) {
        let done = self.done.fetch_add(1, Ordering::Relaxed) + 1;
        if self.is_seen {
            let end = if done == self.steps { "\r\x1b[K" } else { "" };
            let _ = write!(io::stderr(), "\r{done} of {}{end}", self.steps);
        }
    }
}
