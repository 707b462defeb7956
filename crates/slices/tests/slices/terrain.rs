//! Tiles, keys and samples, by projections of their own types: those of [`Projection`](terrella::cube::Projection) are
//! tried in `cube.rs`, and are long to compile.

use terrella::batch::{self, InvalidBatch, terrain::InvalidTiled};
use terrella::cube::{Balanced, Cobe, CubeMap, CubeProjection, Face, FacePoint, InvalidFace, S2Quadratic, Vertex};
use terrella::terrain::{Curve, Hilbert, InvalidKey, InvalidNumberedTile, InvalidTile, Key, Morton, Tile};
use terrella::{Direction, Ellipsoid, LatLon, Shift};

use super::{ALL, Scalar, bits, bytes, directions, faces, numbers, parts, places, points};

/// Keys of both curves, from tiles and back, and of places.
fn every_key<T: Scalar, C: Curve>() {
    let mut rng = fastrand::Rng::with_seed(41);
    let tiles = [(); ALL].map(|()| {
        let level = rng.u8(0..=30);
        let [i, j] = [(); 2].map(|()| rng.u32(0..1 << level));
        Tile::new(Face::ALL[rng.usize(0..6)], level, i, j).unwrap()
    });
    let keys = tiles.map(|tile| Key::<C>::from(tile).bits());
    for part in parts() {
        let tiles = &tiles[part.clone()];
        let faces: Vec<Face> = tiles.iter().map(|tile| tile.face()).collect();
        let levels: Vec<u8> = tiles.iter().map(|tile| tile.level()).collect();
        let [i, j]: [Vec<u32>; 2] = [
            tiles.iter().map(|tile| tile.i()).collect(),
            tiles.iter().map(|tile| tile.j()).collect(),
        ];
        let mut found = vec![7; part.len()];
        batch::terrain::to_key::<C, _>(&faces, &levels, [&i, &j], &mut found).unwrap();
        assert_eq!(found, keys[part.clone()]);
        let (mut f, mut l, mut a, mut b) = (vec![9_u8; part.len()], levels.clone(), i.clone(), j.clone());
        l.fill(9);
        a.fill(9);
        b.fill(9);
        batch::terrain::from_key::<C, _>(&found, &mut f, &mut l, [&mut a, &mut b]).unwrap();
        assert_eq!((&l, &a, &b), (&levels, &i, &j));
        assert!(f.iter().zip(&faces).all(|(f, face)| *f == face.index()));
    }
    let map = CubeMap::new(Ellipsoid::<T>::WGS84, Shift::Authalic, S2Quadratic).unwrap();
    let ([lat, lon], [x, y, z]) = (places::<T>(), directions::<T>());
    let key = |point, level| Key::<C>::from(Tile::containing(point, level).unwrap()).bits();
    for (part, level) in parts().zip([0, 1, 12, 29, 30].into_iter().cycle()) {
        let mut found = vec![7; part.len()];
        batch::terrain::places_to_key::<C, _, _>(&map, level, [&lat[part.clone()], &lon[part.clone()]], &mut found)
            .unwrap();
        for (i, &found) in part.clone().zip(&found) {
            assert_eq!(found, key(map.project(LatLon::new(lat[i], lon[i]).unwrap()), level));
        }
        let columns = [&x[part.clone()], &y[part.clone()], &z[part.clone()]];
        batch::terrain::directions_to_key::<C, _, _>(Cobe, level, columns, &mut found).unwrap();
        for (i, found) in part.clone().zip(found) {
            let point = Cobe.project(Direction::new(x[i], y[i], z[i]).unwrap());
            assert_eq!(found, key(point, level));
        }
        let [face, x, y] = points::<T>().map(|column| column[part.clone()].to_vec());
        let (mut i, mut j) = (vec![7; part.len()], vec![7; part.len()]);
        batch::terrain::containing(level, &bytes(&face), [&x, &y], [&mut i, &mut j]).unwrap();
        for index in 0..part.len() {
            let point = FacePoint::new(faces(&face)[index], x[index], y[index]).unwrap();
            let tile = Tile::containing(point, level).unwrap();
            assert_eq!((i[index], j[index]), (tile.i(), tile.j()));
        }
    }
}

#[test]
fn keys_are_the_same_bits() {
    every_key::<f64, Hilbert>();
    every_key::<f32, Hilbert>();
    every_key::<f64, Morton>();
    every_key::<f32, Morton>();
}

#[test]
fn s2_cells_are_the_same_bits() {
    let ends = &[0.0, -0.0, 1.0, -1.0, 0.5, -0.5, 1e-300, -1e-300];
    let [x, y, z] = [1, 2, 3].map(|seed| numbers::<f64>(seed, ends));
    for part in parts() {
        let mut found = vec![7; part.len()];
        let result = batch::terrain::s2_leaf([&x[part.clone()], &y[part.clone()], &z[part.clone()]], &mut found);
        let expected = part.clone().map(|i| Key::s2_leaf_of([x[i], y[i], z[i]]));
        assert!(
            found
                .iter()
                .zip(expected.clone())
                .all(|(found, key)| *found == key.map_or(0, Key::bits))
        );
        let refused = expected.clone().filter(Result::is_err).count();
        match result {
            Ok(()) => assert_eq!(refused, 0),
            Err(InvalidBatch::Elements { count, first, why }) => {
                assert_eq!((count, Err(why)), (refused, expected.clone().nth(first).unwrap()));
            }
            other => panic!("{other:?}"),
        }
    }
}

#[test]
fn tiles_that_are_refused() {
    // 70 elements, of which some are bad: keys of nothing, tiles of no level.
    let bad = [0, 0x5000_0000_0000_0002, u64::MAX, 1 << 63, 0xd000_0000_0000_0000];
    let good = Key::<Hilbert>::from(Tile::new(Face::Top, 4, 3, 9).unwrap()).bits();
    for length in [3, 70] {
        for bits in bad {
            let mut keys = vec![good; length];
            (keys[1], keys[length - 1]) = (bits, bits);
            let (mut face, mut level) = (vec![Face::Left; length], vec![7; length]);
            let (mut i, mut j) = (vec![7; length], vec![7; length]);
            let found = batch::terrain::from_key::<Hilbert, _>(&keys, &mut face, &mut level, [&mut i, &mut j]);
            let (count, first, why) = (2, 1, InvalidKey(bits));
            assert_eq!(found, Err(InvalidBatch::Elements { count, first, why }));
            assert_eq!((face[0], level[0], i[0], j[0]), (Face::Top, 4, 3, 9));
            assert_eq!((face[1], level[1], i[1], j[1]), (Face::Front, 0, 0, 0));
        }
        let level_31 = InvalidNumberedTile::Tile(InvalidTile::Level(31));
        let column = InvalidNumberedTile::Tile(InvalidTile::Column { level: 4, i: 16 });
        let row = InvalidNumberedTile::Tile(InvalidTile::Row { level: 4, j: u32::MAX });
        let face = InvalidNumberedTile::Face(InvalidFace(6));
        for (tile, why) in [
            ((0, 31, 0, 0), level_31),
            ((0, 4, 16, 0), column),
            ((0, 4, 0, u32::MAX), row),
            ((6, 99, 0, 0), face),
        ] {
            let (mut f, mut l, mut i, mut j) = (vec![4; length], vec![4; length], vec![3; length], vec![9; length]);
            (f[1], l[1], i[1], j[1]) = tile;
            let mut keys = vec![7; length];
            let found = batch::terrain::to_key::<Hilbert, u8>(&f, &l, [&i, &j], &mut keys);
            let (count, first) = (1, 1);
            assert_eq!(found, Err(InvalidBatch::Elements { count, first, why }));
            assert_eq!((keys[0], keys[1], keys[2]), (good, 0, good));
        }
        let map = CubeMap::new(Ellipsoid::<f64>::WGS84, Shift::Authalic, Vertex).unwrap();
        let mut lat = vec![1.0; length];
        lat[1] = f64::NAN;
        let (lon, mut keys) = (vec![2.0; length], vec![7; length]);
        let found = batch::terrain::places_to_key::<Morton, _, _>(&map, 30, [&lat, &lon], &mut keys);
        assert!(matches!(
            found,
            Err(InvalidBatch::Elements {
                count: 1,
                first: 1,
                why: InvalidTiled::Place(_)
            })
        ));
        assert!(keys[1] == 0 && keys[0] == keys[2] && keys[0] != 0);
        let found = batch::terrain::places_to_key::<Morton, _, _>(&map, 31, [&lat, &lon], &mut keys);
        let (count, first, why) = (length, 0, InvalidTiled::Tile(InvalidTile::Level(31)));
        assert_eq!(found, Err(InvalidBatch::Elements { count, first, why }));
        assert!(keys.iter().all(|&key| key == 0));
        let found = batch::terrain::places_to_key::<Morton, _, _>(&map, 31, [&lat, &lon], &mut keys[1..]);
        assert_eq!(
            found,
            Err(InvalidBatch::Lengths {
                first: length,
                other: length - 1
            })
        );
        assert_eq!(
            batch::terrain::places_to_key::<Morton, f64, _>(&map, 31, [&[], &[]], &mut []),
            Ok(())
        );
    }
}

fn every_sample<T: Scalar>() {
    let map = CubeMap::new(Ellipsoid::<T>::WGS84, Shift::Conformal, Balanced).unwrap();
    for (tile, samples) in [
        (Tile::root(Face::Left), 0),
        (Tile::root(Face::Top), 1),
        (Tile::new(Face::Bottom, 3, 7, 2).unwrap(), 2),
        (Tile::new(Face::Back, 20, 1 << 19, 77).unwrap(), 17),
        (Tile::new(Face::Front, 30, 5, 1 << 29).unwrap(), 33),
    ] {
        let length = (samples * samples) as usize;
        let mut found = [(); 5].map(|()| vec![T::of(7.0); length]);
        let [lat, lon, x, y, z] = &mut found;
        batch::terrain::sample_places(&map, tile, samples, [lat, lon]).unwrap();
        batch::terrain::sample_directions(Vertex, tile, samples, [x, y, z]).unwrap();
        for index in 0..length as u32 {
            let node = tile.node([index % samples, index / samples], samples.saturating_sub(1));
            let (place, direction) = (map.unproject(node), Vertex.unproject(node));
            let [x, y, z] = direction.to_array();
            let row = found.each_ref().map(|column| column[index as usize]);
            assert_eq!(bits(&row), bits(&[place.lat(), place.lon(), x, y, z]));
        }
        let [lat, lon, ..] = &mut found;
        lat.push(T::ZERO);
        let refused = batch::terrain::sample_places(&map, tile, samples, [lat, lon]);
        assert_eq!(
            refused,
            Err(InvalidBatch::Lengths {
                first: length,
                other: length + 1
            })
        );
    }
}

#[test]
fn samples_are_the_same_bits() {
    every_sample::<f64>();
    every_sample::<f32>();
}
