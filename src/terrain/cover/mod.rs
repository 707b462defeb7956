//! Which tiles cover a region: boxes of latitude and longitude, caps, and what is near to something.

mod boundary;
mod cap;
mod covering;
mod lat_lon_box;
mod near;
mod tile_box;

pub use cap::{Cap, InvalidRadius};
pub use covering::Covering;
pub use lat_lon_box::{InvalidBox, LatLonBox};
pub use near::Near;

use super::Tile;
use crate::Real;
use crate::cube::{CubeMap, CubeProjection};

/// How a tile and a [`Region`] lie to each other.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Relation {
    /// They have no place in common.
    Apart,
    /// They have a place in common, and the tile is not inside the region.
    Meets,
    /// The tile is inside the region.
    Inside,
}

/// A set of places that a [`Covering`] covers with tiles: [`LatLonBox`], [`Cap`] and [`Near`], or your own.
///
/// Tiles and regions are closed: their edges belong to them.
///
/// ```
/// use terrella::cube::{CubeMap, CubeProjection, Face, S2Quadratic};
/// use terrella::terrain::{Covering, Region, Relation, Tile};
/// use terrella::{Ellipsoid, Real, Shift};
///
/// /// The northern face.
/// struct North;
///
/// impl<T: Real> Region<T> for North {
///     fn relation<P: CubeProjection>(&self, _: &CubeMap<T, P>, tile: Tile) -> Relation {
///         if tile.face() == Face::Top { Relation::Inside } else { Relation::Apart }
///     }
/// }
///
/// let map = CubeMap::new(Ellipsoid::<f64>::WGS84, Shift::Geodetic, S2Quadratic)?;
/// assert_eq!(Covering::new(map, North, 2)?.count(), 16);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub trait Region<T: Real> {
    /// Returns how a tile of a cube map and the region lie to each other.
    ///
    /// An answer of [`Relation::Meets`] is always safe: the tile is divided, and at the finest level it is a
    /// tile of the outer covering and none of the inner one.
    #[must_use]
    fn relation<P: CubeProjection>(&self, map: &CubeMap<T, P>, tile: Tile) -> Relation;
}

impl<T: Real, R: Region<T>> Region<T> for &R {
    #[inline]
    fn relation<P: CubeProjection>(&self, map: &CubeMap<T, P>, tile: Tile) -> Relation {
        R::relation(self, map, tile)
    }
}
