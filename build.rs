//! Tells the library two things: whether it is compiled for size (`opt-level = "s"` or `"z"`), where its larger kernels are
//! linked once and not inlined wherever they are called; and whether the compiler knows AVX-512, which is from Rust 1.89.

use std::process::Command;

fn main() {
    println!("cargo::rerun-if-changed=build.rs");
    println!("cargo::rustc-check-cfg=cfg(small)");
    println!("cargo::rustc-check-cfg=cfg(avx512)");
    if matches!(std::env::var("OPT_LEVEL").as_deref(), Ok("s" | "z")) {
        println!("cargo::rustc-cfg=small");
    }
    if minor_version().is_some_and(|minor| minor >= 89) {
        println!("cargo::rustc-cfg=avx512");
    }
}

/// The 89 of "rustc 1.89.0 (…)"; none if the compiler does not say.
fn minor_version() -> Option<u32> {
    let rustc = std::env::var_os("RUSTC")?;
    let said = Command::new(rustc).arg("--version").output().ok()?;
    let version = String::from_utf8(said.stdout).ok()?;
    version.split('.').nth(1)?.parse().ok()
}
