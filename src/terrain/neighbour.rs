use super::{InvalidTile, Tile};
use crate::cube::{Corner, Edge, beyond};

/// The neighbour of a tile across an edge: from [`Tile::neighbour`].
///
/// `turns` relates the axes of the two tiles, as in [`Neighbour`](crate::cube::Neighbour) for faces. Unfold
/// the neighbour into the plane of this tile, with this tile's s to the right and t up. After `turns`
/// counter-clockwise quarter turns of the plane, the neighbour's own s points to the right and its t up.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Adjacent {
    /// The tile across the edge.
    pub tile: Tile,
    /// The shared edge, in the neighbour's own axes.
    pub edge: Edge,
    /// Counter-clockwise quarter turns, 0 to 3; 0 if both tiles are on one face.
    pub turns: u8,
}

/// The neighbour of a tile across a corner: from [`Tile::diagonal`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Diagonal {
    /// The tile that shares this corner, but no edge.
    pub tile: Tile,
    /// The shared corner, in the neighbour's own axes.
    pub corner: Corner,
    /// Counter-clockwise quarter turns, as in [`Adjacent`], 0 to 3; 0 if both tiles are on one face.
    pub turns: u8,
}

/// The tiles of one level that meet in a point, each with the name of its corner at that point. They are in
/// counter-clockwise order, seen from outside.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Around {
    /// Three tiles, at a corner of the cube.
    Three([(Tile, Corner); 3]),
    /// Four tiles, at any other point.
    Four([(Tile, Corner); 4]),
}

impl Around {
    /// Returns the three or four tiles as a slice.
    #[must_use]
    pub const fn as_slice(&self) -> &[(Tile, Corner)] {
        match self {
            Self::Three(tiles) => tiles,
            Self::Four(tiles) => tiles,
        }
    }
}

impl Tile {
    /// Returns the neighbour across an edge, at the same level.
    ///
    /// ```
    /// use terrella::cube::{Edge, Face};
    /// use terrella::terrain::Tile;
    /// let beyond = Tile::new(Face::Right, 3, 2, 7)?.neighbour(Edge::Up);
    /// assert_eq!(beyond.tile, Tile::new(Face::Top, 3, 7, 2)?);
    /// assert_eq!((beyond.edge, beyond.turns), (Edge::Right, 1));
    /// # Ok::<(), terrella::terrain::InvalidTile>(())
    /// ```
    #[doc(alias = "adjacent tile")]
    #[must_use]
    #[inline]
    pub const fn neighbour(self, edge: Edge) -> Adjacent {
        let (i, j) = match edge {
            Edge::Right => (1, 0),
            Edge::Up => (0, 1),
            Edge::Left => (u32::MAX, 0),
            Edge::Down => (0, u32::MAX),
        };
        let (i, j) = (self.i.wrapping_add(i), self.j.wrapping_add(j));
        let (tile, turns) = self.beyond(i, j, edge);
        let edge = Edge::turned(edge as u8 + 2 + turns);
        Adjacent { tile, edge, turns }
    }

    /// Returns the neighbour across a corner, at the same level. Returns `None` at a corner of the cube:
    /// there only this tile and its two edge neighbours meet.
    ///
    /// ```
    /// use terrella::cube::{Corner, Face};
    /// use terrella::terrain::Tile;
    /// let tile = Tile::new(Face::Front, 3, 7, 6)?;
    /// let beyond = tile.diagonal(Corner::UpRight).ok_or("four meet there")?;
    /// assert_eq!((beyond.tile, beyond.corner), (Tile::new(Face::Right, 3, 0, 7)?, Corner::DownLeft));
    /// assert_eq!(Tile::new(Face::Front, 3, 7, 7)?.diagonal(Corner::UpRight), None);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[must_use]
    #[inline]
    pub const fn diagonal(self, corner: Corner) -> Option<Diagonal> {
        let (i, j) = match corner {
            Corner::UpRight => (1, 1),
            Corner::UpLeft => (u32::MAX, 1),
            Corner::DownLeft => (u32::MAX, u32::MAX),
            Corner::DownRight => (1, u32::MAX),
        };
        let (i, j) = (self.i.wrapping_add(i), self.j.wrapping_add(j));
        let (beside, above) = (i > self.last(), j > self.last());
        if beside & above {
            return None;
        }
        let (first, second) = corner.edges();
        // A change of i crosses the edges of even number.
        let edge = if beside == (first as u8 % 2 == 0) {
            first
        } else {
            second
        };
        let (tile, turns) = self.beyond(i, j, edge);
        let corner = Corner::turned(corner as u8 + 2 + turns);
        Some(Diagonal { tile, corner, turns })
    }

    /// Returns the tile of any level that shares this corner with this tile, but no edge.
    ///
    /// At a finer level it exists wherever [`diagonal`](Self::diagonal) returns a tile. At a coarser level it
    /// often does not exist: the coarse tile across the corner may also lie across an edge, or contain this
    /// tile. Then the result is `None`.
    ///
    /// ```
    /// use terrella::cube::{Corner, Face};
    /// use terrella::terrain::Tile;
    /// let tile = Tile::new(Face::Front, 3, 3, 3)?;
    /// let across = |level| {
    ///     tile.diagonal_at(Corner::UpRight, level).map(|beyond| beyond.map(|beyond| beyond.tile))
    /// };
    /// assert_eq!(across(5)?, Some(Tile::new(Face::Front, 5, 16, 16)?));
    /// assert_eq!(across(1)?, Some(Tile::new(Face::Front, 1, 1, 1)?));
    /// assert_eq!(across(0)?, None);
    /// # Ok::<(), terrella::terrain::InvalidTile>(())
    /// ```
    ///
    /// # Errors
    /// [`InvalidTile::Level`] if the level is above 30.
    pub const fn diagonal_at(self, corner: Corner, level: u8) -> Result<Option<Diagonal>, InvalidTile> {
        if level > Self::MAX_LEVEL {
            return Err(InvalidTile::Level(level));
        }
        let Some(beyond) = self.diagonal(corner) else {
            return Ok(None);
        };
        let tile = match beyond.tile.ancestor(level) {
            Some(coarse) => {
                let (first, second) = corner.edges();
                if coarse.contains(self)
                    || coarse.contains(self.neighbour(first).tile)
                    || coarse.contains(self.neighbour(second).tile)
                {
                    return Ok(None);
                }
                coarse
            }
            None => {
                let finer = level - beyond.tile.level;
                let last = (1 << finer) - 1;
                let (right, up) = match beyond.corner {
                    Corner::UpRight => (last, last),
                    Corner::UpLeft => (0, last),
                    Corner::DownLeft => (0, 0),
                    Corner::DownRight => (last, 0),
                };
                let (i, j) = ((beyond.tile.i << finer) + right, (beyond.tile.j << finer) + up);
                Self::within(beyond.tile.face, level, i, j)
            }
        };
        Ok(Some(Diagonal { tile, ..beyond }))
    }

    /// Returns the tiles of this level that meet in a corner, this tile first: three at a corner of the cube,
    /// four elsewhere.
    ///
    /// ```
    /// use terrella::cube::{Corner, Face};
    /// use terrella::terrain::{Around, Tile};
    /// let around = Tile::new(Face::Front, 3, 7, 7)?.around(Corner::UpRight);
    /// let expected = [
    ///     (Tile::new(Face::Front, 3, 7, 7)?, Corner::UpRight),
    ///     (Tile::new(Face::Right, 3, 0, 7)?, Corner::UpLeft),
    ///     (Tile::new(Face::Top, 3, 7, 0)?, Corner::DownRight),
    /// ];
    /// assert_eq!(around, Around::Three(expected));
    /// # Ok::<(), terrella::terrain::InvalidTile>(())
    /// ```
    #[must_use]
    pub const fn around(self, corner: Corner) -> Around {
        let (first, second) = corner.edges();
        let (before, after) = (self.neighbour(first), self.neighbour(second));
        let this = (self, corner);
        let before = (before.tile, Corner::turned(corner as u8 + 1 + before.turns));
        let after = (after.tile, Corner::turned(corner as u8 + 3 + after.turns));
        match self.diagonal(corner) {
            None => Around::Three([this, before, after]),
            Some(beyond) => Around::Four([this, before, (beyond.tile, beyond.corner), after]),
        }
    }

    /// Returns the tiles of a coarser level that meet in one corner of this tile's ancestor: the corner
    /// nearest to this tile. The ancestor comes first. This is S2's `AppendVertexNeighbors`. Returns `None`
    /// if `level` is not coarser than this tile's level.
    ///
    /// ```
    /// use terrella::cube::{Corner, Face};
    /// use terrella::terrain::Tile;
    /// let tile = Tile::new(Face::Front, 5, 18, 17)?;
    /// assert_eq!(tile.around_nearest(3), Some(Tile::new(Face::Front, 3, 4, 4)?.around(Corner::DownRight)));
    /// assert_eq!(tile.around_nearest(5), None);
    /// # Ok::<(), terrella::terrain::InvalidTile>(())
    /// ```
    #[doc(alias = "AppendVertexNeighbors")]
    #[must_use]
    pub const fn around_nearest(self, level: u8) -> Option<Around> {
        // The corner is that of the quarter of the ancestor that contains this tile.
        let Some(Self { i, j, .. }) = self.ancestor(level.saturating_add(1)) else {
            return None;
        };
        let Some(ancestor) = self.ancestor(level) else {
            return None;
        };
        let corner = match (i % 2, j % 2) {
            (1, 1) => Corner::UpRight,
            (0, 1) => Corner::UpLeft,
            (0, _) => Corner::DownLeft,
            _ => Corner::DownRight,
        };
        Some(ancestor.around(corner))
    }

    /// Returns the tiles of any level that touch an edge of this tile from outside, for example to find
    /// T-junctions.
    ///
    /// * At a coarser level: one tile, or none if the tile of that level across the edge also contains this
    ///   tile.
    /// * At the same level: one tile.
    /// * At a level finer by n: 2ⁿ tiles, in the order of increasing x or y of this tile.
    ///
    /// ```
    /// use terrella::cube::{Edge, Face};
    /// use terrella::terrain::Tile;
    /// let tile = Tile::new(Face::Right, 1, 1, 1)?;
    /// let beyond = tile.neighbours(Edge::Up, 2)?;
    /// assert_eq!((beyond.edge(), beyond.len()), (Edge::Right, 2));
    /// assert!(beyond.eq([Tile::new(Face::Top, 2, 3, 2)?, Tile::new(Face::Top, 2, 3, 3)?]));
    /// assert!(tile.neighbours(Edge::Up, 0)?.eq([Tile::root(Face::Top)]));
    /// assert_eq!(tile.neighbours(Edge::Left, 0)?.len(), 0);
    /// # Ok::<(), terrella::terrain::InvalidTile>(())
    /// ```
    ///
    /// # Errors
    /// [`InvalidTile::Level`] if the level is above 30.
    #[doc(alias = "T-junction")]
    pub const fn neighbours(self, edge: Edge, level: u8) -> Result<Along, InvalidTile> {
        if level > Self::MAX_LEVEL {
            return Err(InvalidTile::Level(level));
        }
        let Adjacent {
            tile,
            edge: meets,
            turns,
        } = self.neighbour(edge);
        let (first, count) = match tile.ancestor(level) {
            Some(coarse) => (coarse, !coarse.contains(self) as u32),
            None => {
                let finer = level - tile.level;
                let last = (1 << finer) - 1;
                let (i, j) = (tile.i << finer, tile.j << finer);
                let (i, j) = match meets {
                    Edge::Right => (i + last, j),
                    Edge::Up => (i, j + last),
                    Edge::Left | Edge::Down => (i, j),
                };
                (Self::within(tile.face, level, i, j), last + 1)
            }
        };
        // The direction of a step along the edge, on the neighbour's face: a step along y becomes one along
        // −x after one turn, and along −y after two; a step along x becomes one along −x after two turns, and
        // along −y after three.
        let sideways = edge as u8 % 2 == 1;
        let backward = if sideways { turns >= 2 } else { turns == 1 || turns == 2 };
        Ok(Along {
            first,
            edge: meets,
            turns,
            backward,
            front: 0,
            back: count,
        })
    }

    /// The largest column and row of this level.
    #[inline(always)]
    pub(super) const fn last(self) -> u32 {
        (1 << self.level) - 1
    }

    /// The tile of a column and row that may be one beyond an edge, in the axes of its own face, and the
    /// quarter turns from this face to that one.
    #[inline(always)]
    const fn beyond(self, i: u32, j: u32, edge: Edge) -> (Self, u8) {
        let (face, [i, j], turns) = beyond(self.face, self.last(), [i, j], edge);
        (Self::within(face, self.level, i, j), turns)
    }
}

/// An iterator over the tiles along the far side of an edge: from [`Tile::neighbours`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[must_use]
pub struct Along {
    first: Tile,
    edge: Edge,
    turns: u8,
    backward: bool,
    front: u32,
    back: u32,
}

impl Along {
    /// Returns the edge of these tiles that touches this tile's edge, in their own axes.
    #[must_use]
    pub const fn edge(&self) -> Edge {
        self.edge
    }

    /// Returns the counter-clockwise quarter turns to their face, 0 to 3, as in [`Adjacent`].
    #[must_use]
    pub const fn turns(&self) -> u8 {
        self.turns
    }
}

impl Iterator for Along {
    type Item = Tile;

    #[inline]
    fn next(&mut self) -> Option<Tile> {
        if self.front == self.back {
            return None;
        }
        let steps = if self.backward {
            self.back -= 1;
            self.back
        } else {
            self.front += 1;
            self.front - 1
        };
        let Tile { face, level, i, j } = self.first;
        Some(match self.edge {
            Edge::Right | Edge::Left => Tile::within(face, level, i, j + steps),
            Edge::Up | Edge::Down => Tile::within(face, level, i + steps, j),
        })
    }

    #[inline]
    fn size_hint(&self) -> (usize, Option<usize>) {
        let left = (self.back - self.front) as usize;
        (left, Some(left))
    }
}

impl ExactSizeIterator for Along {}
impl core::iter::FusedIterator for Along {}
