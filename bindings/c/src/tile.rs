use pastey::paste;
use terrella::LatLon;
use terrella::cube::Face;
use terrella::terrain::{Hilbert, Key, LatLonBox, Tile};

use crate::cube::{terrella_cube_f32, terrella_cube_f64};
use crate::handle::{object, put};
use crate::status::{status, terrella_status};

/// The face of a number. Faces and levels come as 32 bits: C would cut a larger number to 8 in silence.
pub fn face_of(number: u32) -> Result<Face, terrella_status> {
    let number = u8::try_from(number).map_err(|_| terrella_status::TERRELLA_FACE)?;
    Ok(Face::from_index(number)?)
}

fn level_of(number: u32) -> Result<u8, terrella_status> {
    u8::try_from(number).map_err(|_| terrella_status::TERRELLA_LEVEL)
}

/// The key of a tile, along Hilbert's curve: face 0 to 5, level 0 to 30, column and row 0 to 2^level − 1. With the projection
/// "s2-quadratic" and the shift "geodetic" it is S2's cell id.
///
/// # Safety
/// `key` is NULL or valid.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn terrella_tile_key(face: u32, level: u32, i: u32, j: u32, key: *mut u64) -> terrella_status {
    status(|| {
        let tile = Tile::new(face_of(face)?, level_of(level)?, i, j)?;
        // SAFETY: the caller's.
        unsafe { put(key, Key::<Hilbert>::from(tile).bits()) };
        Ok(())
    })
}

/// The tile of a key.
///
/// # Safety
/// Pointers are NULL or valid.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn terrella_tile_of_key(
    key: u64,
    face: *mut u8,
    level: *mut u8,
    i: *mut u32,
    j: *mut u32,
) -> terrella_status {
    // SAFETY: the caller's.
    status(|| unsafe {
        let tile = Tile::from(Key::<Hilbert>::new(key)?);
        put(face, tile.face().index());
        put(level, tile.level());
        put(i, tile.i());
        put(j, tile.j());
        Ok(())
    })
}

macro_rules! functions {
    ($($t:ident)*) => {$(paste! {
        /// The key of the tile of a level that contains a place in degrees.
        ///
        /// # Safety
        /// Pointers are NULL or valid; `cube` may not be NULL.
        #[unsafe(no_mangle)]
        pub unsafe extern "C" fn [<terrella_cube_key_ $t>](
            cube: *const [<terrella_cube_ $t>],
            lat: $t,
            lon: $t,
            level: u32,
            key: *mut u64,
        ) -> terrella_status {
            // SAFETY: the caller's.
            status(|| unsafe {
                let tile = Tile::containing(object(cube)?.project(LatLon::new(lat, lon)?), level_of(level)?)?;
                put(key, Key::<Hilbert>::from(tile).bits());
                Ok(())
            })
        }

        /// The box of latitudes and longitudes in degrees that holds a tile; `east` is below `west` if it crosses ±180°.
        ///
        /// # Safety
        /// Pointers are NULL or valid; `cube` may not be NULL.
        #[unsafe(no_mangle)]
        pub unsafe extern "C" fn [<terrella_cube_bounds_ $t>](
            cube: *const [<terrella_cube_ $t>],
            key: u64,
            south: *mut $t,
            west: *mut $t,
            north: *mut $t,
            east: *mut $t,
        ) -> terrella_status {
            // SAFETY: the caller's.
            status(|| unsafe {
                let bounds = LatLonBox::of_tile(object(cube)?, Tile::from(Key::<Hilbert>::new(key)?));
                put(south, bounds.south());
                put(west, bounds.west());
                put(north, bounds.north());
                put(east, bounds.east());
                Ok(())
            })
        }
    })*};
}

functions! { f64 f32 }
