use core::fmt;

use super::{Corner, Edge, Face, FacePoint};
use crate::Real;
use crate::math::select;

/// A cell of a face that is divided into n × n, for any n: column i from the left, row j from below.
///
/// Models of the atmosphere and the ocean have such cells: the cells of *c48* have n = 48, those of *c720*
/// n = 720. The cell covers −1 + 2i/n ≤ x ≤ −1 + 2(i + 1)/n, and likewise y with j. For powers of two,
/// [`Tile`](crate::terrain::Tile) has levels, keys and bounds besides.
///
/// FV3, GEOS and MITgcm number faces and axes as [`Numbering::S2`](super::Numbering::S2) does.
///
/// ```
/// use terrella::cube::{Cell, CubeMap, Edge, EquiEdge, Face};
/// use terrella::{Ellipsoid, LatLon, Shift};
///
/// let c48 = CubeMap::new(Ellipsoid::<f64>::WGS84, Shift::Geodetic, EquiEdge)?;
/// let cell = Cell::containing(c48.project(LatLon::new(52.5, 13.4)?), 48)?;
/// assert_eq!(cell, Cell::new(Face::Top, 48, 28, 5)?);
/// let centre = c48.unproject(cell.centre());
/// assert!((centre.lat() - 52.5).abs() < 1.0 && (centre.lon() - 13.4).abs() < 1.5);
/// assert_eq!(cell.neighbour(Edge::Right), Cell::new(Face::Top, 48, 29, 5)?);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[doc(alias = "cubed-sphere")]
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Cell {
    face: Face,
    n: u32,
    i: u32,
    j: u32,
}

impl Cell {
    /// The largest n, 2²⁴: `f32` tells the edges of such cells apart.
    pub const MAX_N: u32 = 1 << 24;

    /// Creates the cell of a face, of n (1 to 2²⁴) and a column and row (0 to n − 1).
    ///
    /// # Errors
    /// [`InvalidCell`] if n, the column or the row is out of range.
    pub const fn new(face: Face, n: u32, i: u32, j: u32) -> Result<Self, InvalidCell> {
        if n == 0 || n > Self::MAX_N {
            return Err(InvalidCell::Count(n));
        }
        if i >= n {
            return Err(InvalidCell::Column { n, i });
        }
        if j >= n {
            return Err(InvalidCell::Row { n, j });
        }
        Ok(Self { face, n, i, j })
    }

    /// Returns the cell that contains a point. A point on the line between two cells belongs to the cell of
    /// larger x or y, where the line is that of [`corner`](Self::corner), to the bit.
    ///
    /// # Errors
    /// [`InvalidCell::Count`] if n is 0 or above 2²⁴.
    pub fn containing<T: Real>(point: FacePoint<T>, n: u32) -> Result<Self, InvalidCell> {
        if n == 0 || n > Self::MAX_N {
            return Err(InvalidCell::Count(n));
        }
        let [i, j] = [point.x(), point.y()].map(|x| index(x, n));
        let face = point.face();
        Ok(Self { face, n, i, j })
    }

    /// Returns the face.
    #[must_use]
    pub const fn face(self) -> Face {
        self.face
    }

    /// Returns n, the number of columns and of rows of the face, 1 to 2²⁴.
    #[must_use]
    pub const fn n(self) -> u32 {
        self.n
    }

    /// Returns the column, counted from the left, 0 to n − 1.
    #[must_use]
    pub const fn i(self) -> u32 {
        self.i
    }

    /// Returns the row, counted from below, 0 to n − 1.
    #[must_use]
    pub const fn j(self) -> u32 {
        self.j
    }

    /// Returns the centre. Its coordinates are correctly rounded.
    #[must_use]
    pub fn centre<T: Real>(self) -> FacePoint<T> {
        let [x, y] = [self.i, self.j].map(|index| coordinate(2 * index + 1, 2 * self.n));
        FacePoint::within(self.face, x, y)
    }

    /// Returns a corner. Its coordinates are correctly rounded; cells that meet there give the same bits. On
    /// an edge of the cube, coordinates of different faces may trade places or change sign, as the axes of
    /// the faces require.
    #[must_use]
    pub fn corner<T: Real>(self, corner: Corner) -> FacePoint<T> {
        let right = matches!(corner, Corner::UpRight | Corner::DownRight);
        let up = matches!(corner, Corner::UpRight | Corner::UpLeft);
        let [x, y] =
            [(self.i, right), (self.j, up)].map(|(index, beyond)| coordinate(index + u32::from(beyond), self.n));
        FacePoint::within(self.face, x, y)
    }

    /// Returns the four corners in the order of [`Corner::ALL`]: counter-clockwise from the corner of largest
    /// x and y.
    #[must_use]
    pub fn corners<T: Real>(self) -> [FacePoint<T>; 4] {
        Corner::ALL.map(|corner| self.corner(corner))
    }

    /// Returns the cell across an edge, also if that is an edge of the face. [`Face::neighbour`] says how the
    /// axes of the two faces are turned.
    ///
    /// ```
    /// use terrella::cube::{Cell, Edge, Face};
    /// let beyond = Cell::new(Face::Right, 48, 2, 47)?.neighbour(Edge::Up);
    /// assert_eq!(beyond, Cell::new(Face::Top, 48, 47, 2)?);
    /// # Ok::<(), terrella::cube::InvalidCell>(())
    /// ```
    #[must_use]
    pub const fn neighbour(self, edge: Edge) -> Self {
        let Self { face, n, i, j } = self;
        let (i, j) = match edge {
            Edge::Right => (i + 1, j),
            Edge::Up => (i, j + 1),
            Edge::Left => (i.wrapping_sub(1), j),
            Edge::Down => (i, j.wrapping_sub(1)),
        };
        let (face, [i, j], _) = beyond(face, n - 1, [i, j], edge);
        Self { face, n, i, j }
    }

    /// Returns the cell that shares this corner, but no edge. Returns `None` at a corner of the cube: there
    /// only this cell and its two edge neighbours meet.
    #[must_use]
    pub const fn diagonal(self, corner: Corner) -> Option<Self> {
        let Self { face, n, i, j } = self;
        let (first, second) = corner.edges();
        let (i, j) = match corner {
            Corner::UpRight => (i + 1, j + 1),
            Corner::UpLeft => (i.wrapping_sub(1), j + 1),
            Corner::DownLeft => (i.wrapping_sub(1), j.wrapping_sub(1)),
            Corner::DownRight => (i + 1, j.wrapping_sub(1)),
        };
        let (beside, above) = (i >= n, j >= n);
        if beside && above {
            return None;
        }
        // A change of i crosses the edges of even number.
        let edge = if beside == (first as u8 % 2 == 0) {
            first
        } else {
            second
        };
        let (face, [i, j], _) = beyond(face, n - 1, [i, j], edge);
        Some(Self { face, n, i, j })
    }
}

/// The face, column and row of a cell of which one index may be one beyond an edge (−1 by wrapping), in the
/// axes of the face where it is, and the quarter turns to that face. `last` is the largest index.
#[inline(always)]
pub(crate) const fn beyond(face: Face, last: u32, [i, j]: [u32; 2], edge: Edge) -> (Face, [u32; 2], u8) {
    if i <= last && j <= last {
        return (face, [i, j], 0);
    }
    let across = face.neighbour(edge);
    let (i, j) = match edge {
        Edge::Right => (0, j),
        Edge::Up => (i, 0),
        Edge::Left => (last, j),
        Edge::Down => (i, last),
    };
    let place = match across.turns {
        0 => [i, j],
        1 => [last - j, i],
        2 => [last - i, last - j],
        _ => [j, last - i],
    };
    (across.face, place, across.turns)
}

/// −1 + 2 index/n as one division of whole numbers, an odd function about the middle of the face.
#[inline(always)]
fn coordinate<T: Real>(index: u32, n: u32) -> T {
    let twice = 2 * index;
    let distance = T::whole(twice.abs_diff(n).into()) / T::whole(n.into());
    select(twice < n, -distance, distance)
}

/// The column or row of a coordinate.
#[inline(always)]
fn index<T: Real>(x: T, n: u32) -> u32 {
    // The rounded guess is off by one at most.
    let guess = ((x + T::ONE) * T::whole(n.into()) * T::of(0.5)).floor();
    let guess = (guess.max(0) as u32).min(n - 1);
    let (low, high) = (coordinate::<T>(guess, n), coordinate::<T>(guess + 1, n));
    let up = u32::from((x >= high) & (guess < n - 1));
    let down = u32::from((x < low) & (guess > 0));
    guess + up - down
}

impl fmt::Display for Cell {
    /// Writes face, n, column and row: `top/48/5/2`.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { face, n, i, j } = self;
        write!(f, "{face}/{n}/{i}/{j}")
    }
}

/// The error of creating a [`Cell`]: a number is out of range.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum InvalidCell {
    /// The number of columns and rows; it is 0 or above 2²⁴.
    Count(u32),
    /// The column is not in 0 to n − 1.
    Column {
        /// The number of columns.
        n: u32,
        /// The column.
        i: u32,
    },
    /// The row is not in 0 to n − 1.
    Row {
        /// The number of rows.
        n: u32,
        /// The row.
        j: u32,
    },
}

impl fmt::Display for InvalidCell {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Count(n) => write!(f, "{n} columns and rows are not in 1 to {}", Cell::MAX_N),
            Self::Column { n, i } => write!(f, "column {i} is not in 0 to {n} - 1"),
            Self::Row { n, j } => write!(f, "row {j} is not in 0 to {n} - 1"),
        }
    }
}

impl core::error::Error for InvalidCell {}
