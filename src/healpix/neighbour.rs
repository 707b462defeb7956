use super::Pixel;

/// A side of a pixel.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Side {
    /// From the southern corner to the western one.
    SouthWest,
    /// From the western corner to the northern one.
    NorthWest,
    /// From the northern corner to the eastern one.
    NorthEast,
    /// From the eastern corner to the southern one.
    SouthEast,
}

/// A corner of a pixel.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Corner {
    /// The southern corner.
    South,
    /// The western corner.
    West,
    /// The northern corner.
    North,
    /// The eastern corner.
    East,
}

impl Side {
    /// Every side, clockwise from the south-west.
    pub const ALL: [Self; 4] = [Self::SouthWest, Self::NorthWest, Self::NorthEast, Self::SouthEast];
}

impl Corner {
    /// Every corner, clockwise from the south.
    pub const ALL: [Self; 4] = [Self::South, Self::West, Self::North, Self::East];
}

impl Pixel {
    /// Returns the pixel of the same depth beyond a side.
    ///
    /// ```
    /// use terrella::healpix::{Pixel, Side};
    /// assert_eq!(Pixel::new(0, 4)?.neighbour(Side::NorthEast), Pixel::new(0, 0)?);
    /// # Ok::<(), terrella::healpix::InvalidPixel>(())
    /// ```
    #[must_use]
    #[inline]
    pub const fn neighbour(self, side: Side) -> Self {
        self.beyond(self.square(), side)
    }

    /// Returns the pixel of the same depth that shares a corner with this pixel, but no side. Returns `None`
    /// where only three pixels meet: at eight points, two of each base pixel's corners.
    ///
    /// These points are on the parallels where the polar caps begin: the western and eastern corners of the
    /// base pixels about the poles, and the northern and southern ones of those on the equator.
    ///
    /// ```
    /// use terrella::healpix::{Corner, Pixel};
    /// let base = Pixel::new(0, 4)?;
    /// assert_eq!(base.diagonal(Corner::East), Some(Pixel::new(0, 5)?));
    /// assert_eq!(base.diagonal(Corner::North), None);
    /// # Ok::<(), terrella::healpix::InvalidPixel>(())
    /// ```
    #[must_use]
    #[inline]
    pub const fn diagonal(self, corner: Corner) -> Option<Self> {
        let (last, [x, y]) = (self.last(), self.square());
        // The sides of the corner: that of x, and that of y.
        let (beside, above) = match corner {
            Corner::South => (Side::SouthWest, Side::SouthEast),
            Corner::West => (Side::SouthWest, Side::NorthWest),
            Corner::North => (Side::NorthEast, Side::NorthWest),
            Corner::East => (Side::NorthEast, Side::SouthEast),
        };
        match (step([x, y], beside, last), step([x, y], above, last)) {
            (_, Some(moved)) => Some(self.beyond(moved, beside)),
            (Some(moved), None) => Some(self.beyond(moved, above)),
            (None, None) => self.beyond_corner(corner),
        }
    }

    /// Returns the pixels of the same depth around this pixel, in the order of healpy: south-west, west,
    /// north-west, north, north-east, east, south-east, south.
    ///
    /// The west, north, east or south is `None` where only three pixels meet in the corner: see
    /// [`diagonal`](Self::diagonal).
    ///
    /// ```
    /// use terrella::healpix::Pixel;
    /// let around = Pixel::new(0, 4)?.neighbours();
    /// let numbers = around.map(|pixel| pixel.map(Pixel::number));
    /// assert_eq!(numbers, [Some(11), Some(7), Some(3), None, Some(0), Some(5), Some(8), None]);
    /// # Ok::<(), terrella::healpix::InvalidPixel>(())
    /// ```
    #[doc(alias = "get_all_neighbours")]
    #[must_use]
    #[inline]
    pub const fn neighbours(self) -> [Option<Self>; 8] {
        [
            Some(self.neighbour(Side::SouthWest)),
            self.diagonal(Corner::West),
            Some(self.neighbour(Side::NorthWest)),
            self.diagonal(Corner::North),
            Some(self.neighbour(Side::NorthEast)),
            self.diagonal(Corner::East),
            Some(self.neighbour(Side::SouthEast)),
            self.diagonal(Corner::South),
        ]
    }

    /// The pixel beyond a side of the pixel that has this column and row of this base pixel.
    #[inline(always)]
    const fn beyond(self, square: [u32; 2], side: Side) -> Self {
        let (depth, base, last) = (self.depth(), self.base(), self.last());
        if let Some(square) = step(square, side, last) {
            return Self::within(depth, base, square);
        }
        let (row, quarter, [x, y]) = (base / 4, base % 4, square);
        let (east, west) = ((quarter + 1) % 4, (quarter + 3) % 4);
        // About the poles a side between two base pixels of one row is x of one and y of the other.
        let (row, quarter, square) = match (row, side) {
            (0, Side::NorthEast) => (0, east, [y, last]),
            (0, Side::NorthWest) => (0, west, [last, x]),
            (0, Side::SouthEast) => (1, east, [x, last]),
            (0, Side::SouthWest) => (1, quarter, [last, y]),
            (1, Side::NorthEast) => (0, quarter, [0, y]),
            (1, Side::NorthWest) => (0, west, [x, 0]),
            (1, Side::SouthEast) => (2, quarter, [x, last]),
            (1, Side::SouthWest) => (2, west, [last, y]),
            (_, Side::NorthEast) => (1, east, [0, y]),
            (_, Side::NorthWest) => (1, quarter, [x, 0]),
            (_, Side::SouthEast) => (2, east, [0, x]),
            (_, Side::SouthWest) => (2, west, [y, 0]),
        };
        Self::within(depth, 4 * row + quarter, square)
    }

    /// The pixel beyond a corner of the base pixel.
    const fn beyond_corner(self, corner: Corner) -> Option<Self> {
        let (base, last) = (self.base(), self.last());
        let (row, quarter) = (base / 4, base % 4);
        let (row, turn, square) = match (row, corner) {
            (0, Corner::North) => (0, 2, [last, last]),
            (0, Corner::South) => (2, 0, [last, last]),
            (1, Corner::East) => (1, 1, [0, last]),
            (1, Corner::West) => (1, 3, [last, 0]),
            (2, Corner::North) => (0, 0, [0, 0]),
            (2, Corner::South) => (2, 2, [0, 0]),
            _ => return None,
        };
        Some(Self::within(self.depth(), 4 * row + (quarter + turn) % 4, square))
    }
}

/// Column and row beyond a side, if they are of the same base pixel.
#[inline(always)]
const fn step([x, y]: [u32; 2], side: Side, last: u32) -> Option<[u32; 2]> {
    match side {
        Side::NorthEast if x < last => Some([x + 1, y]),
        Side::NorthWest if y < last => Some([x, y + 1]),
        Side::SouthWest if x > 0 => Some([x - 1, y]),
        Side::SouthEast if y > 0 => Some([x, y - 1]),
        _ => None,
    }
}
