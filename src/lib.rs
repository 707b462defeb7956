//! terrella
#![cfg_attr(not(feature = "std"), no_std)]

pub mod cube;
mod ellipsoid;
mod interop;
pub mod latitude;
pub mod math;
mod position;
mod real;

pub use ellipsoid::{Ellipsoid, InvalidEllipsoid, NAMED};
pub use latitude::{Latitude, Shift, Shifted};
pub use position::{Direction, InvalidDirection, InvalidLatLon, LatLon};
pub use real::Real;
