use super::bilinear::{blend, weights};
use super::vector::{difference, dot};
use super::{Heights, Patches, Tile};
use crate::Real;
use crate::cube::{Corner, CubeProjection, Face};
use crate::math::max;

/// How far the tiles of a level differ from bilinear patches between their corners: from
/// [`Patches::flatness`].
#[doc(alias = "geometric error")]
#[doc(alias = "LOD")]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Flatness {
    /// A bound on the displacement from the bilinear patch, on the ellipsoid, in metres. On a level base at
    /// height b the bound is `displacement` + |b| · `turning`.
    pub displacement: f64,
    /// A bound on the length of the difference between a normal and the normal interpolated between those of
    /// the corners. It has no unit.
    pub turning: f64,
}

impl<P: CubeProjection> Patches<P> {
    /// Returns bounds on the displacements and normals of all tiles of a level. A level above 30 is treated
    /// as 30.
    ///
    /// For a surface G, the error of bilinear interpolation over a tile of width w = 2^(1−level) is at most
    /// (w²/8)(max |∂²G/∂x²| + max |∂²G/∂y²|): a quarter at each next level. Where a projection has a crease
    /// (the quadrilateralized, vertex and HEALPix cubes, on the diagonals of the faces) there is no second
    /// derivative, and the error of the tiles on the crease, a displacement along the ground, only halves. In
    /// the corners of the conformal cube, where G behaves like the 4/3rd power of the distance, the error
    /// shrinks by 2^(4/3).
    ///
    /// The bounds are therefore measured at the level itself. The tiles tried are those next to a face's
    /// centre, edges and corners, and at eighths of the way, in a quarter of the front and of the top. The
    /// result is the largest value at 7 × 7 points of each, times 1.25 for the points and tiles between, plus
    /// 4 ulps of the planet's radius for rounding. This assumes a projection whose faces are symmetric about
    /// their midlines, and alike around the equator; all projections of this crate are such
    /// (`tests/terrain/patch.rs` searches for tiles that are worse). At levels 0 to 22 the result is at most
    /// twice the true maximum; at finer levels rounding begins to exceed the displacement. Of a cube that is
    /// [turned](crate::cube::Turned) or [stretched](crate::cube::Stretched), such tiles of all quarters of all
    /// faces are tried.
    ///
    /// A call takes about a millisecond, or twenty: make it when a map is loaded, not in every frame.
    ///
    /// ```
    /// use terrella::cube::{CubeMap, Quadrilateralized, Tangential};
    /// use terrella::terrain::Patches;
    /// use terrella::{Ellipsoid, Shift};
    ///
    /// let earth = Ellipsoid::WGS84;
    /// let patches = Patches::new(CubeMap::new(earth, Shift::Authalic, Tangential)?);
    /// let flatness = [8, 9, 10].map(|level| patches.flatness(level).displacement);
    /// for k in 0..2 {
    ///     assert!((flatness[k] / flatness[k + 1] - 4.0).abs() < 0.1);
    /// }
    /// let creased = Patches::new(CubeMap::new(earth, Shift::Authalic, Quadrilateralized)?);
    /// assert!(creased.flatness(16).displacement > 0.4 * creased.flatness(15).displacement);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[must_use]
    pub fn flatness(&self, level: u8) -> Flatness {
        let mut worst = [0.0; 2];
        for tile in witnesses::<P>(level) {
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

    /// The squares of the longest displacement and of the largest difference of a normal, among 7 × 7 points
    /// of a tile.
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

    /// Returns the coarsest level whose tiles need no displacements and no normals of their own, to stay
    /// within a tolerance in metres. Returns `None` if even level 30 exceeds the tolerance.
    ///
    /// From this level on a renderer needs only the corners of each tile, their normals, and the terrain
    /// heights ([`Vertices::plain`](super::Vertices::plain)). This holds for any level base in the range
    /// `heights`, and for terrain heights in that range.
    ///
    /// On the Earth (WGS 84, authalic latitude), for heights from −11 to 9 km or for heights of 0, the levels
    /// are:
    ///
    /// | projection | 1 m | 1 cm | 1 mm |
    /// |---|---|---|---|
    /// | COBE's two | 12 | 16 | 17 |
    /// | conformal | 16 | 21 | 23 |
    /// | vertex | 21 | 27 | none |
    /// | quadrilateralized | 21 | 28 | none |
    /// | HEALPix | 22 | 29 | none |
    /// | all others | 12 | 15 | 17 |
    ///
    /// ```
    /// use terrella::cube::{CubeMap, Projection};
    /// use terrella::terrain::{Heights, Patches};
    /// use terrella::{Ellipsoid, Shift};
    ///
    /// let earth = |projection| {
    ///     CubeMap::new(Ellipsoid::WGS84, Shift::Authalic, projection).map(Patches::new)
    /// };
    /// let sea = Heights::default();
    /// assert_eq!(earth(Projection::Adjusted)?.plain_level(1.0, sea), Some(12));
    /// // This projection has a crease: points would be displaced along the ground.
    /// assert_eq!(earth(Projection::Quadrilateralized)?.plain_level(1.0, sea), Some(21));
    /// assert_eq!(earth(Projection::Adjusted)?.plain_level(0.0, sea), None);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[doc(alias = "LOD")]
    #[must_use]
    pub fn plain_level(&self, tolerance: f64, heights: Heights<f64>) -> Option<u8> {
        let height = max(heights.low().abs(), heights.high().abs());
        (0..=Tile::MAX_LEVEL).find(|&level| {
            let Flatness { displacement, turning } = self.flatness(level);
            displacement + height * turning <= tolerance
        })
    }

    /// Returns the length of the skirts, in metres, that hide the gaps between a tile of this level and an
    /// adjacent tile of the next finer level or any level beyond it.
    ///
    /// Draw the skirt downward along the normal, from the edges of both tiles. `samples` is the number of
    /// samples along an edge of either tile; `heights` is the range of the terrain's heights there.
    ///
    /// Between two samples an edge is a straight line. A cell of the grid is no larger than a tile of a level
    /// finer by the whole part of log₂(samples − 1), so the ground is within f, the
    /// [`flatness`](Self::flatness) of that level, of the cell's edge. Let h₀ be the mean of the lowest and
    /// the highest height, r half of their difference, and f′ the bound of that level for normals. A vertex
    /// at G + hN is within r of G + h₀N, and an edge is within f + |h₀|f′ + r. The length returned is the sum
    /// of this for both edges.
    ///
    /// Edges that bend sideways also leave a gap sideways, which a vertical skirt does not hide. With 65
    /// samples on the Earth at level 8 it is up to 7 mm; in the conformal cube 9 cm, and next to the tips of
    /// the quadrilateralized, vertex and HEALPix cubes 0.8 m.
    ///
    /// Where the faces of a projection disagree along an edge of the cube
    /// ([`Faces::agree`](crate::cube::Faces::agree)), the tiles of the two faces share no vertices there, and
    /// this length does not hold.
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
    #[doc(alias = "T-junction")]
    #[doc(alias = "crack filling")]
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

/// Tiles of a level among which is the worst one, or nearly the worst.
pub(super) fn witnesses<P: CubeProjection>(level: u8) -> impl Iterator<Item = Tile> {
    let level = level.min(Tile::MAX_LEVEL);
    let last = (1_u32 << level) - 1;
    let half = (1_u32 << level) / 2;
    let near = move |place: u32| match place {
        0..3 => half + place,
        3..6 => (last + 3).saturating_sub(place),
        // Eighths of the way to the edge.
        6..13 => half + (u64::from(half) * u64::from(place - 5) / 8) as u32,
        // If the cube is stretched, what is worst may be nearer to the centre.
        _ => half + (u64::from(half) * u64::from(2 * place - 25) / 32) as u32,
    };
    let index = move |place| near(place).clamp(half.min(last), last);
    // At coarse levels many are the same.
    let first = move |&place: &u32| (0..place).all(|before| index(before) != index(place));
    let (places, faces, mirrors): (_, &[Face], &[bool]) = if P::SYMMETRIC {
        (13, &[Face::Front, Face::Top], &[false])
    } else {
        (17, &Face::ALL, &[false, true])
    };
    let quarter = move || (0..places).filter(first).map(index);
    let mirrored = move |&mirror: &bool| quarter().map(move |index| if mirror { last - index } else { index });
    let indices = move || mirrors.iter().flat_map(mirrored);
    let row = move |face, j| indices().map(move |i| Tile::within(face, level, i, j));
    faces
        .iter()
        .flat_map(move |&face| indices().flat_map(move |j| row(face, j)))
}
