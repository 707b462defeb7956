use core::fmt;
use core::iter::FusedIterator;

use super::footprint::Footprint;
use super::slab::Slab;
use super::{Camera, Enclosure, Heights, Horizon, InvalidTile, OrientedBox, Tile};
use crate::cube::{CubeProjection, Face};
use crate::distortion::texture::anisotropic;
use crate::math::{log2, min};
use crate::{Ecef, Real};

/// The level of detail that a picture needs: samples of a tile per pixel, and the finest level.
///
/// ```
/// use terrella::terrain::{Detail, InvalidDetail};
/// // Tiles of 512 × 512 samples, of data that go down to level 17.
/// let detail = Detail::new(512, 1.5, 17)?;
/// assert_eq!(Detail::new(512, -1.0, 17), Err(InvalidDetail::Ratio(-1.0)));
/// # Ok::<(), InvalidDetail<f64>>(())
/// ```
#[doc(alias = "LOD")]
#[doc(alias = "level of detail")]
#[doc(alias = "SSE")]
#[doc(alias = "screen-space error")]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Detail<T> {
    samples: T,
    ratio: T,
    finest: u8,
    anisotropy: T,
}

impl<T: Real> Detail<T> {
    /// Creates a level of detail.
    ///
    /// * `samples`: the number of samples along a side of a tile, at least 1.
    /// * `ratio`: how many pixels of the picture may show one sample (1.5 in the paper).
    /// * `finest`: the finest level of which there are data, 0 to 30.
    ///
    /// # Errors
    /// [`InvalidDetail`] if `samples` is 0, `ratio` is not positive and finite, or `finest` is above 30.
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

    /// Selects tiles for an anisotropic texture filter of at most `most` samples: the level of a tile becomes
    /// the level that such a filter reads.
    ///
    /// A tile is split if, at one of nine points of it at the middle of its heights, the filter would read
    /// from a level more than ½ log₂ `ratio` below the tile's (λ of Dimitrijević, Lambers & Rančić 2016, 3.2
    /// and 3.3; see [`anisotropic`]). The filter's footprint comes from the derivative of the picture there;
    /// its sign does not matter, so ground above the eye and mirrored pictures are treated like any other.
    /// Points behind the eye or behind the horizon do not cause a split.
    ///
    /// A tile is also split while the centre of projection is nearer to its box than half of the box's
    /// diagonal on the ground, since then nine points do not represent what lies between them. This does not
    /// apply to a parallel projection. Ground seen at a grazing angle is split further than its coverage
    /// requires. Boxes that are higher than they are wide are treated as by [`Enclosure::coverage`].
    ///
    /// # Errors
    /// [`InvalidDetail::Anisotropy`] if `most` is below 1 or not finite.
    #[doc(alias = "anisotropic filtering")]
    #[doc(alias = "mipmap")]
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

/// The error of creating a [`Detail`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum InvalidDetail<T> {
    /// The number of samples along a tile's side is 0.
    Samples,
    /// The ratio of pixels to samples; it is not positive and finite.
    Ratio(T),
    /// The finest level is above 30.
    Level(InvalidTile),
    /// The filter's largest number of samples; it is below 1 or not finite.
    Anisotropy(T),
}

impl<T: fmt::Debug> fmt::Display for InvalidDetail<T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Samples => f.write_str("expected at least 1 sample along a tile's side, got 0"),
            Self::Ratio(ratio) => write!(
                f,
                "expected a positive, finite ratio of pixels to samples, got {ratio:?}"
            ),
            Self::Level(level) => level.fmt(f),
            Self::Anisotropy(most) => write!(f, "expected a finite anisotropy of at least 1, got {most:?}"),
        }
    }
}

impl<T: fmt::Debug> core::error::Error for InvalidDetail<T> {}

/// The tiles from which a picture is drawn: an iterator. Each visible place is in exactly one of them.
///
/// The method is that of Lambers & Kolb (2012). It starts with the six faces, and splits a tile into its four
/// children while its ground covers more pixels, in the picture and beyond its sides, than `ratio` times its
/// samples ([`Enclosure::coverage`]). Tiles outside the view (frustum culling) or behind the horizon (horizon
/// culling) are left out. The boxes contain their tiles and the horizon hides nothing that is visible, so no
/// place is missed. The children of a tile do not overlap, so no place is drawn twice, except the lines
/// between tiles. This holds for perspective and parallel, mirrored and off-axis cameras, inside valleys and
/// far away ([`Camera`] says what lies behind a camera).
///
/// The height range should shrink with the tile, as it does in a table of the lowest and the highest sample
/// of each tile. Then the selection has 0.6 to 2 times as many tiles as if the ground itself were known. One
/// range of several kilometres for all tiles does not miss anything either; but the ground may then be next
/// to the eye, and tiles around the eye are split to the finest level: some 100 more tiles.
///
/// The iterator needs no stack: the address of the current tile determines the next one. Tiles come in the
/// order of [`Morton`](super::Morton)'s keys.
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
#[doc(alias = "LOD")]
#[doc(alias = "level of detail")]
#[doc(alias = "chunked LOD")]
#[doc(alias = "culling")]
#[derive(Clone, Copy, Debug)]
#[must_use]
pub struct Selection<'a, T, P, H> {
    enclosure: &'a Enclosure<T, P>,
    camera: Camera<T>,
    /// The centre of projection; `None` for a parallel projection.
    centre: Option<Ecef<T>>,
    horizon: Horizon<T>,
    detail: Detail<T>,
    /// The largest number of pixels that a tile may cover.
    most: T,
    /// The lowest texture level that the filter may read from a tile: below it the tile is too coarse.
    coarsest: T,
    heights: H,
    next: Option<Tile>,
}

impl<'a, T: Real, P: CubeProjection, H: FnMut(Tile) -> Heights<T>> Selection<'a, T, P, H> {
    /// Creates the selection for a camera.
    ///
    /// `heights` returns the lowest and the highest point of a tile's terrain, in metres. The range of a tile
    /// must lie within the range of its parent. The closer the range is to the ground, the fewer tiles are
    /// selected.
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

    /// Whether a visible tile is too coarse.
    #[inline]
    fn is_coarse(&self, tile: Tile, heights: Heights<T>, bounds: &OrientedBox<T>) -> bool {
        if self.enclosure.is_wide(tile) {
            return true;
        }
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
            let finer = tile.level() < self.detail.finest;
            match tile.children() {
                Some([first, ..]) if finer && self.is_coarse(tile, heights, &bounds) => {
                    self.next = Some(first);
                }
                _ => return Some(tile),
            }
        }
        None
    }
}

impl<T: Real, P: CubeProjection, H: FnMut(Tile) -> Heights<T>> FusedIterator for Selection<'_, T, P, H> {}

/// The tile after this one and all its descendants: its next sibling, or the next sibling of the nearest
/// ancestor that has one.
pub(super) fn after(tile: Tile) -> Option<Tile> {
    let Tile { face, level, i, j } = tile;
    // Every level at which the tile is the last of four siblings is finished too.
    let ended = (i & j).trailing_ones() as u8;
    if ended >= level {
        return Face::from_index(face.index() + 1).ok().map(Tile::root);
    }
    let (level, i, j) = (level - ended, i >> ended, j >> ended);
    Some(Tile::within(face, level, i ^ 1, j + (i & 1)))
}
