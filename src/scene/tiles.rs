use super::{Scene, SceneError};
use crate::cube::{Decay, Projection};
use crate::terrain::Tile;

/// The levels from which tiles of a cube map can be drawn in a simpler way: from [`Scene::tiles`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Tiles {
    /// From this level on, four corners with their normals and heights, interpolated, are enough:
    /// [`Vertices::plain`](crate::terrain::Vertices::plain). `None` if no level up to 30 is fine enough.
    pub plain: Option<u8>,
    /// From this level on, a [`Series`](crate::terrain::Series) of the second order is enough. `None` if no
    /// level up to 30 is fine enough.
    pub series: Option<u8>,
}

impl Scene {
    /// Returns the coarsest levels at which tiles need only their four corners, or only their series, to keep
    /// the tolerance in metres at the heights of the scene.
    ///
    /// At level L, the corners of a tile leave an error of D a 4^(−L), and its series one of S a 8^(−L), if
    /// the projection is smooth. The errors are (D 2^(−L) + 0.35·4^(−L)) a if it is creased
    /// (quadrilateralized, HEALPix, vertex). They fall with 2^(−4L/3) for the conformal one. D and S hold for
    /// every shift. They are the largest values of [`Patches::flatness`](crate::terrain::Patches::flatness)
    /// and [`Patches::truncation`](crate::terrain::Patches::truncation), which examine one map and take a
    /// thousand times as long.
    ///
    /// # Errors
    /// A [`SceneError`] if the scene itself is refused.
    ///
    /// ```
    /// use terrella::Ellipsoid;
    /// use terrella::cube::Projection;
    /// use terrella::scene::{Scene, Tiles};
    /// const EARTH: Scene = Scene::new(Ellipsoid::WGS84).heights(-11_000.0, 9_000.0).within(0.01);
    /// const TILES: Tiles = match EARTH.tiles(Projection::Adjusted) {
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
        // Normals are off by as much as places on a sphere of radius 1, and a little more on an ellipsoid; a
        // series has its normals from its own slopes.
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
