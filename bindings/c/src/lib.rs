//! terrella for C: names, pointers and status codes, and no arithmetic.
//!
//! | file | what is in it |
//! |---|---|
//! | `status` | the number of each refusal, and its text |
//! | `handle` | objects in the caller's memory, and what a pointer may be: all the `unsafe` there is |
//! | `ellipsoid`, `geodesic`, `area`, `route`, `frame`, `cube`, `tile` | the functions, by room |
//! | `batch` | the same over arrays |
//!
//! `terrella.h` is made from these files by `./header`.

#![cfg_attr(not(feature = "std"), no_std)]
#![allow(non_camel_case_types)] // the types' names are C's

mod area;
mod batch;
mod cube;
mod ellipsoid;
mod frame;
mod geodesic;
mod handle;
mod route;
mod status;
mod tile;
mod version;

#[cfg(all(not(feature = "std"), not(test)))]
#[panic_handler]
fn nothing_panics(_: &core::panic::PanicInfo) -> ! {
    loop {}
}
