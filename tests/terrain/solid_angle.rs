//! Solid angles of tiles: against what they are on S2's faces in closed form, and against their sum.

use fastrand::Rng;
use terrella::cube::{Face, Projection, S2Quadratic};
use terrella::terrain::Tile;

use crate::sample;

#[test]
fn tiles_fill_the_sphere() {
    for &projection in Projection::ALL {
        for level in [0, 3] {
            let count = 1_u32 << level;
            let tiles = Face::ALL.into_iter().flat_map(|face| {
                (0..count * count).map(move |n| Tile::new(face, level, n % count, n / count).unwrap())
            });
            let sum: f64 = tiles.map(|tile| tile.solid_angle::<f64>(projection)).sum();
            let error = (sum - 4.0 * std::f64::consts::PI).abs();
            assert!(error <= 1e-13, "{projection} {level} {error:e}");
        }
    }
}

/// Google's S2, `cell_test.go`: a sixth of the sphere, within 5e-16.
#[test]
fn faces_are_sixths_of_the_sphere() {
    for face in Face::ALL {
        let error = (Tile::root(face).solid_angle::<f64>(S2Quadratic) - 2.094_395_102_393_195_5).abs();
        assert!(error <= 5e-16, "{face:?} {error:e}");
    }
}

/// Nodes and weights of Gauss and Legendre on [0, 1], five of each: exact to the ninth degree.
const GAUSS: [(f64, f64); 5] = [
    (0.046_910_077_030_668_004, 0.118_463_442_528_094_54),
    (0.230_765_344_947_158_46, 0.239_314_335_249_683_24),
    (0.5, 0.284_444_444_444_444_44),
    (0.769_234_655_052_841_5, 0.239_314_335_249_683_24),
    (0.953_089_922_969_332, 0.118_463_442_528_094_54),
];

/// The solid angle on the gnomonic plane: the integral of (1 + u² + v²)^−3/2, without a difference of large numbers.
fn integral(tile: Tile) -> f64 {
    let across = f64::from(1 << tile.level());
    let ends = |index: u32| {
        let low = 2.0 * f64::from(index) / across - 1.0;
        let [a, b] = [low.abs(), (low + 2.0 / across).abs()];
        let [near, width] = [testkit::minimum(a, b), 2.0 / across];
        (near * (2.0 + near) / 3.0, width * (2.0 + a + b) / 3.0)
    };
    let ((u, du), (v, dv)) = (ends(tile.i()), ends(tile.j()));
    let mut sum = 0.0;
    for (s, p) in GAUSS {
        for (t, q) in GAUSS {
            let (u, v) = (u + s * du, v + t * dv);
            sum += p * q * (1.0 + u * u + v * v).powf(-1.5);
        }
    }
    sum * du * dv
}

#[test]
fn solid_angles_are_those_of_s2_cells() {
    let mut rng = Rng::with_seed(1);
    for _ in 0..200_000 {
        let level = rng.u8(5..=30);
        let tile = sample::tile_of(&mut rng, level);
        let truth = integral(tile);
        let across = f64::from(1_u32 << level);
        let error = |found: f64| ((found - truth) / truth).abs() / across;
        let double = error(tile.solid_angle(S2Quadratic));
        assert!(double <= 2e-16, "{tile:?} {double:e}");
        let single = error(tile.solid_angle::<f32>(S2Quadratic).into());
        assert!(single <= 2.4e-7 || level > 25, "{tile:?} {single:e}");
    }
}
