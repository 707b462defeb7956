//! Prints a line for each function and scalar: its name, the scalar and a hash of what it gives for fixed arguments; on standard error, the widest instructions that batches may use.

fn main() {
    calls::hashes(|function, scalar, hash| println!("{function}\t{scalar}\t{hash:016x}"));
    eprintln!("{}", widest());
}

#[cfg(all(feature = "std", target_arch = "x86_64"))]
fn widest() -> &'static str {
    if is_x86_feature_detected!("avx512f") {
        "AVX-512"
    } else if is_x86_feature_detected!("avx2") {
        "AVX2"
    } else {
        "SSE2"
    }
}

#[cfg(not(all(feature = "std", target_arch = "x86_64")))]
fn widest() -> &'static str {
    "as compiled"
}
