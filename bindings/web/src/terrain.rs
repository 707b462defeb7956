//! Tiles of the faces: keys, neighbours, bounds, samples, and those that cover a region.

use terrella::batch::terrain::{InvalidTiled, from_key, places_to_key, to_key};
use terrella::cube::{CubeMap, Edge, Face, Projection};
use terrella::terrain::{Covering, Hilbert, InvalidBox, InvalidKey, InvalidNumberedTile, Key, LatLonBox, Tile};
use terrella::{Ellipsoid, InvalidLatLon, LatLon, Shift};

use crate::columns::{POINTS, column, leave};
use crate::current::Current;
use crate::refusal::{Refusal, Value, or_words, refused};

type Map = CubeMap<f64, Projection>;

static MAP: Current<Map> = Current::none();
static COVERING: Current<Covering<f64, Projection, LatLonBox<f64>>> = Current::none();

/// Calls are about this map from now on, or words. Shift and projection by their indices in `ALL`, of which the package
/// has the names.
#[unsafe(no_mangle)]
extern "C" fn tiles(a: f64, f: f64, shift: usize, projection: usize) -> bool {
    let map = || {
        let (shift, projection) = (*Shift::ALL.get(shift)?, *Projection::ALL.get(projection)?);
        or_words(CubeMap::new(or_words(Ellipsoid::new(a, f))?, shift, projection))
    };
    MAP.put(map())
}

/// Columns lat, lon → key of the tile at a level.
#[unsafe(no_mangle)]
extern "C" fn tiles_containing(count: usize, level: u8) -> usize {
    // SAFETY: each column is lent once.
    let (places, keys) = unsafe {
        (
            [column(0, count), column(1, count)].map(|column| &*column),
            column(2, count),
        )
    };
    refused(places_to_key::<Hilbert, _, _>(MAP.get(), level, places, keys))
}

/// Columns face, level, i, j → key.
#[unsafe(no_mangle)]
extern "C" fn tiles_to_key(count: usize) -> usize {
    // SAFETY: each column is lent once.
    unsafe {
        let (faces, levels) = (column::<u8>(0, count), column(1, count));
        let squares = [column(2, count), column(3, count)].map(|column| &*column);
        refused(to_key::<Hilbert, u8>(faces, levels, squares, column(4, count)))
    }
}

/// Column key → face, level, i, j.
#[unsafe(no_mangle)]
extern "C" fn tiles_from_key(count: usize) -> usize {
    // SAFETY: each column is lent once.
    unsafe {
        let (faces, levels) = (column::<u8>(1, count), column(2, count));
        refused(from_key::<Hilbert, u8>(
            column(0, count),
            faces,
            levels,
            [column(3, count), column(4, count)],
        ))
    }
}

/// A tile, or words.
fn tile(face: u8, level: u8, i: u32, j: u32) -> Option<Tile> {
    let face = or_words(Face::from_index(face).map_err(InvalidNumberedTile::Face))?;
    or_words(Tile::new(face, level, i, j).map_err(InvalidNumberedTile::Tile))
}

/// Leaves south, west, north and east of a tile; returns whether there is one, or words.
#[unsafe(no_mangle)]
extern "C" fn tile_bounds(face: u8, level: u8, i: u32, j: u32) -> bool {
    let tile = tile(face, level, i, j);
    if let Some(tile) = tile {
        let bounds = LatLonBox::of_tile(MAP.get(), tile);
        leave([bounds.south(), bounds.west(), bounds.north(), bounds.east()]);
    }
    tile.is_some()
}

/// Leaves the keys of the neighbours to the right, above, to the left and below; returns whether there is a tile, or words.
#[unsafe(no_mangle)]
extern "C" fn tile_neighbours(face: u8, level: u8, i: u32, j: u32) -> bool {
    let tile = tile(face, level, i, j);
    if let Some(tile) = tile {
        for (slot, edge) in Edge::ALL.into_iter().enumerate() {
            // SAFETY: each column is lent once.
            unsafe { column(slot, 1) }.fill(Key::<Hilbert>::from(tile.neighbour(edge).tile).bits());
        }
    }
    tile.is_some()
}

/// Places of samples of a tile, `count` of them from a first one on, → columns lat, lon; returns whether there is a tile, or
/// words.
#[unsafe(no_mangle)]
extern "C" fn tile_samples(face: u8, level: u8, i: u32, j: u32, samples: u32, first: u32, count: usize) -> bool {
    let tile = tile(face, level, i, j);
    if let Some(tile) = tile {
        // SAFETY: each column is lent once.
        let [lats, lons] = unsafe { [column(0, count), column(1, count)] };
        for (at, (lat, lon)) in (first..).zip(lats.iter_mut().zip(lons)) {
            let place: LatLon<f64> = MAP
                .get()
                .unproject(tile.node([at % samples, at / samples], samples - 1));
            (*lat, *lon) = (place.lat(), place.lon());
        }
    }
    tile.is_some()
}

/// Starts the covering of a box by tiles of a level: by those inside it alone, and with those of coarser levels where all
/// of them is inside. Returns whether there is one, or words.
#[unsafe(no_mangle)]
extern "C" fn cover(south: f64, west: f64, north: f64, east: f64, level: u8, inner: bool, mixed: bool) -> bool {
    let covering = || {
        let region = or_words(LatLonBox::new(south, west, north, east))?;
        let mut covering = or_words(Covering::new(*MAP.get(), region, level).map_err(InvalidNumberedTile::Tile))?;
        if inner {
            covering = covering.inner();
        }
        Some(if mixed { covering.mixed() } else { covering })
    };
    COVERING.put(covering())
}

/// The next keys of the covering → column; returns how many, 0 at the end.
#[unsafe(no_mangle)]
extern "C" fn cover_next() -> usize {
    // SAFETY: the column is lent once.
    let keys = unsafe { column(0, POINTS) };
    let tiles = keys.iter_mut().zip(COVERING.get());
    tiles
        .map(|(key, tile)| *key = Key::<Hilbert>::from(tile).bits())
        .count()
}

/// Errors without numbers of their scalar: as they are.
macro_rules! plain {
    ($($error:ty)*) => {$(
        impl Refusal for $error {
            type Words = Self;

            fn words(self) -> Self {
                self
            }
        }
    )*};
}

plain! { InvalidNumberedTile InvalidKey }

impl Refusal for InvalidTiled<InvalidLatLon<f64>> {
    type Words = InvalidTiled<InvalidLatLon<Value>>;

    fn words(self) -> Self::Words {
        match self {
            Self::Place(why) => InvalidTiled::Place(why.words()),
            Self::Tile(why) => InvalidTiled::Tile(why),
        }
    }
}

impl Refusal for InvalidBox<f64> {
    type Words = InvalidBox<Value>;

    fn words(self) -> Self::Words {
        match self {
            Self::Corner(why) => InvalidBox::Corner(why.words()),
            Self::Order { south, north } => InvalidBox::Order {
                south: Value(south),
                north: Value(north),
            },
        }
    }
}
