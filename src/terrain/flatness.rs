use super::bilinear::{blend, weights};
use super::vector::{difference, dot};
use super::{Heights, Patches, Tile};
use crate::Real;
use crate::cube::{Corner, CubeProjection, Face};
use crate::math::max;

/// What the tiles of a level lack of being flat: from [`Patches::flatness`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Flatness {
    /// No displacement from the bilinear patch between the corners is longer, on the ellipsoid; on a level
    /// base at height b none is longer than this and |b| times `turning`: metres.
    pub displacement: f64,
    /// No normal is farther from the one interpolated between those of the corners: the length of the difference.
    pub turning: f64,
}

impl<P: CubeProjection> Patches<P> {
    /// Bounds of displacement and normals over all tiles of a level; a level above 30 is taken for 30.
    ///
    /// Bilinear interpolation of a surface G is within (w²/8)(max |∂²G/∂x²| + max |∂²G/∂y²|) for a tile of width w = 2^(1−level), which falls by four
    /// from level to level. Where a projection is creased (the quadrilateralized, vertex and HEALPix cubes on the faces' diagonals) the second derivative is none and the tiles on the crease lose
    /// only half, by a displacement along the ground; in the conformal cube's corners, where G is of the order of the 4/3rd power of the distance, 2^(4/3).
    ///
    /// So the tiles themselves are asked, at the level itself: those next to a face's centre, edges and corners, and at eighths of the way, in a
    /// quarter of the front and of the top; the largest of 7 × 7 places in them, and a quarter more for the places and tiles between. Rounding, 4 ulps of the planet's radius, is added. It
    /// presumes a projection with the symmetries of the square, of which these tiles are the worst, as all of this crate are: `tests/terrain/patch.rs` searches. It is
    /// at most twice the largest at levels 0 to 22; beyond, rounding begins to be more than the displacement.
    ///
    /// It takes about a millisecond: to be asked when a map is loaded, not in a frame.
    ///
    /// ```
    /// use terrella::cube::{CubeMap, Quadrilateralized, Tangential};
    /// use terrella::terrain::Patches;
    /// use terrella::{Ellipsoid, Shift};
    ///
    /// let earth = Ellipsoid::WGS84;
    /// let patches = Patches::new(CubeMap::new(earth, Shift::Authalic, Tangential)?);
    /// let flatness = [8, 9, 10].map(|level| patches.flatness(level).displacement);
    /// assert!((flatness[0] / flatness[1] - 4.0).abs() < 0.1 && (flatness[1] / flatness[2] - 4.0).abs() < 0.1);
    /// let creased = Patches::new(CubeMap::new(earth, Shift::Authalic, Quadrilateralized)?);
    /// assert!(creased.flatness(16).displacement > 0.4 * creased.flatness(15).displacement);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[must_use]
    pub fn flatness(&self, level: u8) -> Flatness {
        let mut worst = [0.0; 2];
        for tile in witnesses(level) {
            for (worst, found) in worst.iter_mut().zip(self.bulge(tile)) {
                *worst = max(*worst, found);
            }
        }
        let [displacement, turning] = worst.map(|squared| 1.25 * Real::sqrt(squared));
        Flatness {
            displacement: displacement + 4.0 * f64::EPSILON * self.map().shifted().ellipsoid().a(),
            turning: turning + 4.0 * f64::EPSILON,
        }
    }

    /// The squares of the longest displacement and of the largest difference of a normal, among 7 × 7 places of a tile.
    fn bulge(&self, tile: Tile) -> [f64; 2] {
        const PARTS: u32 = 6;
        let ends = Corner::ALL.map(|corner| self.ground(tile.corner(corner)));
        let mut most = [0.0; 2];
        for n in 0..=PARTS {
            for m in 0..=PARTS {
                let weights = weights([m.into(), n.into()], PARTS.into());
                let [foot, normal] = self.ground(tile.node([m, n], PARTS));
                let bulge = difference(foot, blend(ends.map(|[foot, _]| foot), weights));
                let turning = difference(normal, blend(ends.map(|[_, normal]| normal), weights));
                for (most, vector) in most.iter_mut().zip([bulge, turning]) {
                    *most = max(*most, dot(vector, vector));
                }
            }
        }
        most
    }

    /// The coarsest level whose tiles need neither displacements nor normals of their own: corners, on
    /// whatever level base in this range, their normals and heights in this range are enough
    /// ([`Vertices::plain`](super::Vertices::plain)) to be within a tolerance in metres; none if not even
    /// level 30 is.
    ///
    /// On the Earth (WGS 84, authalic latitude), at heights from −11 to 9 km or none at all:
    ///
    /// | projection | 1 m | 1 cm | 1 mm |
    /// |---|---|---|---|
    /// | twelve of the sixteen | 12 | 15 | 17 |
    /// | of them COBE's two | 12 | 16 | 17 |
    /// | conformal | 16 | 21 | 23 |
    /// | vertex | 21 | 27 | none |
    /// | quadrilateralized | 21 | 28 | none |
    /// | HEALPix | 22 | 29 | none |
    ///
    /// ```
    /// use terrella::cube::{CubeMap, Projection};
    /// use terrella::terrain::{Heights, Patches};
    /// use terrella::{Ellipsoid, Shift};
    ///
    /// let earth = |projection| CubeMap::new(Ellipsoid::WGS84, Shift::Authalic, projection).map(Patches::new);
    /// let sea = Heights::default();
    /// assert_eq!(earth(Projection::Adjusted)?.plain_level(1.0, sea), Some(12));
    /// // Creased: places would be shifted along the ground.
    /// assert_eq!(earth(Projection::Quadrilateralized)?.plain_level(1.0, sea), Some(21));
    /// assert_eq!(earth(Projection::Adjusted)?.plain_level(0.0, sea), None);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[must_use]
    pub fn plain_level(&self, tolerance: f64, heights: Heights<f64>) -> Option<u8> {
        let height = max(heights.low().abs(), heights.high().abs());
        (0..=Tile::MAX_LEVEL).find(|&level| {
            let Flatness { displacement, turning } = self.flatness(level);
            displacement + height * turning <= tolerance
        })
    }

    /// How far apart, in metres, the edges of two tiles may be where one of this level meets one of the next finer level or any beyond: the length of the skirt, along the normal downward
    /// from the edges of both, that hides the gap. `samples` are those along an edge of either tile, `heights` those of the terrain there.
    ///
    /// Between two samples an edge is a straight line. A cell of the grid is no larger than a tile of a level finer by the whole part of log₂(samples − 1),
    /// and the ground is within that level's [`flatness`](Self::flatness), f, of the cell's edge. With h₀ the mean of the lowest and the highest height, and r half
    /// their difference, a vertex at G + hN is within r of G + h₀N, and an edge within f + |h₀|f′ + r, f′ the same bound for normals. The skirt is what two edges have together.
    ///
    /// Where edges bend to the side they part to the side too, which a skirt straight down does not hide: with 65 samples, on the Earth at level 8, by up to 7 mm, in
    /// the conformal cube 9 cm, and next to the tips of the quadrilateralized, vertex and HEALPix cubes 0.8 m.
    ///
    /// ```
    /// use terrella::cube::{Adjusted, CubeMap};
    /// use terrella::terrain::{Heights, Patches};
    /// use terrella::{Ellipsoid, Shift};
    ///
    /// let patches = Patches::new(CubeMap::new(Ellipsoid::WGS84, Shift::Authalic, Adjusted)?);
    /// assert!(patches.skirt(8, 65, Heights::default()) < 0.1);
    /// let hills = patches.skirt(8, 65, Heights::new(200.0, 250.0)?);
    /// assert!((50.0..50.1).contains(&hills));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[must_use]
    pub fn skirt(&self, level: u8, samples: u32, heights: Heights<f64>) -> f64 {
        let finer = samples.saturating_sub(1).checked_ilog2().unwrap_or(0) as u8;
        let height = (0.5 * (heights.low() + heights.high())).abs();
        let mut apart = heights.high() - heights.low();
        for level in [level, level.saturating_add(1)] {
            let Flatness { displacement, turning } = self.flatness(level.saturating_add(finer));
            apart += displacement + height * turning;
        }
        apart
    }
}

/// Tiles of a level among which the worst is, or nearly.
pub(super) fn witnesses(level: u8) -> impl Iterator<Item = Tile> {
    let level = level.min(Tile::MAX_LEVEL);
    let last = (1_u32 << level) - 1;
    let half = (1_u32 << level) / 2;
    let near = move |place: u32| match place {
        0..3 => half + place,
        3..6 => (last + 3).saturating_sub(place),
        // Eighths of the way to the edge.
        _ => half + (u64::from(half) * u64::from(place - 5) / 8) as u32,
    };
    let indices = move || (0..13).map(near).map(move |index| index.clamp(half.min(last), last));
    [Face::Front, Face::Top]
        .into_iter()
        .flat_map(move |face| indices().flat_map(move |j| indices().map(move |i| Tile::within(face, level, i, j))))
}
