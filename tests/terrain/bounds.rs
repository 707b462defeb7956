//! Boxes and spheres: that they contain what they should, how much more they contain, and what their proof takes from the projections.

use fastrand::Rng;
use proptest::prelude::*;
use rayon::prelude::*;
use terrella::cube::{CubeMap, CubeProjection, Face, FacePoint, Projection};
use terrella::terrain::{Enclosure, Heights, InvalidHeights, OrientedBox, Tile};
use terrella::{Ellipsoid, Geodetic, Real, Shift};

use crate::sample::{self, Scalar};

/// A point of the terrain, in metres.
fn ground<P: CubeProjection>(map: &CubeMap<f64, P>, point: FacePoint<f64>, height: f64) -> [f64; 3] {
    let position = Geodetic::new(map.unproject(point), height).unwrap();
    map.shifted().ellipsoid().to_ecef(position).to_array()
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    (0..3).map(|k| a[k] * b[k]).sum()
}

/// The coordinates of a point along a box's axes, in units of its extent.
fn inside<T: Scalar>(bounds: &OrientedBox<T>, point: [f64; 3]) -> [f64; 3] {
    let centre = bounds.centre().to_array().map(Into::into);
    let apart: [f64; 3] = std::array::from_fn(|k| point[k] - centre[k]);
    std::array::from_fn(|k| dot(apart, bounds.axes()[k].map(Into::into)) / bounds.half()[k].into())
}

/// The largest part of a box's extent that any of the tile's points uses, along each axis.
fn used<T: Scalar>(
    map: &CubeMap<f64, Projection>,
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
            let node = tile.node([m, n], grid);
            for height in heights {
                let point = ground(map, node, height);
                for (most, used) in most.iter_mut().zip(inside(bounds, point)) {
                    *most = most.max(used.abs());
                }
                let apart: [f64; 3] = std::array::from_fn(|k| point[k] - centre[k]);
                assert!(dot(apart, apart).sqrt() <= radius, "{tile:?} {heights:?}");
            }
        }
    }
    most
}

fn every_map(check: impl Fn(CubeMap<f64, Projection>) + Sync) {
    let shapes = [
        Ellipsoid::wgs84(),
        Ellipsoid::moon(),
        Ellipsoid::mars(),
        Ellipsoid::new(6.4e6, 0.1).unwrap(),
        Ellipsoid::new(6.4e6, -1.0 / 9.0).unwrap(),
        Ellipsoid::new(1.0, 0.5).unwrap(),
        Ellipsoid::new(1.0, -1.0).unwrap(),
    ];
    Projection::ALL.par_iter().for_each(|&projection| {
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

fn contains<T: Scalar>(map: CubeMap<f64, Projection>, tile: Tile, low: f64, high: f64) {
    let ellipsoid = map.shifted().ellipsoid();
    let same = Ellipsoid::new(T::of(ellipsoid.a()), T::of(ellipsoid.f())).unwrap();
    let enclosure = Enclosure::new(CubeMap::new(same, map.shifted().shift(), map.projection()).unwrap());
    let bounds = enclosure.of(tile, Heights::new(T::of(low), T::of(high)).unwrap());
    let used = used(&map, &bounds, tile, [low, high], 8);
    assert!(
        used.into_iter().all(|u| u <= 1.0),
        "{} {:?} {ellipsoid:?} {tile:?} {low} {high}: {used:?}",
        map.projection(),
        map.shifted().shift()
    );
}

#[test]
fn tiles_are_in_their_boxes() {
    every_map(|map| {
        let radius = map.shifted().ellipsoid().a();
        let mut rng = Rng::with_seed(1);
        for face in [Face::Front, Face::Left, Face::Top, Face::Bottom] {
            for level in 0..=2 {
                for n in 0..1 << (2 * level) {
                    let tile = Tile::new(face, level, n % (1 << level), n >> level).unwrap();
                    contains::<f64>(map, tile, 0.0, 0.0);
                }
            }
        }
        for _ in 0..60 {
            let tile = sample::tile(&mut rng);
            let height = |rng: &mut Rng| radius * 10_f64.powf(-8.0 * rng.f64()) * (2.0 * rng.f64() - 0.8);
            let (a, b) = (height(&mut rng), height(&mut rng));
            contains::<f64>(map, tile, a.min(b), a.max(b));
            contains::<f32>(map, tile, f64::from(a.min(b) as f32), f64::from(a.max(b) as f32));
        }
    });
}

/// How many times as large as need be the boxes are, along each axis and for the worst tile of each level, on the Earth.
fn waste(projection: Projection, shift: Shift, level: u8) -> [f64; 3] {
    let map = CubeMap::new(Ellipsoid::wgs84(), shift, projection).unwrap();
    let enclosure = Enclosure::new(map);
    let mut rng = Rng::with_seed(2);
    let mut worst = [0.0_f64; 3];
    for _ in 0..200 {
        let tile = sample::tile_of(&mut rng, level);
        let bounds = enclosure.of(tile, Heights::default());
        let used = used(&map, &bounds, tile, [0.0; 2], 16);
        for (worst, used) in worst.iter_mut().zip(used) {
            *worst = worst.max(1.0 / used);
        }
    }
    worst
}

/// The third axis is left to itself: it is thin.
#[test]
fn boxes_are_not_much_larger_than_their_tiles() {
    // Projections that bulge more, or are more askew, than most.
    for &projection in Projection::ALL {
        for shift in [Shift::Geodetic, Shift::Geocentric, Shift::Authalic] {
            for (level, most) in [(0, 1.45), (1, 1.3), (2, 1.2), (4, 1.12), (8, 1.1), (16, 1.1)] {
                let [across, up, _] = waste(projection, shift, level);
                assert!(across.max(up) <= most, "{projection} {shift} {level}: {across} {up}");
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

/// The gnomonic coordinate u, or v with x and y exchanged.
fn gnomonic<T: Real>(projection: Projection, face: Face, [x, y]: [T; 2], exchanged: bool) -> T {
    let [right, up, outward] = projection.inverse(face, if exchanged { [y, x] } else { [x, y] });
    if exchanged { up / outward } else { right / outward }
}

/// What the proof takes from a projection: u rises with x, and along a line of x, between two lines of y of a level, it is at most 1.25·l²/8
/// beyond its values at the ends. The largest number in place of 1.25 that was found.
fn bulge(projection: Projection, face: Face, x: f64, [low, high]: [f64; 2], next: f64, parts: u32) -> f64 {
    let mut most = 0.0_f64;
    for exchanged in [false, true] {
        let u = |x: f64, y: f64| gnomonic(projection, face, [x, y], exchanged);
        let ends = [u(x, low), u(x, high)];
        let (least, largest) = (ends[0].min(ends[1]), ends[0].max(ends[1]));
        for part in 0..=parts {
            let y = low + (high - low) * f64::from(part) / f64::from(parts);
            let here = u(x, y);
            assert!(u(next, y) >= here - 1e-15, "{projection} {face:?} {x} {next} {y}");
            // Rounding is provided for.
            let beyond = (here - largest).max(least - here) - 8.0 * f64::EPSILON;
            most = most.max(8.0 * beyond / ((high - low) * (high - low)));
        }
    }
    most
}

#[test]
fn every_projection_bulges_less_than_the_proof_allows() {
    Projection::ALL.par_iter().for_each(|&projection| {
        for face in [Face::Front, Face::Top] {
            let mut most = 0.0_f64;
            for level in 1..=6 {
                let count = 1_i32 << level;
                let line = |n: i32| f64::from(n) / f64::from(count) * 2.0 - 1.0;
                for i in 0..=count {
                    for j in 0..count {
                        let next = line((i + 1).min(count));
                        most = most.max(bulge(projection, face, line(i), [line(j), line(j + 1)], next, 16));
                    }
                }
            }
            let mut rng = Rng::with_seed(3);
            for _ in 0..20_000 {
                // Next to a corner more often than not, where some are singular.
                let level = rng.u8(7..=Tile::MAX_LEVEL);
                let count = 1_i64 << level;
                let index = |rng: &mut Rng| {
                    let from_corner = (count as f64).powf(rng.f64()) as i64;
                    from_corner.clamp(1, count)
                };
                let line = |n: i64| 1.0 - n as f64 / count as f64 * 2.0;
                let (i, j) = (index(&mut rng), index(&mut rng));
                most = most.max(bulge(projection, face, line(i), [line(j), line(j - 1)], line(i - 1), 8));
            }
            let known = match projection {
                Projection::Cobe | Projection::CobeExact => 0.09,
                Projection::Square => 0.5,
                Projection::Vertex => 1.03,
                _ => 0.0,
            };
            assert!(most <= known, "{projection} {face:?}: {most}");
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
    assert_eq!(said, "heights from 2.0 to 1.0 metres are no range");
}

#[test]
fn a_box_is_what_its_parts_say() {
    let map = CubeMap::new(Ellipsoid::<f64>::mars(), Shift::Authalic, Projection::Balanced).unwrap();
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
            assert!(place.iter().all(|p| (p.abs() - 1.0).abs() < 1e-8), "{place:?}");
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

proptest! {
    /// Whatever the tile, the heights and the ellipsoid, the box has numbers in it.
    #[test]
    fn boxes_are_finite(seed: u64, low in -1e9_f64..1e9, more in 0.0_f64..1e9, flattening in -1.0_f64..0.5) {
        let mut rng = Rng::with_seed(seed);
        let projection = Projection::ALL[rng.usize(..Projection::ALL.len())];
        let map = CubeMap::new(Ellipsoid::new(6.4e6, flattening).unwrap(), Shift::Parametric, projection).unwrap();
        let tile = sample::tile(&mut rng);
        let bounds = Enclosure::new(map).of(tile, Heights::new(low, low + more).unwrap());
        prop_assert!(bounds.half().into_iter().all(|h| h.is_finite() && h > 0.0));
        prop_assert!(bounds.sphere().radius.is_finite());
        let middle = ground(&map, tile.centre(), low + 0.5 * more);
        prop_assert!(inside(&bounds, middle).into_iter().all(|u| u.abs() <= 1.0));
    }
}
