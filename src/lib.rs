//! Geodesy and cube maps of the Earth, and of other planets, for programs from flight computers to browsers.
//!
//! terrella converts latitude and longitude on an ellipsoid to a sphere and to the faces of a cube, and back.
//! It computes distances, azimuths, destinations and areas, and converts positions between geodetic,
//! Earth-centred and local axes. It addresses terrain tiles on the faces, and selects those that a picture
//! needs.
//!
//! ```text
//! LatLon ──shift──▶ Direction ──project──▶ FacePoint ──quantise──▶ Tile
//! (degrees on       (unit vector,          (face, x, y)            (face, level,
//!  the ellipsoid)    Earth axes)                                    column, row)
//!
//! LatLon, LatLon ──geodesic──▶ distance, azimuths     Geodetic ──▶ Ecef ──▶ Enu, Ned, Aer
//! ```
//!
//! **A point of a cube map.** The authalic shift and an equal-area projection give cells of equal area on the
//! ellipsoid:
//!
//! ```
//! use terrella::cube::{CubeMap, Face, Vertex};
//! use terrella::{Ellipsoid, LatLon, Shift};
//!
//! let map = CubeMap::new(Ellipsoid::<f64>::WGS84, Shift::Authalic, Vertex)?;
//! let quito = LatLon::new(-0.18, -78.47)?;
//! let point = map.project(quito);
//! assert_eq!(point.face(), Face::Left);
//! assert!((map.unproject(point).lon() - quito.lon()).abs() < 3e-14);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! **A distance**, in metres, with the azimuth at the start in degrees clockwise from north:
//!
//! ```
//! use terrella::geodesic::{Geodesic, Karney};
//! use terrella::{Ellipsoid, LatLon};
//!
//! let earth = Karney::new(Ellipsoid::<f64>::WGS84)?;
//! let line = earth.inverse(LatLon::new(40.6, -73.8)?, LatLon::new(51.6, -0.5)?)?;
//! assert_eq!(format!("{:.3} m, {:.6}°", line.distance, line.azimuth1), "5551759.400 m, 51.198883°");
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! **A local frame.** Where does an antenna point to see an aircraft?
//!
//! ```
//! use terrella::{Ellipsoid, Geodetic, LatLon, LocalFrame};
//!
//! let antenna = Geodetic::new(LatLon::new(52.0, 8.0)?, 110.0)?;
//! let aircraft = Geodetic::new(LatLon::new(52.1, 8.3)?, 10_000.0)?;
//! let seen = LocalFrame::new(Ellipsoid::<f64>::WGS84, antenna).geodetic_to_aer(aircraft);
//! assert_eq!(format!("{seen:.1}"), "azimuth 61.5°, elevation 22.8°, range 25417.3 m");
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # Rooms
//!
//! | room | what is in it |
//! |---|---|
//! | [`LatLon`], [`Geodetic`] | latitude and longitude in degrees, without and with a height in metres |
//! | [`Ecef`], [`Direction`] | Earth-centred coordinates in metres, and unit vectors in the same axes |
//! | [`Ellipsoid`] | the size and shape of a planet; [`Geodetic`] to [`Ecef`] and back |
//! | [`LocalFrame`], [`frame`] | the axes east, north and up about an origin; [`Enu`], [`Ned`], [`Aer`] |
//! | [`latitude`] | auxiliary latitudes; [`Shifted`], the step from the ellipsoid to the sphere |
//! | [`cube`] | [`CubeMap`](cube::CubeMap), the projections, and the faces of the cube with their points |
//! | [`healpix`] | standard HEALPix: pixels and the plane, on the sphere and on an ellipsoid |
//! | [`geodesic`] | distances, azimuths, destinations and areas, all methods behind one trait |
//! | [`route`] | closest points, intersections, rhumb lines, rings and fences |
//! | [`grid`] | transverse Mercator, UTM, UPS, MGRS and other grids; their text |
//! | [`distortion`] | how a projection distorts shapes, areas and texels, at a point and over whole faces |
//! | [`terrain`] | tiles of the faces: addresses, neighbours, bounds, selection, vertices in `f32` |
//! | [`scene`] | the cheapest method, scalar or level of tiles that keeps your tolerance |
//! | [`batch`] | the same functions over slices, several points at a time |
//! | [`math`] | elementary functions for every scalar |
//! | [`Real`], [`Dual`] | the trait of scalars, and the scalar that carries derivatives |
//!
//! # Conventions
//!
//! Latitude comes before longitude. Both are in degrees, as are azimuths, which run clockwise from north.
//! Lengths and heights are in metres. Earth axes are x toward 0° N 0° E, y toward 0° N 90° E, and z toward
//! the north pole.
//!
//! Types and functions are generic over `f32` and `f64`. With `f32`, no `f64` arithmetic is done. Each page
//! states the worst error that was measured; the README has the table of all of them.
//!
//! The results are built from `+ − × ÷ √` alone: the same input gives the same bits on every machine.
//!
//! # What can fail
//!
//! * **Constructors** such as [`LatLon::new`] refuse numbers that are out of range, infinite or NaN. The
//!   error carries the number. Projections and conversions of what a constructor has accepted never fail.
//! * **Plain numbers**, such as the fields of [`Enu`], [`Ned`] and [`Aer`] and the angles of a
//!   [`Conversion`](latitude::Conversion), are checked by the function that takes them.
//! * **Formulas with a limited range of flattening** are refused when you make them, with
//!   [`UnsupportedFlattening`](latitude::UnsupportedFlattening). All named ellipsoids of
//!   the Earth are in range.
//! * **Geodesics** return [`GeodesicError`](geodesic::GeodesicError) for an azimuth or a distance that is not
//!   finite; [`Vincenty`](geodesic::Vincenty) also where it does not converge.
//! * **Batches** refuse slices of unequal lengths, with [`InvalidBatch`](batch::InvalidBatch). Of elements that are
//!   wrong they write NaN; they write all others, and return how many were wrong and which was the first.
//! * **Scenes** return [`SceneError`](scene::SceneError) if nothing keeps the tolerance.
//! * **Text**: [`str::parse`] returns an error that says what was expected.
//!
//! No function panics, for any input.
//!
//! # Features and `no_std`
//!
//! The crate is `no_std` and allocates nothing. Without the default feature `std`, results are the same, bit
//! for bit.
//!
//! | feature | adds |
//! |---|---|
//! | `std` (default) | the hardware's square root, and AVX2 or AVX-512 in batches if the machine has them |
//! | `glam`, `mint`, `nalgebra` | conversions to and from their vectors; axes as their matrices |
//! | `geo-types` | conversions between [`LatLon`] and geo-types' points |
//! | `num-traits` | `Float`, `FloatConst` and `NumAssign` for [`Dual`] |
//! | `serde` | `Serialize` and `Deserialize`, which refuses what the constructors refuse |
//! | `defmt` | `defmt::Format` for public types and errors |

#![cfg_attr(not(feature = "std"), no_std)]

// The registers of these machines are wider than the numbers: sums are rounded twice, and roundings and
// remainders in the kernels would be wrong.
#[cfg(any(all(target_arch = "x86", not(target_feature = "sse2")), target_arch = "m68k"))]
compile_error!(
    "terrella needs a processor that rounds each operation to the precision of its numbers: \
     on 32-bit x86 one with SSE2 (i686, not i586), and none of the m68k family"
);

pub mod batch;
pub mod cube;
pub mod distortion;
mod dual;
mod ellipsoid;
pub mod frame;
pub mod geodesic;
pub mod grid;
pub mod healpix;
mod interop;
pub mod latitude;
pub mod math;
mod name;
mod position;
mod real;
pub mod route;
pub mod scene;
mod simd;
pub mod terrain;

pub use dual::Dual;
pub use ellipsoid::{Ellipsoid, GeodeticSeries, InvalidEllipsoid, Meeting, NAMED, Ray, UnknownEllipsoid};
pub use frame::{Aer, Enu, LocalFrame, Ned};
pub use latitude::{Latitude, Shift, Shifted};
pub use position::{
    Direction, Dms, DmsLatLon, Ecef, Geodetic, InvalidDirection, InvalidEcef, InvalidHeight, InvalidLatLon, LatLon,
    NmeaLatLon, ParseLatLonError, ParseNmeaError,
};
pub use real::Real;

#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;

#[cfg(doctest)]
#[doc = include_str!("../docs/recipes.md")]
struct Recipes;
