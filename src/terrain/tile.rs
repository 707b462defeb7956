use core::fmt;

use crate::Real;
use crate::cube::{Corner, Face, FacePoint};
use crate::math::{min, select};

/// A quadtree tile: one of the 2^L × 2^L squares of a face at level L, in column i from the left and row j
/// from below.
///
/// The tile covers −1 + 2i/2^L ≤ x ≤ −1 + 2(i + 1)/2^L, and likewise y with j. These coordinates are exact in
/// `f64` at every level, and in `f32` up to level 25. At finer levels `f32` rounds them to the nearest
/// number, and corners of one tile may coincide.
///
/// A position within a tile is (s, t) ∈ [0, 1]², with s along x and t along y.
///
/// ```
/// use terrella::cube::{Face, FacePoint};
/// use terrella::terrain::Tile;
///
/// let tile = Tile::new(Face::Top, 3, 5, 2)?;
/// assert_eq!(tile.centre(), FacePoint::new(Face::Top, 0.375, -0.375)?);
/// assert_eq!(tile.parent(), Some(Tile::new(Face::Top, 2, 2, 1)?));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[doc(alias = "quadtree")]
#[doc(alias = "LOD")]
#[doc(alias = "QuadtreeTile")]
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Tile {
    pub(super) face: Face,
    pub(super) level: u8,
    pub(super) i: u32,
    pub(super) j: u32,
}

impl Tile {
    /// The finest level, 30. A tile of this level is 9 mm wide on the Earth.
    pub const MAX_LEVEL: u8 = 30;

    /// Creates the tile of a face, a level (0 to 30), and a column and row (0 to 2^level − 1).
    ///
    /// # Errors
    /// [`InvalidTile`] if the level is above 30, or the column or row is not in 0 to 2^level − 1.
    #[inline]
    pub const fn new(face: Face, level: u8, i: u32, j: u32) -> Result<Self, InvalidTile> {
        if level > Self::MAX_LEVEL {
            return Err(InvalidTile::Level(level));
        }
        if i >> level != 0 {
            return Err(InvalidTile::Column { level, i });
        }
        if j >> level != 0 {
            return Err(InvalidTile::Row { level, j });
        }
        Ok(Self { face, level, i, j })
    }

    /// Creates a tile of indices that are known to be in range.
    #[inline(always)]
    pub(crate) const fn within(face: Face, level: u8, i: u32, j: u32) -> Self {
        Self { face, level, i, j }
    }

    /// Returns the tile of level 0, which is a whole face.
    #[must_use]
    #[inline]
    pub const fn root(face: Face) -> Self {
        Self::within(face, 0, 0, 0)
    }

    /// Returns the tile of a level that contains a point. A point on the line between two tiles belongs to
    /// the tile of larger x or y. The result is exact in `f64` and in `f32`.
    ///
    /// The axes are those of this crate. For a place on the edge between two faces,
    /// [`project`](crate::cube::CubeProjection::project) prefers the face of y to that of z, and that of z to
    /// that of x. S2's axes are turned on three faces, and S2 prefers z to y and y to x: for S2's own cell of
    /// a place on a line between cells, use [`Key::s2_leaf`](super::Key::s2_leaf).
    ///
    /// ```
    /// use terrella::cube::{Face, FacePoint};
    /// use terrella::terrain::Tile;
    /// let point = FacePoint::new(Face::Left, 0.0, -1e-300)?;
    /// assert_eq!(Tile::containing(point, 1)?, Tile::new(Face::Left, 1, 1, 0)?);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`InvalidTile::Level`] if the level is above 30.
    #[inline]
    pub fn containing<T: Real>(point: FacePoint<T>, level: u8) -> Result<Self, InvalidTile> {
        if level > Self::MAX_LEVEL {
            return Err(InvalidTile::Level(level));
        }
        let [i, j] = [point.x(), point.y()].map(|x| Self::index(x, level));
        Ok(Self::within(point.face(), level, i, j))
    }

    /// The column or row of a coordinate at a level of at most 30.
    #[inline(always)]
    pub(crate) fn index<T: Real>(x: T, level: u8) -> u32 {
        let half = 1_u32 << (Self::MAX_LEVEL - 1);
        // Scaling is exact; adding 1 to x before it would round.
        let finest = (x * T::whole(half.into())).floor().wrapping_add_unsigned(half);
        (finest as u32).min(2 * half - 1) >> (Self::MAX_LEVEL - level)
    }

    /// Returns the face.
    #[must_use]
    #[inline(always)]
    pub const fn face(self) -> Face {
        self.face
    }

    /// Returns the level, 0 to 30.
    #[must_use]
    #[inline(always)]
    pub const fn level(self) -> u8 {
        self.level
    }

    /// Returns the column, counted from the left, 0 to 2^level − 1.
    #[must_use]
    #[inline(always)]
    pub const fn i(self) -> u32 {
        self.i
    }

    /// Returns the row, counted from below, 0 to 2^level − 1.
    #[must_use]
    #[inline(always)]
    pub const fn j(self) -> u32 {
        self.j
    }

    /// Returns the tile of the next coarser level that contains this one, or `None` for a tile of level 0.
    #[must_use]
    #[inline]
    pub const fn parent(self) -> Option<Self> {
        match self.level {
            0 => None,
            level => Some(Self::within(self.face, level - 1, self.i >> 1, self.j >> 1)),
        }
    }

    /// Returns the tile of `level` that contains this tile (the tile itself for its own level). Returns
    /// `None` if `level` is finer than this tile's level.
    ///
    /// ```
    /// use terrella::cube::Face;
    /// use terrella::terrain::Tile;
    /// let tile = Tile::new(Face::Top, 30, 12_345, 67_890)?;
    /// assert_eq!(tile.ancestor(14), Some(Tile::new(Face::Top, 14, 0, 1)?));
    /// assert_eq!(tile.ancestor(31), None);
    /// # Ok::<(), terrella::terrain::InvalidTile>(())
    /// ```
    #[must_use]
    #[inline]
    pub const fn ancestor(self, level: u8) -> Option<Self> {
        match self.level.checked_sub(level) {
            None => None,
            Some(up) => Some(Self::within(self.face, level, self.i >> up, self.j >> up)),
        }
    }

    /// Returns the finest tile that contains this one and another, or `None` if they are on different faces.
    ///
    /// ```
    /// use terrella::cube::Face;
    /// use terrella::terrain::Tile;
    /// let (tile, other) = (Tile::new(Face::Top, 5, 9, 30)?, Tile::new(Face::Top, 3, 3, 5)?);
    /// assert_eq!(tile.common_ancestor(other), Some(Tile::new(Face::Top, 1, 0, 1)?));
    /// assert_eq!(tile.common_ancestor(Tile::root(Face::Front)), None);
    /// # Ok::<(), terrella::terrain::InvalidTile>(())
    /// ```
    #[doc(alias = "lowest common ancestor")]
    #[must_use]
    #[inline]
    pub const fn common_ancestor(self, other: Self) -> Option<Self> {
        let level = if self.level < other.level {
            self.level
        } else {
            other.level
        };
        let (Some(a), Some(b)) = (self.ancestor(level), other.ancestor(level)) else {
            return None;
        };
        if a.face as u8 != b.face as u8 {
            return None;
        }
        // The bits of column and row that differ.
        let differing = 32 - ((a.i ^ b.i) | (a.j ^ b.j)).leading_zeros();
        a.ancestor(level - differing as u8)
    }

    /// Returns the four tiles of the next finer level, row by row from below: (0, 0), (1, 0), (0, 1), (1, 1)
    /// as (column, row). Returns `None` for a tile of level 30.
    ///
    /// ```
    /// use terrella::cube::Face;
    /// use terrella::terrain::Tile;
    /// let quarters = Tile::new(Face::Top, 1, 1, 0)?.children().map(|all| all.map(|q| (q.i(), q.j())));
    /// assert_eq!(quarters, Some([(2, 0), (3, 0), (2, 1), (3, 1)]));
    /// # Ok::<(), terrella::terrain::InvalidTile>(())
    /// ```
    #[must_use]
    #[inline]
    pub const fn children(self) -> Option<[Self; 4]> {
        if self.level == Self::MAX_LEVEL {
            return None;
        }
        let (level, i, j) = (self.level + 1, 2 * self.i, 2 * self.j);
        Some([
            Self::within(self.face, level, i, j),
            Self::within(self.face, level, i + 1, j),
            Self::within(self.face, level, i, j + 1),
            Self::within(self.face, level, i + 1, j + 1),
        ])
    }

    /// Returns whether `other` is this tile or a descendant of it.
    #[must_use]
    #[inline]
    pub const fn contains(self, other: Self) -> bool {
        match other.level.checked_sub(self.level) {
            None => false,
            Some(down) => {
                let (i, j) = (other.i >> down, other.j >> down);
                self.face as u8 == other.face as u8 && i == self.i && j == self.j
            }
        }
    }

    /// Returns a corner of the tile.
    ///
    /// ```
    /// use terrella::cube::{Corner, Face, FacePoint};
    /// use terrella::terrain::Tile;
    /// let tile = Tile::new(Face::Front, 2, 1, 0)?;
    /// assert_eq!(tile.corner(Corner::UpRight), FacePoint::new(Face::Front, 0.0_f32, -0.5)?);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[must_use]
    #[inline]
    pub fn corner<T: Real>(self, corner: Corner) -> FacePoint<T> {
        let right = matches!(corner, Corner::UpRight | Corner::DownRight);
        let up = matches!(corner, Corner::UpRight | Corner::UpLeft);
        self.node([right.into(), up.into()], 1)
    }

    /// Returns the four corners in the order of [`Corner::ALL`]: counter-clockwise from the corner of largest
    /// x and y.
    #[must_use]
    #[inline]
    pub fn corners<T: Real>(self) -> [FacePoint<T>; 4] {
        Corner::ALL.map(|corner| self.corner(corner))
    }

    /// Returns the centre of the tile, where (s, t) = (½, ½).
    #[must_use]
    #[inline]
    pub fn centre<T: Real>(self) -> FacePoint<T> {
        self.node([1, 1], 2)
    }

    /// Returns the node (m, n) of a grid of `count` × `count` cells over the tile, at (s, t) = (m, n)/count.
    /// An m or n above `count` is replaced by `count`, and a `count` of 0 by 1.
    ///
    /// Coordinates are correctly rounded for counts up to 2²² in `f64`, and within 1.5 ulp in `f32`. Two
    /// tiles of one level that share an edge get identical bits along it; if the edge is between two faces,
    /// the coordinates may trade places or change sign, as the axes of the faces require. This holds because
    /// each coordinate is one division of whole numbers, and an odd function about the middle of the face.
    ///
    /// ```
    /// use terrella::cube::{Face, FacePoint};
    /// use terrella::terrain::Tile;
    /// let (tile, next) = (Tile::new(Face::Front, 1, 0, 0)?, Tile::new(Face::Front, 1, 1, 0)?);
    /// assert_eq!(tile.node::<f64>([3, 1], 3), next.node([0, 1], 3));
    /// assert_eq!(tile.node([1, 0], 3), FacePoint::new(Face::Front, -2.0 / 3.0, -1.0)?);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[must_use]
    #[inline]
    pub fn node<T: Real>(self, [m, n]: [u32; 2], count: u32) -> FacePoint<T> {
        let [x, y] = [(self.i, m), (self.j, n)].map(|(index, m)| self.coordinate(index, m, count));
        FacePoint::within(self.face, x, y)
    }

    /// The coordinate of a node of the grid, in this tile's column or row.
    #[inline(always)]
    pub(crate) fn coordinate<T: Real>(self, index: u32, m: u32, count: u32) -> T {
        let count = u64::from(count) + u64::from(count == 0);
        let across = count << self.level;
        let twice = 2 * (u64::from(index) * count + u64::from(m).min(count));
        let distance = T::whole(twice.abs_diff(across)) / T::whole(across);
        select(twice < across, -distance, distance)
    }

    /// Returns the point of the face at position (s, t) of the tile. It is correctly rounded in `f64`, and in
    /// `f32` up to level 25; at finer levels `f32` is within 1 ulp.
    ///
    /// A point is stored by its face coordinates, so their spacing limits how many different values of s it
    /// can tell apart at level L: at least 2^(53−L) in `f64`, and 2^(24−L) in `f32`.
    ///
    /// ```
    /// use terrella::cube::{Face, FacePoint};
    /// use terrella::terrain::Tile;
    /// let tile = Tile::new(Face::Front, 2, 3, 0)?;
    /// assert_eq!(tile.point([0.25, 1.0])?, FacePoint::new(Face::Front, 0.625, -0.5)?);
    /// assert!(tile.point([0.25, 1.1]).is_err());
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`InvalidPlace`] if s or t is outside [0, 1] or NaN.
    #[inline]
    pub fn point<T: Real>(self, [s, t]: [T; 2]) -> Result<FacePoint<T>, InvalidPlace<T>> {
        let inside = |s: T| (s >= T::ZERO) & (s <= T::ONE);
        if !(inside(s) & inside(t)) {
            return Err(InvalidPlace { s, t });
        }
        let across = T::whole(1 << self.level);
        let coordinate = |index: u32, s: T| min((signed::<T>(self.low(index)) + (s + s)) / across, T::ONE);
        Ok(FacePoint::within(
            self.face,
            coordinate(self.i, s),
            coordinate(self.j, t),
        ))
    }

    /// Returns the position (s, t) of a point within the tile, within 1 ulp. Returns `None` if the point is
    /// on another face or outside the tile. The tile's edges belong to the tile.
    ///
    /// ```
    /// use terrella::cube::{Face, FacePoint};
    /// use terrella::terrain::Tile;
    /// let tile = Tile::new(Face::Front, 2, 3, 0)?;
    /// assert_eq!(tile.place(FacePoint::new(Face::Front, 0.625, -0.5)?), Some([0.25, 1.0]));
    /// assert_eq!(tile.place(FacePoint::new(Face::Front, 0.375, -0.5)?), None);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[must_use]
    #[inline]
    pub fn place<T: Real>(self, point: FacePoint<T>) -> Option<[T; 2]> {
        let across = T::whole(1 << self.level);
        // The number of whole half tiles is exact, and so is the remainder, at any level.
        let place = |index: u32, x: T| {
            let scaled = x * across;
            let floor = scaled.floor();
            let halves = floor - self.low(index);
            let rest = scaled - signed::<T>(floor);
            let inside = (halves == 0) | (halves == 1) | ((halves == 2) & (rest == T::ZERO));
            (inside, T::of(0.5) * (rest + signed::<T>(halves)))
        };
        let (inside_s, s) = place(self.i, point.x());
        let (inside_t, t) = place(self.j, point.y());
        let inside = (point.face() == self.face) & inside_s & inside_t;
        inside.then_some([s, t])
    }

    /// The lower end of a column or row, in half tile widths from the middle of the face.
    #[inline(always)]
    const fn low(self, index: u32) -> i32 {
        2 * index as i32 - (1 << self.level)
    }
}

/// The scalar nearest to a signed whole number.
#[inline(always)]
fn signed<T: Real>(number: i32) -> T {
    let magnitude = T::whole(number.unsigned_abs().into());
    select(number < 0, -magnitude, magnitude)
}

impl fmt::Display for Tile {
    /// Writes face, level, column and row: `top/3/5/2`. To parse text, see [`Key`](super::Key).
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { face, level, i, j } = self;
        write!(f, "{face}/{level}/{i}/{j}")
    }
}

/// The error of creating a [`Tile`]: an index is out of range.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum InvalidTile {
    /// The level; it is above 30.
    Level(u8),
    /// The column is not in 0 to 2^level − 1.
    Column {
        /// The level.
        level: u8,
        /// The column.
        i: u32,
    },
    /// The row is not in 0 to 2^level − 1.
    Row {
        /// The level.
        level: u8,
        /// The row.
        j: u32,
    },
}

impl fmt::Display for InvalidTile {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Level(level) => write!(f, "level {level} is not in 0 to 30"),
            Self::Column { level, i } => write!(f, "column {i} is not in 0 to 2^{level} - 1"),
            Self::Row { level, j } => write!(f, "row {j} is not in 0 to 2^{level} - 1"),
        }
    }
}

impl core::error::Error for InvalidTile {}

/// The error of [`Tile::point`]: s or t is outside [0, 1] or NaN.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct InvalidPlace<T> {
    /// The value of s, the coordinate along x.
    pub s: T,
    /// The value of t, the coordinate along y.
    pub t: T,
}

impl<T: fmt::Debug> fmt::Display for InvalidPlace<T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "({:?}, {:?}) is not in [0, 1]²", self.s, self.t)
    }
}

impl<T: fmt::Debug> core::error::Error for InvalidPlace<T> {}
