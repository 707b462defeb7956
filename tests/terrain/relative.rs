//! Series and split numbers: the ground and points from a camera in single precision.

use fastrand::Rng;
use terrella::cube::{CubeMap, CubeProjection, Face, Projection};
use terrella::terrain::{Base, Heights, Patches, Split, Tile};
use terrella::{Ecef, Ellipsoid, Real, Shift};
use testkit::{maximum, parallel};

use crate::patch::map;
use crate::vector::{length, minus};

/// The ground of a height by latitude and longitude.
fn ground(patches: &Patches<Projection>, tile: Tile, node: [u32; 2], count: u32, height: f64) -> [f64; 3] {
    let place = patches.map().unproject(tile.node(node, count));
    let position = terrella::Geodetic::new(place, height).unwrap();
    patches.map().shifted().ellipsoid().to_ecef(position).to_array()
}

/// The error of a tile's series without a camera, and the length of its way.
fn error(rng: &mut Rng, patches: &Patches<Projection>, tile: Tile, height: f64) -> [f64; 2] {
    let series = patches
        .series(tile, Base::from(Heights::new(height, height).unwrap()))
        .unwrap();
    let node = match rng.u8(0..3) {
        0 => [16 * rng.u32(0..=1), rng.u32(0..=16)],
        1 => [rng.u32(0..=16), 16 * rng.u32(0..=1)],
        _ => [rng.u32(0..=16), rng.u32(0..=16)],
    };
    let place = node.map(|index| index as f32 / 8.0 - 1.0);
    let way = minus(ground(patches, tile, node, 16, height), series.anchor().to_array());
    let apart = minus(series.offset(place).map(f64::from), way);
    [length(apart), length(way)]
}

#[test]
fn series_are_within_their_truncation() {
    parallel::for_each(Projection::ALL, |&projection| {
        for (ellipsoid, shift) in [
            (Ellipsoid::WGS84, Shift::Authalic),
            (Ellipsoid::MARS, Shift::Geocentric),
            (Ellipsoid::new(6.4e6, 0.1).unwrap(), Shift::Parametric),
        ] {
            let patches = map(ellipsoid, shift, projection);
            let mut rng = Rng::with_seed(1);
            for level in 0..=22 {
                let bound = patches.truncation(level);
                let mut most = 0.0_f64;
                for _ in 0..400 {
                    let tile = crate::sample::tile_of(&mut rng, level);
                    let height = [0.0, -11_000.0, 30_000.0][rng.usize(0..3)];
                    let [error, way] = error(&mut rng, &patches, tile, height);
                    let curvature = ellipsoid.b() * ellipsoid.b() / ellipsoid.a();
                    let allowed = bound * (1.0 + height.abs() / curvature) + 3e-7 * way;
                    assert!(error <= allowed, "{projection} {shift} {tile:?}: {error} > {allowed}");
                    most = maximum(most, error / allowed);
                }
                assert!(most > 0.02, "{projection} {shift} {level}: only {most} of the bound");
            }
        }
    });
}

/// The tip of a cone in the middle of each face.
#[derive(Clone, Copy)]
struct Cone;

impl CubeProjection for Cone {
    fn forward<T: Real>(&self, _: Face, [right, up, outward]: [T; 3]) -> [T; 2] {
        let away = (right * right + up * up).sqrt();
        [right / (outward - away), up / (outward - away)]
    }
    fn inverse<T: Real>(&self, _: Face, [x, y]: [T; 2]) -> [T; 3] {
        let outward = T::ONE + (x * x + y * y).sqrt();
        let length = (x * x + y * y + outward * outward).sqrt();
        [x / length, y / length, outward / length]
    }
}

#[test]
fn a_singular_middle_is_refused() {
    let patches = Patches::new(CubeMap::new(Ellipsoid::WGS84, Shift::Authalic, Cone).unwrap());
    let tile = Tile::root(Face::Front);
    assert_eq!(patches.series(tile, Base::default()).unwrap_err().0, tile.centre());
    assert!(
        patches
            .series(Tile::new(Face::Front, 1, 0, 0).unwrap(), Base::default())
            .is_ok()
    );
    assert_eq!(patches.truncation(0), f64::INFINITY);
}

#[test]
fn series_and_patch_meet() {
    let mut rng = Rng::with_seed(2);
    for projection in [
        Projection::Balanced,
        Projection::Adjusted,
        Projection::Square,
        Projection::Outerra,
    ] {
        let patches = map(Ellipsoid::WGS84, Shift::Authalic, projection);
        for _ in 0..2000 {
            let level = rng.u8(12..=16);
            let tile = crate::sample::tile_of(&mut rng, level);
            let patch = patches.of(tile, Base::default());
            let [eye, ..] = patch.corners();
            let series = patches.series(tile, Base::default()).unwrap();
            let (origin, seen) = (series.origin(eye), patch.seen_from(eye).corners());
            for (place, corner) in [[1.0, 1.0], [-1.0, 1.0], [-1.0, -1.0], [1.0, -1.0]]
                .into_iter()
                .zip(seen)
            {
                let offset = series.offset(place);
                let apart = std::array::from_fn(|k| f64::from(origin[k] + offset[k]) - f64::from(corner[k]));
                assert!(length(apart) < 2e-3, "{projection} {tile:?}: {apart:?}");
            }
        }
    }
}

#[test]
#[ignore = "a table to look at: cargo test --release --test terrain -- --ignored --nocapture truncations"]
fn truncations() {
    for &projection in Projection::ALL {
        let map = CubeMap::new(Ellipsoid::WGS84, Shift::Authalic, projection).unwrap();
        let row = [4, 6, 8, 10, 12, 14].map(|level| format!("{:.1e}", Patches::new(map).truncation(level)));
        println!("{:18} {}", projection.name(), row.join(" "));
    }
}

fn coordinate(rng: &mut Rng) -> f64 {
    let magnitude = 10_f64.powf(-3.0 + 11.0 * rng.f64()) * (0.5 + rng.f64());
    if rng.bool() { magnitude } else { -magnitude }
}

#[test]
fn split_numbers_are_within_their_bounds() {
    let mut rng = Rng::with_seed(3);
    let mut most = [0.0_f64; 2];
    for round in 0..1_000_000 {
        let point: [f64; 3] = std::array::from_fn(|_| coordinate(&mut rng));
        let eye: [f64; 3] = if round % 2 == 0 {
            std::array::from_fn(|_| coordinate(&mut rng))
        } else {
            point.map(|v| v + coordinate(&mut rng) * 1e-5)
        };
        let split = |[x, y, z]: [f64; 3]| Split::new(Ecef::new(x, y, z).unwrap());
        let (high, low) = (split(point).high(), split(point).low());
        let seen = split(point).seen_from(split(eye));
        for k in 0..3 {
            assert_eq!(high[k], point[k] as f32);
            let error = (point[k] - f64::from(high[k]) - f64::from(low[k])).abs();
            let bound = 2_f64.powi(-49) * point[k].abs();
            most[0] = maximum(most[0], error / bound);
            let truth = point[k] - eye[k];
            let error = (f64::from(seen[k]) - truth).abs();
            let bound = 2_f64.powi(-23) * truth.abs() + 2_f64.powi(-45) * maximum(point[k].abs(), eye[k].abs());
            most[1] = maximum(most[1], error / bound);
        }
    }
    println!("largest of the bounds: {most:.2?}");
    assert!(most.iter().all(|&used| used <= 1.0 && used > 0.3), "{most:?}");
}
