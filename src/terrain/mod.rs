//! Terrain on the cube: [`Tile`], the square piece of a face that a renderer loads, culls and draws.
//!
//! Lambers & Kolb, *Ellipsoidal cube maps for accurate rendering of planetary-scale terrain data* (Pacific Graphics 2012), for every
//! projection, ellipsoid and shift.
//!
//! ```
//! use terrella::cube::{CubeMap, Quadrilateralized};
//! use terrella::terrain::Tile;
//! use terrella::{Ellipsoid, LatLon, Shift};
//!
//! let map = CubeMap::new(Ellipsoid::<f64>::wgs84(), Shift::Authalic, Quadrilateralized)?;
//! let oslo = map.project(LatLon::new(59.9139, 10.7522)?);
//! let tile = Tile::containing(oslo, 12)?;
//! assert_eq!((tile.face().index(), tile.i(), tile.j()), (4, 2339, 668));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod bilinear;
mod bounds;
mod camera;
mod flatness;
mod footprint;
mod heights;
mod hilbert;
mod horizon;
mod key;
mod morton;
mod neighbour;
mod patch;
mod selection;
mod series;
mod split;
mod symmetry;
mod tile;
mod vector;
mod vertices;
mod volume;

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
pub use selection::{Detail, InvalidDetail, Selection};
pub use series::Series;
pub use split::Split;
pub use symmetry::Symmetry;
pub use tile::{InvalidPlace, InvalidTile, Tile};
pub use vertices::Vertices;
pub use volume::{BoundingSphere, OrientedBox};
