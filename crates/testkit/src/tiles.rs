//! Random tiles, many of them near special cases.

use fastrand::Rng;
use terrella::cube::Face;
use terrella::terrain::Tile;

pub fn face(rng: &mut Rng) -> Face {
    Face::ALL[rng.usize(0..6)]
}

/// A column or row of a level: often the first, the last or one next to the middle.
pub fn index(rng: &mut Rng, level: u8) -> u32 {
    let last = (1_u32 << level) - 1;
    match rng.u8(0..8) {
        0 => 0,
        1 => last,
        2 => last / 2,
        3 => last.div_ceil(2),
        _ => rng.u32(0..=last),
    }
}

pub fn tile(rng: &mut Rng) -> Tile {
    let level = rng.u8(0..=Tile::MAX_LEVEL);
    tile_of(rng, level)
}

pub fn tile_of(rng: &mut Rng, level: u8) -> Tile {
    Tile::new(face(rng), level, index(rng, level), index(rng, level)).unwrap()
}
