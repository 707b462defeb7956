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
//! | [`ellipsoid::second_order`] | [`GeodeticSeries::second_order`](crate::GeodeticSeries::second_order) |
//! | [`ellipsoid::third_order`] | [`GeodeticSeries::third_order`](crate::GeodeticSeries::third_order) |
//! | [`ellipsoid::fourth_order`] | [`GeodeticSeries::fourth_order`](crate::GeodeticSeries::fourth_order) |
//! | [`frame::to_enu`] | [`LocalFrame::to_enu`](crate::LocalFrame::to_enu) |
//! | [`frame::to_ned`] | [`LocalFrame::to_ned`](crate::LocalFrame::to_ned) |
//! | [`frame::to_aer`] | [`LocalFrame::to_aer`](crate::LocalFrame::to_aer) |
//! | [`frame::from_enu`] | [`LocalFrame::from_enu`](crate::LocalFrame::from_enu) |
//! | [`frame::from_ned`] | [`LocalFrame::from_ned`](crate::LocalFrame::from_ned) |
//! | [`frame::from_aer`] | [`LocalFrame::from_aer`](crate::LocalFrame::from_aer) |
//! | [`frame::geodetic_to_enu`] | [`LocalFrame::geodetic_to_enu`](crate::LocalFrame::geodetic_to_enu) |
//! | [`frame::geodetic_to_ned`] | [`LocalFrame::geodetic_to_ned`](crate::LocalFrame::geodetic_to_ned) |
//! | [`frame::geodetic_to_aer`] | [`LocalFrame::geodetic_to_aer`](crate::LocalFrame::geodetic_to_aer) |
//! | [`frame::enu_to_geodetic`] | [`LocalFrame::enu_to_geodetic`](crate::LocalFrame::enu_to_geodetic) |
//! | [`frame::ned_to_geodetic`] | [`LocalFrame::ned_to_geodetic`](crate::LocalFrame::ned_to_geodetic) |
//! | [`frame::aer_to_geodetic`] | [`LocalFrame::aer_to_geodetic`](crate::LocalFrame::aer_to_geodetic) |
//! | [`frame::enu_to_offset`] | [`LocalFrame::enu_to_offset`](crate::LocalFrame::enu_to_offset) |
//! | [`frame::offset_to_enu`] | [`LocalFrame::offset_to_enu`](crate::LocalFrame::offset_to_enu) |
//! | [`frame::vector_to_enu`] | [`LocalFrame::vector_to_enu`](crate::LocalFrame::vector_to_enu) |
//! | [`frame::vector_from_enu`] | [`LocalFrame::vector_from_enu`](crate::LocalFrame::vector_from_enu) |
//! | [`geodesic::inverse`] | [`Geodesic::inverse`](crate::geodesic::Geodesic::inverse) |
//! | [`geodesic::inverse_from`], [`geodesic::inverse_to`] | the same, from or to one place |
//! | [`geodesic::distance`] | [`Geodesic::distance`](crate::geodesic::Geodesic::distance) |
//! | [`geodesic::distance_from`], [`geodesic::distance_to`] | the same, from or to one place |
//! | [`geodesic::legs`] | the same, from each place to the next |
//! | [`geodesic::direct`] | [`Geodesic::direct`](crate::geodesic::Geodesic::direct) |
//! | [`geodesic::direct_from`] | the same, from one place at one azimuth |
//! | [`geodesic::along`] | [`Line::at`](crate::geodesic::Line::at) |
//! | [`geodesic::intermediate`] | `intermediate` of [`GreatCircle`](crate::geodesic::GreatCircle), by any method |
//! | [`geodesic::tracks`] | `along_track`, `cross_track` of [`GreatCircle`](crate::geodesic::GreatCircle) |
//! | [`geodesic::leg_tracks`] | the same, beside each leg of a path |
//! | [`cube::project`] | [`CubeProjection::project`](crate::cube::CubeProjection::project) |
//! | [`cube::unproject`] | [`CubeProjection::unproject`](crate::cube::CubeProjection::unproject) |
//! | [`map::project`] | [`CubeMap::project`](crate::cube::CubeMap::project) |
//! | [`map::unproject`] | [`CubeMap::unproject`](crate::cube::CubeMap::unproject) |
//! | [`area::polygons`] | [`PolygonArea`](crate::geodesic::PolygonArea) |
//! | [`area::fields`] | [`PlanarPolygon`](crate::geodesic::PlanarPolygon) |
//! | [`healpix::containing`] | [`OnEllipsoid::containing`](crate::healpix::OnEllipsoid::containing) |
//! | [`healpix::centre`] | [`OnEllipsoid::centre`](crate::healpix::OnEllipsoid::centre) |
//! | [`route::rhumb_inverse`], [`route::rhumb_area`] | [`Rhumb::inverse`](crate::route::Rhumb::inverse) |
//! | [`route::rhumb_direct`] | [`Rhumb::direct`](crate::route::Rhumb::direct) |
//! | [`route::closest`] | [`Legs::closest`](crate::route::Legs::closest) |
//! | [`route::tracks`] | [`Legs::track`](crate::route::Legs::track) |
//! | [`route::leg_closest`], [`route::leg_tracks`] | the same, of and beside each leg of a path |
//! | [`route::sides`] | [`Fence::side`](crate::route::Fence::side) |
//! | [`route::distances`] | [`Fence::distance`](crate::route::Fence::distance) |
//! | [`route::of_segments`] | [`Intersections::of_segments`](crate::route::Intersections::of_segments) |
//! | [`terrain::containing`] | [`Tile::containing`](crate::terrain::Tile::containing) |
//! | [`terrain::to_key`], [`terrain::from_key`] | [`Key`](crate::terrain::Key) of a tile, and back |
//! | [`terrain::places_to_key`], [`terrain::directions_to_key`] | the same, of the tile that contains a place |
//! | [`terrain::s2_leaf`] | [`Key::s2_leaf_of`](crate::terrain::Key::s2_leaf_of) |
//! | [`terrain::sample_places`] | [`Tile::node`](crate::terrain::Tile::node), on the ground |
//! | [`terrain::sample_directions`] | the same, as unit vectors |
//! | [`scene::inverse`], [`scene::direct`] | [`AnyMethod`](crate::geodesic::AnyMethod) of a scene |
//! | [`scene::enu`] | [`AnyView::enu`](crate::scene::AnyView::enu) |
//! | [`scene::to_geodetic`] | [`AnyOrder::to_geodetic`](crate::scene::AnyOrder::to_geodetic) |
//! | [`scene::areas`] | [`AnyArea::area`](crate::scene::AnyArea::area) |
//!
//! Every element passes the constructor of its type, as in `LatLon::new(lat, lon)`: longitudes are brought
//! into [−180, 180], and vectors of any length are normalised, many at a time as well.
//!
//! **Bad elements.** A batch writes all that it can. If a constructor or the method refuses an element, its
//! results are NaN, its face is [`Front`](crate::cube::Face::Front), whole numbers are 0, and the call
//! returns [`InvalidBatch::Elements`] with the number of such elements, the index of the first, and why it
//! was refused. So a missing value among a billion costs its own row only: a caller who expects some ignores
//! this error, and `?` stops at it. If slices have unequal lengths, nothing is written
//! ([`InvalidBatch::Lengths`]).
//!
//! ```
//! use terrella::batch::{InvalidBatch, position};
//! let (mut x, mut y, mut z) = ([0.0; 3], [0.0; 3], [0.0; 3]);
//! let places: [&[f64]; 2] = [&[0.0, f64::NAN, 90.0], &[450.0, 0.0, 0.0]];
//! match position::to_direction(places, [&mut x, &mut y, &mut z]) {
//!     Ok(()) => println!("all places are written"),
//!     Err(InvalidBatch::Elements { count, first, why }) => println!("{count} refused, {first} first: {why}"),
//!     Err(lengths) => return Err(lengths.into()),
//! }
//! assert!(y[0] == 1.0 && y[1].is_nan() && z[2] == 1.0);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! **Lengths.** Elements go through vectors in blocks of 64. The last ones are filled up to a multiple of 16,
//! and fewer than 4 are computed one by one. On a machine without vectors (a microcontroller), and in a
//! program that is compiled for size, a batch is a loop over the function that takes one element: it takes
//! that function's stack and flash. With vectors, a call takes up to 44 kB of stack in `f64` (measured with
//! AVX-512, for rings of geodesics; 36 kB for geodesics, maps and Earth-centred coordinates).
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

pub mod area;
pub mod cube;
pub mod ellipsoid;
mod engine;
mod face_mask;
mod face_number;
pub mod frame;
pub mod geodesic;
pub mod grid;
pub mod healpix;
pub mod latitude;
pub mod map;
pub mod position;
pub mod route;
pub mod scene;
pub mod terrain;

pub use face_number::FaceNumber;

/// What is wrong with a batch.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum InvalidBatch<E> {
    /// A slice does not have the length of the first. Nothing was written.
    Lengths {
        /// The length of the first slice.
        first: usize,
        /// The length of the slice that differs.
        other: usize,
    },
    /// Elements were refused. Their results are NaN, whole numbers 0, and all others are written.
    Elements {
        /// How many were refused.
        count: usize,
        /// The index of the first in the slices.
        first: usize,
        /// Why the first was refused.
        why: E,
    },
}

impl<E> InvalidBatch<E> {
    /// The same with another reason.
    fn map<O>(self, reason: impl FnOnce(E) -> O) -> InvalidBatch<O> {
        match self {
            Self::Lengths { first, other } => InvalidBatch::Lengths { first, other },
            Self::Elements { count, first, why } => InvalidBatch::Elements {
                count,
                first,
                why: reason(why),
            },
        }
    }
}

impl<E: fmt::Display> fmt::Display for InvalidBatch<E> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Lengths { first, other } => write!(f, "expected slices of {first} elements, got {other}"),
            Self::Elements { count: 1, first, why } => write!(f, "element {first}: {why}"),
            Self::Elements { count, first, why } => {
                write!(f, "{count} elements are refused; the first is element {first}: {why}")
            }
        }
    }
}

impl<E: fmt::Debug + fmt::Display> core::error::Error for InvalidBatch<E> {}
