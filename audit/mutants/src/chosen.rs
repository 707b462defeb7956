//! Added to the library: which mutant this run is of, and where it came by.
#![allow(
    missing_docs, unsafe_code, clippy::panic, clippy::unwrap_used, clippy::indexing_slicing
)]

extern crate std;

use core::sync::atomic::{AtomicBool, AtomicUsize, Ordering::Relaxed};
use std::boxed::Box;
use std::string::String;
use std::{env, format, fs, panic};

const MUTANTS: usize = 0;
/// No mutant, but every place that is reached is written to the file `REACHED`.
pub(crate) const REACH: usize = usize::MAX;

pub(crate) static CHOSEN: AtomicUsize = AtomicUsize::new(REACH - 1);
static REACHED: [AtomicBool; MUTANTS] = [const { AtomicBool::new(false) }; MUTANTS];

/// The mutant to be, at the place whose first mutant is `place`.
#[inline(always)]
pub fn at(place: usize) -> usize {
    let chosen = CHOSEN.load(Relaxed);
    if chosen == REACH {
        reach(place);
    }
    chosen
}

#[cold]
pub(crate) fn reach(place: usize) {
    REACHED[place].store(true, Relaxed);
}

unsafe extern "C" {
    fn alarm(seconds: u32) -> u32;
    fn atexit(function: extern "C" fn()) -> i32;
    fn _exit(code: i32) -> !;
}

/// Before `main`: the first panic ends a mutant, or time does.
extern "C" fn start() {
    let number = |name| env::var(name).ok().map(|text| text.parse().unwrap());
    if let Some(mutant) = number("MUTANT") {
        CHOSEN.store(mutant, Relaxed);
        unsafe { alarm(number("SECONDS").unwrap() as u32) };
        panic::set_hook(Box::new(|_| unsafe { _exit(101) }));
    } else if env::var_os("REACHED").is_some() {
        CHOSEN.store(REACH, Relaxed);
        unsafe { atexit(tell) };
    }
}

extern "C" fn tell() {
    let reached = (0..MUTANTS).filter(|place| REACHED[*place].load(Relaxed));
    let text: String = reached.map(|place| format!("{place}\n")).collect();
    fs::write(env::var_os("REACHED").unwrap(), text).unwrap();
}

#[used]
#[unsafe(link_section = ".init_array")]
static START: extern "C" fn() = start;
