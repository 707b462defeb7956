//! Selections that bug reports showed to be wrong.

use terrella::cube::{Balanced, CubeMap};
use terrella::terrain::{Camera, Detail, Enclosure, Heights, Selection, Tile};
use terrella::{Ecef, Ellipsoid, Enu, Geodetic, LatLon, LocalFrame, Shift};

fn enclosure(ellipsoid: Ellipsoid<f64>) -> Enclosure<f64, Balanced> {
    Enclosure::new(CubeMap::new(ellipsoid, Shift::Authalic, Balanced).unwrap())
}

/// Straight down from above 0° N 0° E, north up; both pictures' halves per unit of distance.
fn down(height: f64, half: f64, up: f64) -> Camera<f64> {
    let eye = Ecef::new(Ellipsoid::<f64>::WGS84.a() + height, 0.0, 0.0).unwrap();
    let matrix = [
        [0.0, 1.0 / half, 0.0, 0.0],
        [0.0, 0.0, up / half, 0.0],
        [0.0; 4],
        [-1.0, 0.0, 0.0, 0.0],
    ];
    Camera::new(eye, matrix, [1024.0; 2]).unwrap()
}

/// 17 600 of 40 401 visible places were in no tile.
#[test]
fn a_parallel_projection_misses_nothing() {
    let radius = 6_371_000.0;
    let enclosure = enclosure(Ellipsoid::sphere(radius).unwrap());
    let eye = Ecef::new(radius + 100.0, 0.0, 0.0).unwrap();
    let matrix = [
        [0.0, 1e-5, 0.0, 0.0],
        [0.0, 0.0, 1e-5, 0.0],
        [0.0; 4],
        [0.0, 0.0, 0.0, 1.0],
    ];
    let camera = Camera::new(eye, matrix, [1024.0; 2]).unwrap();
    let tiles: Vec<_> = Selection::new(&enclosure, camera, Detail::new(256, 1.5, 18).unwrap(), |_| {
        Heights::default()
    })
    .collect();
    let mut missed = 0;
    for n in 0..201_i32 * 201 {
        let [y, z] = [n % 201, n / 201].map(|k| 1e3 * f64::from(k - 100));
        let place = Ecef::new((radius * radius - y * y - z * z).sqrt(), y, z).unwrap();
        let map = enclosure.map();
        let point = map.project(map.shifted().ellipsoid().to_geodetic(place).lat_lon());
        let holds = |tile: &&Tile| Tile::containing(point, tile.level()) == Ok(**tile);
        missed += i32::from(tiles.iter().filter(holds).count() != 1);
    }
    assert_eq!(missed, 0);
    // Tiles of 39 km, 200 pixels: 78 km would be 400 pixels for 256 samples.
    assert_eq!(tiles.len(), 36);
}

/// 4 tiles at level 4 with y down, 144 at level 13 with y up.
#[test]
fn a_mirrored_picture_has_the_same_tiles() {
    let enclosure = enclosure(Ellipsoid::WGS84);
    let detail = Detail::new(256, 1.5, 20).unwrap().anisotropic(8.0).unwrap();
    let [up, down] = [1.0, -1.0].map(|up| {
        let camera = down(600_000.0, 0.01, up);
        Selection::new(&enclosure, camera, detail, |_| Heights::default()).collect::<Vec<_>>()
    });
    assert_eq!(up, down);
    assert_eq!(up.len(), 144);
    assert!(up.iter().all(|tile| tile.level() == 13));
}

/// From Zermatt the Matterhorn: level 11.
#[test]
fn ground_above_the_eye_is_as_fine_as_any() {
    let earth = Ellipsoid::<f64>::WGS84;
    let enclosure = enclosure(earth);
    let eye = LocalFrame::new(earth, Geodetic::new(LatLon::new(46.02, 7.75).unwrap(), 1610.0).unwrap());
    let peak = LatLon::new(45.9766, 7.6585).unwrap();
    let enu = eye.to_enu(earth.to_ecef(Geodetic::new(peak, 3489.0).unwrap()));
    let away = enu.east.hypot(enu.north);
    let (sin, cos) = (enu.east / away, enu.north / away);
    for (wide, half, expected) in [(1920.0, 0.6, 13), (3840.0, 0.3, 15)] {
        let row = |[east, north, up]: [f64; 3], scale: f64| {
            let [x, y, z] = eye.vector_from_enu(Enu { east, north, up });
            [x * scale, y * scale, z * scale, 0.0]
        };
        let high = wide * 9.0 / 16.0;
        let matrix = [
            row([cos, -sin, 0.0], 1.0 / half),
            row([0.0, 0.0, 1.0], wide / high / half),
            [0.0; 4],
            row([sin, cos, 0.0], 1.0),
        ];
        let camera = Camera::new(eye.origin_ecef(), matrix, [wide, high]).unwrap();
        let detail = Detail::new(256, 1.5, 20).unwrap().anisotropic(16.0).unwrap();
        let heights = |_: Tile| Heights::new(2500.0, 4478.0).unwrap();
        let point = enclosure.map().project(peak);
        let tiles: Vec<_> = Selection::new(&enclosure, camera, detail, heights).collect();
        let holds = |tile: &&Tile| Tile::containing(point, tile.level()) == Ok(**tile);
        let level = tiles.iter().find(holds).unwrap().level();
        assert_eq!(level, expected);
    }
}

/// 73 984 tiles and over three million, where the ground asks for 4; and the same looking ahead.
#[test]
fn one_range_of_heights_for_all_tiles_is_bearable() {
    let enclosure = enclosure(Ellipsoid::WGS84);
    let eye = down(2_000.0, 0.5, 1.0).eye();
    for (tilt, ground) in [(0.0_f64, 4), (30.0, 8), (60.0, 16), (80.0, 24), (90.0, 30)] {
        let (sin, cos) = tilt.to_radians().sin_cos();
        let matrix = [
            [0.0, 2.0, 0.0, 0.0],
            [2.0 * sin, 0.0, 2.0 * cos, 0.0],
            [0.0; 4],
            [-cos, 0.0, sin, 0.0],
        ];
        let camera = Camera::new(eye, matrix, [1024.0; 2]).unwrap();
        let detail = Detail::new(512, 1.5, 20).unwrap();
        let count = |detail: Detail<f64>, low: f64, high: f64| {
            let heights = move |_: Tile| Heights::new(low, high).unwrap();
            Selection::new(&enclosure, camera, detail, heights)
                .take(100_000)
                .count()
        };
        assert_eq!(count(detail, 0.0, 0.0), ground);
        for low in [-500.0, -11_000.0] {
            let plain = count(detail, low, 9_000.0);
            let anisotropic = count(detail.anisotropic(16.0).unwrap(), low, 9_000.0);
            assert!(
                plain <= 170 && anisotropic <= 420,
                "{tilt} {low}: {plain} {anisotropic}"
            );
        }
    }
}
