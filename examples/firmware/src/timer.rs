//! Counts instructions by a timer: under `-icount shift=6` QEMU lets each take 64 ns, and the boards' timer 0 counts down at 25 MHz.

const TIMER: *mut u32 = 0x4000_0000 as *mut u32;
const VALUE: usize = 1;
const RELOAD: usize = 2;

/// A running timer.
pub struct Timer(());

impl Timer {
    /// Starts it.
    pub fn start() -> Self {
        // SAFETY: the registers of CMSDK timer 0 on both boards; nothing else uses them.
        unsafe {
            TIMER.add(RELOAD).write_volatile(u32::MAX);
            TIMER.add(VALUE).write_volatile(u32::MAX);
            TIMER.write_volatile(1);
        }
        Self(())
    }

    fn now(&self) -> u32 {
        // SAFETY: as above.
        unsafe { TIMER.add(VALUE).read_volatile() }
    }

    /// The instructions of a call, and those of calling.
    #[inline(never)]
    pub fn instructions(&self, call: &mut dyn FnMut()) -> u32 {
        let before = self.now();
        call();
        let ticks = before.wrapping_sub(self.now());
        // 64 ns over 40 ns.
        ((u64::from(ticks) * 5 + 4) / 8) as u32
    }
}
