use core::marker::PhantomData;

use super::tile::InvalidTiled;
use crate::batch::cube::ProjectInLanes;
use crate::batch::engine::{refuse_all, solve_by};
use crate::batch::face_number::Faces;
use crate::batch::map::ProjectAll;
use crate::batch::position::Vectors;
use crate::batch::{FaceNumber, InvalidBatch};
use crate::cube::{CubeMap, CubeProjection, Face, FacePoint};
use crate::simd::{Behind, CHUNK, Door, Kernel, Tally, front, head, lanes, sweep};
use crate::terrain::{Curve, Hilbert, InvalidKey, InvalidNumberedTile, InvalidTile, Key, Tile, has_s2_leaf, leaf_of};
use crate::{Direction, InvalidDirection, InvalidLatLon, LatLon, Real};

/// A face's number, a level, and a column and row.
type Address = (f32, ([u8; 1], [u32; 2]));

/// Tiles by their numbers.
#[derive(Clone, Copy)]
struct Tiles;

impl Tiles {
    fn tile((number, ([level], [i, j])): Address) -> Result<Tile, InvalidNumberedTile> {
        let face = Face::from_index(number as u8).map_err(InvalidNumberedTile::Face)?;
        Tile::new(face, level, i, j).map_err(InvalidNumberedTile::Tile)
    }
}

impl Door<Address> for Tiles {
    type Error = InvalidNumberedTile;

    #[inline(always)]
    fn keeps(&self, (number, ([level], [i, j])): Address) -> bool {
        (number <= 5.0) & (level <= Tile::MAX_LEVEL) & ((i | j) >> (level & 31) == 0)
    }

    fn admit(&self, address: Address) -> Result<Address, Self::Error> {
        Self::tile(address).map(|_| address)
    }
}

/// From a tile's numbers to its key.
#[derive(Clone, Copy)]
struct ToKey<C>(PhantomData<C>);

impl<C: Curve> Kernel<Address> for ToKey<C> {
    type Output = [u64; 1];

    #[inline(always)]
    fn apply(&self, (number, ([level], [i, j])): Address) -> [u64; 1] {
        let tile = Tile::within(Face::of_number(number), level.min(Tile::MAX_LEVEL), i, j);
        [Key::<C>::from(tile).bits()]
    }
}

/// Keys along a curve.
#[derive(Clone, Copy)]
struct Keys<C>(PhantomData<C>);

impl<C: Curve> Door<[u64; 1]> for Keys<C> {
    type Error = InvalidKey;

    #[inline(always)]
    fn keeps(&self, [bits]: [u64; 1]) -> bool {
        Key::<C>::is_key(bits)
    }

    fn admit(&self, [bits]: [u64; 1]) -> Result<[u64; 1], InvalidKey> {
        Key::<C>::new(bits).map(|key| [key.bits()])
    }
}

/// From a key to the numbers of its tile.
#[derive(Clone, Copy)]
struct FromKey<C>(PhantomData<C>);

/// The key of a tile of level 0, for the loop where a number is not one.
const ROOT: u64 = 1 << 60;

fn address(tile: Tile) -> Address {
    (f32::from(tile.face().index()), ([tile.level()], [tile.i(), tile.j()]))
}

impl<C: Curve> Kernel<[u64; 1]> for FromKey<C> {
    type Output = Address;

    #[inline(always)]
    fn apply(&self, [bits]: [u64; 1]) -> Address {
        let bits = if Key::<C>::is_key(bits) { bits } else { ROOT };
        let tile = Tile::from(Key::<C>::within(bits));
        let number = <f32 as crate::real::Kernel>::from_byte(tile.face().index());
        (number, ([tile.level()], [tile.i(), tile.j()]))
    }
}

/// From a point to the key of its tile at a level; 0 where there is no point.
#[derive(Clone, Copy)]
struct KeyAt<C>(u8, PhantomData<C>);

impl<T: Real, C: Curve> Kernel<([T; 2], T)> for KeyAt<C> {
    type Output = [u64; 1];

    #[inline(always)]
    fn apply(&self, (point, number): ([T; 2], T)) -> [u64; 1] {
        let [i, j] = point.map(|x| Tile::index(x, self.0));
        let bits = Key::<C>::from(Tile::within(Face::of_number(number), self.0, i, j)).bits();
        [if point[0].is_finite() { bits } else { 0 }]
    }
}

/// A block of points on their way to keys.
struct Buffer<T> {
    faces: [u8; CHUNK],
    points: [[T; CHUNK]; 2],
}

impl<T: Real> Buffer<T> {
    const fn new() -> Self {
        Self {
            faces: [0; CHUNK],
            points: [[T::ZERO; CHUNK]; 2],
        }
    }

    /// The first points, to be written.
    fn lend(&mut self, count: usize) -> (Faces<&mut [u8], T>, [&mut [T]; 2]) {
        let points = self.points.each_mut();
        (
            Faces::new(self.faces.get_mut(..count).unwrap_or_default()),
            points.map(|column| column.get_mut(..count).unwrap_or_default()),
        )
    }

    /// The keys of the first points.
    fn keys<C: Curve>(&self, level: u8, keys: [&mut [u64]; 1]) {
        let count = keys[0].len();
        let points = self.points.each_ref();
        let points = points.map(|column| column.get(..count).unwrap_or_default());
        let faces = Faces::new(self.faces.get(..count).unwrap_or_default());
        sweep(KeyAt::<C>(level, PhantomData), (points, faces), keys);
    }
}

fn key_of<T: Real, C: Curve>(point: FacePoint<T>, level: u8) -> [u64; 1] {
    let [i, j] = [point.x(), point.y()].map(|x| Tile::index(x, level));
    [Key::<C>::from(Tile::within(point.face(), level, i, j)).bits()]
}

/// Converts tiles, given as faces, levels, columns and rows, to their keys along
/// [`Morton`](crate::terrain::Morton)'s or [`Hilbert`]'s curve, with the bits of [`Key`]. On Hilbert's curve
/// they are S2's cell ids.
///
/// # Errors
/// [`InvalidBatch`] if slices have unequal lengths, or if there is no such face or tile: its key is 0, which
/// no tile has.
///
/// ```
/// use terrella::batch::terrain;
/// use terrella::cube::Face;
/// use terrella::terrain::Hilbert;
/// let mut keys = [0; 2];
/// terrain::to_key::<Hilbert, _>(&[Face::Right, Face::Front], &[2, 0], [&[1, 0], &[3, 0]], &mut keys)?;
/// assert_eq!(keys, [0x3900_0000_0000_0000, 0x1000_0000_0000_0000]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn to_key<C: Curve, F: FaceNumber>(
    faces: &[F],
    levels: &[u8],
    squares: [&[u32]; 2],
    keys: &mut [u64],
) -> Result<(), InvalidBatch<InvalidNumberedTile>> {
    solve_by(
        (Faces::new(faces), ([levels], squares)),
        [keys],
        |address| Ok([Key::<C>::from(Tiles::tile(address)?).bits()]),
        |tiles, keys, tally| lanes(Behind(Tiles, ToKey::<C>(PhantomData)), tiles, keys, tally),
    )
}

/// Converts keys along [`Morton`](crate::terrain::Morton)'s or [`Hilbert`]'s curve to faces, levels, columns
/// and rows: the inverse of [`to_key`].
///
/// # Errors
/// [`InvalidBatch`] if slices have unequal lengths, or [`Key::new`] refuses an element: its face is
/// [`Front`](Face::Front), and its level, column and row are 0.
///
/// ```
/// use terrella::batch::terrain;
/// use terrella::cube::Face;
/// use terrella::terrain::Hilbert;
/// let (mut face, mut level, mut i, mut j) = ([Face::Front], [0], [0], [0]);
/// let keys = [0x3900_0000_0000_0000];
/// terrain::from_key::<Hilbert, _>(&keys, &mut face, &mut level, [&mut i, &mut j])?;
/// assert_eq!((face, level, i, j), ([Face::Right], [2], [1], [3]));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn from_key<C: Curve, F: FaceNumber>(
    keys: &[u64],
    faces: &mut [F],
    levels: &mut [u8],
    squares: [&mut [u32]; 2],
) -> Result<(), InvalidBatch<InvalidKey>> {
    solve_by(
        [keys],
        (Faces::new(faces), ([levels], squares)),
        |[bits]| Ok(address(Tile::from(Key::<C>::new(bits)?))),
        |keys, tiles, tally| {
            let kernel = Behind(Keys::<C>(PhantomData), FromKey::<C>(PhantomData));
            lanes(kernel, keys, tiles, tally);
        },
    )
}

/// Finds the keys of the tiles of a level that contain geodetic latitudes and longitudes in degrees, with the
/// bits of [`CubeMap::project`], [`Tile::containing`] and [`Key`].
///
/// # Errors
/// [`InvalidBatch`] if slices have unequal lengths, or [`LatLon::new`] refuses an element: its key is 0,
/// which no tile has. If the level is above 30, all elements are refused.
///
/// ```
/// use terrella::cube::{CubeMap, S2Quadratic};
/// use terrella::terrain::Hilbert;
/// use terrella::{Ellipsoid, Shift, batch::terrain};
/// let earth = CubeMap::new(Ellipsoid::<f64>::WGS84, Shift::Geodetic, S2Quadratic)?;
/// let mut keys = [0];
/// terrain::places_to_key::<Hilbert, _, _>(&earth, 12, [&[48.8566], &[2.3522]], &mut keys)?;
/// assert_eq!(keys, [0x47e6_6e10_0000_0000]); // S2's cell in Paris
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[doc(alias = "S2CellId")]
pub fn places_to_key<C: Curve, T: Real, P: CubeProjection>(
    map: &CubeMap<T, P>,
    level: u8,
    places: [&[T]; 2],
    keys: &mut [u64],
) -> Result<(), InvalidBatch<InvalidTiled<InvalidLatLon<T>>>> {
    if level > Tile::MAX_LEVEL {
        return refuse_all(places, [keys], InvalidTiled::Tile(InvalidTile::Level(level)));
    }
    let result = solve_by(
        places,
        [keys],
        |[lat, lon]| Ok(key_of::<T, C>(map.project(LatLon::new(lat, lon)?), level)),
        |mut places, mut keys, tally: &mut Tally<_>| {
            let mut buffer = Buffer::new();
            while let here @ 1.. = places[0].len().min(CHUNK) {
                map.projection().with(ProjectAll {
                    shifted: map.shifted(),
                    places: head(&mut places, here),
                    points: buffer.lend(here),
                    tally: &mut *tally,
                });
                buffer.keys::<C>(level, front(&mut keys, here));
            }
        },
    );
    result.map_err(|invalid| invalid.map(InvalidTiled::Place))
}

/// Finds the keys of the tiles of a level that contain vectors of any length, with the bits of
/// [`CubeProjection::project`], [`Tile::containing`] and [`Key`].
///
/// # Errors
/// [`InvalidBatch`] if slices have unequal lengths, or [`Direction::new`] refuses an element: its key is 0,
/// which no tile has. If the level is above 30, all elements are refused.
///
/// ```
/// use terrella::batch::terrain;
/// use terrella::cube::Balanced;
/// use terrella::terrain::Morton;
/// let mut keys = [0];
/// terrain::directions_to_key::<Morton, f64, _>(Balanced, 1, [&[2.0], &[-0.1], &[0.1]], &mut keys)?;
/// assert_eq!(keys, [0b000_10_1 << 58]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn directions_to_key<C: Curve, T: Real, P: CubeProjection>(
    projection: P,
    level: u8,
    directions: [&[T]; 3],
    keys: &mut [u64],
) -> Result<(), InvalidBatch<InvalidTiled<InvalidDirection<T>>>> {
    if level > Tile::MAX_LEVEL {
        return refuse_all(directions, [keys], InvalidTiled::Tile(InvalidTile::Level(level)));
    }
    let result = solve_by(
        directions,
        [keys],
        |[x, y, z]| Ok(key_of::<T, C>(projection.project(Direction::new(x, y, z)?), level)),
        |mut directions, mut keys, tally: &mut Tally<_>| {
            let mut buffer = Buffer::new();
            while let here @ 1.. = directions[0].len().min(CHUNK) {
                projection.with(ProjectInLanes {
                    vectors: Vectors { known: false },
                    directions: head(&mut directions, here),
                    points: buffer.lend(here),
                    tally: &mut *tally,
                });
                buffer.keys::<C>(level, front(&mut keys, here));
            }
        },
    );
    result.map_err(|invalid| invalid.map(InvalidTiled::Place))
}

/// Vectors of any length.
#[derive(Clone, Copy)]
struct Rays;

impl Door<[f64; 3]> for Rays {
    type Error = InvalidDirection<f64>;

    #[inline(always)]
    fn keeps(&self, ray: [f64; 3]) -> bool {
        has_s2_leaf(ray)
    }

    fn admit(&self, ray: [f64; 3]) -> Result<[f64; 3], Self::Error> {
        Key::s2_leaf_of(ray).map(|_| ray)
    }
}

#[derive(Clone, Copy)]
struct S2Leaf;

impl Kernel<[f64; 3]> for S2Leaf {
    type Output = [u64; 1];

    #[inline(always)]
    fn apply(&self, ray: [f64; 3]) -> [u64; 1] {
        [leaf_of(ray).bits()]
    }
}

/// Finds S2's leaf cells of vectors of any length, chosen as S2 itself chooses them, with the bits of
/// [`Key::s2_leaf_of`].
///
/// # Errors
/// [`InvalidBatch`] if slices have unequal lengths, or if a vector is zero, infinite or NaN: its id is 0.
///
/// ```
/// use terrella::batch::terrain;
/// let mut keys = [0; 2];
/// terrain::s2_leaf([&[0.0, 1.0], &[1.0, 0.0], &[1.0, 0.0]], &mut keys)?;
/// assert_eq!(keys.map(|key| key >> 61), [2, 0]); // S2's faces
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[doc(alias = "S2CellId")]
#[doc(alias = "S2Point")]
pub fn s2_leaf(directions: [&[f64]; 3], keys: &mut [u64]) -> Result<(), InvalidBatch<InvalidDirection<f64>>> {
    solve_by(
        directions,
        [keys],
        |ray| Ok([Key::<Hilbert>::s2_leaf_of(ray)?.bits()]),
        |rays, keys, tally| lanes(Behind(Rays, S2Leaf), rays, keys, tally),
    )
}
