use std::hint::black_box;

/// Measurements in one scalar.
#[derive(Clone, Copy)]
pub struct Sweep(&'static str);

impl Sweep {
    pub fn of<T>() -> Self {
        Self(std::any::type_name::<T>())
    }

    /// Calls a function once for each input, and prints its name, the scalar and the number of calls.
    pub fn count<I: Copy, O>(self, name: &str, inputs: &[I], function: impl Fn(I) -> O) {
        println!("{name}\t{}\t{}", self.0, inputs.len());
        let call = |index: usize| {
            black_box(function(inputs[index]));
        };
        counted_by_callgrind(inputs.len(), black_box(&call));
    }
}

/// Callgrind counts what happens in here. One loop for all: the compiler can neither merge nor hoist what it calls.
#[inline(never)]
fn counted_by_callgrind(calls: usize, call: &dyn Fn(usize)) {
    for index in 0..calls {
        call(index);
    }
}
