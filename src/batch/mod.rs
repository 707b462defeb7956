//! Functions of the other modules over slices: several points at a time, with the same bits as one by one.
//!
//! Each component of the input is a slice, and each component of the result is written to a slice of the
//! caller. Nothing is allocated. Modules and functions have the names of those that they repeat:
//!
//! | over slices | one by one |
//! |---|---|
//! | [`position::to_direction`] | [`LatLon::to_direction`](crate::LatLon::to_direction) |
//! | [`position::to_lat_lon`] | [`Direction::to_lat_lon`](crate::Direction::to_lat_lon) |
//! | [`latitude::to_direction`] | [`Shifted::to_direction`](crate::Shifted::to_direction) |
//! | [`latitude::to_lat_lon`] | [`Shifted::to_lat_lon`](crate::Shifted::to_lat_lon) |
//! | [`latitude::degrees`] | [`Conversion::degrees`](crate::latitude::Conversion::degrees) |
//! | [`latitude::radians`] | [`Conversion::radians`](crate::latitude::Conversion::radians) |
//! | [`ellipsoid::to_ecef`] | [`Ellipsoid::to_ecef`](crate::Ellipsoid::to_ecef) |
//! | [`ellipsoid::to_geodetic`] | [`Ellipsoid::to_geodetic`](crate::Ellipsoid::to_geodetic) |
//! | [`geodesic::inverse`] | [`Geodesic::inverse`](crate::geodesic::Geodesic::inverse) |
//! | [`geodesic::direct`] | [`Geodesic::direct`](crate::geodesic::Geodesic::direct) |
//! | [`cube::project`] | [`CubeProjection::project`](crate::cube::CubeProjection::project) |
//! | [`cube::unproject`] | [`CubeProjection::unproject`](crate::cube::CubeProjection::unproject) |
//! | [`map::project`] | [`CubeMap::project`](crate::cube::CubeMap::project) |
//! | [`map::unproject`] | [`CubeMap::unproject`](crate::cube::CubeMap::unproject) |
//!
//! Every element passes the constructor of its type, as in `LatLon::new(lat, lon)`: longitudes are brought
//! into [−180, 180], and vectors of any length are normalised. A batch is fastest if all longitudes are in
//! [−180, 180] and all vectors are unit vectors; otherwise it takes longer by about the time of the
//! constructors.
//!
//! A batch is refused with [`InvalidBatch`] if slices have unequal lengths, or a constructor refuses an
//! element. Nothing is written then. ([`geodesic::inverse`] may also find pairs of places without an answer,
//! after it has written the others.)
//!
//! A call takes up to 19 kB of stack in `f64`, and half of that in `f32` (measured on a Cortex-M).
//!
//! On x86-64 with the feature `std`, batches use AVX-512 or AVX2 if the machine has them. Elsewhere they use
//! the instructions that the crate is compiled for (SSE2, NEON, wasm's `simd128`).
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

/// Why a batch was refused.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum InvalidBatch<E> {
    /// A slice does not have the length of the first.
    Lengths {
        /// The length of the first slice.
        first: usize,
        /// The length of the slice that differs.
        other: usize,
    },
    /// An element was refused: the first of them.
    Element {
        /// The index of the element in the slices.
        index: usize,
        /// Why it was refused.
        why: E,
    },
}

impl<E: fmt::Display> fmt::Display for InvalidBatch<E> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Lengths { first, other } => write!(f, "expected slices of {first} elements, got {other}"),
            Self::Element { index, why } => write!(f, "element {index}: {why}"),
        }
    }
}

impl<E: fmt::Debug + fmt::Display> core::error::Error for InvalidBatch<E> {}

/// Returns an error unless all slices have the length of the first.
pub(crate) fn same_length<E>(first: usize, others: &[usize]) -> Result<(), InvalidBatch<E>> {
    match others.iter().find(|&&other| other != first) {
        Some(&other) => Err(InvalidBatch::Lengths { first, other }),
        None => Ok(()),
    }
}
