//! Tells the library what it is compiled for.
//!
//! * `small`: for size (`opt-level = "s"` or `"z"`). Its larger kernels are then linked once, and not inlined.
//! * `lanes`: for a machine with vectors, and not for size. Elsewhere a batch is a loop over one by one.
//! * `avx2`, `avx512`: loops over slices are compiled for these instructions too, and the machine chooses at run
//!   time. Not below `opt-level = 2`: there nothing is fast, and each loop would be compiled three times. AVX-512
//!   needs Rust 1.89.

use std::env::{var, var_os};
use std::process::Command;

/// The features that mean vectors of floating-point numbers, of all machines.
const VECTORS: [&str; 8] = ["sse2", "neon", "simd128", "v", "vsx", "vector", "lsx", "msa"];

fn main() {
    println!("cargo::rerun-if-changed=build.rs");
    for name in ["small", "lanes", "avx2", "avx512"] {
        println!("cargo::rustc-check-cfg=cfg({name})");
    }
    let level = var("OPT_LEVEL").unwrap_or_default();
    let features = var("CARGO_CFG_TARGET_FEATURE").unwrap_or_default();
    if matches!(level.as_str(), "s" | "z") {
        println!("cargo::rustc-cfg=small");
    } else if features.split(',').any(|feature| VECTORS.contains(&feature)) {
        println!("cargo::rustc-cfg=lanes");
    }
    let chooses = var_os("CARGO_FEATURE_STD").is_some() && var("CARGO_CFG_TARGET_ARCH").as_deref() == Ok("x86_64");
    if chooses && !matches!(level.as_str(), "0" | "1") {
        println!("cargo::rustc-cfg=avx2");
        if minor_version().is_some_and(|minor| minor >= 89) {
            println!("cargo::rustc-cfg=avx512");
        }
    }
}

/// The 89 of "rustc 1.89.0 (…)"; none if the compiler does not say.
fn minor_version() -> Option<u32> {
    let rustc = var_os("RUSTC")?;
    let said = Command::new(rustc).arg("--version").output().ok()?;
    let version = String::from_utf8(said.stdout).ok()?;
    version.split('.').nth(1)?.parse().ok()
}
