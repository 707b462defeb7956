//! Speed of the terrain on one core: patches beside the loop that a user would write, and tiles and keys beside the crate `s2`.
//!
//! `taskset -c 1 cargo bench -p s2-cells`; nanoseconds are the minimum and the median of blocks, as in `frontier`.

#![allow(clippy::unwrap_used, clippy::indexing_slicing)] // a bench may fail loudly

use std::hint::black_box;

use fastrand::Rng;
use s2::cellid::CellID;
use terrella::cube::{CubeMap, Edge, Face, Quadrilateralized};
use terrella::terrain::{Base, Hilbert, Key, Morton, Patches, Tile};
use terrella::{Ecef, Ellipsoid, Geodetic, Shift};
use timing::{REPETITIONS, Timing, time};

const SAMPLES: u32 = 64;
const PLACES: usize = (SAMPLES * SAMPLES) as usize;
const TILES: usize = 256;
const KEYS: usize = 1 << 16;

fn main() {
    let map = CubeMap::new(Ellipsoid::WGS84, Shift::Authalic, Quadrilateralized).unwrap();
    let mut rng = Rng::with_seed(1);
    let mut tile = |level: u8| {
        let mut index = || rng.u32(0..1 << level);
        let (i, j) = (index(), index());
        Tile::new(Face::ALL[rng.usize(0..6)], level, i, j).unwrap()
    };
    let inner: Vec<_> = (0..TILES).map(|n| tile(8 + (n % 8) as u8)).collect();
    let any: Vec<_> = (0..KEYS).map(|n| tile((n % 31) as u8)).collect();
    patches(&map, &inner);
    keys(&any);
}

fn patches(map: &CubeMap<f64, Quadrilateralized>, tiles: &[Tile]) {
    println!("patches of {SAMPLES} x {SAMPLES}, quadrilateralized, WGS84, authalic: displacements and normals");
    let patches = Patches::new(*map);
    let mut columns = [0; 6].map(|_| vec![0.0_f32; PLACES]);
    let report = |name: &str, Timing { min, median }: Timing| {
        println!("{name:56} {:9.0} {:9.0} patches a second", 1e9 / min, 1e9 / median);
    };
    let ours = one_at_a_time(tiles, |tile| {
        let [ox, oy, oz, nx, ny, nz] = columns.each_mut().map(Vec::as_mut_slice);
        black_box(
            patches
                .fill(tile, Base::default(), SAMPLES, [ox, oy, oz], [nx, ny, nz])
                .unwrap(),
        );
    });
    report("Patches::fill", ours);
    let scalar = one_at_a_time(tiles, |tile| {
        one_by_one(map, tile, &mut columns);
        black_box(&columns);
    });
    report("a loop in f64 over unproject and to_ecef", scalar);
    let patch = patches.of(tiles[0], Base::default());
    let eye = Ecef::new(6_378_500.0, 3_000.0, 20_000.0).unwrap();
    let heights = vec![100.0_f32; PLACES];
    let mut vertices = [0; 3].map(|_| vec![0.0_f32; PLACES]);
    let vertex = one_at_a_time(tiles, |_| {
        let [ox, oy, oz, nx, ny, nz] = columns.each_ref().map(Vec::as_slice);
        let into = vertices.each_mut().map(Vec::as_mut_slice);
        let seen = patch.seen_from(black_box(eye));
        seen.fill(SAMPLES, [ox, oy, oz], [nx, ny, nz], &heights, into).unwrap();
        black_box(&vertices);
    });
    report("Vertices::fill, for a frame", vertex);
}

/// Each patch is a block of its own: the mean of them.
fn one_at_a_time(tiles: &[Tile], mut pass: impl FnMut(Tile)) -> Timing {
    let times: Vec<_> = tiles.iter().map(|&tile| time(1, REPETITIONS, |_| pass(tile))).collect();
    let mean = |of: fn(&Timing) -> f64| times.iter().map(of).sum::<f64>() / times.len() as f64;
    Timing {
        min: mean(|timing| timing.min),
        median: mean(|timing| timing.median),
    }
}

/// What a user would write: each place from the cube to latitude and longitude to Earth-centred coordinates.
fn one_by_one(map: &CubeMap<f64, Quadrilateralized>, tile: Tile, columns: &mut [Vec<f32>; 6]) {
    let earth = map.shifted().ellipsoid();
    let ground = |node: [u32; 2]| {
        let place = map.unproject(tile.node(node, SAMPLES - 1));
        (
            earth.to_ecef(Geodetic::from(place)).to_array(),
            place.to_direction().to_array(),
        )
    };
    let last = SAMPLES - 1;
    let [a, b, c, d] = [[0, 0], [last, 0], [0, last], [last, last]].map(|node| ground(node).0);
    for n in 0..SAMPLES {
        for m in 0..SAMPLES {
            let (s, t) = (f64::from(m) / f64::from(last), f64::from(n) / f64::from(last));
            let (point, normal) = ground([m, n]);
            let index = (n * SAMPLES + m) as usize;
            for k in 0..3 {
                let flat = (a[k] * (1.0 - s) + b[k] * s) * (1.0 - t) + (c[k] * (1.0 - s) + d[k] * s) * t;
                columns[k][index] = (point[k] - flat) as f32;
                columns[3 + k][index] = normal[k] as f32;
            }
        }
    }
}

fn keys(tiles: &[Tile]) {
    println!("tiles of any level and their keys, nanoseconds each");
    let cells: Vec<_> = tiles
        .iter()
        .map(|&tile| CellID(Key::<Hilbert>::from(tile).bits()))
        .collect();
    let parts: Vec<_> = cells
        .iter()
        .map(|cell| (cell.face_ij_orientation(), cell.level()))
        .collect();
    let hilbert: Vec<_> = tiles.iter().copied().map(Key::<Hilbert>::from).collect();
    let morton: Vec<_> = tiles.iter().copied().map(Key::<Morton>::from).collect();
    each("Key::<Hilbert>::from(tile)", tiles, Key::<Hilbert>::from);
    each("s2 from_face_ij and parent", &parts, |((face, i, j, _), level)| {
        CellID::from_face_ij(face, i, j).parent(level)
    });
    each("Tile::from(Key::<Hilbert>)", &hilbert, Tile::from);
    each("s2 face_ij_orientation and level", &cells, |cell| {
        (cell.face_ij_orientation(), cell.level())
    });
    each("Key::<Morton>::from(tile)", tiles, Key::<Morton>::from);
    each("Tile::from(Key::<Morton>)", &morton, Tile::from);
    each("four neighbours of a tile", tiles, four);
    each("four neighbours of a Hilbert key, as keys", &hilbert, |key| {
        four(Tile::from(key)).map(Key::<Hilbert>::from)
    });
    each("s2 edge_neighbors", &cells, |cell| cell.edge_neighbors());
}

fn four(tile: Tile) -> [Tile; 4] {
    Edge::ALL.map(|edge| tile.neighbour(edge).tile)
}

fn each<I: Copy, O>(name: &str, inputs: &[I], mut function: impl FnMut(I) -> O) {
    let Timing { min, median } = time(inputs.len(), REPETITIONS, |range| {
        for &input in &inputs[range] {
            black_box(function(black_box(input)));
        }
    });
    println!("{name:56} {min:9.2} {median:9.2}");
}
