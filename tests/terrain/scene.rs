use terrella::cube::{CubeMap, Projection};
use terrella::scene::Scene;
use terrella::terrain::{Heights, Patches, Tile};
use terrella::{Ellipsoid, Shift};
use testkit::minimum;

/// The bound at a level, from the smallest tolerance that it keeps.
fn bound(scene: Scene, projection: Projection, level: u8) -> [f64; 2] {
    let keeps = |tolerance: f64, which: usize| {
        let tiles = scene.within(tolerance).tiles(projection).unwrap();
        [tiles.plain, tiles.series][which].is_some_and(|coarsest| coarsest <= level)
    };
    [0, 1].map(|which| {
        let (mut low, mut high) = (1e-12_f64, 1e9_f64);
        while high / low > 1.0001 {
            let middle = (low * high).sqrt();
            if keeps(middle, which) {
                high = middle;
            } else {
                low = middle;
            }
        }
        high
    })
}

/// What the maps themselves say: never more, and on the worst of the ellipsoids not much less.
#[test]
fn levels_hold_for_every_projection_shift_and_ellipsoid() {
    let heights = Heights::new(-11_000.0, 9_000.0).unwrap();
    for &projection in Projection::ALL {
        let mut tightest = [[f64::INFINITY; 8]; 2];
        for (f, shift) in [
            (0.0, Shift::Geodetic),
            (0.01, Shift::Geodetic),
            (0.01, Shift::Authalic),
            (0.01, Shift::Geocentric),
        ] {
            let ellipsoid = Ellipsoid::new(6.4e6, f).unwrap();
            let patches = Patches::new(CubeMap::new(ellipsoid, shift, projection).unwrap());
            let scene = Scene::new(ellipsoid).heights(heights.low(), heights.high());
            for (n, level) in [0, 1, 2, 3, 5, 8, 12, 16].into_iter().enumerate() {
                let flatness = patches.flatness(level);
                let most = [
                    flatness.displacement + 11_000.0 * flatness.turning,
                    patches.truncation(level),
                ];
                let bounds = bound(scene, projection, level);
                for k in 0..2 {
                    assert!(
                        most[k] <= bounds[k],
                        "{projection} {f} {shift} level {level}: {most:?} of {bounds:?}"
                    );
                    tightest[k][n] = minimum(tightest[k][n], bounds[k] / most[k]);
                }
            }
        }
        // Where the law has set in.
        println!("{projection}: plain {:.3?} series {:.3?}", tightest[0], tightest[1]);
        assert!(
            tightest[0][6] < 1.1 && tightest[1][6] < 1.1,
            "{projection}: {tightest:?}"
        );
    }
}

#[test]
fn the_finest_level_is_the_last_resort() {
    let earth = Scene::new(Ellipsoid::WGS84);
    let tiles = earth.within(0.0).tiles(Projection::Adjusted).unwrap();
    assert_eq!((tiles.plain, tiles.series), (None, None));
    let tiles = earth.within(1e9).tiles(Projection::Adjusted).unwrap();
    assert_eq!((tiles.plain, tiles.series), (Some(0), Some(0)));
    assert!(earth.within(0.01).tiles(Projection::Healpix).unwrap().plain.unwrap() <= Tile::MAX_LEVEL);
}
