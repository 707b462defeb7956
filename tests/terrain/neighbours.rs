//! Neighbours against geometry: tiles as squares on the surface of the cube, whose corners are exact.

use std::collections::{BTreeMap, BTreeSet};

use fastrand::Rng;
use terrella::cube::{Corner, CubeProjection, Edge, Face, FacePoint, Projection};
use terrella::terrain::{Around, InvalidTile, Tile};
use testkit::{maximum, minimum};

use crate::sample;

/// A point of the cube's surface, in units that make it whole.
type Vertex = [i64; 3];

fn on_cube(point: FacePoint<f64>) -> Vertex {
    point
        .face()
        .to_earth([point.x(), point.y(), 1.0])
        .map(|v| (v * f64::from(1 << 30)) as i64)
}

fn vertex(tile: Tile, corner: Corner) -> Vertex {
    on_cube(tile.corner(corner))
}

/// The ends of an edge, counter-clockwise: its corner of the same number is where it ends.
fn ends(tile: Tile, edge: Edge) -> [Vertex; 2] {
    let number = edge as usize;
    [Corner::ALL[(number + 3) % 4], Corner::ALL[number]].map(|corner| vertex(tile, corner))
}

fn all_tiles(level: u8) -> impl Iterator<Item = Tile> {
    let count = 1_u32 << level;
    Face::ALL
        .into_iter()
        .flat_map(move |face| (0..count * count).map(move |n| Tile::new(face, level, n % count, n / count).unwrap()))
}

fn check_edges(tile: Tile) {
    for edge in Edge::ALL {
        let beyond = tile.neighbour(edge);
        assert_ne!(beyond.tile, tile);
        assert_eq!(beyond.tile.level(), tile.level());
        // Counter-clockwise on one side is clockwise on the other.
        let [begin, end] = ends(beyond.tile, beyond.edge);
        assert_eq!(ends(tile, edge), [end, begin], "{tile:?} {edge:?} {beyond:?}");
        let back = beyond.tile.neighbour(beyond.edge);
        assert_eq!((back.tile, back.edge), (tile, edge));
        assert_eq!((beyond.turns + back.turns) % 4, 0);
        assert_eq!((edge as u8 + 2 + beyond.turns) % 4, beyond.edge as u8);
        if beyond.tile.face() == tile.face() {
            assert_eq!(beyond.turns, 0);
        } else {
            let faces = tile.face().neighbour(edge);
            assert_eq!((beyond.edge, beyond.turns), (faces.edge, faces.turns));
        }
        assert!(tile.neighbours(edge, tile.level()).unwrap().eq([beyond.tile]));
    }
}

#[test]
fn across_an_edge_there_is_the_same_edge() {
    for level in 0..=4 {
        all_tiles(level).for_each(check_edges);
    }
    let mut rng = Rng::with_seed(1);
    (0..100_000).for_each(|_| check_edges(sample::tile(&mut rng)));
}

/// All corners of a level: who meets there, by geometry.
fn meetings(level: u8) -> BTreeMap<Vertex, BTreeSet<(u64, u8)>> {
    let mut meetings = BTreeMap::<_, BTreeSet<_>>::new();
    for tile in all_tiles(level) {
        for corner in Corner::ALL {
            let known = meetings.entry(vertex(tile, corner)).or_default();
            assert!(known.insert((number(tile), corner as u8)));
        }
    }
    meetings
}

fn number(tile: Tile) -> u64 {
    terrella::terrain::Key::<terrella::terrain::Morton>::from(tile).bits()
}

#[test]
fn three_meet_in_the_corners_of_the_cube_and_four_elsewhere() {
    for level in 0..=4 {
        let meetings = meetings(level);
        assert_eq!(meetings.len(), (6 << (2 * level)) + 2);
        assert_eq!(meetings.values().filter(|tiles| tiles.len() == 3).count(), 8);
        for tile in all_tiles(level) {
            for corner in Corner::ALL {
                let around = tile.around(corner);
                let listed: BTreeSet<_> = around.as_slice().iter().map(|&(t, c)| (number(t), c as u8)).collect();
                assert_eq!(listed, meetings[&vertex(tile, corner)], "{tile:?} {corner:?}");
                assert_eq!(around.as_slice().len(), listed.len());
                assert_eq!(matches!(around, Around::Three(_)), listed.len() == 3);
            }
        }
    }
}

fn check_corners(tile: Tile) {
    for corner in Corner::ALL {
        let here = vertex(tile, corner);
        let around = tile.around(corner);
        let tiles = around.as_slice();
        assert_eq!(tiles[0], (tile, corner));
        for (at, &(one, its)) in tiles.iter().enumerate() {
            assert_eq!(vertex(one, its), here);
            // Counter-clockwise: the edge that begins the next tile's corner is that which ends this one's.
            let (next, next_corner) = tiles[(at + 1) % tiles.len()];
            let (edge, _) = its.edges();
            assert_eq!(one.neighbour(edge).tile, next, "{tile:?} {corner:?}");
            assert_eq!(next_corner.edges().1, one.neighbour(edge).edge);
            // Any of them tells the same cycle.
            let mut cycle = tiles.to_vec();
            cycle.rotate_left(at);
            assert_eq!(one.around(its).as_slice(), cycle);
        }
        match tile.diagonal(corner) {
            None => {
                assert!(matches!(around, Around::Three(_)));
                assert_eq!(here.map(i64::abs), [1 << 30; 3]);
            }
            Some(beyond) => {
                assert_eq!(tiles[2], (beyond.tile, beyond.corner));
                let back = beyond.tile.diagonal(beyond.corner).unwrap();
                assert_eq!((back.tile, back.corner), (tile, corner));
                assert_eq!((beyond.turns + back.turns) % 4, 0);
                assert_eq!((corner as u8 + 2 + beyond.turns) % 4, beyond.corner as u8);
                let edges = Edge::ALL.map(|edge| tile.neighbour(edge).tile);
                assert!(!edges.contains(&beyond.tile));
            }
        }
    }
}

#[test]
fn across_a_corner_there_is_the_same_corner() {
    for level in 0..=4 {
        all_tiles(level).for_each(check_corners);
    }
    let mut rng = Rng::with_seed(2);
    (0..100_000).for_each(|_| check_corners(sample::tile(&mut rng)));
}

/// Whether all of the segment b is part of the segment a; both along an axis.
fn within(a: [Vertex; 2], b: [Vertex; 2]) -> bool {
    let between = |p: Vertex| (0..3).all(|k| (minimum(a[0][k], a[1][k])..=maximum(a[0][k], a[1][k])).contains(&p[k]));
    b.into_iter().all(between)
}

#[test]
fn at_other_levels_too() {
    for (level, other) in [(0, 2), (1, 3), (2, 3), (3, 3), (3, 2), (3, 1), (2, 0), (3, 0)] {
        for tile in all_tiles(level) {
            for edge in Edge::ALL {
                let line = ends(tile, edge);
                let beyond = tile.neighbours(edge, other).unwrap();
                let expected: BTreeSet<_> = all_tiles(other)
                    .filter(|&t| !t.contains(tile) && !tile.contains(t))
                    .filter(|&t| {
                        Edge::ALL.into_iter().any(|e| {
                            let its = ends(t, e);
                            within(line, its) || within(its, line)
                        })
                    })
                    .map(number)
                    .collect();
                assert_eq!(beyond.len(), expected.len());
                let listed: Vec<_> = beyond.collect();
                assert_eq!(listed.iter().copied().map(number).collect::<BTreeSet<_>>(), expected);
                if other < level {
                    continue;
                }
                // From low to high x or y, without a gap; counter-clockwise that is along two of the edges.
                let along = matches!(edge, Edge::Right | Edge::Down);
                let [mut from, to] = if along { line } else { [line[1], line[0]] };
                for t in listed {
                    let [begin, end] = ends(t, beyond.edge());
                    let (first, last) = if along { (end, begin) } else { (begin, end) };
                    assert_eq!(first, from, "{tile:?} {edge:?}");
                    from = last;
                }
                assert_eq!(from, to, "{tile:?} {edge:?}");
            }
        }
    }
}

#[test]
fn across_corners_at_other_levels_too() {
    for (level, other) in [(0, 2), (1, 3), (2, 3), (3, 3), (3, 2), (3, 1), (2, 0), (3, 0)] {
        for tile in all_tiles(level) {
            for corner in Corner::ALL {
                let here = vertex(tile, corner);
                let touches = |t: Tile| Corner::ALL.into_iter().find(|&c| vertex(t, c) == here);
                let meets = |t: Tile| {
                    Edge::ALL.into_iter().any(|e| {
                        let (own, its) = (Edge::ALL.map(|edge| ends(tile, edge)), ends(t, e));
                        own.into_iter().any(|line| within(line, its) || within(its, line))
                    })
                };
                let expected: Vec<_> = all_tiles(other)
                    .filter(|&t| !t.contains(tile) && !tile.contains(t))
                    .filter_map(|t| Some((t, touches(t)?)))
                    .filter(|&(t, _)| !meets(t))
                    .collect();
                let found = tile.diagonal_at(corner, other).unwrap();
                let found: Vec<_> = found.into_iter().map(|beyond| (beyond.tile, beyond.corner)).collect();
                assert_eq!(found, expected, "{tile:?} {corner:?} {other}");
            }
        }
    }
    let tile = Tile::new(Face::Right, 5, 3, 31).unwrap();
    let finest = tile.diagonal_at(Corner::UpRight, Tile::MAX_LEVEL).unwrap().unwrap();
    assert_eq!(vertex(finest.tile, finest.corner), vertex(tile, Corner::UpRight));
    for level in 31..=u8::MAX {
        assert_eq!(tile.diagonal_at(Corner::UpRight, level), Err(InvalidTile::Level(level)));
    }
}

#[test]
fn at_the_finest_level_too() {
    let tile = Tile::new(Face::Right, 5, 3, 31).unwrap();
    let beyond = tile.neighbours(Edge::Up, Tile::MAX_LEVEL).unwrap();
    assert_eq!(beyond.len(), 1 << 25);
    let all = beyond.enumerate().step_by(99_991);
    for (n, t) in all {
        let i = (1_u32 << 30) - 1;
        // Beyond the top of the right face is the right edge of the top one, counted the same way.
        assert_eq!(t, Tile::new(Face::Top, 30, i, (3 << 25) + n as u32).unwrap());
    }
    for level in 31..=u8::MAX {
        assert_eq!(tile.neighbours(Edge::Up, level), Err(InvalidTile::Level(level)));
    }
}

/// On the sphere: the shared edge is the same line from both tiles, in every projection.
#[test]
fn shared_edges_coincide_on_the_sphere() {
    let mut rng = Rng::with_seed(3);
    for &projection in Projection::ALL {
        // COBE's published pair does not close; see its documentation.
        let tolerance = if projection == Projection::Cobe { 1e-3 } else { 1e-15 };
        for _ in 0..5_000 {
            let tile = sample::tile(&mut rng);
            let edge = Edge::ALL[rng.usize(0..4)];
            let beyond = tile.neighbour(edge);
            if beyond.tile.face() != tile.face() && !projection.faces().agree(tile.face(), edge) {
                continue;
            }
            let count = 63;
            let m = rng.u32(0..=count);
            let node = |edge: Edge, m: u32| match edge {
                Edge::Right => [count, m],
                Edge::Up => [m, count],
                Edge::Left => [0, m],
                Edge::Down => [m, 0],
            };
            let vertical = |edge: Edge| matches!(edge, Edge::Right | Edge::Left);
            // Turning reverses the order along some edges.
            let reversed = match (vertical(edge), beyond.turns) {
                (true, 1 | 2) | (false, 2 | 3) => count - m,
                _ => m,
            };
            let here = tile.node::<f64>(node(edge, m), count);
            let there = beyond.tile.node::<f64>(node(beyond.edge, reversed), count);
            // The same bits on the cube, and on the sphere within rounding.
            assert_eq!(
                here.face().to_earth([here.x(), here.y(), 1.0]),
                there.face().to_earth([there.x(), there.y(), 1.0])
            );
            let [a, b] = [here, there].map(|p| projection.unproject(p).to_array());
            let distance = (0..3).map(|k| (a[k] - b[k]).powi(2)).sum::<f64>().sqrt();
            assert!(distance <= tolerance, "{projection} {tile:?} {edge:?}: {distance}");
        }
    }
}
