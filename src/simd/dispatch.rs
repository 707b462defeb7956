//! Chooses the machine's widest instructions at run time. Besides `math/sqrt.rs` this is the only file with
//! `unsafe`.
#![allow(unsafe_code)]

/// A loop over slices, as a value that holds the slices.
///
/// [`run`](Self::run) must be `#[inline(always)]`, and so must everything that it calls in the loop: it is
/// then compiled once for each instruction set. Wider instructions only process more elements at a time; none
/// of them contracts a product and a sum, so the results have the same bits.
pub(crate) trait Pass {
    /// The result of the loop.
    type Output;

    /// Runs the loop.
    fn run(self) -> Self::Output;
}

/// Runs a pass with the widest instructions that this machine has.
#[cfg(avx2)]
pub(crate) fn dispatch<P: Pass>(pass: P) -> P::Output {
    #[cfg(avx512)]
    if std::is_x86_feature_detected!("avx512f")
        && std::is_x86_feature_detected!("avx512bw")
        && std::is_x86_feature_detected!("avx512dq")
        && std::is_x86_feature_detected!("avx512vl")
    {
        // SAFETY: the machine has what the function is compiled for.
        return unsafe { avx512(pass) };
    }
    if std::is_x86_feature_detected!("avx2") {
        // SAFETY: as above.
        unsafe { avx2(pass) }
    } else {
        pass.run()
    }
}

/// Runs a pass with the instructions that the crate is compiled for.
#[cfg(not(avx2))]
pub(crate) fn dispatch<P: Pass>(pass: P) -> P::Output {
    pass.run()
}

#[cfg(avx512)]
#[target_feature(enable = "avx512f,avx512bw,avx512dq,avx512vl")]
unsafe fn avx512<P: Pass>(pass: P) -> P::Output {
    pass.run()
}

#[cfg(avx2)]
#[target_feature(enable = "avx2")]
unsafe fn avx2<P: Pass>(pass: P) -> P::Output {
    pass.run()
}
