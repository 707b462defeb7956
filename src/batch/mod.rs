//! The functions of the other rooms over slices: as many points at a time as the machine's widest instructions hold, with the same
//! bits as one by one.
//!
//! A slice for each component, the results into the caller's slices, nothing allocated. The modules are those of the crate, the
//! functions are named as the ones they repeat:
//!
//! | over slices | one by one |
//! |---|---|
//! | [`position::to_direction`], [`position::to_lat_lon`] | [`LatLon::to_direction`](crate::LatLon::to_direction), [`Direction::to_lat_lon`](crate::Direction::to_lat_lon) |
//! | [`latitude::to_direction`], [`latitude::to_lat_lon`] | [`Shifted::to_direction`](crate::Shifted::to_direction), [`Shifted::to_lat_lon`](crate::Shifted::to_lat_lon) |
//! | [`latitude::degrees`], [`latitude::radians`] | [`Conversion::degrees`](crate::latitude::Conversion::degrees), [`Conversion::radians`](crate::latitude::Conversion::radians) |
//! | [`ellipsoid::to_ecef`], [`ellipsoid::to_geodetic`] | [`Ellipsoid::to_ecef`](crate::Ellipsoid::to_ecef), [`Ellipsoid::to_geodetic`](crate::Ellipsoid::to_geodetic) |
//! | [`geodesic::inverse`], [`geodesic::direct`] | [`Geodesic::inverse`](crate::geodesic::Geodesic::inverse), [`Geodesic::direct`](crate::geodesic::Geodesic::direct) |
//! | [`cube::project`], [`cube::unproject`] | [`CubeProjection::project`](crate::cube::CubeProjection::project), [`CubeProjection::unproject`](crate::cube::CubeProjection::unproject) |
//! | [`map::project`], [`map::unproject`] | [`CubeMap::project`](crate::cube::CubeMap::project), [`CubeMap::unproject`](crate::cube::CubeMap::unproject) |
//!
//! What the one-by-one function takes is built from the components as its constructor does it: vectors of any length are normalised,
//! longitudes wrapped. What the constructor refuses, and slices of unequal lengths, are an [`InvalidBatch`], found before anything is
//! written. Unit vectors, and longitudes in [−180, 180], are what the fast path takes; others cost about as much more as the
//! constructor does.
//!
//! A call takes up to 19 kB of stack in `f64`, half of that in `f32` (measured on a Cortex-M).
//!
//! With feature `std` on x86-64, AVX-512 or AVX2 are used where the machine has them; elsewhere the instructions that the crate is
//! compiled for (SSE2, NEON, wasm's `simd128`).
//!
//! ```
//! use terrella::batch::cube;
//! use terrella::cube::{Face, Quadrilateralized};
//!
//! let (x, y, z) = ([1.0, 0.6], [0.0, 0.0], [0.0, -0.8]);
//! let (mut face, mut u, mut v) = ([Face::Front; 2], [0.0; 2], [0.0; 2]);
//! cube::project(Quadrilateralized, [&x, &y, &z], &mut face, [&mut u, &mut v])?;
//! assert_eq!(face, [Face::Front, Face::Bottom]);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

use core::fmt;

mod admit;
pub mod cube;
pub mod ellipsoid;
mod face_mask;
pub mod geodesic;
pub mod latitude;
pub mod map;
pub mod position;

/// Why a batch was refused; nothing was written.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum InvalidBatch<E> {
    /// Not all slices are as long as the first.
    Lengths {
        /// The length of the first slice.
        first: usize,
        /// The first other length.
        other: usize,
    },
    /// An element that the constructor of what it belongs to refuses: the first one.
    Element {
        /// Its place in the slices.
        index: usize,
        /// Why it is refused.
        why: E,
    },
}

impl<E: fmt::Display> fmt::Display for InvalidBatch<E> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Lengths { first, other } => write!(f, "slices of {first} and {other} elements"),
            Self::Element { index, why } => write!(f, "element {index}: {why}"),
        }
    }
}

impl<E: fmt::Debug + fmt::Display> core::error::Error for InvalidBatch<E> {}

/// Whether all slices are as long as the first.
pub(crate) fn same_length<E>(first: usize, others: &[usize]) -> Result<(), InvalidBatch<E>> {
    match others.iter().find(|&&other| other != first) {
        Some(&other) => Err(InvalidBatch::Lengths { first, other }),
        None => Ok(()),
    }
}
