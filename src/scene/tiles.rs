use super::{Scene, SceneError};
use crate::cube::{Decay, Projection};
use crate::terrain::Tile;

/// From which level on the tiles of a cube map need no more than little: from [`Scene::tiles`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Tiles {
    /// A tile is its corners, their normals and heights, interpolated: [`Vertices::plain`](crate::terrain::Vertices::plain).
    pub plain: Option<u8>,
    /// A tile is its [`Series`](crate::terrain::Series) of the second order.
    pub series: Option<u8>,
}

impl Scene {
    /// The coarsest levels at which tiles need no displacements, or their series is enough, for the tolerance in metres and the heights of the scene; none if level 30 is not enough.
    ///
    /// At level L a tile of a smooth projection is within D a 4^(−L) of what its corners give, and within S a 8^(−L) of its series; of a creased one (quadrilateralized, HEALPix, vertex)
    /// within (D 2^(−L) + 0.35·4^(−L)) a; of the conformal one, for its corners, 2^(−4L/3). D and S hold for every shift, and are the largest of
    /// [`Patches::flatness`](crate::terrain::Patches::flatness) and [`truncation`](crate::terrain::Patches::truncation), which ask a map itself and take a thousand times as long.
    ///
    /// # Errors
    /// If the scene is none.
    ///
    /// ```
    /// use terrella::Ellipsoid;
    /// use terrella::cube::Projection;
    /// use terrella::scene::{Scene, Tiles};
    /// const TILES: Tiles = match Scene::new(Ellipsoid::WGS84).heights(-11_000.0, 9_000.0).within(0.01).tiles(Projection::Adjusted) {
    ///     Ok(tiles) => tiles,
    ///     Err(_) => panic!(),
    /// };
    /// assert_eq!(TILES, Tiles { plain: Some(15), series: Some(10) });
    /// ```
    pub const fn tiles(&self, projection: Projection) -> Result<Tiles, SceneError> {
        if let Some(error) = self.fault() {
            return Err(error);
        }
        let [displacement, series] = projection.tiles();
        let [low, high] = self.heights;
        // Normals are off by as much as places on a sphere of radius 1, and a little more on an ellipsoid; a series has its normals from its own slopes.
        let height = 1.02 * low.abs().max(high.abs());
        Ok(Tiles {
            plain: self.coarsest(displacement, height),
            series: self.coarsest(series, 0.0),
        })
    }

    const fn coarsest(&self, decay: Decay, height: f64) -> Option<u8> {
        let a = self.ellipsoid.a();
        // The first level that holds, and one past the last.
        let (mut first, mut past) = (0, Tile::MAX_LEVEL + 1);
        while first < past {
            let level = (first + past) / 2;
            if (a + height) * decay.at(level) + 4e-15 * a <= self.tolerance {
                past = level;
            } else {
                first = level + 1;
            }
        }
        if first > Tile::MAX_LEVEL { None } else { Some(first) }
    }
}
