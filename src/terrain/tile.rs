use core::fmt;

use crate::Real;
use crate::cube::{Corner, Face, FacePoint};
use crate::math::{min, select};

/// A square piece of a face: at level L the face has 2^L × 2^L, column i from the left and row j from below.
///
/// It covers −1 + 2i/2^L ≤ x ≤ −1 + 2(i + 1)/2^L, and y by j alike. These coordinates are exact in `f64` at
/// every level and in `f32` to level 25; beyond, `f32` rounds them to the nearest, and corners of one tile
/// may coincide.
///
/// A place in a tile is (s, t) ∈ [0, 1]², s along x and t along y.
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
    /// The finest level, at which a tile of the Earth's is 9 mm wide.
    pub const MAX_LEVEL: u8 = 30;

    /// From a face, a level in 0 to 30, and a column and row in 0 to 2^level − 1.
    ///
    /// # Errors
    /// [`InvalidTile`] for a level above 30, or a column or row that the level does not have.
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

    /// For indices known to be in range.
    #[inline(always)]
    pub(crate) const fn within(face: Face, level: u8, i: u32, j: u32) -> Self {
        Self { face, level, i, j }
    }

    /// The tile of level 0: all of a face.
    #[must_use]
    #[inline]
    pub const fn root(face: Face) -> Self {
        Self::within(face, 0, 0, 0)
    }

    /// The tile of a level in which a point lies; on the line between two, the one of larger x or y. Exact at
    /// either precision.
    ///
    /// These are this crate's axes, and of a place on the edge of two faces
    /// [`project`](crate::cube::CubeProjection::project) takes the face of y before those of z and x. S2's
    /// axes are turned on three faces, and S2 takes z before y before x: its own cell of a place on a line
    /// between cells is [`Key::s2_leaf`](super::Key::s2_leaf).
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
    /// [`InvalidTile::Level`] for a level above 30.
    #[inline]
    pub fn containing<T: Real>(point: FacePoint<T>, level: u8) -> Result<Self, InvalidTile> {
        if level > Self::MAX_LEVEL {
            return Err(InvalidTile::Level(level));
        }
        let half = 1_u32 << (Self::MAX_LEVEL - 1);
        let index = |x: T| {
            // Scaling is exact; adding 1 to x first would not be.
            let finest = (x * T::whole(half.into())).floor().wrapping_add_unsigned(half);
            (finest as u32).min(2 * half - 1) >> (Self::MAX_LEVEL - level)
        };
        Ok(Self::within(point.face(), level, index(point.x()), index(point.y())))
    }

    /// The face.
    #[must_use]
    #[inline(always)]
    pub const fn face(self) -> Face {
        self.face
    }

    /// The level, in 0 to 30.
    #[must_use]
    #[inline(always)]
    pub const fn level(self) -> u8 {
        self.level
    }

    /// The column from the left, in 0 to 2^level − 1.
    #[must_use]
    #[inline(always)]
    pub const fn i(self) -> u32 {
        self.i
    }

    /// The row from below, in 0 to 2^level − 1.
    #[must_use]
    #[inline(always)]
    pub const fn j(self) -> u32 {
        self.j
    }

    /// The tile of the next coarser level that this is a quarter of; a face has none.
    #[must_use]
    #[inline]
    pub const fn parent(self) -> Option<Self> {
        match self.level {
            0 => None,
            level => Some(Self::within(self.face, level - 1, self.i >> 1, self.j >> 1)),
        }
    }

    /// The tile of a coarser level, or the same, that this lies in; none for a finer level.
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

    /// The four quarters, by columns in rows from below: (0, 0), (1, 0), (0, 1), (1, 1); the finest level has
    /// none.
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

    /// Whether the other tile is this one or lies in it.
    #[must_use]
    #[inline]
    pub const fn contains(self, other: Self) -> bool {
        match other.level.checked_sub(self.level) {
            None => false,
            Some(down) => self.face as u8 == other.face as u8 && other.i >> down == self.i && other.j >> down == self.j,
        }
    }

    /// A corner.
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

    /// The corners, counter-clockwise from the one of largest x and y, as [`Corner::ALL`].
    #[must_use]
    #[inline]
    pub fn corners<T: Real>(self) -> [FacePoint<T>; 4] {
        Corner::ALL.map(|corner| self.corner(corner))
    }

    /// The middle, where (s, t) = (½, ½).
    #[must_use]
    #[inline]
    pub fn centre<T: Real>(self) -> FacePoint<T> {
        self.node([1, 1], 2)
    }

    /// The node (m, n) of the tile's grid of `count` × `count` cells, at (s, t) = (m, n)/count; a larger m or
    /// n is taken for `count`, and a `count` of 0 for 1.
    ///
    /// Correctly rounded to counts of 2²² in `f64`, within 1.5 ulp in `f32`. Two tiles of a level that share
    /// an edge have the same bits along it, on either side of a face's edge too, but for the order and the
    /// signs that the other face's axes ask for: a coordinate is one division of whole numbers, and odd about
    /// the middle of the face.
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
        let count = u64::from(count) + u64::from(count == 0);
        let across = count << self.level;
        let coordinate = |index: u32, m: u32| {
            let twice = 2 * (u64::from(index) * count + u64::from(m).min(count));
            let distance = T::whole(twice.abs_diff(across)) / T::whole(across);
            select(twice < across, -distance, distance)
        };
        FacePoint::within(self.face, coordinate(self.i, m), coordinate(self.j, n))
    }

    /// The point of the face at (s, t), correctly rounded (`f32`: to level 25, an ulp beyond).
    ///
    /// The coordinates of a face have their own digits: at level L there are 2^(53−L) different s in the
    /// coarsest spot (`f64`), 2^(24−L) (`f32`).
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

    /// (s, t) of a point, within an ulp; none if it is on another face or beyond the tile's edges, which are
    /// part of the tile.
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
        // In half tiles: their number is exact, and what is left of it at any level.
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

    /// The lower end of a column or row, in units of 2^−level from the middle of the face.
    #[inline(always)]
    const fn low(self, index: u32) -> i32 {
        2 * index as i32 - (1 << self.level)
    }
}

/// The scalar nearest to a whole number of either sign.
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

/// Why there is no such [`Tile`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum InvalidTile {
    /// The level is above 30.
    Level(u8),
    /// The level has no such column.
    Column {
        /// The level.
        level: u8,
        /// The column.
        i: u32,
    },
    /// The level has no such row.
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

/// A place that is not in a tile: s or t is not in [0, 1].
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct InvalidPlace<T> {
    /// The coordinate along x.
    pub s: T,
    /// The coordinate along y.
    pub t: T,
}

impl<T: fmt::Debug> fmt::Display for InvalidPlace<T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "({:?}, {:?}) is not in [0, 1]²", self.s, self.t)
    }
}

impl<T: fmt::Debug> core::error::Error for InvalidPlace<T> {}
