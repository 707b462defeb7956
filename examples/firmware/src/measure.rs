//! Each function: a hash of what it gives, the instructions and the stack of a call.

use core::hint::black_box;

use calls::{Arguments, Bits, Function, Scalar, Visitor};
use cortex_m_semihosting::hprintln;

use crate::stack::{DEPTH, depth};
use crate::timer::Timer;

/// Calls that are measured, of ordinary arguments.
const CALLS: u32 = 16;

/// Prints a line for each function.
pub struct Measure {
    timer: Timer,
    /// What calling costs.
    instructions: u32,
    stack: usize,
    /// Whether a call went deeper than is looked at.
    pub too_deep: bool,
}

impl Measure {
    pub fn new() -> Self {
        let timer = Timer::start();
        let mut nothing = || {
            black_box(());
        };
        Self {
            instructions: timer.instructions(&mut nothing),
            stack: depth(&mut nothing),
            timer,
            too_deep: false,
        }
    }
}

impl Visitor for Measure {
    fn visit<T: Scalar, I: Copy, O: Bits>(
        &mut self,
        function: Function,
        draw: impl Fn(&mut Arguments) -> I,
        call: impl Fn(I) -> O,
    ) {
        let hash = function.hash(&draw, &call);
        let calls = CALLS.min(function.number_of_calls() as u32);
        let mut arguments = Arguments::new();
        let (mut instructions, mut stack) = (0, 0);
        for _ in 0..calls {
            let input = draw(&mut arguments);
            let mut once = || {
                black_box(call(black_box(input)));
            };
            stack = depth(&mut once).max(stack);
            instructions += u64::from(self.timer.instructions(&mut once) - self.instructions);
        }
        self.too_deep |= stack == DEPTH;
        let (mean, stack) = (instructions / u64::from(calls), stack - self.stack);
        hprintln!("{}\t{}\t{:016x}\t{}\t{}", function, T::NAME, hash, mean, stack);
    }
}
