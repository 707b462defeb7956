//! Measures how deep a call goes: the free stack is painted, and looked at afterwards.

use cortex_m::register::msp;

const PAINT: u32 = 0xa5c3_965a;

/// How far the stack is painted, in bytes.
pub const DEPTH: usize = 0x1_0000;

/// The bytes of stack that a call takes, its return address and those of calling included.
#[inline(never)]
pub fn depth(call: &mut dyn FnMut()) -> usize {
    let top = msp::read() as usize & !3;
    // SAFETY: below the stack pointer there is nothing but free memory, far more than is painted; no interrupt is enabled.
    unsafe {
        for address in (top - DEPTH..top).step_by(4) {
            (address as *mut u32).write_volatile(PAINT);
        }
    }
    call();
    // SAFETY: as above.
    let painted = |address: &usize| unsafe { (*address as *const u32).read_volatile() } == PAINT;
    let untouched = (top - DEPTH..top).step_by(4).take_while(painted).count();
    DEPTH - 4 * untouched
}
