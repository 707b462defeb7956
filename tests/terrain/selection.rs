//! Selections against rays through pixels: the place that a ray meets is in exactly one of the tiles.

use fastrand::Rng;
use terrella::cube::{Balanced, CubeMap, Face, FacePoint, Projection};
use terrella::terrain::{
    Camera, Detail, Enclosure, Heights, Horizon, InvalidCamera, InvalidDetail, InvalidTile, Selection, Tile,
};
use terrella::{Ecef, Ellipsoid, Geodetic, LatLon, Shift};
use testkit::{minimum, parallel};

use crate::vector::{Vector, cross, plus, unit};

fn ecef([x, y, z]: Vector) -> Ecef<f64> {
    Ecef::new(x, y, z).unwrap()
}

/// A view as a test draws it.
#[derive(Clone, Copy, Debug)]
struct View {
    eye: Vector,
    right: Vector,
    up: Vector,
    forward: Vector,
    /// Half of the picture at a distance of 1.
    half: [f64; 2],
    pixels: [f64; 2],
}

const SCREEN: [f64; 2] = [1280.0, 1024.0];

impl View {
    fn new(eye: Vector, forward: Vector, roll: Vector, height_of_view: f64, pixels: [f64; 2]) -> Self {
        let forward = unit(forward);
        let right = unit(cross(forward, roll));
        let half = (height_of_view / 2.0).to_radians().tan();
        Self {
            eye,
            right,
            up: cross(right, forward),
            forward,
            half: [half * pixels[0] / pixels[1], half],
            pixels,
        }
    }

    /// From somewhere above the ground, 100 m to 30 000 km, to somewhere on it or past it.
    fn random(rng: &mut Rng, ellipsoid: Ellipsoid<f64>) -> Self {
        let place = somewhere(rng);
        let height = 10_f64.powf(2.0 + 5.5 * rng.f64());
        let eye = ellipsoid.to_ecef(Geodetic::new(place, height).unwrap()).to_array();
        let down = unit(eye.map(|v| -v));
        let level = unit(cross(down, unit(std::array::from_fn(|_| rng.f64() - 0.5))));
        let tilt = (100.0 * rng.f64()).to_radians();
        let forward = plus(down.map(|v| v * tilt.cos()), tilt.sin(), level);
        let roll = if rng.bool() {
            down.map(|v| -v)
        } else {
            unit(std::array::from_fn(|_| rng.f64() - 0.5))
        };
        let roll = plus(roll, 1e-3, level);
        Self::new(eye, forward, roll, 20.0 + 60.0 * rng.f64(), SCREEN)
    }

    fn camera(&self) -> Camera<f64> {
        let row = |axis: Vector, scale: f64| [axis[0] * scale, axis[1] * scale, axis[2] * scale, 0.0];
        // A depth that makes no sense, for nobody is to look at it.
        let depth = [7.0, -3.0, 0.1, 1e9];
        let matrix = [
            row(self.right, 1.0 / self.half[0]),
            row(self.up, 1.0 / self.half[1]),
            depth,
            row(self.forward, 1.0),
        ];
        Camera::new(ecef(self.eye), matrix, self.pixels).unwrap()
    }

    /// The direction of a place of the picture in [−1, 1]².
    fn ray(&self, [x, y]: [f64; 2]) -> Vector {
        unit(plus(
            plus(self.forward, x * self.half[0], self.right),
            y * self.half[1],
            self.up,
        ))
    }
}

fn somewhere(rng: &mut Rng) -> LatLon<f64> {
    let sine: f64 = 2.0 * rng.f64() - 1.0;
    LatLon::new(sine.asin().to_degrees(), 360.0 * rng.f64() - 180.0).unwrap()
}

/// Where a ray first meets the surface of a height: by steps as long as the distance.
fn first_hit(ellipsoid: Ellipsoid<f64>, eye: Vector, ray: Vector, height: f64) -> Option<LatLon<f64>> {
    let mut way = 0.0;
    for _ in 0..400 {
        let place = ellipsoid.to_geodetic(ecef(plus(eye, way, ray)));
        let distance = place.height() - height;
        if distance < 1e-4 {
            return Some(place.lat_lon());
        }
        way += distance;
        if way > 1e8 {
            return None;
        }
    }
    None // grazing
}

/// The lowest and the highest terrain of a view.
fn range(view: &View, ellipsoid: Ellipsoid<f64>) -> [f64; 2] {
    let height = ellipsoid.to_geodetic(ecef(view.eye)).height().abs();
    [-minimum(500.0, 0.1 * height), minimum(9_000.0, 0.5 * height)].map(f64::round)
}

fn terrain(view: &View, map: &CubeMap<f64, Projection>) -> Heights<f64> {
    let [low, high] = range(view, map.shifted().ellipsoid());
    Heights::new(low, high).unwrap()
}

fn selected(map: CubeMap<f64, Projection>, view: &View, detail: Detail<f64>) -> Vec<Tile> {
    let enclosure = Enclosure::new(map);
    let heights = terrain(view, &map);
    Selection::new(&enclosure, view.camera(), detail, |_| heights).collect()
}

fn holding(tiles: &[Tile], point: FacePoint<f64>) -> Vec<Tile> {
    let holds = |tile: &&Tile| Tile::containing(point, tile.level()) == Ok(**tile);
    tiles.iter().filter(holds).copied().collect()
}

/// Every pixel of random views, at the lowest, the highest and the middle height of the terrain.
fn covers_once(map: CubeMap<f64, Projection>, detail: Detail<f64>, seed: u64, views: usize) -> Vec<usize> {
    let ellipsoid = map.shifted().ellipsoid();
    let mut rng = Rng::with_seed(seed);
    let (mut counts, mut hits) = (Vec::new(), 0);
    for _ in 0..views {
        let view = View::random(&mut rng, ellipsoid);
        let tiles = selected(map, &view, detail);
        for _ in 0..100 {
            let ray = view.ray([2.0 * rng.f64() - 1.0, 2.0 * rng.f64() - 1.0]);
            let [low, high] = range(&view, ellipsoid);
            for height in [low, 0.0, high] {
                let Some(place) = first_hit(ellipsoid, view.eye, ray, height) else {
                    continue;
                };
                hits += 1;
                let found = holding(&tiles, map.project(place));
                assert_eq!(
                    found.len(),
                    1,
                    "{} {view:?} {place:?} {height}: {found:?}",
                    map.projection()
                );
            }
        }
        counts.push(tiles.len());
    }
    assert!(hits > 50 * views, "{hits}");
    counts
}

#[test]
fn every_pixel_is_covered_once() {
    // COBE's published pair does not close: what it projects to is not quite where the tile is.
    let closed = Projection::ALL
        .iter()
        .enumerate()
        .filter(|&(_, &p)| p != Projection::Cobe);
    parallel::for_each(closed, |(seed, &projection)| {
        for (ellipsoid, shift) in [
            (Ellipsoid::WGS84, Shift::Authalic),
            (Ellipsoid::MARS, Shift::Geocentric),
            (Ellipsoid::new(6.4e6, 0.1).unwrap(), Shift::Conformal),
        ] {
            let map = CubeMap::new(ellipsoid, shift, projection).unwrap();
            let detail = Detail::new(512, 1.5, 20).unwrap();
            covers_once(map, detail, seed as u64, 20);
            covers_once(map, detail.anisotropic(16.0).unwrap(), seed as u64 + 100, 4);
        }
    });
}

/// No tile is inside another.
fn is_partition(tiles: &[Tile]) -> bool {
    let mut keys: Vec<_> = tiles
        .iter()
        .map(|&tile| terrella::terrain::Key::<terrella::terrain::Morton>::from(tile).range())
        .collect();
    keys.sort_by_key(|range| *range.start());
    keys.windows(2).all(|pair| pair[0].end() < pair[1].start())
}

#[test]
fn tiles_are_as_coarse_as_they_may_be() {
    let map = CubeMap::new(Ellipsoid::WGS84, Shift::Authalic, Projection::Balanced).unwrap();
    let enclosure = Enclosure::new(map);
    let mut rng = Rng::with_seed(7);
    for _ in 0..100 {
        let view = View::random(&mut rng, map.shifted().ellipsoid());
        let camera = view.camera();
        let finest = rng.u8(0..=20);
        let detail = Detail::new(256, 1.5, finest).unwrap();
        let tiles = selected(map, &view, detail);
        assert!(is_partition(&tiles));
        let limit = 1.5 * 256.0 * 256.0;
        let heights = terrain(&view, &map);
        let horizon = Horizon::of(map.shifted().ellipsoid(), heights.low(), &camera);
        for tile in tiles {
            let bounds = enclosure.of(tile, heights);
            assert!(camera.sees(&bounds) && !horizon.hides_box(&bounds));
            assert!(tile.level() == finest || enclosure.coverage(&camera, tile, heights) <= limit);
            if let Some(parent) = tile.parent() {
                assert!(enclosure.coverage(&camera, parent, heights) > limit);
            }
        }
    }
}

/// A heights function that knows its terrain is used tile by tile.
#[test]
fn heights_are_asked_for_each_tile() {
    let map = CubeMap::new(Ellipsoid::<f64>::WGS84, Shift::Authalic, Projection::Adjusted).unwrap();
    let enclosure = Enclosure::new(map);
    let view = View::random(&mut Rng::with_seed(3), map.shifted().ellipsoid());
    let heights = terrain(&view, &map);
    let mut asked = std::collections::BTreeMap::new();
    let tiles: Vec<_> = Selection::new(&enclosure, view.camera(), Detail::new(128, 1.5, 12).unwrap(), |tile| {
        *asked
            .entry((tile.face(), tile.level(), tile.i(), tile.j()))
            .or_insert(0) += 1;
        heights
    })
    .collect();
    assert!(!tiles.is_empty());
    for (&(_, level, ..), &times) in &asked {
        // The faces are asked once more, for the lowest of all.
        assert_eq!(times, if level == 0 { 2 } else { 1 });
    }
    assert!(
        tiles
            .iter()
            .all(|t| asked.contains_key(&(t.face(), t.level(), t.i(), t.j())))
    );
}

/// The paper's Section 5: about 20 to 30 tiles of 512 × 512 samples for 1280 × 1024 pixels.
fn paper_counts(projection: Projection) -> Vec<usize> {
    let map = CubeMap::new(Ellipsoid::WGS84, Shift::Geocentric, projection).unwrap();
    let ellipsoid = map.shifted().ellipsoid();
    let enclosure = Enclosure::new(map);
    let mut rng = Rng::with_seed(11);
    let mut counts: Vec<_> = (0..400)
        .map(|_| {
            let place = somewhere(&mut rng);
            let height = 10_f64.powf(3.0 + 4.3 * rng.f64());
            let eye = ellipsoid.to_ecef(Geodetic::new(place, height).unwrap()).to_array();
            let down = unit(eye.map(|v| -v));
            let level = unit(cross(down, unit(std::array::from_fn(|_| rng.f64() - 0.5))));
            // Down to 20° below the horizontal.
            let tilt = (70.0 * rng.f64()).to_radians();
            let forward = plus(down.map(|v| v * tilt.cos()), tilt.sin(), level);
            let view = View::new(eye, forward, plus(level, 0.01, down), 50.0, SCREEN);
            // Terrain as it is in most places, and data without end.
            let heights = Heights::new(0.0, 0.01 * minimum(height, 1e5)).unwrap();
            Selection::new(&enclosure, view.camera(), Detail::new(512, 1.5, 22).unwrap(), |_| {
                heights
            })
            .count()
        })
        .collect();
    counts.sort_unstable();
    counts
}

#[test]
fn tile_counts_are_of_the_papers_kind() {
    for projection in [
        Projection::Quadrilateralized,
        Projection::Adjusted,
        Projection::Balanced,
    ] {
        let counts = paper_counts(projection);
        let (low, median, high) = (counts[40], counts[200], counts[360]);
        println!("{projection}: {low} {median} {high}, at most {}", counts[399]);
        assert!((15..=35).contains(&median), "{projection}: {low} {median} {high}");
    }
}

/// Of level ground: the area of a polygon of 512 places along the tile's edges.
#[test]
fn coverage_of_level_ground_is_its_area() {
    const PARTS: u32 = 128;
    let map = CubeMap::new(Ellipsoid::<f64>::WGS84, Shift::Authalic, Projection::Vertex).unwrap();
    let ellipsoid = map.shifted().ellipsoid();
    let enclosure = Enclosure::new(map);
    let mut rng = Rng::with_seed(5);
    let (mut before, mut infinite) = (0, 0);
    for _ in 0..1_000 {
        let view = View::random(&mut rng, ellipsoid);
        let camera = view.camera();
        let hit = first_hit(ellipsoid, view.eye, view.ray([0.0; 2]), 0.0);
        let place = hit.unwrap_or_else(|| somewhere(&mut rng));
        let tile = Tile::containing(map.project(place), rng.u8(4..18)).unwrap();
        let height = 500.0 * (rng.f64() - 0.5);
        let edge = (0..PARTS).map(|k| [k, 0]);
        let edge = edge.chain((0..PARTS).map(|k| [PARTS, k]));
        let edge = edge.chain((0..PARTS).map(|k| [PARTS - k, PARTS]));
        let edge = edge.chain((0..PARTS).map(|k| [0, PARTS - k]));
        let pixels: Option<Vec<_>> = edge
            .map(|node| {
                let place = Geodetic::new(map.unproject(tile.node(node, PARTS)), height).unwrap();
                camera.pixel(ellipsoid.to_ecef(place))
            })
            .collect();
        let level = Heights::new(height, height).unwrap();
        let area = enclosure.coverage(&camera, tile, level);
        // What turns its back is more than the outline.
        let limb = (6.4e6 * 2.0 / f64::from(1 << tile.level())).powi(2);
        match pixels {
            None => {
                infinite += u32::from(area == f64::INFINITY);
            }
            Some(pixels) => {
                let next = pixels.iter().cycle().skip(1);
                let twice: f64 = pixels.iter().zip(next).map(|(a, b)| a[0] * b[1] - a[1] * b[0]).sum();
                let expected = 0.5 * twice.abs();
                let away = enclosure.of(tile, level).distance(camera.eye());
                if away * away < 4.0 * limb || area == f64::INFINITY {
                    continue;
                }
                before += 1;
                assert!(
                    (area - expected).abs() <= 0.05 * expected + 1.0,
                    "{tile:?} {area} {expected} {away}"
                );
            }
        }
    }
    assert!(before > 300 && infinite > 10, "{before} {infinite}");
}

#[test]
fn a_box_in_the_picture_is_seen() {
    let map = CubeMap::new(Ellipsoid::<f64>::WGS84, Shift::Authalic, Projection::Vertex).unwrap();
    let enclosure = Enclosure::new(map);
    let mut rng = Rng::with_seed(6);
    let (mut seen, mut left_out) = (0, 0);
    for _ in 0..20_000 {
        let view = View::random(&mut rng, map.shifted().ellipsoid());
        let camera = view.camera();
        let level = rng.u8(0..12);
        let tile = Tile::containing(map.project(somewhere(&mut rng)), level).unwrap();
        let bounds = enclosure.of(tile, terrain(&view, &map));
        let in_picture = |p: Ecef<f64>| {
            let pixel = camera.pixel(p);
            pixel.is_some_and(|[x, y]| x.abs() <= 640.0 && y.abs() <= 512.0)
        };
        // Its corners, and places inside.
        let inside = (0..200).map(|_| {
            let axes = bounds.axes();
            (0..3).fold(bounds.centre().to_array(), |p, k| {
                plus(p, (2.0 * rng.f64() - 1.0) * bounds.half()[k], axes[k])
            })
        });
        if bounds.corners().into_iter().chain(inside.map(ecef)).any(in_picture) {
            assert!(camera.sees(&bounds));
            seen += 1;
        }
        left_out += u32::from(!camera.sees(&bounds));
    }
    assert!(seen > 1_000 && left_out > 5_000, "{seen} {left_out}");
}

/// The footprint of a pixel in texels, by differences of rays.
#[test]
fn an_anisotropic_filter_reads_from_its_level() {
    let map = CubeMap::new(Ellipsoid::<f64>::WGS84, Shift::Authalic, Projection::Adjusted).unwrap();
    let ellipsoid = map.shifted().ellipsoid();
    let mut rng = Rng::with_seed(8);
    let flat = Heights::new(0.0, 0.0).unwrap();
    let enclosure = Enclosure::new(map);
    let (mut levels, mut finer) = (Vec::new(), 0);
    for _ in 0..40 {
        let view = View::random(&mut rng, ellipsoid);
        let select = |detail| Selection::new(&enclosure, view.camera(), detail, |_| flat).collect::<Vec<_>>();
        let plain = Detail::new(256, 1.5, 24).unwrap();
        let tiles = select(plain.anisotropic(16.0).unwrap());
        finer += usize::from(tiles.len() >= select(plain).len());
        for _ in 0..60 {
            let at = [2.0 * rng.f64() - 1.0, 2.0 * rng.f64() - 1.0];
            let point = |dx: f64, dy: f64| {
                let ray = view.ray([at[0] + 2.0 * dx / SCREEN[0], at[1] + 2.0 * dy / SCREEN[1]]);
                first_hit(ellipsoid, view.eye, ray, 0.0).map(|place| map.project(place))
            };
            let (Some(here), Some(right), Some(up)) = (point(0.0, 0.0), point(0.01, 0.0), point(0.0, 0.01)) else {
                continue;
            };
            if here.face() != right.face() || here.face() != up.face() {
                continue;
            }
            let [tile] = holding(&tiles, here)[..] else { panic!() };
            let texels = 128.0 * f64::from(1 << tile.level()) / 0.01;
            let step = |p: FacePoint<f64>| [(p.x() - here.x()) * texels, (p.y() - here.y()) * texels];
            levels.push(terrella::distortion::texture::anisotropic(step(right), step(up), 16.0).level);
        }
    }
    // A tile has texels for the places where it was asked, and two times too fine at most; between them a little less.
    levels.sort_by(f64::total_cmp);
    let (worst, low, median) = (levels[0], levels[levels.len() / 50], levels[levels.len() / 2]);
    println!("{worst} {low} {median} of {}", levels.len());
    assert!(worst > -0.75 && low > -0.35 && median < 1.0, "{worst} {low} {median}");
    assert!(finer >= 30, "{finer}");
}

#[test]
fn eyes_below_the_ground_see_as_well() {
    let map = CubeMap::new(Ellipsoid::<f64>::WGS84, Shift::Authalic, Projection::Square).unwrap();
    let ellipsoid = map.shifted().ellipsoid();
    let mut rng = Rng::with_seed(9);
    for height in [-400.0, -100_000.0, -6_000_000.0] {
        let place = somewhere(&mut rng);
        let eye = ellipsoid.to_ecef(Geodetic::new(place, height).unwrap()).to_array();
        let view = View::new(eye, [0.3, 0.2, 0.9], [0.0, 1.0, 0.1], 60.0, SCREEN);
        let tiles = selected(map, &view, Detail::new(512, 1.5, 10).unwrap());
        assert!(is_partition(&tiles));
        // What is before it, straight ahead.
        let mut way = 1.0;
        while ellipsoid.to_geodetic(ecef(plus(eye, way, view.forward))).height() < 0.0 {
            way *= 1.01;
        }
        let ahead = ellipsoid.to_geodetic(ecef(plus(eye, way, view.forward)));
        assert_eq!(holding(&tiles, map.project(ahead.lat_lon())).len(), 1);
    }
}

#[test]
fn single_precision_selects_alike() {
    let wide = CubeMap::new(Ellipsoid::<f64>::WGS84, Shift::Authalic, Projection::Balanced).unwrap();
    // By its type: all projections with derivatives in single precision take a compiler long.
    let narrow = CubeMap::new(Ellipsoid::<f32>::WGS84, Shift::Authalic, Balanced).unwrap();
    let enclosure = Enclosure::new(narrow);
    let mut rng = Rng::with_seed(10);
    let (mut alike, mut all) = (0, 0);
    for _ in 0..100 {
        let view = View::random(&mut rng, wide.shifted().ellipsoid());
        let [x, y, z] = view.eye.map(|v| v as f32);
        let row = |axis: Vector, scale: f64| {
            let [a, b, c] = axis.map(|v| (v * scale) as f32);
            [a, b, c, 0.0]
        };
        let matrix = [
            row(view.right, 1.0 / view.half[0]),
            row(view.up, 1.0 / view.half[1]),
            [0.0; 4],
            row(view.forward, 1.0),
        ];
        let camera = Camera::new(Ecef::new(x, y, z).unwrap(), matrix, SCREEN.map(|v| v as f32)).unwrap();
        let [low, high] = range(&view, wide.shifted().ellipsoid()).map(|v| v as f32);
        let heights = Heights::new(low, high).unwrap();
        let tiles: Vec<_> =
            Selection::new(&enclosure, camera, Detail::new(512, 1.5, 16).unwrap(), |_| heights).collect();
        assert!(is_partition(&tiles));
        let exact = selected(wide, &view, Detail::new(512, 1.5, 16).unwrap());
        all += exact.len();
        alike += exact.iter().filter(|tile| tiles.contains(tile)).count();
    }
    assert!(alike * 100 >= all * 97, "{alike} of {all}");
}

#[test]
fn what_is_no_camera_is_refused() {
    let eye = Ecef::new(7e6, 0.0, 0.0).unwrap();
    let good = [[1.0; 4]; 4];
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        for n in 0..16 {
            let mut matrix = good;
            matrix[n / 4][n % 4] = bad;
            let Err(InvalidCamera::Matrix(entry)) = Camera::new(eye, matrix, SCREEN) else {
                panic!()
            };
            assert_eq!(entry.to_bits(), bad.to_bits());
        }
    }
    for bad in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        for pixels in [[bad, 1.0], [1.0, bad]] {
            let Err(InvalidCamera::Pixels(count)) = Camera::new(eye, good, pixels) else {
                panic!()
            };
            assert_eq!(count.to_bits(), bad.to_bits());
        }
    }
    let said = [InvalidCamera::Matrix(f64::NAN), InvalidCamera::Pixels(-1.0)].map(|e| e.to_string());
    assert_eq!(
        said,
        [
            "expected a matrix of finite numbers, got NaN",
            "expected a positive, finite size in pixels, got -1.0"
        ]
    );
}

#[test]
fn what_is_no_detail_is_refused() {
    assert_eq!(Detail::new(0, 1.5, 20), Err(InvalidDetail::Samples));
    assert_eq!(
        Detail::new(1, 1.5, 31),
        Err(InvalidDetail::Level(InvalidTile::Level(31)))
    );
    for bad in [0.0, -1.0, f64::INFINITY] {
        assert_eq!(Detail::new(1, bad, 20), Err(InvalidDetail::Ratio(bad)));
    }
    assert!(matches!(Detail::new(1, f64::NAN, 20), Err(InvalidDetail::Ratio(r)) if r.is_nan()));
    let detail = Detail::new(1, 1.5, 20).unwrap();
    for bad in [0.0, 0.5, -1.0, f64::INFINITY] {
        assert_eq!(detail.anisotropic(bad), Err(InvalidDetail::Anisotropy(bad)));
    }
    assert!(matches!(detail.anisotropic(f64::NAN), Err(InvalidDetail::Anisotropy(r)) if r.is_nan()));
    let said = [
        InvalidDetail::Samples,
        InvalidDetail::Ratio(0.0),
        InvalidDetail::Level(InvalidTile::Level(31)),
        InvalidDetail::Anisotropy(0.5),
    ]
    .map(|e| e.to_string());
    assert_eq!(
        said,
        [
            "expected at least 1 sample along a tile's side, got 0",
            "expected a positive, finite ratio of pixels to samples, got 0.0",
            "level 31 is not in 0 to 30",
            "expected a finite anisotropy of at least 1, got 0.5"
        ]
    );
}

/// In the order of Morton's keys: it is how the walk knows what is next.
#[test]
fn tiles_come_in_order() {
    let map = CubeMap::new(Ellipsoid::<f64>::WGS84, Shift::Authalic, Projection::Tangential).unwrap();
    let view = View::new([3e7, 1e6, 2e6], [-1.0, 0.0, 0.0], [0.0, 0.0, 1.0], 40.0, SCREEN);
    let tiles = selected(map, &view, Detail::new(16, 1.5, 9).unwrap());
    assert!(tiles.len() > 500);
    assert!(tiles.iter().any(|tile| tile.face() != Face::Front));
    let keys = tiles
        .into_iter()
        .map(terrella::terrain::Key::<terrella::terrain::Morton>::from);
    assert!(keys.is_sorted());
}
