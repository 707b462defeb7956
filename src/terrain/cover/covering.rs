use core::iter::FusedIterator;

use super::{Region, Relation, Tile};
use crate::Real;
use crate::cube::{CubeMap, CubeProjection, Face};
use crate::terrain::InvalidTile;
use crate::terrain::selection::after;

/// The tiles that cover a region: an iterator that needs no memory beyond itself.
///
/// It goes through the quadtree from the faces down, face by face and quarter by quarter, and divides the
/// tiles that meet the region. An outer covering has every tile of a level that has a place in common with the
/// region; an [`inner`](Self::inner) one has those that are inside. How exact that is, the region says; it rests
/// on how smooth edges of tiles are, for which a search over every projection found the bound, not a proof.
///
/// ```
/// use terrella::cube::{CubeMap, Vertex};
/// use terrella::terrain::{Covering, LatLonBox};
/// use terrella::{Ellipsoid, Shift};
///
/// let map = CubeMap::new(Ellipsoid::<f64>::WGS84, Shift::Authalic, Vertex)?;
/// let iceland = LatLonBox::new(63.2, -24.7, 66.7, -13.3)?;
/// let outer = Covering::new(map, iceland, 8)?;
/// assert_eq!((outer.clone().count(), outer.clone().inner().count()), (197, 131));
/// // Tiles of all levels: those that are inside are not divided.
/// assert_eq!(outer.clone().mixed().count(), 104);
/// // As fine as 32 tiles allow.
/// let few = outer.mixed().of_at_most(32).ok_or("at least one tile a face")?;
/// assert_eq!((few.level(), few.count()), (6, 20));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[doc(alias = "polyfill")]
#[doc(alias = "S2RegionCoverer")]
#[derive(Clone, Debug)]
#[must_use]
pub struct Covering<T, P, R> {
    map: CubeMap<T, P>,
    region: R,
    level: u8,
    inner: bool,
    mixed: bool,
    next: Option<Tile>,
    /// A tile inside the region whose descendants are under way.
    inside: Option<Tile>,
}

impl<T: Real, P: CubeProjection, R: Region<T>> Covering<T, P, R> {
    /// Creates the outer covering of a region by tiles of one level of a cube map.
    ///
    /// # Errors
    /// [`InvalidTile::Level`] if the level is above 30.
    pub fn new(map: CubeMap<T, P>, region: R, level: u8) -> Result<Self, InvalidTile> {
        if level > Tile::MAX_LEVEL {
            return Err(InvalidTile::Level(level));
        }
        Ok(Self {
            map,
            region,
            level,
            inner: false,
            mixed: false,
            next: Some(Tile::root(Face::Front)),
            inside: None,
        })
    }

    /// Returns the finest level.
    #[must_use]
    pub const fn level(&self) -> u8 {
        self.level
    }

    /// Leaves out the tiles that are not inside the region. Call it before the iteration starts.
    pub fn inner(mut self) -> Self {
        self.inner = true;
        self
    }

    /// Gives each tile that is inside the region as it is, and not its descendants: the same ground in fewer
    /// tiles. Call it before the iteration starts.
    #[doc(alias = "compact")]
    pub fn mixed(mut self) -> Self {
        self.mixed = true;
        self
    }

    /// Returns the covering, of this kind, of the finest level up to this one at which it has at most `count`
    /// tiles. Returns `None` if there is no such level. Call it before the iteration starts.
    ///
    /// It counts the tiles of each level, from 0 up; a finer level never has fewer.
    pub fn of_at_most(self, count: u32) -> Option<Self>
    where
        P: Clone,
        R: Clone,
    {
        let mut best = None;
        for level in 0..=self.level {
            let at = Self { level, ..self.clone() };
            if at.clone().zip(0..=count).count() as u64 > u64::from(count) {
                break;
            }
            best = Some(at);
        }
        best
    }
}

impl<T: Real, P: CubeProjection, R: Region<T>> Iterator for Covering<T, P, R> {
    type Item = Tile;

    fn next(&mut self) -> Option<Tile> {
        while let Some(tile) = self.next {
            self.next = after(tile);
            let known = self.inside.is_some_and(|inside| inside.contains(tile));
            let relation = if known {
                Relation::Inside
            } else {
                self.region.relation(&self.map, tile)
            };
            let inside = relation == Relation::Inside;
            if !known {
                self.inside = inside.then_some(tile);
            }
            if relation == Relation::Apart {
                continue;
            }
            match tile.children() {
                Some([first, ..]) if tile.level() < self.level && !(inside && self.mixed) => self.next = Some(first),
                _ if inside || !self.inner => return Some(tile),
                _ => {}
            }
        }
        None
    }
}

impl<T: Real, P: CubeProjection, R: Region<T>> FusedIterator for Covering<T, P, R> {}
