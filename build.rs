//! Tells the library whether it is compiled for size (`opt-level = "s"` or `"z"`): then its larger kernels are linked once, and not
//! inlined wherever they are called.

fn main() {
    println!("cargo::rerun-if-changed=build.rs");
    println!("cargo::rustc-check-cfg=cfg(small)");
    if matches!(std::env::var("OPT_LEVEL").as_deref(), Ok("s" | "z")) {
        println!("cargo::rustc-cfg=small");
    }
}
