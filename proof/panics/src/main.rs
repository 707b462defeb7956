//! Calls every function once, with arguments and results that the compiler cannot see through. Not to be run: `run` looks for what
//! panics in the linked image.

#![no_std]
#![no_main]

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

/// Where the image begins, on a microcontroller and on Linux.
#[cfg_attr(target_os = "none", unsafe(export_name = "_start"))]
#[cfg_attr(not(target_os = "none"), unsafe(export_name = "main"))]
extern "C" fn start() -> i32 {
    let mut link = Link(Hash::default());
    if !cfg!(feature = "single") {
        calls::every_in::<f64, _>(&mut link);
    }
    calls::every_in::<f32, _>(&mut link);
    #[cfg(feature = "planted")]
    black_box(terrella_is_fine(black_box(7)));
    link.0.value() as i32
}

#[cfg(feature = "planted")]
fn terrella_is_fine(index: usize) -> u8 {
    [1, 2, 3][index]
}

#[panic_handler]
fn panic(_: &PanicInfo) -> ! {
    loop {}
}
