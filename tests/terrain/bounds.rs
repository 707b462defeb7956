//! Bounding boxes and spheres: that they contain their tiles, how much larger they are, and the property of
//! projections that their proof relies on.

use std::fmt::Debug;

use fastrand::Rng;
use terrella::cube::{CubeMap, CubeProjection, Face, Projection, Stretched};
use terrella::terrain::{Enclosure, Heights, InvalidHeights, OrientedBox, Tile};
use terrella::{Ellipsoid, Geodetic, LatLon, Shift};
use testkit::{maximum, minimum, parallel};

use crate::sample::{self, Scalar};
use crate::vector::{cross, dot, length, minus, plus, unit};

/// A point of the terrain, in metres.
fn ground(ellipsoid: Ellipsoid<f64>, place: LatLon<f64>, height: f64) -> [f64; 3] {
    ellipsoid.to_ecef(Geodetic::new(place, height).unwrap()).to_array()
}

/// The coordinates of a point along a box's axes, in units of its extent.
fn inside<T: Scalar>(bounds: &OrientedBox<T>, point: [f64; 3]) -> [f64; 3] {
    let centre = bounds.centre().to_array().map(Into::into);
    let apart = minus(point, centre);
    std::array::from_fn(|k| dot(apart, bounds.axes()[k].map(Into::into)) / bounds.half()[k].into())
}

/// The largest part of a box's extent that any of the tile's points uses, along each axis.
fn used<T: Scalar, P: CubeProjection>(
    map: &CubeMap<f64, P>,
    bounds: &OrientedBox<T>,
    tile: Tile,
    heights: [f64; 2],
    grid: u32,
) -> [f64; 3] {
    let sphere = bounds.sphere();
    let centre: [f64; 3] = sphere.centre.to_array().map(Into::into);
    let radius: f64 = sphere.radius.into();
    let mut most = [0.0_f64; 3];
    for n in 0..=grid {
        for m in 0..=grid {
            let place = map.unproject(tile.node([m, n], grid));
            for height in heights {
                let point = ground(map.shifted().ellipsoid(), place, height);
                for (most, used) in most.iter_mut().zip(inside(bounds, point)) {
                    *most = maximum(*most, used.abs());
                }
                assert!(length(minus(point, centre)) <= radius, "{tile:?} {heights:?}");
            }
        }
    }
    most
}

fn every_map(check: impl Fn(CubeMap<f64, Projection>) + Sync) {
    let shapes = [
        Ellipsoid::WGS84,
        Ellipsoid::MOON,
        Ellipsoid::MARS,
        Ellipsoid::new(6.4e6, 0.1).unwrap(),
        Ellipsoid::new(6.4e6, -1.0 / 9.0).unwrap(),
        Ellipsoid::new(1.0, 0.5).unwrap(),
        Ellipsoid::new(1.0, -1.0).unwrap(),
    ];
    parallel::for_each(Projection::ALL, |&projection| {
        for &shift in Shift::ALL {
            for ellipsoid in shapes {
                // The series end at a tenth.
                if let Ok(map) = CubeMap::new(ellipsoid, shift, projection) {
                    check(map);
                }
            }
        }
    });
}

pub fn contains<T: Scalar, P: CubeProjection + Debug>(map: CubeMap<f64, P>, tile: Tile, low: f64, high: f64) {
    let ellipsoid = map.shifted().ellipsoid();
    let same = Ellipsoid::new(T::of(ellipsoid.a()), T::of(ellipsoid.f())).unwrap();
    let enclosure = Enclosure::new(CubeMap::new(same, map.shifted().shift(), map.projection()).unwrap());
    let bounds = enclosure.of(tile, Heights::new(T::of(low), T::of(high)).unwrap());
    let used = used(&map, &bounds, tile, [low, high], 8);
    assert!(
        used.into_iter().all(|u| u <= 1.0),
        "{:?} {:?} {ellipsoid:?} {tile:?} {low} {high}: {used:?}",
        map.projection(),
        map.shifted().shift()
    );
}

#[test]
fn tiles_are_in_their_boxes() {
    every_map(|map| {
        let radius = map.shifted().ellipsoid().a();
        let mut rng = Rng::with_seed(1);
        for face in [Face::Left, Face::Top] {
            for level in 0..=2 {
                for n in 0..1 << (2 * level) {
                    let tile = Tile::new(face, level, n % (1 << level), n >> level).unwrap();
                    contains::<f64, _>(map, tile, 0.0, 0.0);
                }
            }
        }
        for _ in 0..40 {
            let tile = sample::tile(&mut rng);
            let height = |rng: &mut Rng| radius * 10_f64.powf(-8.0 * rng.f64()) * (2.0 * rng.f64() - 0.8);
            let (a, b) = (height(&mut rng), height(&mut rng));
            contains::<f64, _>(map, tile, minimum(a, b), maximum(a, b));
            contains::<f32, _>(
                map,
                tile,
                f64::from(minimum(a, b) as f32),
                f64::from(maximum(a, b) as f32),
            );
        }
    });
}

/// How many times as large as need be the boxes are, along each axis and for the worst tile of each level, on the Earth.
fn waste(projection: Projection, shift: Shift, level: u8) -> [f64; 3] {
    let map = CubeMap::new(Ellipsoid::WGS84, shift, projection).unwrap();
    let enclosure = Enclosure::new(map);
    let mut rng = Rng::with_seed(2);
    let mut worst = [0.0_f64; 3];
    for _ in 0..100 {
        let tile = sample::tile_of(&mut rng, level);
        let bounds = enclosure.of(tile, Heights::default());
        let used = used(&map, &bounds, tile, [0.0; 2], 8);
        for (worst, used) in worst.iter_mut().zip(used) {
            *worst = maximum(*worst, 1.0 / used);
        }
    }
    worst
}

/// The third axis is left to itself: it is thin.
#[test]
fn boxes_are_not_much_larger_than_their_tiles() {
    for &projection in Projection::ALL {
        for shift in [Shift::Geocentric, Shift::Authalic] {
            for level in [0, 1, 2, 4, 8, 16] {
                let most = match (projection, level) {
                    (Projection::Healpix, 0) => 1.27,
                    (Projection::Healpix, _) => 1.16,
                    _ => 1.11,
                };
                let [across, up, _] = waste(projection, shift, level);
                assert!(
                    maximum(across, up) <= most,
                    "{projection} {shift} {level}: {across} {up}"
                );
            }
        }
    }
}

#[test]
#[ignore = "a table to look at"]
fn waste_by_level() {
    for &projection in Projection::ALL {
        let row: Vec<_> = [0, 1, 2, 3, 4, 6, 8, 12, 16, 20]
            .map(|level| waste(projection, Shift::Authalic, level))
            .map(|[a, b, c]| format!("{a:5.2} {b:5.2} {c:5.2}"))
            .into();
        println!("{projection:18} {}", row.join(" | "));
    }
}

/// Whether a tile of a stretched cube is too wide for the proof, which its box does not need.
fn is_wide(projection: impl CubeProjection, tile: Tile) -> bool {
    let toward = |node| projection.unproject::<f64>(tile.node(node, 2)).to_array();
    (0..9).any(|n| dot(toward([1, 1]), toward([n % 3, n / 3])) < 0.4)
}

/// What the proof takes from a projection: how far the halves of a tile's edges are from straight, on the plane that touches in its
/// middle, beyond half of the middle's distance; over the edge's length, and over its length in x or y.
fn bend(projection: impl CubeProjection, tile: Tile) -> f64 {
    const PARTS: u32 = 32;
    let middle = projection.unproject::<f64>(tile.centre()).to_array();
    let face = tile.face();
    let toward = |axis: [f64; 3]| {
        let axis = face.to_earth(axis);
        unit(plus(axis, -dot(axis, middle), middle))
    };
    let right = toward([1.0, 0.0, 0.0]);
    let up = cross(middle, right);
    let seen = |node: [u32; 2]| {
        let vector = projection.unproject(tile.node(node, 2 * PARTS)).to_array();
        let outward = dot(middle, vector);
        [dot(right, vector) / outward, dot(up, vector) / outward]
    };
    let width = 0.5_f64.powi(i32::from(tile.level()) - 1);
    let edges = [0, 2 * PARTS]
        .into_iter()
        .flat_map(|side| [[Some(side), None], [None, Some(side)]]);
    edges
        .map(|edge| {
            let at = |way: u32| seen(edge.map(|side| side.unwrap_or(way)));
            let off = |from: [f64; 2], to: [f64; 2], place: [f64; 2]| {
                let (p, q) = (to[0] - from[0], to[1] - from[1]);
                ((place[0] - from[0]) * q - (place[1] - from[1]) * p).abs() / p.hypot(q)
            };
            let (from, between, to) = (at(0), at(PARTS), at(2 * PARTS));
            let length = (to[0] - from[0]).hypot(to[1] - from[1]);
            let most = (1..PARTS)
                .map(|way| maximum(off(from, between, at(way)), off(between, to, at(PARTS + way))))
                .fold(0.0, maximum);
            // Rounding is provided for.
            (most - 0.5 * off(from, to, between) - 8.0 * f64::EPSILON) / (length * width)
        })
        .fold(0.0, maximum)
}

/// The largest bend of any tile to level 5 and of deeper ones.
fn largest_bend(projection: impl CubeProjection, faces: &[Face]) -> f64 {
    let mut most = 0.0_f64;
    let mut include = |tile: Tile| {
        if !is_wide(projection, tile) {
            most = maximum(most, bend(projection, tile));
        }
    };
    for &face in faces {
        for level in 0..=5 {
            let count = 1_u32 << level;
            for n in 0..count * count {
                include(Tile::new(face, level, n % count, n / count).unwrap());
            }
        }
        let mut rng = Rng::with_seed(3);
        for _ in 0..6_000 {
            // Next to a corner or the centre more often than not, and on a diagonal, where some are singular.
            let level = rng.u8(6..=Tile::MAX_LEVEL);
            let count = 1_u32 << level;
            let index = |rng: &mut Rng| {
                let small = (f64::from(count / 2).powf(rng.f64()) as u32).clamp(1, count / 2);
                match rng.u8(0..4) {
                    0 => small - 1,
                    1 => count - small,
                    2 => count / 2 - small,
                    _ => count / 2 + small - 1,
                }
            };
            let i = index(&mut rng);
            let j = match rng.u8(0..4) {
                0 => i,
                1 => count - 1 - i,
                _ => index(&mut rng),
            };
            include(Tile::new(face, level, i, j).unwrap());
        }
    }
    most
}

#[test]
fn every_projection_bends_less_than_the_proof_allows() {
    parallel::for_each(Projection::ALL, |&projection| {
        let most = largest_bend(projection, &[Face::Front, Face::Top]);
        assert!(most <= 0.0045, "{projection}: {most}");
        stretched_bends(projection, 3.0, &[Face::Bottom]);
    });
}

fn stretched_bends(projection: Projection, factor: f64, faces: &[Face]) {
    let stretched = Stretched::new(projection, factor).unwrap();
    let most = largest_bend(stretched, faces) / factor;
    assert!(most <= 0.006, "{projection}, stretched by {factor}: {most}");
}

#[test]
#[ignore = "minutes: cargo test --release --test terrain -- --ignored bends_less_at_any_stretch"]
fn every_projection_bends_less_at_any_stretch() {
    parallel::for_each(Projection::ALL, |&projection| {
        for factor in [1.5, 2.0, 3.0, 4.0, 6.0, 8.0, 11.0, 16.0] {
            stretched_bends(projection, factor, &[Face::Front, Face::Top, Face::Bottom]);
        }
    });
}

#[test]
fn ranges_that_are_none_are_refused() {
    let bad = [
        (1.0, 0.0),
        (f64::NAN, 0.0),
        (0.0, f64::NAN),
        (f64::NEG_INFINITY, 0.0),
        (0.0, f64::INFINITY),
    ];
    for (low, high) in bad {
        let Err(InvalidHeights { low: l, high: h }) = Heights::new(low, high) else {
            panic!("{low} {high}");
        };
        assert_eq!((l.to_bits(), h.to_bits()), (low.to_bits(), high.to_bits()));
    }
    let said = Heights::new(2.0, 1.0).unwrap_err().to_string();
    assert_eq!(said, "expected finite heights with low ≤ high, got 2.0 and 1.0");
}

#[test]
fn a_box_is_what_its_parts_say() {
    let map = CubeMap::new(Ellipsoid::<f64>::MARS, Shift::Authalic, Projection::Balanced).unwrap();
    let enclosure = Enclosure::new(map);
    let mut rng = Rng::with_seed(4);
    for _ in 0..1000 {
        let bounds = enclosure.of(sample::tile(&mut rng), Heights::new(-100.0, 2000.0).unwrap());
        let axes = bounds.axes();
        for (k, axis) in axes.into_iter().enumerate() {
            for (l, other) in axes.into_iter().enumerate() {
                let expected = if k == l { 1.0 } else { 0.0 };
                assert!((dot(axis, other) - expected).abs() < 1e-15);
            }
        }
        let mut signs = std::collections::BTreeSet::new();
        for corner in bounds.corners() {
            let place = inside(&bounds, corner.to_array());
            for (place, half) in place.into_iter().zip(bounds.half()) {
                assert!(((place.abs() - 1.0) * half).abs() < 1e-8);
            }
            signs.insert(place.map(|p| p > 0.0));
            assert!(bounds.distance(corner) < 1e-8);
        }
        assert_eq!(signs.len(), 8);
        let [x, y, z] = bounds.centre().to_array();
        let [a, b, c] = axes[1];
        let way = bounds.half()[1] + 50.0;
        let beside = terrella::Ecef::new(x + way * a, y + way * b, z + way * c).unwrap();
        assert!((bounds.distance(beside) - 50.0).abs() < 1e-8);
        assert_eq!(bounds.distance(bounds.centre()), 0.0);
    }
}

/// Whatever the tile, the heights and the ellipsoid, the box has numbers in it.
#[test]
fn boxes_are_finite() {
    let mut rng = Rng::with_seed(5);
    for _ in 0..4000 {
        let projection = Projection::ALL[rng.usize(..Projection::ALL.len())];
        let flattening = 1.5 * rng.f64() - 1.0;
        let map = CubeMap::new(
            Ellipsoid::new(6.4e6, flattening).unwrap(),
            Shift::Parametric,
            projection,
        )
        .unwrap();
        let tile = sample::tile(&mut rng);
        let (low, more) = (1e9 * (2.0 * rng.f64() - 1.0), 1e9 * rng.f64());
        let context = || format!("{projection} {flattening} {tile:?} {low} {more}");
        let bounds = Enclosure::new(map).of(tile, Heights::new(low, low + more).unwrap());
        assert!(
            bounds.half().into_iter().all(|h| h.is_finite() && h > 0.0),
            "{}",
            context()
        );
        assert!(bounds.sphere().radius.is_finite(), "{}", context());
        let middle = ground(
            map.shifted().ellipsoid(),
            map.unproject(tile.centre()),
            low + 0.5 * more,
        );
        assert!(
            inside(&bounds, middle).into_iter().all(|u| u.abs() <= 1.0),
            "{}",
            context()
        );
    }
}
