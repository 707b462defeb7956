//! The square root without `std`: an instruction where the processor is known to have one, else the `libm`
//! crate's routine.
#![allow(unsafe_code)]

/// Correctly rounded, as every square root here.
#[cfg(all(target_arch = "arm", target_abi = "eabihf"))]
#[inline(always)]
pub(crate) fn sqrt_f32(x: f32) -> f32 {
    let root: u32;
    // SAFETY: the hard-float calling convention presumes a floating-point unit, and each has this
    // instruction; no memory is touched. Through core registers, as rustc knows of no others on these
    // targets.
    unsafe {
        core::arch::asm!(
            "vmov s0, {x}",
            "vsqrt.f32 s0, s0",
            "vmov {root}, s0",
            x = in(reg) x.to_bits(),
            root = lateout(reg) root,
            out("s0") _,
            options(pure, nomem, nostack, preserves_flags)
        );
    }
    f32::from_bits(root)
}

/// Correctly rounded, as every square root here.
#[cfg(not(all(target_arch = "arm", target_abi = "eabihf")))]
#[inline(always)]
pub(crate) fn sqrt_f32(x: f32) -> f32 {
    libm::sqrtf(x)
}
