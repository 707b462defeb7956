//! Calls every function once, with arguments and results that the compiler cannot see through. Not to be run: `run` looks for what
//! panics in the linked images. They differ in where they begin alone, so that the functions are compiled once.

#![no_std]

use core::hint::black_box;
use core::panic::PanicInfo;

use calls::{Arguments, Bits, Function, Hash, Scalar, Visitor};

struct Link(Hash);

impl Visitor for Link {
    fn visit<T: Scalar, I: Copy, O: Bits>(
        &mut self,
        _: Function,
        draw: impl Fn(&mut Arguments) -> I,
        call: impl Fn(I) -> O,
    ) {
        let input = black_box(draw(&mut Arguments::with_limits()));
        black_box(call(input)).add_to(&mut self.0);
    }
}

/// Every function in one scalar.
#[inline(never)]
fn every<T: Scalar>() -> i32 {
    let mut link = Link(Hash::default());
    calls::every_in::<T, _>(&mut link);
    link.0.value() as i32
}

/// Every function in `f32`.
#[inline(never)]
pub fn single() -> i32 {
    every::<f32>()
}

/// Every function in both scalars.
#[inline(never)]
pub fn both() -> i32 {
    #[cfg(feature = "planted")]
    black_box(terrella_is_fine(black_box(7)));
    every::<f64>() ^ single()
}

#[cfg(feature = "planted")]
fn terrella_is_fine(index: usize) -> u8 {
    [1, 2, 3][index]
}

// What copies memory there.
#[cfg(not(target_os = "none"))]
#[link(name = "c")]
unsafe extern "C" {}

/// The precompiled `core` names it in tables for unwinding, which are not used.
#[cfg(not(target_os = "none"))]
#[unsafe(no_mangle)]
extern "C" fn rust_eh_personality() {}

#[panic_handler]
fn panic(_: &PanicInfo) -> ! {
    loop {}
}
