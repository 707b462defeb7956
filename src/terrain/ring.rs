use core::fmt;
use core::iter::FusedIterator;

use super::Tile;
use crate::cube::Edge;

/// The tiles around a tile, by how many steps across edges and corners they are away: from [`Tile::ring`] and
/// [`Tile::disc`]. No tile comes twice.
#[derive(Clone, Debug)]
#[must_use]
pub struct Ring {
    tile: Tile,
    nearest: u32,
    farthest: u32,
    /// The face under way: the tile's own, or the one across an edge.
    across: Option<Edge>,
    /// The first and the last place to look at there, along the edge and away from it; on the tile's own face
    /// columns and rows.
    along: [u32; 2],
    away: [u32; 2],
    next: Option<[u32; 2]>,
}

impl Tile {
    /// Returns the tiles of this level that are exactly `steps` steps away, across edges or corners: the tile
    /// itself for 0, eight for 1, or seven for a tile at a corner of the cube, where three tiles meet.
    ///
    /// ```
    /// use terrella::cube::Face;
    /// use terrella::terrain::Tile;
    /// let (inner, corner) = (Tile::new(Face::Top, 5, 9, 20)?, Tile::new(Face::Top, 5, 31, 31)?);
    /// assert_eq!((inner.ring(1)?.count(), inner.ring(3)?.count()), (8, 24));
    /// assert_eq!((corner.ring(1)?.count(), corner.ring(3)?.count()), (7, 19));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`InvalidSteps`] if `steps` is above 2^level, the number of tiles along an edge of the cube.
    #[doc(alias = "k-ring")]
    #[doc(alias = "gridRing")]
    pub const fn ring(self, steps: u32) -> Result<Ring, InvalidSteps> {
        Ring::new(self, steps, steps)
    }

    /// Returns this tile and the tiles of this level that are at most `steps` steps away, across edges or
    /// corners.
    ///
    /// ```
    /// use terrella::cube::Face;
    /// use terrella::terrain::{InvalidSteps, Tile};
    /// assert_eq!(Tile::new(Face::Top, 5, 9, 20)?.disc(3)?.count(), 49);
    /// let face = Tile::root(Face::Left);
    /// assert_eq!(face.disc(1)?.count(), 5);
    /// assert_eq!(face.disc(2).err(), Some(InvalidSteps { level: 0, steps: 2 }));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`InvalidSteps`] if `steps` is above 2^level, the number of tiles along an edge of the cube.
    #[doc(alias = "gridDisk")]
    pub const fn disc(self, steps: u32) -> Result<Ring, InvalidSteps> {
        Ring::new(self, 0, steps)
    }

    /// How many tiles are between this one and an edge of the face, and how many come before it along that
    /// edge, counter-clockwise.
    const fn seen_from(self, edge: Edge) -> [u32; 2] {
        let (i, j, end) = (self.i, self.j, self.last());
        match edge {
            Edge::Right => [end - i, j],
            Edge::Up => [end - j, end - i],
            Edge::Left => [i, end - j],
            Edge::Down => [j, i],
        }
    }

    /// The tile beyond an edge of this tile's face, so many places along it, counter-clockwise, and away from
    /// it.
    fn across(self, edge: Edge, [along, away]: [u32; 2]) -> Self {
        let end = self.last();
        let (i, j) = match edge {
            Edge::Right => (end, along),
            Edge::Up => (end - along, end),
            Edge::Left => (0, end - along),
            Edge::Down => (along, 0),
        };
        let beyond = Self { i, j, ..self }.neighbour(edge);
        let Self { i, j, .. } = beyond.tile;
        let (i, j) = match beyond.edge {
            Edge::Right => (i - away, j),
            Edge::Up => (i, j - away),
            Edge::Left => (i + away, j),
            Edge::Down => (i, j + away),
        };
        Self { i, j, ..beyond.tile }
    }
}

impl Ring {
    const fn new(tile: Tile, nearest: u32, farthest: u32) -> Result<Self, InvalidSteps> {
        let level = tile.level;
        if farthest > 1 << level {
            return Err(InvalidSteps { level, steps: farthest });
        }
        let along = about(tile.i, farthest, tile.last());
        let away = about(tile.j, farthest, tile.last());
        let ([column, _], [row, _]) = (along, away);
        Ok(Self {
            tile,
            nearest,
            farthest,
            across: None,
            along,
            away,
            next: Some([column, row]),
        })
    }

    /// Goes on to the next place, on this face or another.
    fn advance(&mut self, [along, away]: [u32; 2]) {
        let ([first, last], [_, farthest]) = (self.along, self.away);
        if along < last {
            self.next = Some([along + 1, away]);
        } else if away < farthest {
            self.next = Some([first, away + 1]);
        } else {
            self.turn();
        }
    }

    /// Goes on to the next face that is near enough.
    fn turn(&mut self) {
        let following = self.across.map_or(0, |edge| edge as usize + 1);
        let near = |edge: &&Edge| {
            let [between, _] = self.tile.seen_from(**edge);
            between < self.farthest
        };
        self.next = None;
        if let Some(&edge) = Edge::ALL.iter().skip(following).find(near) {
            let ([_, before], end) = (self.tile.seen_from(edge), self.tile.last());
            self.across = Some(edge);
            self.along = about(before, self.farthest, end);
            self.away = [0, if self.farthest > end { end } else { self.farthest - 1 }];
            let ([along, _], [away, _]) = (self.along, self.away);
            self.next = Some([along, away]);
        }
    }

    /// How many steps away a place is. Beyond an edge the way may lead through a third face, about one of the
    /// ends of the edge.
    fn steps(&self, [along, away]: [u32; 2]) -> u32 {
        let Some(edge) = self.across else {
            return along.abs_diff(self.tile.i).max(away.abs_diff(self.tile.j));
        };
        let ([between, before], end) = (self.tile.seen_from(edge), self.tile.last());
        let direct = along.abs_diff(before).max(between + 1 + away);
        let start = (before + 1 + away).max(between + 1 + along);
        let other = (end - before + 1 + away).max(between + 1 + (end - along));
        direct.min(start).min(other)
    }
}

/// The places up to a distance before and after a place, within 0 to the last.
const fn about(place: u32, distance: u32, end: u32) -> [u32; 2] {
    let last = place + distance;
    [place.saturating_sub(distance), if last < end { last } else { end }]
}

impl Iterator for Ring {
    type Item = Tile;

    fn next(&mut self) -> Option<Tile> {
        while let Some(place) = self.next {
            // Before the next place, which may be on another face.
            let (across, steps) = (self.across, self.steps(place));
            self.advance(place);
            if steps >= self.nearest && steps <= self.farthest {
                let [i, j] = place;
                return Some(match across {
                    Some(edge) => self.tile.across(edge, place),
                    None => Tile { i, j, ..self.tile },
                });
            }
        }
        None
    }
}

impl FusedIterator for Ring {}

/// The error of [`Tile::ring`] and [`Tile::disc`]: there are fewer tiles than steps along an edge of the cube,
/// and those beyond the next faces would be reached from several sides.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct InvalidSteps {
    /// The level.
    pub level: u8,
    /// The number of steps; it is above 2^level.
    pub steps: u32,
}

impl fmt::Display for InvalidSteps {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { level, steps } = self;
        write!(f, "{steps} steps are more than the 2^{level} tiles along an edge")
    }
}

impl core::error::Error for InvalidSteps {}
