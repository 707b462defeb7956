//! Prints a hash for every function; on standard error, the widest instructions that batches may use.

fn main() {
    bits::lines(|line| println!("{line}"));
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
