//! Tile addresses: refusals, ancestors, and coordinates to the last digit.

use std::collections::HashSet;

use fastrand::Rng;
use terrella::cube::{Corner, Face, FacePoint};
use terrella::terrain::{InvalidPlace, InvalidTile, Tile};

use crate::sample::{self, Scalar};

#[test]
fn what_is_no_tile_is_refused() {
    for level in 0..=30_u8 {
        let count = 1_u32 << level;
        assert!(Tile::new(Face::Top, level, count - 1, count - 1).is_ok());
        for bad in [count, count + 1, u32::MAX] {
            let (i, j) = (bad, bad);
            assert_eq!(Tile::new(Face::Top, level, i, 0), Err(InvalidTile::Column { level, i }));
            assert_eq!(Tile::new(Face::Top, level, 0, j), Err(InvalidTile::Row { level, j }));
        }
    }
    let point = FacePoint::new(Face::Top, 0.5, 0.5).unwrap();
    for level in 31..=u8::MAX {
        assert_eq!(Tile::new(Face::Top, level, 0, 0), Err(InvalidTile::Level(level)));
        assert_eq!(Tile::containing(point, level), Err(InvalidTile::Level(level)));
        assert_eq!(Tile::root(Face::Top).ancestor(level), None);
    }
    let said = [
        InvalidTile::Level(31).to_string(),
        InvalidTile::Column { level: 3, i: 8 }.to_string(),
        InvalidTile::Row { level: 3, j: 9 }.to_string(),
        InvalidPlace { s: 0.5, t: -1.0 }.to_string(),
    ];
    assert_eq!(
        said,
        [
            "level 31 is not in 0 to 30",
            "column 8 is not in 0 to 2^3 - 1",
            "row 9 is not in 0 to 2^3 - 1",
            "(0.5, -1.0) is not in [0, 1]²"
        ]
    );
}

#[test]
fn children_part_the_tile() {
    let mut rng = Rng::with_seed(1);
    for _ in 0..20_000 {
        let tile = sample::tile(&mut rng);
        let Some(children) = tile.children() else {
            assert_eq!(tile.level(), Tile::MAX_LEVEL);
            continue;
        };
        assert_eq!(children.iter().collect::<HashSet<_>>().len(), 4);
        for child in children {
            assert_eq!(child.parent(), Some(tile));
            assert_eq!(child.ancestor(tile.level()), Some(tile));
            assert!(tile.contains(child) && !child.contains(tile));
            assert_eq!(Tile::new(child.face(), child.level(), child.i(), child.j()), Ok(child));
        }
        // The outer corners are the tile's, and the four meet in its centre.
        let [low, right, up, high] = children;
        for (corner, child) in [
            (Corner::DownLeft, low),
            (Corner::DownRight, right),
            (Corner::UpLeft, up),
            (Corner::UpRight, high),
        ] {
            assert_eq!(child.corner::<f64>(corner), tile.corner(corner));
            let opposite = Corner::ALL[(corner as usize + 2) % 4];
            assert_eq!(child.corner::<f64>(opposite), tile.centre());
        }
    }
}

#[test]
fn a_level_covers_the_face_once() {
    for level in 0..=4 {
        let count = 1 << level;
        let area: f64 = (0..count * count)
            .map(|n| Tile::new(Face::Left, level, n % count, n / count).unwrap())
            .map(|tile| {
                let (low, high) = (
                    tile.corner::<f64>(Corner::DownLeft),
                    tile.corner::<f64>(Corner::UpRight),
                );
                assert_eq!(Tile::containing(low, level), Ok(tile));
                (high.x() - low.x()) * (high.y() - low.y())
            })
            .sum();
        assert_eq!(area, 4.0);
    }
    assert_eq!(Tile::root(Face::Left).parent(), None);
    assert_eq!(Tile::root(Face::Left).ancestor(0), Some(Tile::root(Face::Left)));
}

#[test]
fn ancestors_are_those_that_contain() {
    let mut rng = Rng::with_seed(2);
    for _ in 0..20_000 {
        let (a, b) = (sample::tile(&mut rng), sample::tile(&mut rng));
        assert_eq!(a.contains(b), b.ancestor(a.level()) == Some(a), "{a:?} {b:?}");
        let mut up = Some(b);
        while let Some(tile) = up {
            assert!(tile.contains(b));
            assert_eq!(b.ancestor(tile.level()), Some(tile));
            up = tile.parent();
        }
    }
}

fn holds_its_points<T: Scalar>(seed: u64) {
    let mut rng = Rng::with_seed(seed);
    for _ in 0..200_000 {
        let point = sample::point::<T>(&mut rng);
        let level = rng.u8(0..=Tile::MAX_LEVEL);
        let tile = Tile::containing(point, level).unwrap();
        assert_eq!((tile.face(), tile.level()), (point.face(), level));
        // In f64 the tile's lines and these comparisons are exact.
        let (low, high) = (
            tile.corner::<f64>(Corner::DownLeft),
            tile.corner::<f64>(Corner::UpRight),
        );
        let between = |low: f64, x: T, high: f64| low <= x.into() && (x.into() < high || high == 1.0);
        assert!(between(low.x(), point.x(), high.x()), "{tile:?} {point:?}");
        assert!(between(low.y(), point.y(), high.y()), "{tile:?} {point:?}");
        let [s, t] = tile.place(point).unwrap();
        let width = 0.5_f64.powi(i32::from(level) - 1);
        for (s, x, low) in [(s, point.x(), low.x()), (t, point.y(), low.y())] {
            // Exact: a difference of neighbours, or of a small number and a line.
            let expected = (x.into() - low) / width;
            assert!((T::ZERO..=T::ONE).contains(&s), "{tile:?} {point:?}");
            assert!(
                (s.into() - expected).abs() <= T::EPSILON.into() * expected,
                "{tile:?} {point:?} {s:?} {expected}"
            );
        }
        let back = tile.point([s, t]).unwrap();
        for (a, b) in [(back.x(), point.x()), (back.y(), point.y())] {
            assert!(
                (a.into() - b.into()).abs() <= T::EPSILON.into() * 0.5,
                "{tile:?} {point:?} {back:?}"
            );
        }
        // A tile beside it does not hold it, unless it is on the line between.
        let other = sample::tile_of(&mut rng, level.min(3));
        assert_eq!(other.place(point).is_some(), holds(other, point), "{other:?} {point:?}");
    }
}

fn holds<T: Scalar>(tile: Tile, point: FacePoint<T>) -> bool {
    let (low, high) = (
        tile.corner::<f64>(Corner::DownLeft),
        tile.corner::<f64>(Corner::UpRight),
    );
    tile.face() == point.face()
        && (low.x()..=high.x()).contains(&point.x().into())
        && (low.y()..=high.y()).contains(&point.y().into())
}

#[test]
fn a_tile_holds_its_points() {
    holds_its_points::<f64>(3);
    holds_its_points::<f32>(4);
}

fn corners_are_exact<T: Scalar>(seed: u64) {
    let mut rng = Rng::with_seed(seed);
    for _ in 0..50_000 {
        let tile = sample::tile(&mut rng);
        let line = |index: u32| f64::from(index) / f64::from(1_u32 << tile.level()) * 2.0 - 1.0;
        let (left, right) = (line(tile.i()), line(tile.i() + 1));
        let (down, up) = (line(tile.j()), line(tile.j() + 1));
        let expected = [(right, up), (left, up), (left, down), (right, down)];
        for (corner, (x, y)) in tile.corners::<T>().into_iter().zip(expected) {
            assert_eq!((corner.x(), corner.y()), (T::of(x), T::of(y)), "{tile:?}");
            if tile.level() <= T::EXACT {
                assert_eq!((corner.x().into(), corner.y().into()), (x, y), "{tile:?}");
            }
        }
        let centre = tile.centre::<T>();
        assert_eq!(centre.x(), T::of((left + right) / 2.0));
        assert_eq!(centre.y(), T::of((down + up) / 2.0));
        if tile.level() <= T::EXACT {
            let [zero, one] = [T::ZERO, T::ONE];
            let places = [[one, one], [zero, one], [zero, zero], [one, zero]];
            assert_eq!(places.map(|p| tile.point(p).unwrap()), tile.corners());
            assert_eq!(tile.corners::<T>().map(|c| tile.place(c).unwrap()), places);
        }
    }
}

#[test]
fn corners_are_where_they_should() {
    corners_are_exact::<f64>(5);
    corners_are_exact::<f32>(6);
}

#[test]
fn nodes_are_the_same_from_either_tile() {
    let mut rng = Rng::with_seed(7);
    for _ in 0..50_000 {
        let level = rng.u8(1..=Tile::MAX_LEVEL);
        let count = [1, 2, 3, 63, 255, 1000, u32::MAX][rng.usize(0..7)];
        let (i, j) = (rng.u32(1..1 << level), sample::index(&mut rng, level));
        let face = sample::face(&mut rng);
        let (tile, left) = (
            Tile::new(face, level, i, j).unwrap(),
            Tile::new(face, level, i - 1, j).unwrap(),
        );
        let n = rng.u32(0..=count);
        let node = tile.node::<f64>([0, n], count);
        assert_eq!(left.node([count, n], count), node);
        assert_eq!(left.node::<f32>([count, n], count), tile.node([0, n], count));
        // Odd about the middle: what turning a face does to a coordinate.
        let mirrored = Tile::new(face, level, (1 << level) - 1 - i, (1 << level) - 1 - j).unwrap();
        let opposite = mirrored.node::<f64>([count, count - n], count);
        assert_eq!((opposite.x(), opposite.y()), (-node.x(), -node.y()));
        if count <= 1 << 22 {
            let exact = |index: u32, m: u32| {
                let across = i64::from(count) << level;
                let odd = 2 * (i64::from(index) * i64::from(count) + i64::from(m)) - across;
                odd as f64 / across as f64
            };
            assert_eq!((node.x(), node.y()), (exact(i, 0), exact(j, n)));
        }
    }
    let root = Tile::root(Face::Back);
    assert_eq!(root.node([7, 8], 4), FacePoint::new(Face::Back, 1.0, 1.0).unwrap());
    assert_eq!(root.node([0, 1], 0), FacePoint::new(Face::Back, -1.0, 1.0).unwrap());
    let last = Tile::new(Face::Back, 30, (1 << 30) - 1, 0).unwrap();
    let node = last.node::<f32>([u32::MAX; 2], u32::MAX);
    assert_eq!((node.x(), node.y()), (1.0, -1.0));
}

fn any_scalar_is_handled<T: Scalar>(bits: [u64; 2], tile: Tile) {
    let [s, t] = bits.map(T::from_raw);
    let inside = |s: T| s >= T::ZERO && s <= T::ONE;
    match tile.point([s, t]) {
        Ok(point) => {
            assert!(inside(s) && inside(t));
            assert!(FacePoint::new(point.face(), point.x(), point.y()).is_ok());
        }
        Err(InvalidPlace { .. }) => assert!(!(inside(s) && inside(t))),
    }
}

#[test]
fn places_outside_are_refused() {
    let mut rng = Rng::with_seed(9);
    for _ in 0..4000 {
        let bits = [(); 2].map(|()| rng.u64(..));
        let tile = sample::tile(&mut rng);
        any_scalar_is_handled::<f64>(bits, tile);
        any_scalar_is_handled::<f32>(bits, tile);
        let unit = bits.map(|b| (b >> 11) as f64 / (1_u64 << 53) as f64);
        any_scalar_is_handled::<f64>(unit.map(f64::to_bits), tile);
    }
}
