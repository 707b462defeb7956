//! Runs terrella on an emulated Cortex-M: its errors against a slice of the truth, then instructions, stack and a hash for each function.
//! Fails if an error is over what the README claims.

#![no_std]
#![no_main]

mod accuracy;
mod measure;
mod stack;
mod timer;
mod truth;

use core::panic::PanicInfo;

use cortex_m_rt::entry;
use cortex_m_semihosting::debug::{EXIT_FAILURE, EXIT_SUCCESS, exit};
use cortex_m_semihosting::hprintln;

#[entry]
fn main() -> ! {
    let kept = accuracy::all_kept();
    let mut measure = measure::Measure::new();
    hprintln!("function\tscalar\thash\tinstructions\tstack");
    calls::every(&mut measure);
    end(kept && !measure.too_deep)
}

fn end(well: bool) -> ! {
    loop {
        exit(if well { EXIT_SUCCESS } else { EXIT_FAILURE });
    }
}

#[panic_handler]
fn panic(why: &PanicInfo) -> ! {
    hprintln!("{}", why);
    end(false)
}
