use super::{InvalidTile, Tile};
use crate::cube::{Corner, Edge};

/// What lies across an edge of a tile.
///
/// As [`Neighbour`](crate::cube::Neighbour) has it for faces: laid flat beside this tile and then turned
/// counter-clockwise by `turns` quarter circles, the plane of this tile's (s, t) becomes that of the
/// neighbour's.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Adjacent {
    /// The tile across the edge.
    pub tile: Tile,
    /// The shared edge, as that tile calls it.
    pub edge: Edge,
    /// Counter-clockwise quarter turns, 0 to 3; 0 on the same face.
    pub turns: u8,
}

/// What lies across a corner of a tile.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Diagonal {
    /// The tile that has this corner, and no edge, in common.
    pub tile: Tile,
    /// The shared corner, as that tile calls it.
    pub corner: Corner,
    /// Counter-clockwise quarter turns, 0 to 3; 0 on the same face.
    pub turns: u8,
}

/// The tiles of a level that meet in a point, each with the corner that it has there: counter-clockwise as
/// seen from outside.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Around {
    /// In a corner of the cube.
    Three([(Tile, Corner); 3]),
    /// Anywhere else.
    Four([(Tile, Corner); 4]),
}

impl Around {
    /// The tiles, three or four.
    #[must_use]
    pub const fn as_slice(&self) -> &[(Tile, Corner)] {
        match self {
            Self::Three(tiles) => tiles,
            Self::Four(tiles) => tiles,
        }
    }
}

impl Tile {
    /// What lies across an edge, at the same level.
    ///
    /// ```
    /// use terrella::cube::{Edge, Face};
    /// use terrella::terrain::Tile;
    /// let beyond = Tile::new(Face::Right, 3, 2, 7)?.neighbour(Edge::Up);
    /// assert_eq!((beyond.tile, beyond.edge, beyond.turns), (Tile::new(Face::Top, 3, 7, 2)?, Edge::Right, 1));
    /// # Ok::<(), terrella::terrain::InvalidTile>(())
    /// ```
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

    /// What lies across a corner, at the same level; nothing in a corner of the cube, where this tile and its
    /// neighbours across the two edges are all there is.
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
        // Of the two edges, those of even number are crossed by a change of i.
        let edge = if beside == (first as u8 % 2 == 0) {
            first
        } else {
            second
        };
        let (tile, turns) = self.beyond(i, j, edge);
        let corner = Corner::turned(corner as u8 + 2 + turns);
        Some(Diagonal { tile, corner, turns })
    }

    /// What lies across a corner at any level: the tile that has this corner, and no edge, in common with
    /// this one. Of a finer level there is one wherever there is a [`diagonal`](Self::diagonal); of a coarser
    /// one often none, since the tile that lies there is also across an edge, or holds this tile.
    ///
    /// ```
    /// use terrella::cube::{Corner, Face};
    /// use terrella::terrain::Tile;
    /// let tile = Tile::new(Face::Front, 3, 3, 3)?;
    /// let across = |level| tile.diagonal_at(Corner::UpRight, level).map(|beyond| beyond.map(|beyond| beyond.tile));
    /// assert_eq!(across(5)?, Some(Tile::new(Face::Front, 5, 16, 16)?));
    /// assert_eq!(across(1)?, Some(Tile::new(Face::Front, 1, 1, 1)?));
    /// assert_eq!(across(0)?, None);
    /// # Ok::<(), terrella::terrain::InvalidTile>(())
    /// ```
    ///
    /// # Errors
    /// [`InvalidTile::Level`] for a level above 30.
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

    /// The tiles that meet in a corner, this one first: three in a corner of the cube, four elsewhere.
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

    /// The tiles of a coarser level about one corner of this tile's ancestor of that level, which is first:
    /// the corner that is nearest to this tile. S2's `AppendVertexNeighbors`. None for a level that is not
    /// coarser.
    ///
    /// ```
    /// use terrella::cube::{Corner, Face};
    /// use terrella::terrain::Tile;
    /// let tile = Tile::new(Face::Front, 5, 18, 17)?;
    /// assert_eq!(tile.around_nearest(3), Some(Tile::new(Face::Front, 3, 4, 4)?.around(Corner::DownRight)));
    /// assert_eq!(tile.around_nearest(5), None);
    /// # Ok::<(), terrella::terrain::InvalidTile>(())
    /// ```
    #[must_use]
    pub const fn around_nearest(self, level: u8) -> Option<Around> {
        // The quarter of the ancestor that this tile is in has the corner.
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

    /// The tiles of any level that touch an edge from beyond: one of a coarser level, or none if that one
    /// holds this tile too; one of the same level; 2ⁿ of the level that is finer by n, from low to high x or
    /// y of this tile.
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
    /// [`InvalidTile::Level`] for a level above 30.
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
        // A step along y becomes one along −x by one turn, along −y by two; one along x becomes one along −x
        // by two, along −y by three.
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

    /// The largest column and row.
    #[inline(always)]
    pub(super) const fn last(self) -> u32 {
        (1 << self.level) - 1
    }

    /// The tile of a column and row up to one beyond an edge, as its own face has it, and the turns to there.
    #[inline(always)]
    const fn beyond(self, i: u32, j: u32, edge: Edge) -> (Self, u8) {
        let last = self.last();
        if i <= last && j <= last {
            return (Self::within(self.face, self.level, i, j), 0);
        }
        let across = self.face.neighbour(edge);
        let (i, j) = (i & last, j & last);
        let (i, j) = match across.turns {
            0 => (i, j),
            1 => (last - j, i),
            2 => (last - i, last - j),
            _ => (j, last - i),
        };
        (Self::within(across.face, self.level, i, j), across.turns)
    }
}

/// The tiles along the far side of an edge: see [`Tile::neighbours`].
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
    /// The edge of theirs that they have on the line.
    #[must_use]
    pub const fn edge(&self) -> Edge {
        self.edge
    }

    /// Counter-clockwise quarter turns to their face, 0 to 3.
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
