//! The image of every function in `f32`.

#![no_std]
#![no_main]

/// Where the image begins, on a microcontroller and on Linux.
#[cfg_attr(target_os = "none", unsafe(export_name = "_start"))]
#[cfg_attr(not(target_os = "none"), unsafe(export_name = "main"))]
extern "C" fn start() -> i32 {
    panics::single()
}
