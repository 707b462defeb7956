//! Terrain on the cube, for a renderer to call: which [`Tile`]s there are, what they are called, and which of them a picture needs.
//!
//! Lambers & Kolb, *Ellipsoidal cube maps for accurate rendering of planetary-scale terrain data* (Pacific Graphics 2012), for every
//! projection, ellipsoid and shift.
//!
//! A face of the cube is a quadtree. Its [`Tile`]s are addressed by whole numbers, so that a renderer's tables need no coordinates:
//!
//! | | |
//! |---|---|
//! | [`Tile`] | face, level, column and row; parent and children, the places in it, its neighbours across edges and corners |
//! | [`Key`] | a tile as one number, in [`Morton`]'s or [`Hilbert`]'s order, for a sorted table or a file's name |
//!
//! Each frame asks which tiles it needs:
//!
//! | | |
//! |---|---|
//! | [`Camera`] | the eye, the renderer's matrix, perspective or parallel, the pixels |
//! | [`Heights`] | the lowest and the highest terrain of a tile |
//! | [`Enclosure`] | boxes and spheres that contain tiles with their terrain |
//! | [`Horizon`] | what the planet itself hides |
//! | [`Selection`] | the tiles a picture is drawn from, of every place that is seen one, as coarse as [`Detail`] allows |
//!
//! And what it draws of them, in single precision, for a graphics card to whom the Earth is a grid of half a metre:
//!
//! | | |
//! |---|---|
//! | [`Patches`], [`Vertices`] | the paper's way: once per tile the displacements from a bilinear patch, once per frame the patch's corners from the eye |
//! | [`Base`] | the height that corners are lifted to, so that single precision has only what the ground differs from it |
//! | [`Symmetry`] | one tile of up to sixteen is enough to know them all |
//! | [`Flatness`] | how far tiles of a level are from flat: from which level on corners are enough, and how long skirts must be |
//! | [`Series`], [`Split`] | two other ways: a Taylor series for each tile, and two numbers for one |
//! | [`lean`] | what heights along a sphere's normal would do |
//!
//! From an eye to vertices:
//!
//! ```
//! use terrella::cube::{Balanced, CubeMap};
//! use terrella::terrain::{Base, Camera, Detail, Enclosure, Heights, Patches, Selection, Tile};
//! use terrella::{Ellipsoid, Enu, Geodetic, LatLon, LocalFrame, Shift};
//!
//! // Once: the planet.
//! let map = CubeMap::new(Ellipsoid::<f64>::WGS84, Shift::Authalic, Balanced)?;
//! let (enclosure, patches) = (Enclosure::new(map), Patches::new(map));
//!
//! // Once a frame: 2 km above Oslo, straight down, north up, 53° high.
//! let frame = LocalFrame::new(Ellipsoid::WGS84, Geodetic::new(LatLon::new(59.9139, 10.7522)?, 2_000.0)?);
//! let eye = frame.origin_ecef();
//! let row = |east, north, up| {
//!     let [x, y, z] = frame.vector_from_enu(Enu { east, north, up });
//!     [x, y, z, 0.0]
//! };
//! let matrix = [row(1.6, 0.0, 0.0), row(0.0, 2.0, 0.0), [0.0; 4], row(0.0, 0.0, -1.0)];
//! let camera = Camera::new(eye, matrix, [1280.0, 1024.0])?;
//! let sea = |_: Tile| Heights::default();
//!
//! let (mut o, mut n, mut vertices) = ([[0.0_f32; 65 * 65]; 3], [[0.0; 65 * 65]; 3], [[0.0; 65 * 65]; 3]);
//! let mut nearest = f32::INFINITY;
//! for tile in Selection::new(&enclosure, camera, Detail::new(65, 1.5, 17)?, sea) {
//!     // Once a tile: kept under its key until the tile is no longer wanted.
//!     let patch = patches.fill(tile, Base::from(sea(tile)), 65, o.each_mut().map(|o| &mut o[..]), n.each_mut().map(|n| &mut n[..]))?;
//!     // Once a frame: a graphics card does this to vertices that it has.
//!     let (heights, into) = ([0.0; 65 * 65], vertices.each_mut().map(|v| &mut v[..]));
//!     let seen = patch.seen_from(eye);
//!     seen.fill(65, o.each_ref().map(|o| &o[..]), n.each_ref().map(|n| &n[..]), &heights, into)?;
//!     for k in 0..65 * 65 {
//!         let [x, y, z] = vertices.each_ref().map(|component| component[k]);
//!         nearest = nearest.min((x * x + y * y + z * z).sqrt());
//!     }
//! }
//! assert!((nearest - 2_000.0).abs() < 0.1);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! Vertices of [`Patches`] with a [`Base`] near the ground are within 0.2 mm of the truth up to 1 km from the
//! eye and within 3·10⁻⁷ of the distance beyond, and a step of the eye of 1 mm is drawn within 0.25 mm up to
//! 1 km, over a million random eyes, projections, shifts, named ellipsoids and grounds from −11 to 30 km with
//! slopes of up to 45°; single precision by itself within 0.65 m and 5.7·10⁻⁴
//! (`cargo test --release --test terrain -- --ignored --nocapture a_million_vertices`). Coarse tiles need displacements, fine ones do not: with most projections tiles of level 12 on the Earth are within 1 m of flat, of level 15
//! within 1 cm, of level 17 within 1 mm ([`Patches::plain_level`] has the table).

mod base;
mod bilinear;
mod bounds;
mod camera;
mod coverage;
mod flatness;
mod footprint;
mod heights;
mod hilbert;
mod horizon;
mod key;
mod morton;
mod neighbour;
mod patch;
mod s2;
mod selection;
mod series;
mod slab;
mod solid_angle;
mod split;
mod symmetry;
mod tile;
mod vector;
mod vertices;
mod volume;

pub use base::{Base, InvalidBase};
pub use bounds::Enclosure;
pub use camera::{Camera, InvalidCamera};
pub use flatness::Flatness;
pub use heights::{Heights, InvalidHeights, lean};
pub use hilbert::Hilbert;
pub use horizon::Horizon;
pub use key::{Curve, InvalidKey, InvalidToken, Key};
pub use morton::Morton;
pub use neighbour::{Adjacent, Along, Around, Diagonal};
pub use patch::{InvalidPatch, Patch, Patches};
pub use s2::InvalidNumberedTile;
pub use selection::{Detail, InvalidDetail, Selection};
pub use series::Series;
pub use split::Split;
pub use symmetry::Symmetry;
pub use tile::{InvalidPlace, InvalidTile, Tile};
pub use vertices::Vertices;
pub use volume::{BoundingSphere, OrientedBox};
