//! What the npm package calls in WebAssembly: names and arrays, no arithmetic.
//!
//! | file | what is in it |
//! |---|---|
//! | `columns` | arrays on their way in and out |
//! | `current` | the object that calls are about |
//! | `refusal` | words of errors on their way out |
//! | the others | the functions of the package's entry of that name |

// Each module of WebAssembly uses a part of what they share; with all features nothing may be unused.
#![cfg_attr(
    not(all(
        feature = "area",
        feature = "cube",
        feature = "geodesic",
        feature = "position",
        feature = "terrain"
    )),
    allow(dead_code, unused_imports)
)]

mod columns;
mod current;
mod refusal;

#[cfg(feature = "area")]
mod area;
#[cfg(feature = "cube")]
mod cube;
#[cfg(feature = "geodesic")]
mod geodesic;
#[cfg(feature = "position")]
mod position;
#[cfg(feature = "terrain")]
mod terrain;
