//! Edges between tiles: identical bits from both sides at one level, and gaps no wider than stated between
//! levels.

use std::fmt::Debug;

use fastrand::Rng;
use terrella::cube::{Corner, CubeProjection, Edge, Face, Faces, Projection};
use terrella::terrain::{Around, Base, Flatness, Heights, Patches, Tile};
use terrella::{Ecef, Ellipsoid, Shift};
use testkit::{maximum, parallel};

use crate::patch::{at, lifted, map};
use crate::vector::{dot, length, minus};

/// The node of an edge, from low to high x or y.
fn on(edge: Edge, along: u32, last: u32) -> [u32; 2] {
    match edge {
        Edge::Right => [last, along],
        Edge::Up => [along, last],
        Edge::Left => [0, along],
        Edge::Down => [along, 0],
    }
}

fn at_corner(corner: Corner, last: u32) -> [u32; 2] {
    match corner {
        Corner::UpRight => [last, last],
        Corner::UpLeft => [0, last],
        Corner::DownLeft => [0, 0],
        Corner::DownRight => [last, 0],
    }
}

/// Whether the places along an edge run the other way beyond it.
fn backward(edge: Edge, turns: u8) -> bool {
    match edge {
        Edge::Right | Edge::Left => turns == 1 || turns == 2,
        Edge::Up | Edge::Down => turns >= 2,
    }
}

/// A camera within some of a tile's sizes of it.
fn camera(rng: &mut Rng, patches: &Patches<impl CubeProjection>, tile: Tile) -> Ecef<f64> {
    let [a, _, c, _] = patches.of(tile, Base::default()).corners().map(Ecef::to_array);
    let size = length(minus(a, c));
    let [x, y, z] = a.map(|v| v + 4.0 * size * (rng.f64() - 0.5));
    Ecef::new(x, y, z).unwrap()
}

/// Heights of a corner by its place: the same from all tiles.
fn base(patches: &Patches<impl CubeProjection>, tile: Tile) -> Base {
    let feet = patches.of(tile, Base::default()).corners().map(Ecef::to_array);
    Base::new(feet.map(|[x, y, z]| 4e3 * (1e-3 * x).sin() + 2e3 * (1e-4 * y).cos() + 5e3 * (1e-6 * z).sin())).unwrap()
}

/// Displacement, normal and vertex of a node: of what edges have to agree.
fn node(
    patches: &Patches<impl CubeProjection>,
    tile: Tile,
    samples: u32,
    eye: Ecef<f64>,
) -> impl Fn([u32; 2]) -> [[u32; 3]; 3] {
    let base = base(patches, tile);
    let [o, n] = lifted(patches, tile, base, samples);
    let seen = patches.of(tile, base).seen_from(eye);
    move |[m, row]| {
        let index = (row * samples + m) as usize;
        let (o, n) = (at(&o, index), at(&n, index));
        [o, n, seen.at([m, row], samples, o, n, 1234.5)].map(|vector| vector.map(f32::to_bits))
    }
}

pub fn edge_agrees(
    rng: &mut Rng,
    patches: &Patches<impl CubeProjection + Debug>,
    tile: Tile,
    edge: Edge,
    samples: u32,
) {
    let last = samples - 1;
    let beyond = tile.neighbour(edge);
    if apart(patches.map().projection().faces(), tile, tile.neighbour(edge).tile) {
        return;
    }
    let eye = camera(rng, patches, tile);
    let (here, there) = (
        node(patches, tile, samples, eye),
        node(patches, beyond.tile, samples, eye),
    );
    for along in 0..samples {
        let other = if backward(edge, beyond.turns) {
            last - along
        } else {
            along
        };
        let (a, b) = (here(on(edge, along, last)), there(on(beyond.edge, other, last)));
        assert_eq!(
            a,
            b,
            "{:?} {tile:?} {edge:?} {along} of {last}",
            patches.map().projection()
        );
    }
}

/// Whether two tiles are on faces that disagree along the edge between them.
fn apart(faces: Faces, tile: Tile, other: Tile) -> bool {
    let [from, to] = [tile, other].map(Tile::face);
    Edge::ALL
        .into_iter()
        .any(|edge| from.neighbour(edge).face == to && !faces.agree(from, edge))
}

fn every_map(check: impl Fn(Patches<Projection>) + Sync) {
    parallel::for_each(Projection::ALL, |&projection| {
        for (ellipsoid, shift) in [
            (Ellipsoid::WGS84, Shift::Authalic),
            (Ellipsoid::MOON, Shift::Geodetic),
            (Ellipsoid::MARS, Shift::Geocentric),
        ] {
            check(map(ellipsoid, shift, projection));
        }
    });
}

/// All of the cube's edges to level 3, sampled to level 12 and beyond, with numbers of samples that are and are not powers of two and one.
#[test]
fn edges_of_the_cube_have_the_same_bits_from_both_sides() {
    every_map(|patches| {
        let mut rng = Rng::with_seed(1);
        for face in Face::ALL {
            for edge in Edge::ALL {
                for level in (0..=12).chain([20, 30]) {
                    let last = (1_u32 << level) - 1;
                    let all = level <= 3;
                    for round in 0..if all { last + 1 } else { 6 } {
                        let along = match round {
                            _ if all => round,
                            0 => 0,
                            1 => last,
                            _ => rng.u32(0..=last),
                        };
                        let [i, j] = on(edge, along, last);
                        let samples = [2, 5, 8, 12][rng.usize(0..4)];
                        edge_agrees(&mut rng, &patches, Tile::new(face, level, i, j).unwrap(), edge, samples);
                    }
                }
            }
        }
    });
}

#[test]
fn edges_within_a_face_have_the_same_bits_from_both_sides() {
    every_map(|patches| {
        let mut rng = Rng::with_seed(2);
        for _ in 0..300 {
            let tile = crate::sample::tile(&mut rng);
            let edge = Edge::ALL[rng.usize(0..4)];
            let samples = rng.u32(2..20);
            edge_agrees(&mut rng, &patches, tile, edge, samples);
        }
    });
}

/// Three tiles in a corner of the cube, four elsewhere: one vertex.
#[test]
fn corners_have_the_same_bits_from_all_sides() {
    every_map(|patches| {
        let mut rng = Rng::with_seed(3);
        let mut threes = 0;
        for face in Face::ALL {
            for corner in Corner::ALL {
                for level in 0..=20 {
                    let last = (1_u32 << level) - 1;
                    for inside in [false, true] {
                        let [i, j] = if inside {
                            [rng.u32(0..=last), rng.u32(0..=last)]
                        } else {
                            at_corner(corner, last)
                        };
                        let tile = Tile::new(face, level, i, j).unwrap();
                        let around = tile.around(corner);
                        threes += u32::from(matches!(around, Around::Three(_)));
                        let eye = camera(&mut rng, &patches, tile);
                        let [first, rest @ ..] = around.as_slice() else {
                            panic!("none around {tile:?}");
                        };
                        let vertex =
                            |(tile, corner): &(Tile, Corner)| node(&patches, *tile, 4, eye)(at_corner(*corner, 3));
                        let faces = patches.map().projection().faces();
                        if inside && around.as_slice().iter().any(|(other, _)| apart(faces, tile, *other)) {
                            continue;
                        }
                        for other in rest {
                            assert_eq!(
                                vertex(first),
                                vertex(other),
                                "{:?} {around:?}",
                                patches.map().projection()
                            );
                        }
                    }
                }
            }
        }
        assert!(threes >= 24 * 21);
    });
}

/// Vertices in double precision along an edge, on terrain of random heights.
fn line(
    patches: &Patches<impl CubeProjection>,
    tile: Tile,
    edge: Edge,
    samples: u32,
    heights: &mut impl FnMut() -> f64,
) -> Vec<[f64; 3]> {
    let last = samples - 1;
    (0..samples)
        .map(|along| {
            let place = patches.map().unproject(tile.node(on(edge, along, last), last));
            let position = terrella::Geodetic::new(place, heights()).unwrap();
            patches.map().shifted().ellipsoid().to_ecef(position).to_array()
        })
        .collect()
}

/// A point of a line of vertices.
fn along(line: &[[f64; 3]], way: f64) -> [f64; 3] {
    let cell = (way as usize).min(line.len() - 2);
    let rest = way - cell as f64;
    std::array::from_fn(|k| line[cell][k] * (1.0 - rest) + line[cell + 1][k] * rest)
}

/// How far the finer tile's edge is from that of the coarser one, at the same parameter.
fn gap(
    rng: &mut Rng,
    patches: &Patches<impl CubeProjection>,
    level: u8,
    finer: u8,
    samples: u32,
    [low, high]: [f64; 2],
) -> f64 {
    let tile = crate::sample::tile_of(rng, level);
    let edge = Edge::ALL[rng.usize(0..4)];
    if apart(patches.map().projection().faces(), tile, tile.neighbour(edge).tile) {
        return 0.0;
    }
    let beyond: Vec<_> = tile.neighbours(edge, level + finer).unwrap().collect();
    let turns = tile.neighbour(edge).turns;
    let meets = tile.neighbour(edge).edge;
    let mut height = || low + (high - low) * [0.0, 0.5, 1.0][rng.usize(0..3)];
    let here = line(patches, tile, edge, samples, &mut height);
    let count = beyond.len();
    let mut widest = 0.0_f64;
    for (part, &small) in beyond.iter().enumerate() {
        let mut there = line(patches, small, meets, samples, &mut height);
        if backward(edge, turns) {
            there.reverse();
        }
        for step in 0..=4 * (samples - 1) {
            let own = f64::from(step) / 4.0;
            let way = (own + (part as f64) * f64::from(samples - 1)) / count as f64;
            widest = maximum(widest, length(minus(along(&there, own), along(&here, way))));
        }
    }
    widest
}

/// The skirt as its documentation states it, from the flatness of the levels.
fn skirt(flatness: &[Flatness], level: u8, samples: u32, [low, high]: [f64; 2]) -> f64 {
    let finer = level as usize + (samples - 1).ilog2() as usize;
    let edges = &flatness[finer..finer + 2];
    let height = (0.5 * (low + high)).abs();
    let apart = |flatness: &Flatness| flatness.displacement + height * flatness.turning;
    edges.iter().fold(high - low, |sum, edge| sum + apart(edge))
}

#[test]
fn gaps_between_levels_are_no_wider_than_said() {
    parallel::for_each(Projection::ALL, |&projection| {
        let patches = map(Ellipsoid::WGS84, Shift::Authalic, projection);
        let mut rng = Rng::with_seed(4);
        let mut used = 0.0_f64;
        // A skirt takes the flatness of two levels, which is long in computing. So skirts are computed from what
        // is known of the levels, and compared with the function's once for each level: the twelve kinds in turn.
        let flatness: Vec<_> = (0..=20).map(|level| patches.flatness(level)).collect();
        for level in 0..=14 {
            let mut kinds = 0;
            for samples in [2, 9, 12, 33] {
                for heights in [[0.0, 0.0], [7000.0, 7000.0], [-300.0, 500.0]] {
                    let skirt = skirt(&flatness, level, samples, heights);
                    if kinds == level % 12 {
                        let [low, high] = heights;
                        let said = patches.skirt(level, samples, Heights::new(low, high).unwrap());
                        assert_eq!(said, skirt, "{projection} {level} {samples} {heights:?}");
                    }
                    kinds += 1;
                    let finer = rng.u8(1..=3);
                    let gap = gap(&mut rng, &patches, level, finer, samples, heights);
                    assert!(
                        gap <= skirt,
                        "{projection} {level} {samples} {heights:?}: {gap} > {skirt}"
                    );
                    used = maximum(used, gap / skirt);
                }
            }
        }
        assert!(used > 0.5, "{projection}: only {used} of the skirts is used");
    });
}

/// What the skirt leaves: how far edges part to the side, where it does not hide.
#[test]
#[ignore = "a table to look at: cargo test --release --test terrain -- --ignored --nocapture gaps_to_the_side"]
fn gaps_to_the_side() {
    for &projection in Projection::ALL {
        let patches = map(Ellipsoid::WGS84, Shift::Authalic, projection);
        let mut rng = Rng::with_seed(5);
        let row = [2, 5, 8, 11, 14].map(|level| {
            let mut most = [0.0_f64; 2];
            for _ in 0..2000 {
                let tile = crate::sample::tile_of(&mut rng, level);
                let edge = Edge::ALL[rng.usize(0..4)];
                let (coarse, fine) = (
                    line(&patches, tile, edge, 65, &mut || 0.0),
                    line(&patches, tile, edge, 129, &mut || 0.0),
                );
                let cell = rng.usize(0..64);
                let apart = minus(fine[2 * cell + 1], along(&coarse, cell as f64 + 0.5));
                let place = patches
                    .map()
                    .unproject(tile.node(on(edge, 2 * cell as u32 + 1, 128), 128));
                let up = dot(apart, place.to_direction().to_array());
                let way = minus(coarse[cell + 1], coarse[cell]);
                let ahead = dot(apart, way) / length(way);
                let side = maximum(dot(apart, apart) - up * up - ahead * ahead, 0.0).sqrt();
                most = [maximum(most[0], up.abs()), maximum(most[1], side)];
            }
            format!("{:.1e} {:.1e}", most[0], most[1])
        });
        println!("{:18} up and side in metres: {}", projection.name(), row.join(" | "));
    }
}
