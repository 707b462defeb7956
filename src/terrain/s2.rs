use super::{Hilbert, InvalidTile, Key, Tile};
use crate::cube::{Edge, Face, InvalidFace, InvalidFacePoint, InvalidNumbered, Numbering};
use crate::math::select;
use crate::{Direction, InvalidDirection, Real};

/// The cells of Google's S2, chosen as S2 itself chooses them.
///
/// A tile of the [`S2Quadratic`](crate::cube::S2Quadratic) cube is the S2 cell with the same key, and a point
/// inside one is inside the other. The two libraries differ only for a point on the line between two cells,
/// or so near to it that rounding decides: [`Tile::containing`] takes the tile of larger x or y along this
/// crate's axes; S2 takes the cell of larger s or t along its own axes, after its own rounding. The functions
/// of this block return S2's choice.
impl Key<Hilbert> {
    /// Returns S2's leaf cell (level 30) of a direction: the number of C++ `S2CellId(point)`, bit for bit.
    /// [`ancestor`](Self::ancestor) gives the cell of a coarser level.
    ///
    /// The face is that of the component with the largest magnitude; of equal components S2 prefers z to y
    /// and y to x. Then follow S2's own divisions and square roots in double precision (`s2coords.h`). The
    /// ports of S2 to Go and Rust prefer x to y and y to z where components are equal: on the twelve edges of
    /// the cube they differ from S2 in C++ and from this function.
    ///
    /// S2's `S2CellId(S2LatLng)` computes sines and cosines from radians. They differ by up to 2·10⁻¹⁶ from
    /// those of [`LatLon::to_direction`](crate::LatLon::to_direction), which computes from degrees: for a
    /// place within 2 nm of a line between cells, the two functions may return different cells.
    ///
    /// ```
    /// use terrella::terrain::{Hilbert, Key};
    /// use terrella::LatLon;
    /// let cell = |lat, lon| Ok(Key::s2_leaf(LatLon::new(lat, lon)?.to_direction()).ancestor(10));
    /// let token = |lat, lon| cell(lat, lon).map(|key: Option<Key<Hilbert>>| key.map(|key| key.to_string()));
    /// assert_eq!(token(48.8566, 2.3522)?.as_deref(), Some("47e66f"));
    /// assert_eq!(token(90.0, 0.0)?.as_deref(), Some("500001")); // where four cells meet
    /// # Ok::<(), terrella::InvalidLatLon<f64>>(())
    /// ```
    #[doc(alias = "S2CellId")]
    #[doc(alias = "S2LatLng")]
    #[doc(alias = "S2Point")]
    #[must_use]
    #[inline]
    pub fn s2_leaf(direction: Direction<f64>) -> Self {
        leaf_of(direction.to_array())
    }

    /// Returns S2's leaf cell of a vector of any length, which S2 does not normalise: see
    /// [`s2_leaf`](Self::s2_leaf). Convert the components of a vector in single precision to `f64` unchanged.
    ///
    /// ```
    /// use terrella::terrain::Key;
    /// let cell = Key::s2_leaf_of([0.0, 1.0, 1.0])?;
    /// assert_eq!(cell.bits() >> 61, 2); // S2's face of the north
    /// let single = Key::s2_leaf_of([0.5_f32, 0.25, 0.0].map(f64::from))?;
    /// assert_eq!(single.ancestor(3).map(|key| key.to_string()).as_deref(), Some("174"));
    /// # Ok::<(), terrella::InvalidDirection<f64>>(())
    /// ```
    ///
    /// # Errors
    /// [`InvalidDirection`] if the vector is zero, or if a component is infinite or NaN.
    #[inline]
    pub fn s2_leaf_of([x, y, z]: [f64; 3]) -> Result<Self, InvalidDirection<f64>> {
        if has_s2_leaf([x, y, z]) {
            Ok(leaf_of([x, y, z]))
        } else {
            Err(InvalidDirection { x, y, z })
        }
    }

    /// Returns S2's leaf cell of cell-space coordinates (s, t) ∈ [0, 1]² on one of S2's faces, 0 to 5. A
    /// coordinate of exactly 1 belongs to the last cell.
    ///
    /// ```
    /// use terrella::terrain::Key;
    /// assert_eq!(Key::s2_leaf_at(0, [0.0, 0.5])?.bits(), 0x0800_0000_0000_0001);
    /// assert!(Key::s2_leaf_at(6, [0.0, 0.5]).is_err() && Key::s2_leaf_at(0, [0.0, 1.1]).is_err());
    /// # Ok::<(), terrella::cube::InvalidNumbered<f64>>(())
    /// ```
    ///
    /// # Errors
    /// [`InvalidNumbered`] if the face is above 5, or if a coordinate is outside [0, 1] or NaN.
    #[inline]
    pub fn s2_leaf_at(face: u8, [s, t]: [f64; 2]) -> Result<Self, InvalidNumbered<f64>> {
        let face = Numbering::S2.face(face).map_err(InvalidNumbered::Face)?;
        let inside = |s: f64| (0.0..=1.0).contains(&s);
        if !(inside(s) && inside(t)) {
            return Err(InvalidNumbered::Point(InvalidFacePoint { x: s, y: t }));
        }
        Ok(leaf(face, [s, t]))
    }

    /// Returns the four cells of the same level that share an edge with this one, in the order of S2's
    /// `GetEdgeNeighbors`: below, right, above and left along S2's axes.
    ///
    /// ```
    /// use terrella::terrain::Key;
    /// let face: Key<_> = "3".parse()?;
    /// assert_eq!(face.s2_edge_neighbours().map(|key| key.to_string()), ["b", "7", "5", "1"]);
    /// # Ok::<(), terrella::terrain::InvalidToken>(())
    /// ```
    #[doc(alias = "GetEdgeNeighbors")]
    #[must_use]
    pub fn s2_edge_neighbours(self) -> [Self; 4] {
        let tile = Tile::from(self);
        [Edge::Down, Edge::Right, Edge::Up, Edge::Left].map(|edge| {
            tile.neighbour(Edge::turned(edge as u8 + 4 - Numbering::S2.turns(tile.face)))
                .tile
                .into()
        })
    }
}

/// The leaf of a vector that is not zero, computed as in `S2::XYZtoFaceUV` and `S2::UVtoST`.
#[inline(always)]
pub(crate) fn leaf_of([x, y, z]: [f64; 3]) -> Key<Hilbert> {
    let [a, b, c] = [x, y, z].map(f64::abs);
    let front = (a > b) & (a > c);
    // If not in front, a ≤ b where b > c.
    let side = !front & (b > c);
    let outward = select(front, x, select(side, y, z));
    let (right, up) = (select(front, y, -x), select(front | side, z, -y));
    let behind = outward < 0.0;
    let uv = [select(behind, up, right) / outward, select(behind, right, up) / outward];
    // Front, right and top; back, left and bottom.
    let face = if front {
        2 * u8::from(behind)
    } else if side {
        1 + 2 * u8::from(behind)
    } else {
        4 + u8::from(behind)
    };
    leaf(Face::numbered(face), uv.map(quadratic))
}

/// Whether a vector has a direction.
#[inline(always)]
pub(crate) fn has_s2_leaf([x, y, z]: [f64; 3]) -> bool {
    let zero = (x == 0.0) & (y == 0.0) & (z == 0.0);
    !zero & x.is_finite() & y.is_finite() & z.is_finite()
}

/// S2's quadratic transformation, with S2's rounding ([`S2Quadratic`](crate::cube::S2Quadratic) rounds less).
#[inline(always)]
fn quadratic(u: f64) -> f64 {
    let root = 0.5 * Real::sqrt(1.0 + 3.0 * u.abs());
    select(u >= 0.0, root, 1.0 - root)
}

/// The leaf of S2's (s, t) on a face (`S2::STtoIJ`).
#[inline(always)]
fn leaf(face: Face, st: [f64; 2]) -> Key<Hilbert> {
    const COUNT: u32 = 1 << Tile::MAX_LEVEL;
    let [i, j] = st.map(|s| ((s * f64::from(COUNT)) as u32).min(COUNT - 1));
    Tile::of_numbering(Numbering::S2, face, Tile::MAX_LEVEL, [i, j]).into()
}

impl Tile {
    /// Returns the face number, column and row of this tile in another convention of faces and axes. Columns
    /// count along that convention's first axis, and rows along its second axis, which points down in
    /// [`OpenGl`](Numbering::OpenGl).
    ///
    /// ```
    /// use terrella::cube::{Face, Numbering};
    /// use terrella::terrain::Tile;
    /// let tile = Tile::new(Face::Top, 3, 5, 2)?;
    /// assert_eq!(tile.to_numbering(Numbering::S2), (2, 2, 2));
    /// assert_eq!(tile.to_numbering(Numbering::OpenGl), (2, 5, 5));
    /// assert_eq!(Tile::from_numbering(Numbering::S2, 2, 3, 2, 2), Ok(tile));
    /// # Ok::<(), terrella::terrain::InvalidTile>(())
    /// ```
    #[must_use]
    #[inline]
    pub const fn to_numbering(self, numbering: Numbering) -> (u8, u32, u32) {
        let [i, j] = numbering.to_square(self.face, self.last(), [self.i, self.j]);
        (numbering.number(self.face), i, j)
    }

    /// Creates the tile of a face number, level, column and row that are given in another convention of faces
    /// and axes: the inverse of [`to_numbering`](Self::to_numbering).
    ///
    /// # Errors
    /// [`InvalidNumberedTile`] if the face is above 5, the level is above 30, or the column or row is not in
    /// 0 to 2^level − 1.
    #[inline]
    pub fn from_numbering(
        numbering: Numbering,
        face: u8,
        level: u8,
        i: u32,
        j: u32,
    ) -> Result<Self, InvalidNumberedTile> {
        let face = numbering.face(face).map_err(InvalidNumberedTile::Face)?;
        Self::new(face, level, i, j).map_err(InvalidNumberedTile::Tile)?;
        Ok(Self::of_numbering(numbering, face, level, [i, j]))
    }

    /// The same for a level, column and row that are known to be in range.
    #[inline(always)]
    const fn of_numbering(numbering: Numbering, face: Face, level: u8, square: [u32; 2]) -> Self {
        let root = Self::within(face, level, 0, 0);
        let [i, j] = numbering.square_of(face, root.last(), square);
        Self::within(face, level, i, j)
    }
}

/// The error of [`Tile::from_numbering`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum InvalidNumberedTile {
    /// The face number is above 5.
    Face(InvalidFace),
    /// The level is above 30, or the column or row is not in 0 to 2^level − 1.
    Tile(InvalidTile),
}

impl core::fmt::Display for InvalidNumberedTile {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        match self {
            Self::Face(face) => face.fmt(f),
            Self::Tile(tile) => tile.fmt(f),
        }
    }
}

impl core::error::Error for InvalidNumberedTile {}
