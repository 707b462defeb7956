//! Tiles, keys and samples.

use terrella::batch::{self, InvalidBatch, terrain::InvalidTiled};
use terrella::cube::{CubeMap, CubeProjection, Face};
use terrella::terrain::{Curve, Hilbert, InvalidTile, Key, Morton, Tile};
use terrella::{Direction, Ellipsoid, LatLon, Real, Shift};

use super::{compare_or, face_point, judge, numbers, place, point, vector};
use testkit::bytes::Bytes;
use testkit::scalar::{Scalar, same};

/// A whole number in pieces of 16 bits, which are exact in any scalar.
pub(super) fn pieces<T: Real>(number: u64) -> [T; 4] {
    [48, 32, 16, 0].map(|shift| T::of(f64::from((number >> shift) as u16)))
}

/// Keys in place of columns of their pieces, which are written if they are. If a column has another length, so have the keys.
pub(super) fn with_keys<T: Scalar, E>(
    columns: [&mut [T]; 4],
    work: impl FnOnce(&mut [u64]) -> Result<(), InvalidBatch<E>>,
) -> Result<(), InvalidBatch<E>> {
    let lengths = columns.each_ref().map(|column| column.len());
    let usual = if lengths[1] == lengths[2] {
        lengths[1]
    } else {
        lengths[3]
    };
    let length = lengths.into_iter().find(|&length| length != usual).unwrap_or(usual);
    let mut keys = vec![7; length];
    let result = work(&mut keys);
    if matches!(result, Err(InvalidBatch::Lengths { .. })) {
        assert!(keys.iter().all(|&key| key == 7), "keys are written");
        return result;
    }
    for (column, values) in columns.into_iter().enumerate() {
        for (slot, &key) in values.iter_mut().zip(&keys) {
            *slot = pieces::<T>(key)[column];
        }
    }
    result
}

pub(super) fn tiles<T: Scalar>(bytes: &mut Bytes<'_>) {
    if bytes.flag() {
        tiles_along::<T, Hilbert>(bytes);
    } else {
        tiles_along::<T, Morton>(bytes);
    }
}

fn too_deep<E>(level: u8) -> InvalidTiled<E> {
    InvalidTiled::Tile(InvalidTile::Level(level))
}

/// Tiles that contain points, places and directions.
fn tiles_along<T: Scalar, C: Curve>(bytes: &mut Bytes<'_>) {
    let level = bytes.byte() % 33;
    let projection = bytes.projection();
    let nothing = [T::ZERO; 4];
    match bytes.byte() % 4 {
        0 => compare_or(
            bytes,
            "containing",
            nothing,
            point,
            |point| {
                if level > Tile::MAX_LEVEL {
                    return Err(too_deep(level));
                }
                let tile = Tile::containing(face_point(point).map_err(InvalidTiled::Place)?, level).unwrap();
                Ok(pieces(u64::from(tile.i()) << 32 | u64::from(tile.j())))
            },
            |[x, y, faces], columns| {
                with_keys(columns, |keys| {
                    let (mut i, mut j) = (vec![0; keys.len()], vec![7; keys.len()]);
                    let result = batch::terrain::containing(level, &numbers(faces), [x, y], [&mut i, &mut j]);
                    for (slot, (&i, &j)) in keys.iter_mut().zip(i.iter().zip(&j)) {
                        *slot = u64::from(i) << 32 | u64::from(j);
                    }
                    result
                })
            },
        ),
        1 => {
            let shift = bytes.choice(Shift::ALL);
            let map = CubeMap::new(Ellipsoid::<T>::WGS84, shift, projection).unwrap();
            compare_or(
                bytes,
                "places_to_key",
                nothing,
                place,
                |[lat, lon]| {
                    if level > Tile::MAX_LEVEL {
                        return Err(too_deep(level));
                    }
                    let point = map.project(LatLon::new(lat, lon).map_err(InvalidTiled::Place)?);
                    Ok(pieces(Key::<C>::from(Tile::containing(point, level).unwrap()).bits()))
                },
                |places, columns| {
                    with_keys(columns, |keys| {
                        batch::terrain::places_to_key::<C, _, _>(&map, level, places, keys)
                    })
                },
            );
        }
        2 => compare_or(
            bytes,
            "directions_to_key",
            nothing,
            vector,
            |[x, y, z]| {
                if level > Tile::MAX_LEVEL {
                    return Err(too_deep(level));
                }
                let point = projection.project(Direction::new(x, y, z).map_err(InvalidTiled::Place)?);
                Ok(pieces(Key::<C>::from(Tile::containing(point, level).unwrap()).bits()))
            },
            |directions, columns| {
                with_keys(columns, |keys| {
                    batch::terrain::directions_to_key::<C, T, _>(projection, level, directions, keys)
                })
            },
        ),
        _ => compare_or(
            bytes,
            "s2_leaf",
            nothing,
            vector::<T>,
            |ray| Ok(pieces(Key::s2_leaf_of(ray.map(Into::into))?.bits())),
            |rays, columns| {
                let rays: [Vec<f64>; 3] = rays.map(|column| column.iter().map(|&part| part.into()).collect());
                with_keys(columns, |keys| {
                    batch::terrain::s2_leaf(rays.each_ref().map(|column| &column[..]), keys)
                })
            },
        ),
    }
}

/// Addresses of tiles to keys, and keys to addresses.
pub(super) fn keys<T: Scalar>(bytes: &mut Bytes<'_>) {
    if bytes.flag() {
        keys_along::<T, Hilbert>(bytes);
    } else {
        keys_along::<T, Morton>(bytes);
    }
}

fn keys_along<T: Scalar, C: Curve>(bytes: &mut Bytes<'_>) {
    let (count, stride) = (usize::from(bytes.byte()), usize::from(bytes.byte()));
    let few = [(); 4].map(|()| {
        let (face, level) = (bytes.byte() % 7, bytes.byte() % 32);
        let bits = if bytes.byte() % 8 == 7 { 31 } else { level };
        let [i, j] = [(); 2].map(|()| (bytes.word() & ((1 << bits) - 1)) as u32);
        (face, level, i, j)
    });
    let rows: Vec<_> = (0..count).map(|i| few[(i * stride + i * i) % few.len()]).collect();
    let column = |of: fn(&(u8, u8, u32, u32)) -> u32| rows.iter().map(of).collect::<Vec<u32>>();
    let faces: Vec<u8> = rows.iter().map(|row| row.0).collect();
    let levels: Vec<u8> = rows.iter().map(|row| row.1).collect();
    let (i, j) = (column(|row| row.2), column(|row| row.3));
    let mut keys = vec![7; count];
    let found = batch::terrain::to_key::<C, _>(&faces, &levels, [&i, &j], &mut keys);
    let tile = |&(face, level, i, j): &(u8, u8, u32, u32)| Tile::new(Face::from_index(face).ok()?, level, i, j).ok();
    for (row, &key) in rows.iter().zip(&keys) {
        let expected = tile(row).map_or(0, |tile| Key::<C>::from(tile).bits());
        assert_eq!(key, expected, "{row:?}");
    }
    let bad: Vec<usize> = (0..count).filter(|&i| tile(&rows[i]).is_none()).collect();
    match found {
        Err(InvalidBatch::Elements { count, first, .. }) => assert_eq!((count, first), (bad.len(), bad[0])),
        other => assert!(other.is_ok() && bad.is_empty(), "{other:?}"),
    }

    // Back, and from anything.
    let anything = bytes.word();
    for slot in keys.iter_mut().skip(3).step_by(5) {
        *slot ^= anything;
    }
    let mut results = [(); 6].map(|()| vec![T::ZERO; count]);
    let (mut f, mut l, mut a, mut b) = (vec![9_u8; count], vec![9; count], vec![9; count], vec![9; count]);
    let found = batch::terrain::from_key::<C, _>(&keys, &mut f, &mut l, [&mut a, &mut b]);
    let row = |face: u8, level: u8, i: u32, j: u32| {
        let [_, _, high, low] = pieces::<T>(u64::from(i));
        let [_, _, above, below] = pieces::<T>(u64::from(j));
        [T::of(f64::from(face)), T::of(f64::from(level)), high, low, above, below]
    };
    for index in 0..count {
        let row = row(f[index], l[index], a[index], b[index]);
        for (column, value) in results.iter_mut().zip(row) {
            column[index] = value;
        }
    }
    let one = |index: usize| {
        let tile = Tile::from(Key::<C>::new(keys[index])?);
        Ok(row(tile.face().index(), tile.level(), tile.i(), tile.j()))
    };
    judge(&format!("{keys:?}"), [T::ZERO; 6], &results, one, found);
}

pub(super) fn samples<T: Scalar>(bytes: &mut Bytes<'_>) {
    let level = bytes.byte() % 31;
    let [i, j] = [(); 2].map(|()| (bytes.word() & ((1 << level) - 1)) as u32);
    let tile = Tile::new(bytes.face(), level, i, j).unwrap();
    let samples = u32::from(bytes.byte() % 24);
    let projection = bytes.projection();
    let map = CubeMap::new(Ellipsoid::<T>::WGS84, bytes.choice(Shift::ALL), projection).unwrap();
    let count = (samples * samples) as usize;
    let unequal = InvalidBatch::Lengths {
        first: count,
        other: count + 1,
    };
    let mut columns = [(); 3].map(|()| vec![T::ZERO; count + 1]);
    let [x, y, z] = &mut columns;
    let long = batch::terrain::sample_places(&map, tile, samples, [&mut x[..count], y]);
    assert_eq!(long, Err(unequal));
    batch::terrain::sample_places(&map, tile, samples, [&mut x[..count], &mut y[..count]]).unwrap();
    let node = |index: usize| {
        let (n, m) = (index as u32 / samples, index as u32 % samples);
        tile.node([m, n], samples - 1)
    };
    for index in 0..count {
        let place = map.unproject(node(index));
        let well = same(x[index], place.lat()) && same(y[index], place.lon());
        assert!(well, "{map:?} {tile:?} {samples} {index}");
    }
    let all = [&mut x[..count], &mut y[..count], &mut z[..count]];
    batch::terrain::sample_directions(projection, tile, samples, all).unwrap();
    for index in 0..count {
        let [a, b, c] = projection.unproject(node(index)).to_array();
        let well = same(x[index], a) && same(y[index], b) && same(z[index], c);
        assert!(well, "{projection} {tile:?} {samples} {index}");
    }
}
