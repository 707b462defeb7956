use super::{Scene, SceneError};
use crate::cube::Projection;
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

/// An error per semi-major axis at a level: the factor times 2^(−thirds·level/3), and another times 4^(−level), which tells in the first levels.
#[derive(Clone, Copy)]
struct Law {
    factor: f64,
    thirds: u64,
    coarse: f64,
}

impl Law {
    const fn at(self, level: u8) -> f64 {
        self.factor * shrink(self.thirds * level as u64) + self.coarse * shrink(6 * level as u64)
    }
}

/// 2^(−thirds/3).
const fn shrink(thirds: u64) -> f64 {
    let part = match thirds % 3 {
        0 => 1.0,
        1 => 0.793_700_525_984_099_7,
        _ => 0.629_960_524_947_436_6,
    };
    part * f64::from_bits((1023 - thirds / 3) << 52)
}

/// Of displacements, and of what a series leaves out.
const fn smooth(displacement: f64, series: f64) -> [Law; 2] {
    [law(displacement, 6, 0.0), law(series, 9, 0.0)]
}

const fn creased(displacement: f64, series: f64) -> [Law; 2] {
    [law(displacement, 3, 0.35), law(series, 3, 0.35)]
}

const fn law(factor: f64, thirds: u64, coarse: f64) -> Law {
    Law { factor, thirds, coarse }
}

/// `tests/terrain/scene.rs` compares with [`Patches::flatness`](crate::terrain::Patches::flatness) and [`Patches::truncation`](crate::terrain::Patches::truncation), and prints the table.
const fn laws(projection: Projection) -> [Law; 2] {
    match projection {
        Projection::Tangential => smooth(1.27, 1.85),
        Projection::Adjusted => smooth(0.79, 1.37),
        Projection::Outerra => smooth(0.88, 0.81),
        Projection::Cobe => smooth(1.87, 9.30),
        Projection::CobeExact => smooth(2.24, 17.6),
        Projection::Quadrilateralized => creased(0.285, 1.38),
        Projection::Cartesian => smooth(1.07, 2.29),
        Projection::Healpix => creased(0.565, 2.77),
        Projection::S2Quadratic => smooth(0.88, 1.52),
        Projection::EquiEdge => smooth(0.97, 1.02),
        Projection::Algebraic => smooth(1.04, 1.03),
        Projection::Vertex => creased(0.199, 0.58),
        Projection::Conformal => [law(0.211, 4, 0.35), law(0.144, 4, 0.4)],
        Projection::Balanced => smooth(0.77, 2.02),
        Projection::Square => smooth(0.88, 2.28),
        Projection::Separable => smooth(0.86, 1.15),
    }
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
        let [displacement, series] = laws(projection);
        let [low, high] = self.heights;
        // Normals are off by as much as places on a sphere of radius 1, and a little more on an ellipsoid; a series has its normals from its own slopes.
        let height = 1.02 * low.abs().max(high.abs());
        Ok(Tiles {
            plain: self.coarsest(displacement, height),
            series: self.coarsest(series, 0.0),
        })
    }

    const fn coarsest(&self, law: Law, height: f64) -> Option<u8> {
        let a = self.ellipsoid.a();
        // The first level that holds, and one past the last.
        let (mut first, mut past) = (0, Tile::MAX_LEVEL + 1);
        while first < past {
            let level = (first + past) / 2;
            if (a + height) * law.at(level) + 4e-15 * a <= self.tolerance {
                past = level;
            } else {
                first = level + 1;
            }
        }
        if first > Tile::MAX_LEVEL { None } else { Some(first) }
    }
}
