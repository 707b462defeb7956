//! Terrain on the cube, for a renderer to call: which [`Tile`]s there are, what they are called, and which of them a picture needs.
//!
//! Lambers & Kolb, *Ellipsoidal cube maps for accurate rendering of planetary-scale terrain data* (Pacific Graphics 2012), for every
//! projection, ellipsoid and shift.
//!
//! | | |
//! |---|---|
//! | [`Tile`] | face, level, column and row; parent and children, the places in it, its neighbours |
//! | [`Key`] | a tile as one number, in [`Morton`]'s or [`Hilbert`]'s order, for a sorted table or a file's name |
//! | [`Enclosure`] | boxes and spheres that contain tiles with their terrain |
//! | [`Horizon`] | what the planet itself hides |
//! | [`Selection`] | the tiles a picture is drawn from, of every place that is seen one |
//!
//! ```
//! use terrella::cube::{CubeMap, Quadrilateralized};
//! use terrella::terrain::{Hilbert, Key, Tile};
//! use terrella::{Ellipsoid, LatLon, Shift};
//!
//! let map = CubeMap::new(Ellipsoid::<f64>::wgs84(), Shift::Authalic, Quadrilateralized)?;
//! let oslo = map.project(LatLon::new(59.9139, 10.7522)?);
//! let tile = Tile::containing(oslo, 12)?;
//! assert_eq!((tile.face().index(), tile.i(), tile.j()), (4, 2339, 668));
//! assert_eq!(Key::<Hilbert>::from(tile).to_string(), "4646541");
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
