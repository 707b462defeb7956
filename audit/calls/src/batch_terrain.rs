use terrella::batch::{self, terrain::InvalidTiled};
use terrella::cube::{Balanced, CubeMap, Face, S2Quadratic};
use terrella::terrain::{Curve, Hilbert, Morton, Tile};
use terrella::{Ellipsoid, Shift};

use crate::batch::{face_points, function, lent, places, vectors};
use crate::{Arguments, Bits, Hash, POINTS, Scalar, Visitor};

pub fn show<T: Scalar, V: Visitor>(visitor: &mut V) {
    tiles::<T, V, Morton>(visitor, "Morton");
    tiles::<T, V, Hilbert>(visitor, "Hilbert");
    samples::<T, V>(visitor);
    // S2 computes in double precision.
    if T::NAME == f64::NAME {
        s2_leaves(visitor);
    }
}

/// Tiles of any level, as columns.
fn addresses(arguments: &mut Arguments) -> ([Face; POINTS], [u8; POINTS], [[u32; POINTS]; 2]) {
    let faces = [(); POINTS].map(|()| arguments.face());
    let levels = [(); POINTS].map(|()| arguments.below(31) as u8);
    let squares = [(); 2].map(|()| levels.map(|level| arguments.below(1 << 24) as u32 >> (24 - level.min(24))));
    (faces, levels, squares)
}

fn tiles<T: Scalar, V: Visitor, C: Curve>(visitor: &mut V, name: &'static str) {
    // What has no scalar is shown once.
    if T::NAME == f64::NAME {
        visitor.visit::<T, _, _>(
            function("batch::terrain::to_key", name),
            addresses,
            |(faces, levels, [i, j])| {
                let mut keys = [0; POINTS];
                let outcome = batch::terrain::to_key::<C, _>(&faces, &levels, [&i, &j], &mut keys);
                (keys, outcome)
            },
        );
        let keys = |arguments: &mut Arguments| {
            // Of all levels; a few are no keys.
            let bits = |arguments: &mut Arguments| arguments.below(1 << 22) << 42 | arguments.below(1 << 22) << 20;
            [(); POINTS].map(|()| (bits(arguments) | 1 << (2 * arguments.below(31))) & !(1 << 63))
        };
        visitor.visit::<T, _, _>(function("batch::terrain::from_key", name), keys, |keys| {
            let (mut faces, mut levels, mut squares) = ([Face::Top; POINTS], [0; POINTS], [[0; POINTS]; 2]);
            let [i, j] = &mut squares;
            let outcome = batch::terrain::from_key::<C, _>(&keys, &mut faces, &mut levels, [i, j]);
            (faces, levels, squares, outcome)
        });
    }
    let Ok(map) = CubeMap::new(Ellipsoid::<T>::WGS84, Shift::Authalic, S2Quadratic) else {
        return;
    };
    let levels = |arguments: &mut Arguments| arguments.below(32) as u8;
    visitor.visit::<T, _, _>(
        function("batch::terrain::places_to_key", name),
        |arguments| (levels(arguments), places::<T>(arguments)),
        |(level, places)| {
            let mut keys = [0; POINTS];
            let outcome = batch::terrain::places_to_key::<C, _, _>(&map, level, lent(&places), &mut keys);
            (keys, outcome)
        },
    );
    visitor.visit::<T, _, _>(
        function("batch::terrain::directions_to_key", name),
        |arguments| (levels(arguments), vectors::<T>(arguments)),
        |(level, vectors)| {
            let mut keys = [0; POINTS];
            let outcome = batch::terrain::directions_to_key::<C, _, _>(S2Quadratic, level, lent(&vectors), &mut keys);
            (keys, outcome)
        },
    );
}

fn samples<T: Scalar, V: Visitor>(visitor: &mut V) {
    visitor.visit::<T, _, _>(
        function("batch::terrain::containing", ""),
        |arguments| (arguments.below(32) as u8, face_points::<T>(arguments)),
        |(level, (faces, points))| {
            let mut squares = [[0; POINTS]; 2];
            let [i, j] = &mut squares;
            let outcome = batch::terrain::containing(level, &faces, lent(&points), [i, j]);
            (squares, outcome)
        },
    );
    let Ok(map) = CubeMap::new(Ellipsoid::<T>::WGS84, Shift::Authalic, Balanced) else {
        return;
    };
    let tile = |arguments: &mut Arguments| loop {
        let level = arguments.below(31) as u8;
        if let Ok(tile) = Tile::containing(arguments.face_point::<T>(), level) {
            return tile;
        }
    };
    visitor.visit::<T, _, _>(function("batch::terrain::sample_places", ""), tile, |tile| {
        let mut columns = [[T::ZERO; 144]; 2];
        let [lat, lon] = &mut columns;
        let outcome = batch::terrain::sample_places(&map, tile, 12, [lat, lon]);
        (columns, outcome)
    });
    visitor.visit::<T, _, _>(function("batch::terrain::sample_directions", ""), tile, |tile| {
        let mut columns = [[T::ZERO; 144]; 3];
        let [x, y, z] = &mut columns;
        let outcome = batch::terrain::sample_directions(Balanced, tile, 12, [x, y, z]);
        (columns, outcome)
    });
}

fn s2_leaves<V: Visitor>(visitor: &mut V) {
    visitor.visit::<f64, _, _>(function("batch::terrain::s2_leaf", ""), vectors::<f64>, |vectors| {
        let mut keys = [0; POINTS];
        let outcome = batch::terrain::s2_leaf(lent(&vectors), &mut keys);
        (keys, outcome)
    });
}

impl<E: Bits> Bits for InvalidTiled<E> {
    fn add_to(&self, hash: &mut Hash) {
        match self {
            Self::Place(why) => why.add_to(hash),
            Self::Tile(why) => why.add_to(hash),
        }
    }
}
