//! A line for each function and scalar: its name, the scalar and a hash of what it gives for fixed arguments.

#[cfg(target_family = "wasm")]
mod wasm;

use calls::{Arguments, Bits, Function, Scalar, Visitor};

struct Lines<F>(F);

impl<F: FnMut(&str)> Visitor for Lines<F> {
    fn visit<T: Scalar, I: Copy, O: Bits>(
        &mut self,
        function: Function,
        draw: impl Fn(&mut Arguments) -> I,
        call: impl Fn(I) -> O,
    ) {
        let hash = function.hash(draw, call);
        (self.0)(&format!("{function}\t{}\t{hash:016x}", T::NAME));
    }
}

/// Hands on the lines.
pub fn lines(print: impl FnMut(&str)) {
    calls::every(&mut Lines(print));
}
