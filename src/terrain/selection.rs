use core::fmt;
use core::iter::FusedIterator;

use super::footprint::Footprint;
use super::slab::Slab;
use super::{Camera, Enclosure, Heights, Horizon, InvalidTile, OrientedBox, Tile};
use crate::cube::{CubeProjection, Face};
use crate::distortion::texture::anisotropic;
use crate::math::{log2, min};
use crate::{Ecef, Real};

/// How finely a picture wants its terrain.
///
/// ```
/// use terrella::terrain::{Detail, InvalidDetail};
/// // Tiles of 512 × 512 samples, of data that go down to level 17.
/// let detail = Detail::new(512, 1.5, 17)?;
/// assert_eq!(Detail::new(512, -1.0, 17), Err(InvalidDetail::Ratio(-1.0)));
/// # Ok::<(), InvalidDetail<f64>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Detail<T> {
    samples: T,
    ratio: T,
    finest: u8,
    anisotropy: T,
}

impl<T: Real> Detail<T> {
    /// From the samples along a tile's side, the pixels that may be drawn from each of them (1.5 in the paper), and the finest level that
    /// there is.
    ///
    /// # Errors
    /// [`InvalidDetail`] for no samples, a ratio that is not positive and finite, a level above 30.
    pub fn new(samples: u32, ratio: T, finest: u8) -> Result<Self, InvalidDetail<T>> {
        if samples == 0 {
            return Err(InvalidDetail::Samples);
        }
        if !(ratio > T::ZERO && ratio.is_finite()) {
            return Err(InvalidDetail::Ratio(ratio));
        }
        if finest > Tile::MAX_LEVEL {
            return Err(InvalidDetail::Level(InvalidTile::Level(finest)));
        }
        Ok(Self {
            samples: T::whole(samples.into()),
            ratio,
            finest,
            anisotropy: T::ZERO,
        })
    }

    /// For an anisotropic filter of at most so many samples: the level is the one that such a filter reads.
    ///
    /// A tile is split while, in one of nine places of it at the middle of its heights, the filter would read
    /// from a level more than ½ log₂ `ratio` below the tile's (λ of Dimitrijević, Lambers & Rančić 2016, 3.2
    /// and 3.3; see [`anisotropic`]), by the derivative of the picture there, whatever its sign: ground above
    /// the eye and mirrored pictures are as any. Places behind the eye and behind the horizon ask for
    /// nothing. It is split too while the centre of projection is nearer to its box than half of the box's
    /// diagonal on the ground, since nine places say nothing of what lies between then; parallel lines of
    /// sight have none. What is seen at a grazing angle is split further than its coverage asks for. Boxes
    /// that are higher than wide are treated as [`Enclosure::coverage`] treats them.
    ///
    /// # Errors
    /// [`InvalidDetail::Anisotropy`] for a number below 1, or not finite.
    pub fn anisotropic(self, most: T) -> Result<Self, InvalidDetail<T>> {
        if !(most >= T::ONE && most.is_finite()) {
            return Err(InvalidDetail::Anisotropy(most));
        }
        Ok(Self {
            anisotropy: most,
            ..self
        })
    }
}

/// Why [`Detail`] was refused.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum InvalidDetail<T> {
    /// Tiles of no samples.
    Samples,
    /// The ratio of pixels to samples is not positive and finite.
    Ratio(T),
    /// There is no such level.
    Level(InvalidTile),
    /// The filter's number of samples is below 1 or not finite.
    Anisotropy(T),
}

impl<T: fmt::Debug> fmt::Display for InvalidDetail<T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Samples => f.write_str("expected at least one sample along a tile's side, got none"),
            Self::Ratio(ratio) => write!(
                f,
                "expected a positive, finite ratio of pixels to samples, got {ratio:?}"
            ),
            Self::Level(level) => level.fmt(f),
            Self::Anisotropy(most) => write!(f, "expected a filter of at least one sample, got {most:?}"),
        }
    }
}

impl<T: fmt::Debug> core::error::Error for InvalidDetail<T> {}

/// The tiles that a picture is drawn from: of every place that is seen, one.
///
/// Lambers & Kolb (2012): from the six faces, a tile is split into its four quarters while its ground covers
/// more pixels, in the picture and beyond its sides, than `ratio` times its samples
/// ([`Enclosure::coverage`]). What is outside the view or behind the horizon is left out. The boxes contain
/// their tiles and the horizon hides nothing that is seen, so that no place is missed; and the quarters of a
/// tile have no place in common, so that none is drawn twice, but for the lines between tiles. That holds for
/// perspective and parallel, mirrored and off-axis cameras, from within valleys and from afar ([`Camera`]
/// says what is behind).
///
/// Heights are to shrink with the tiles, as those of a table with the lowest and the highest sample of each
/// tile do. Then there are 0.6 to 2 times as many tiles as if the ground itself were known. One range of
/// kilometres for all tiles misses nothing either, but then the ground may be next to the eye: around it
/// tiles are split to the finest level, some 100 more.
///
/// An iterator that needs no stack: where it goes on is told by the address of the tile it has done with. Tiles come in the order of
/// [`Morton`](super::Morton)'s keys.
///
/// ```
/// use terrella::cube::{CubeMap, Quadrilateralized};
/// use terrella::terrain::{Camera, Detail, Enclosure, Heights, Selection, Tile};
/// use terrella::{Ecef, Ellipsoid, Shift};
///
/// let enclosure = Enclosure::new(CubeMap::new(Ellipsoid::WGS84, Shift::Authalic, Quadrilateralized)?);
/// // From 300 km above 0° N 0° E straight down, north up, 53° wide and high.
/// let eye = Ecef::new(6_678_137.0_f64, 0.0, 0.0)?;
/// let matrix = [[0.0, 2.0, 0.0, 0.0], [0.0, 0.0, 2.0, 0.0], [0.0; 4], [-1.0, 0.0, 0.0, 0.0]];
/// let camera = Camera::new(eye, matrix, [1024.0, 1024.0])?;
///
/// // In place of a table: hills around 600 m, a tenth of a tile's width high, and 800 m at most.
/// let heights = |tile: Tile| {
///     let half = f64::min(0.05 * 1e7 / f64::from(1 << tile.level()), 400.0);
///     Heights::new(600.0 - half, 600.0 + half).unwrap_or_default()
/// };
/// let tiles = Selection::new(&enclosure, camera, Detail::new(512, 1.5, 20)?, heights);
/// assert_eq!(tiles.count(), 16);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug)]
#[must_use]
pub struct Selection<'a, T, P, H> {
    enclosure: &'a Enclosure<T, P>,
    camera: Camera<T>,
    /// Where lines of sight meet, if they do.
    centre: Option<Ecef<T>>,
    horizon: Horizon<T>,
    detail: Detail<T>,
    /// The pixels that a tile may cover.
    most: T,
    /// The level of a texture below which a tile is too coarse.
    coarsest: T,
    heights: H,
    next: Option<Tile>,
}

impl<'a, T: Real, P: CubeProjection, H: FnMut(Tile) -> Heights<T>> Selection<'a, T, P, H> {
    /// For a camera, where `heights` tells the lowest and the highest point of a tile's terrain: in a tile
    /// not beyond those of the tile it is a quarter of, and the nearer to the ground the fewer tiles.
    pub fn new(enclosure: &'a Enclosure<T, P>, camera: Camera<T>, detail: Detail<T>, mut heights: H) -> Self {
        let lows = Face::ALL.map(|face| heights(Tile::root(face)).low());
        let lowest = lows.into_iter().fold(T::of(f64::INFINITY), min);
        Self {
            enclosure,
            camera,
            centre: camera.point(),
            horizon: Horizon::of(enclosure.map().shifted().ellipsoid(), lowest, &camera),
            detail,
            most: detail.ratio * (detail.samples * detail.samples),
            coarsest: -(T::of(0.5) * log2(detail.ratio)),
            heights,
            next: Some(Tile::root(Face::Front)),
        }
    }

    /// Whether a tile that is seen is too coarse.
    #[inline]
    fn is_coarse(&self, tile: Tile, heights: Heights<T>, bounds: &OrientedBox<T>) -> bool {
        let slab = Slab::new(bounds, &self.camera, self.centre);
        if self.detail.anisotropy == T::ZERO {
            return self.enclosure.covered(&self.camera, tile, heights, &slab) > self.most;
        }
        let [width, height, _] = slab.bounds.half();
        if slab
            .away
            .is_some_and(|away| away < (width * width + height * height).sqrt())
        {
            return true;
        }
        let height = T::of(0.5) * (heights.low() + heights.high()) + slab.above;
        let texels = T::of(0.5) * self.detail.samples * T::whole(1 << tile.level());
        let footprint = Footprint::new(&self.enclosure.map(), &self.camera, height);
        (0..9).any(|n| match footprint.at(tile.node([n % 3, n / 3], 2), &self.horizon) {
            None => false,
            Some(units) => {
                let [across, along] = units.map(|side| side.map(|unit| unit * texels));
                anisotropic(across, along, self.detail.anisotropy).level < self.coarsest
            }
        })
    }
}

impl<T: Real, P: CubeProjection, H: FnMut(Tile) -> Heights<T>> Iterator for Selection<'_, T, P, H> {
    type Item = Tile;

    fn next(&mut self) -> Option<Tile> {
        while let Some(tile) = self.next {
            self.next = after(tile);
            let heights = (self.heights)(tile);
            let bounds = self.enclosure.of(tile, heights);
            if !self.camera.sees(&bounds) || self.horizon.hides_box(&bounds) {
                continue;
            }
            match tile.children() {
                Some([first, ..]) if tile.level() < self.detail.finest && self.is_coarse(tile, heights, &bounds) => {
                    self.next = Some(first);
                }
                _ => return Some(tile),
            }
        }
        None
    }
}

impl<T: Real, P: CubeProjection, H: FnMut(Tile) -> Heights<T>> FusedIterator for Selection<'_, T, P, H> {}

/// The tile to go on with once one is done with, and all of it: the next quarter of the same tile, or of the last one above that has a next.
fn after(tile: Tile) -> Option<Tile> {
    let Tile { face, level, i, j } = tile;
    // Each level at which it is the last quarter ends with it.
    let ended = (i & j).trailing_ones() as u8;
    if ended >= level {
        return Face::from_index(face.index() + 1).ok().map(Tile::root);
    }
    let (level, i, j) = (level - ended, i >> ended, j >> ended);
    Some(Tile::within(face, level, i ^ 1, j + (i & 1)))
}
