//! Terrain on the cube, for a renderer: the quadtree of [`Tile`]s, their addresses, the selection of the
//! tiles that a picture needs, and their vertices in single precision.
//!
//! The methods are those of Lambers & Kolb, *Ellipsoidal cube maps for accurate rendering of planetary-scale
//! terrain data* (Pacific Graphics 2012), for every projection, ellipsoid and shift.
//!
//! Each face of the cube is a quadtree. Its [`Tile`]s are addressed by whole numbers, so a renderer's tables
//! need no coordinates:
//!
//! | | |
//! |---|---|
//! | [`Tile`] | face, level, column, row; parent, children, points, neighbours across edges and corners |
//! | [`Key`] | a tile as one number along [`Morton`]'s or [`Hilbert`]'s curve, for tables and file names |
//!
//! A map, an index or a table of data asks which tiles there are somewhere, and where a tile is:
//!
//! | | |
//! |---|---|
//! | [`Covering`] | the tiles that cover a region, at one level or at several: outer and inner |
//! | [`LatLonBox`], [`Cap`], [`Near`], [`Region`] | regions: a box, a distance from a place or from anything, your own |
//! | [`LatLonBox::of_tile`], [`Tile::area`] | the latitudes and longitudes of a tile, and its area on the ellipsoid |
//! | [`Tile::ring`], [`Tile::disc`] | the tiles so many steps away |
//! | [`Tile::common_ancestor`] | the tile that holds two |
//!
//! In each frame, a renderer selects the tiles it needs:
//!
//! | | |
//! |---|---|
//! | [`Camera`] | the eye, the matrix (perspective or parallel), the size of the picture in pixels |
//! | [`Heights`] | the lowest and the highest terrain of a tile |
//! | [`Enclosure`] | oriented bounding boxes and bounding spheres of tiles with their terrain |
//! | [`Horizon`] | horizon culling: what the planet itself hides |
//! | [`Selection`] | the tiles to draw: one for each visible place, as coarse as [`Detail`] allows |
//!
//! A renderer then draws them in single precision, which on the Earth's surface has steps of half a metre:
//!
//! | | |
//! |---|---|
//! | [`Patches`], [`Vertices`] | the paper's way: a bilinear patch relative to the eye, and displacements |
//! | [`Base`] | the height to which corners are lifted; single precision holds only the difference |
//! | [`Symmetry`] | derives up to sixteen tiles from one |
//! | [`Flatness`] | how flat the tiles of a level are: where corners suffice, and how long skirts must be |
//! | [`Series`], [`Split`] | two other ways: a Taylor series for each tile, and a double as two singles |
//! | [`lean`] | the error of applying heights along a sphere's normal |
//!
//! With [`Patches`], displacements are computed once per tile, and corners relative to the eye once per
//! frame. This example goes from an eye to vertices:
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
//! // Once per frame: from 2 km above Oslo straight down, north up, 53° high.
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
//! let grid = [[0.0_f32; 65 * 65]; 3];
//! let (mut o, mut n, mut vertices) = (grid, grid, grid);
//! let mut nearest = f32::INFINITY;
//! for tile in Selection::new(&enclosure, camera, Detail::new(65, 1.5, 17)?, sea) {
//!     // Once per tile: keep the results under the tile's key while the tile is in use.
//!     let (into_o, into_n) = (o.each_mut().map(|o| &mut o[..]), n.each_mut().map(|n| &mut n[..]));
//!     let patch = patches.fill(tile, Base::from(sea(tile)), 65, into_o, into_n)?;
//!     // Once per frame: a graphics card does this in its vertex shader.
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
//! Accuracy: vertices of [`Patches`] with a [`Base`] near the ground are within 0.2 mm of the truth up to 1
//! km from the eye, and within 3·10⁻⁷ of the distance beyond. A step of the eye of 1 mm is drawn within 0.25
//! mm up to 1 km. These are the worst errors over a million random eyes, projections, shifts, named
//! ellipsoids and grounds from −11 to 30 km with slopes of up to 45°; single precision without the patches is
//! within 0.65 m and 5.7·10⁻⁴ (`cargo test --release --test terrain -- --ignored --nocapture
//! a_million_vertices`).
//!
//! # An equal-area grid of the ellipsoid
//!
//! With [`Vertex`](crate::cube::Vertex), [`Quadrilateralized`](crate::cube::Quadrilateralized) or another
//! equal-area projection, and with the authalic shift, the tiles are a discrete global grid whose cells have
//! equal areas: on WGS 84 every cell of level L has 85 010 936 954 015 m² · 4^−L. Integrals of the map's scale
//! over single cells agree with that to 1e-12. Cells of one level of S2 differ in area by a factor of 2.1.
//!
//! A cell has four children that fill it exactly, and a [`Key`] that sorts like a curve through space. So a
//! table of counts by key is a histogram of densities, and counts of coarser cells are sums.
//!
//! ```
//! use terrella::cube::{CubeMap, Vertex};
//! use terrella::terrain::{Hilbert, Key, Tile};
//! use terrella::{Ellipsoid, LatLon, Shift};
//!
//! let grid = CubeMap::new(Ellipsoid::<f64>::WGS84, Shift::Authalic, Vertex)?;
//! let cell = |lat, lon| Ok(Tile::containing(grid.project(LatLon::new(lat, lon)?), 12)?);
//! let cell = |lat, lon| -> Result<Tile, Box<dyn std::error::Error>> { cell(lat, lon) };
//! let (oslo, quito) = (cell(59.91, 10.75)?, cell(-0.18, -78.47)?);
//! assert_eq!(oslo.area(&grid), quito.area(&grid));
//! assert_eq!(oslo.area(&grid).round(), 5_067_047.0);
//! assert_eq!(Key::<Hilbert>::from(oslo).to_string(), "464638d");
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! Coarse tiles need displacements, fine tiles do not: with most projections, tiles of level 12 on the Earth
//! are within 1 m of flat, of level 15 within 1 cm, and of level 17 within 1 mm ([`Patches::plain_level`] has
//! the table).

mod area;
mod base;
mod bilinear;
mod bounds;
mod camera;
mod cover;
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
mod ring;
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
pub use cover::{Cap, Covering, InvalidBox, InvalidRadius, LatLonBox, Near, Region, Relation};
pub use flatness::Flatness;
pub use heights::{Heights, InvalidHeights, lean};
pub use hilbert::Hilbert;
pub use horizon::Horizon;
pub use key::{Curve, InvalidKey, InvalidToken, Key};
pub use morton::Morton;
pub use neighbour::{Adjacent, Along, Around, Diagonal};
pub use patch::{InvalidPatch, Patch, Patches};
pub use ring::{InvalidSteps, Ring};
pub use s2::InvalidNumberedTile;
pub(crate) use s2::{has_s2_leaf, leaf_of};
pub use selection::{Detail, InvalidDetail, Selection};
pub use series::Series;
pub use split::Split;
pub use symmetry::Symmetry;
pub use tile::{InvalidPlace, InvalidTile, Tile};
pub use vertices::Vertices;
pub use volume::{BoundingSphere, OrientedBox};
