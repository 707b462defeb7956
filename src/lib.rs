//! A little Earth: from latitude and longitude on an ellipsoid to a sphere, and on to the faces of a cube and back; distances and
//! destinations by every usual method; Earth-centred and local frames.
//!
//! ```text
//! LatLon ──shift──▶ Direction ──project──▶ FacePoint
//! (degrees on       (unit vector,          (face, x, y)
//!  the ellipsoid)    Earth axes)
//!
//! LatLon, LatLon ──geodesic──▶ distance, azimuths     Geodetic ──▶ Ecef ──▶ Enu, Ned, Aer
//! ```
//!
//! `no_std`, without allocation, generic over `f32` and `f64`, from `+ − × ÷ √` alone: the same input gives the same bits on every machine. What
//! can be wrong is refused by a constructor with an error that carries the value; past that nothing fails.
//!
//! | room | what is in it |
//! |---|---|
//! | [`LatLon`], [`Direction`], [`Geodetic`], [`Ecef`] | where something is |
//! | [`Ellipsoid`] | the size and shape of a planet; [`Geodetic`] to [`Ecef`] and back |
//! | [`LocalFrame`] | east, north, up about an origin; [`Enu`], [`Ned`], [`Aer`] |
//! | [`latitude`] | auxiliary latitudes; [`Shifted`], the step from ellipsoid to sphere |
//! | [`cube`] | faces, points on them, the projections; [`CubeMap`](cube::CubeMap) ties them to an ellipsoid |
//! | [`healpix`] | standard HEALPix on the sphere: nested pixels and the plane |
//! | [`geodesic`] | distances, azimuths, destinations and areas: nine methods behind one trait |
//! | [`distortion`] | what a projection does to shapes, areas and texels; surveys of whole faces |
//! | [`terrain`] | tiles of the faces: addresses, neighbours, keys, bounds, which of them a picture needs, and vertices in single precision |
//! | [`scene`] | the cheapest model that keeps a tolerance, with a bound |
//! | [`batch`] | the same functions over slices, as wide as the machine is |
//! | [`math`] | elementary functions of the scalar |
//! | [`Real`], [`Dual`] | the scalar, and the scalar that carries derivatives |
//!
//! ```
//! use terrella::cube::{CubeMap, Face, Projection};
//! use terrella::{Ellipsoid, LatLon, Shift};
//!
//! let map = CubeMap::new(Ellipsoid::<f64>::WGS84, Shift::Authalic, Projection::Vertex)?;
//! let quito = LatLon::new(-0.18, -78.47)?;
//! let point = map.project(quito);
//! assert_eq!(point.face(), Face::Left);
//! assert!((map.unproject(point).lon() - quito.lon()).abs() < 3e-14);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! Features: `std` (default) takes the hardware's square root and its widest instructions, with the same results;
//! `geo-types`, `glam`, `mint`, `nalgebra`, `num-traits`, `serde` and `defmt` add conversions and implementations of
//! traits. The README has the table of worst errors.

#![cfg_attr(not(feature = "std"), no_std)]

// Their registers are wider than the numbers: sums round twice, and the kernels' roundings and remainders are
// wrong.
#[cfg(any(all(target_arch = "x86", not(target_feature = "sse2")), target_arch = "m68k"))]
compile_error!(
    "terrella needs a processor that rounds each operation to the precision of its numbers: on 32-bit x86 one with SSE2 (i686, not i586), and none of the m68k family"
);

pub mod batch;
pub mod cube;
pub mod distortion;
mod dual;
mod ellipsoid;
pub mod frame;
pub mod geodesic;
pub mod healpix;
mod interop;
pub mod latitude;
pub mod math;
mod name;
mod position;
mod real;
pub mod scene;
mod simd;
pub mod terrain;

pub use dual::Dual;
pub use ellipsoid::{Ellipsoid, InvalidEllipsoid, NAMED, UnknownEllipsoid};
pub use frame::{Aer, Enu, LocalFrame, Ned};
pub use latitude::{Latitude, Shift, Shifted};
pub use position::{
    Direction, Dms, DmsLatLon, Ecef, Geodetic, InvalidDirection, InvalidEcef, InvalidHeight, InvalidLatLon, LatLon,
    ParseLatLonError,
};
pub use real::Real;

#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
