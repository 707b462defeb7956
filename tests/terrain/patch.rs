//! Patches: vertices in single precision against the truth, the flatness of tiles, and their symmetries.

use fastrand::Rng;
use terrella::cube::{CubeMap, CubeProjection, Face, Projection};
use terrella::terrain::{Base, Flatness, Heights, InvalidBase, InvalidPatch, Patches, Tile};
use terrella::{Ecef, Ellipsoid, Geodetic, LatLon, Shift};
use testkit::{maximum, minimum, parallel};

use crate::sample;
use crate::vector::{blend, length, minus};

pub type Columns = [Vec<f32>; 3];

pub fn columns(samples: u32) -> Columns {
    std::array::from_fn(|_| vec![0.0; (samples * samples) as usize])
}

pub fn shared(columns: &Columns) -> [&[f32]; 3] {
    columns.each_ref().map(Vec::as_slice)
}

pub fn mutable(columns: &mut Columns) -> [&mut [f32]; 3] {
    columns.each_mut().map(Vec::as_mut_slice)
}

/// Displacements and normals, on the ellipsoid.
pub fn fill(patches: &Patches<impl CubeProjection>, tile: Tile, samples: u32) -> [Columns; 2] {
    lifted(patches, tile, Base::default(), samples)
}

/// Displacements and normals.
pub fn lifted(patches: &Patches<impl CubeProjection>, tile: Tile, base: Base, samples: u32) -> [Columns; 2] {
    let mut both = [columns(samples), columns(samples)];
    let [o, n] = &mut both;
    patches.fill(tile, base, samples, mutable(o), mutable(n)).unwrap();
    both
}

pub fn at(columns: &Columns, index: usize) -> [f32; 3] {
    columns.each_ref().map(|column| column[index])
}

pub fn map<P: CubeProjection>(ellipsoid: Ellipsoid<f64>, shift: Shift, projection: P) -> Patches<P> {
    Patches::new(CubeMap::new(ellipsoid, shift, projection).unwrap())
}

/// The ground by latitude and longitude.
fn truth(patches: &Patches<Projection>, tile: Tile, node: [u32; 2], count: u32, height: f64) -> [f64; 3] {
    let map = patches.map();
    let place = map.unproject(tile.node(node, count));
    let position = Geodetic::new(place, height).unwrap();
    map.shifted().ellipsoid().to_ecef(position).to_array()
}

/// From the deepest sea, and farther down than the floor of Hellas, to above Olympus.
const HEIGHTS: [f64; 2] = [-11_000.0, 30_000.0];

/// A camera anywhere: evenly over latitudes and longitudes, poles included, evenly in the logarithm of the
/// height above the ground from 1 m to 10 000 km.
fn camera(rng: &mut Rng, ellipsoid: Ellipsoid<f64>, ground: f64) -> (LatLon<f64>, f64, Ecef<f64>) {
    let place = LatLon::new(180.0 * rng.f64() - 90.0, 360.0 * rng.f64()).unwrap();
    let height = 10_f64.powf(7.0 * rng.f64());
    (
        place,
        height,
        ellipsoid.to_ecef(Geodetic::new(place, ground + height).unwrap()),
    )
}

/// What was worst: the error within a kilometre in metres, the error beyond in units of the distance, and the same of naive single precision.
#[derive(Default, Clone, Copy)]
struct Worst {
    near: f64,
    far: f64,
    naive_near: f64,
    naive_far: f64,
    /// The error in units of the farthest corner's distance and the height above the base.
    rounding: f64,
    /// How far from a step of the eye of 1 mm that is which is drawn, within a kilometre in metres.
    step: f64,
}

impl Worst {
    fn merge(self, other: Self) -> Self {
        Self {
            near: maximum(self.near, other.near),
            far: maximum(self.far, other.far),
            naive_near: maximum(self.naive_near, other.naive_near),
            naive_far: maximum(self.naive_far, other.naive_far),
            rounding: maximum(self.rounding, other.rounding),
            step: maximum(self.step, other.step),
        }
    }
}

/// Earth, the Moon and Mars.
const ELLIPSOIDS: [Ellipsoid<f64>; 8] = [
    Ellipsoid::WGS84,
    Ellipsoid::GRS80,
    Ellipsoid::CLARKE1866,
    Ellipsoid::INTERNATIONAL1924,
    Ellipsoid::AIRY1830,
    Ellipsoid::BESSEL1841,
    Ellipsoid::MOON,
    Ellipsoid::MARS,
];

/// A random camera and vertex on ground of any height and any slope up to 45°, the vertex in a tile as a
/// renderer would have it: its longest side no longer than the distance to it or 1 km.
fn one(rng: &mut Rng) -> Worst {
    let ellipsoid = ELLIPSOIDS[rng.usize(0..ELLIPSOIDS.len())];
    let projection = Projection::ALL[rng.usize(0..Projection::ALL.len())];
    let shift = Shift::ALL[rng.usize(0..Shift::ALL.len())];
    let patches = map(ellipsoid, shift, projection);
    let ground = HEIGHTS[0] + (HEIGHTS[1] - HEIGHTS[0]) * rng.f64();
    let (place, height, eye) = camera(rng, ellipsoid, ground);
    // A vertex about as far from the foot of the camera as something between 1 m and the camera's horizon.
    let reach = minimum((2.0 * ellipsoid.a() * height).sqrt(), ellipsoid.a());
    let way = reach.powf(rng.f64()) / ellipsoid.a();
    let around = std::f64::consts::TAU * rng.f64();
    let local = terrella::LocalFrame::new(ellipsoid, Geodetic::new(place, 0.0).unwrap());
    let beside = local
        .from_enu(terrella::Enu {
            east: ellipsoid.a() * way * around.cos(),
            north: ellipsoid.a() * way * around.sin(),
            up: 0.0,
        })
        .unwrap();
    let vertex_place = ellipsoid.to_geodetic(beside).lat_lon();
    let point = patches.map().project(vertex_place);
    let under = ellipsoid
        .to_ecef(Geodetic::new(vertex_place, ground).unwrap())
        .to_array();
    let room = maximum(length(minus(under, eye.to_array())), 1000.0);
    let side = |level: u8| {
        let corners = patches
            .of(Tile::containing(point, level).unwrap(), Base::default())
            .corners()
            .map(Ecef::to_array);
        (0..4)
            .map(|k| length(minus(corners[k], corners[(k + 1) % 4])))
            .fold(0.0, maximum)
    };
    let level = (0..=20).find(|&level| side(level) <= room).unwrap();
    let tile = Tile::containing(point, level + rng.u8(0..3)).unwrap();
    let relief = minimum(side(tile.level()), 4_000.0);
    let base = if rng.bool() {
        Base::from(Heights::new(ground, ground).unwrap())
    } else {
        Base::new([0; 4].map(|_| ground + relief * (rng.f64() - 0.5))).unwrap()
    };
    let samples = [2, 9, 33][rng.usize(0..3)];
    let [o, n] = lifted(&patches, tile, base, samples);
    let [m, row] = [0; 2].map(|_| rng.u32(0..samples));
    let index = (row * samples + m) as usize;
    let height = (relief * (rng.f64() - 0.5)) as f32;
    let patch = patches.of(tile, base);
    let drawn = |eye| {
        patch
            .seen_from(eye)
            .at([m, row], samples, at(&o, index), at(&n, index), height)
    };
    let found = drawn(eye);
    let above = base.at([m, row], samples) + f64::from(height);
    let truth = truth(&patches, tile, [m, row], samples - 1, above);
    let expected = minus(truth, eye.to_array());
    let distance = length(expected);
    let error = length(minus(found.map(f64::from), expected));
    let farthest = patch
        .seen_from(eye)
        .corners()
        .map(|corner| length(corner.map(f64::from)));
    let rounding = error / (farthest.into_iter().fold(0.0, maximum) + f64::from(height.abs()));
    let naive: [f32; 3] = std::array::from_fn(|k| truth[k] as f32 - eye.to_array()[k] as f32);
    let naive = length(minus(naive.map(f64::from), expected));
    if distance <= 1000.0 {
        let up = place.to_direction().to_array();
        let way: [f64; 3] = match rng.u8(0..3) {
            0 => up.map(|v| 1e-3 * v),
            axis => std::array::from_fn(|k| if k == usize::from(axis) { 1e-3 } else { 0.0 }),
        };
        let [x, y, z] = std::array::from_fn(|k| eye.to_array()[k] + way[k]);
        let next = drawn(Ecef::new(x, y, z).unwrap());
        let step = std::array::from_fn(|k| f64::from(found[k]) - f64::from(next[k]) - way[k]);
        Worst {
            near: error,
            naive_near: naive,
            rounding,
            step: length(step),
            ..Worst::default()
        }
    } else {
        Worst {
            far: error / distance,
            naive_far: naive / distance,
            rounding,
            ..Worst::default()
        }
    }
}

fn vertices(count: u64) {
    let all = parallel::map(0..count, |seed| one(&mut Rng::with_seed(seed)));
    let worst = all.into_iter().fold(Worst::default(), Worst::merge);
    println!(
        "{count} cameras and vertices: {:.2} mm within 1 km, a step of 1 mm within {:.2} mm, {:.2e} of the distance beyond; naive {:.2} m, {:.2e}; {:.2e} of the farthest corner",
        1e3 * worst.near,
        1e3 * worst.step,
        worst.far,
        worst.naive_near,
        worst.naive_far,
        worst.rounding
    );
    assert!(worst.near <= 0.0003 && worst.near > 0.0, "{}", worst.near);
    assert!(worst.step <= 0.0005 && worst.step > 0.0, "{}", worst.step);
    assert!(worst.far <= 4e-7 && worst.far > 0.0, "{}", worst.far);
    assert!(worst.rounding <= 4e-7, "{}", worst.rounding);
    // The contrast: the same places as single precision alone has them.
    assert!(worst.naive_near > 0.1, "{}", worst.naive_near);
}

#[test]
fn vertices_are_where_they_should_be() {
    vertices(10_000);
}

#[test]
#[ignore = "a million: cargo test --release --test terrain -- --ignored --nocapture a_million_vertices"]
fn a_million_vertices() {
    vertices(1_000_000);
}

/// All vertices at once are those one by one, in every bit, and so are displacements and normals.
#[test]
fn slices_are_one_by_one() {
    let mut rng = Rng::with_seed(5);
    for samples in [2, 3, 8, 16, 17, 65] {
        for &projection in Projection::ALL {
            let patches = map(Ellipsoid::MARS, Shift::Authalic, projection);
            let tile = sample::tile(&mut rng);
            let base = Base::new([0; 4].map(|_| 20_000.0 * rng.f64() - 5_000.0)).unwrap();
            let [o, n] = lifted(&patches, tile, base, samples);
            let heights: Vec<f32> = (0..samples * samples).map(|_| rng.f32() * 1000.0).collect();
            let seen = patches.of(tile, base).seen_from(Ecef::new(3.4e6, 100.0, 2e5).unwrap());
            let mut vertices = columns(samples);
            seen.fill(samples, shared(&o), shared(&n), &heights, mutable(&mut vertices))
                .unwrap();
            let corners = patches.of(tile, base).corners().map(Ecef::to_array);
            for row in 0..samples {
                for m in 0..samples {
                    let k = (row * samples + m) as usize;
                    let one = seen.at([m, row], samples, at(&o, k), at(&n, k), heights[k]);
                    assert_eq!(at(&vertices, k).map(f32::to_bits), one.map(f32::to_bits));
                    // The displacement is from the bilinear patch.
                    let count = f64::from(samples - 1);
                    let (s, t) = (f64::from(m) / count, f64::from(row) / count);
                    let ground = truth(&patches, tile, [m, row], samples - 1, base.at([m, row], samples));
                    let expected = minus(ground, blend(corners, s, t));
                    let error = length(minus(at(&o, k).map(f64::from), expected));
                    assert!(error <= 6e-9 + 1e-7 * length(expected), "{projection} {tile:?} {error}");
                }
            }
        }
    }
}

#[test]
fn representatives_say_all() {
    parallel::for_each(Projection::ALL, |&projection| {
        let mut rng = Rng::with_seed(6);
        for shift in [Shift::Authalic, Shift::Geocentric] {
            let patches = map(Ellipsoid::WGS84, shift, projection);
            for round in 0..200 {
                let tile = match round {
                    0..6 => Tile::root(Face::ALL[round]),
                    _ => sample::tile(&mut rng),
                };
                // There the Earth's symmetries are not the projection's.
                if tile.face().is_polar() && !projection.faces().are_square(tile.face()) {
                    continue;
                }
                let samples = rng.u32(2..10);
                let (representative, symmetry) = tile.representative();
                let (own, known) = (fill(&patches, tile, samples), fill(&patches, representative, samples));
                let largest = known[0].iter().flatten().fold(0.0_f32, |a, b| maximum(a, b.abs()));
                for (which, (own, known)) in own.iter().zip(&known).enumerate() {
                    let mut carried = columns(samples);
                    symmetry.fill(samples, shared(known), mutable(&mut carried)).unwrap();
                    for (a, b) in own.iter().flatten().zip(carried.iter().flatten()) {
                        if projection == Projection::Conformal {
                            let allowed = if which == 0 {
                                6e-9 + largest * f32::EPSILON
                            } else {
                                f32::EPSILON
                            };
                            assert!((a - b).abs() <= allowed, "{tile:?} {a} {b}");
                        } else {
                            assert_eq!(a.to_bits(), b.to_bits(), "{projection} {tile:?} {a} {b}");
                        }
                    }
                }
            }
        }
    });
}

#[test]
fn representatives_are_their_own_and_as_many_as_counted() {
    for level in 0..=6 {
        let mut seen = std::collections::BTreeSet::new();
        for face in Face::ALL {
            for n in 0..1_u32 << (2 * level) {
                let tile = Tile::new(face, level, n % (1 << level), n >> level).unwrap();
                let (representative, _) = tile.representative();
                assert_eq!(representative.representative().0, representative);
                seen.insert((representative.face(), representative.i(), representative.j()));
            }
        }
        assert_eq!(seen.len() as u64, Tile::distinct(level));
    }
    assert_eq!(Tile::distinct(255), Tile::distinct(30));
}

/// The largest displacement of a tile, and the largest difference of a normal from the interpolated one.
fn bulge(patches: &Patches<impl CubeProjection>, tile: Tile, parts: u32) -> [f64; 2] {
    let samples = parts + 1;
    let mut most = [0.0_f64; 2];
    let [o, _] = fill(patches, tile, samples);
    let normal = |point| patches.map().unproject(point).to_direction().to_array();
    let corners = tile.corners().map(normal);
    for row in 0..samples {
        for m in 0..samples {
            let k = (row * samples + m) as usize;
            most[0] = maximum(most[0], length(at(&o, k).map(f64::from)));
            let (s, t) = (f64::from(m) / f64::from(parts), f64::from(row) / f64::from(parts));
            let own = normal(tile.node([m, row], parts));
            most[1] = maximum(most[1], length(minus(own, blend(corners, s, t))));
        }
    }
    most
}

/// Tiles in which to look for the worst: all of the coarse levels, then random ones, with every other one near a centre, edge, corner or diagonal.
fn suspects(rng: &mut Rng, level: u8, count: u32) -> Vec<Tile> {
    if level <= 3 {
        return Face::ALL
            .into_iter()
            .flat_map(|face| {
                (0..1_u32 << (2 * level)).map(move |n| Tile::new(face, level, n % (1 << level), n >> level).unwrap())
            })
            .collect();
    }
    let size = 1_u32 << level;
    (0..count)
        .map(|_| {
            let index = |rng: &mut Rng| {
                let log = if rng.bool() { 0.0 } else { rng.f64() };
                let small = (f64::from(size / 2).powf(log) as u32).clamp(1, size / 2);
                match rng.u8(0..6) {
                    0 => small - 1,
                    1 => size - small,
                    2 => size / 2 - small,
                    3 => size / 2 + small - 1,
                    _ => rng.u32(0..size),
                }
            };
            let i = index(rng);
            let j = match rng.u8(0..4) {
                0 => i,
                1 => size - 1 - i,
                _ => index(rng),
            };
            Tile::new(sample::face(rng), level, i, j).unwrap()
        })
        .collect()
}

pub fn flat_enough(patches: &Patches<impl CubeProjection>, level: u8, count: u32) -> [f64; 2] {
    let bound = patches.flatness(level);
    let mut most = [0.0_f64; 2];
    let mut rng = Rng::with_seed(level.into());
    for tile in suspects(&mut rng, level, count) {
        let found = bulge(patches, tile, 10);
        for k in 0..2 {
            most[k] = maximum(most[k], found[k]);
        }
    }
    [bound.displacement / most[0], bound.turning / most[1]]
}

/// Bounds hold, and at levels 0 to 22 they are within twice the largest seen.
#[test]
fn flatness_is_a_bound_and_a_close_one() {
    parallel::for_each(Projection::ALL, |&projection| {
        let mut ratios = [[f64::INFINITY, 0.0_f64]; 2];
        for level in 0..=22 {
            let patches = map(Ellipsoid::WGS84, Shift::Authalic, projection);
            let found = flat_enough(&patches, level, 300);
            for k in 0..2 {
                ratios[k] = [minimum(ratios[k][0], found[k]), maximum(ratios[k][1], found[k])];
            }
            assert!(found[0] >= 1.0 && found[1] >= 1.0, "{projection} {level} {found:?}");
            assert!(found[0] <= 2.0, "{projection} {level} {found:?}");
        }
        println!(
            "{projection:18} bound over largest seen: displacement {:.2?}, normals {:.2?}",
            ratios[0], ratios[1]
        );
    });
}

#[test]
#[ignore = "every shape and shift: cargo test --release --test terrain -- --ignored flatness_of_every_map"]
fn flatness_of_every_map() {
    let shapes = [
        Ellipsoid::MOON,
        Ellipsoid::MARS,
        Ellipsoid::new(6.4e6, 0.1).unwrap(),
        Ellipsoid::new(6.4e6, -1.0 / 9.0).unwrap(),
        Ellipsoid::new(6.4e6, 0.5).unwrap(),
    ];
    parallel::for_each(Projection::ALL, |&projection| {
        for ellipsoid in shapes {
            for &shift in Shift::ALL {
                let Ok(map) = CubeMap::new(ellipsoid, shift, projection) else {
                    continue;
                };
                let patches = Patches::new(map);
                for level in 0..=22 {
                    let found = flat_enough(&patches, level, 150);
                    let context = format!("{projection} {shift} {ellipsoid:?} {level} {found:?}");
                    assert!(found[0] >= 1.0 && found[1] >= 1.0, "{context}");
                    assert!(found[0] <= 2.0, "{context}");
                }
            }
        }
    });
}

/// On a level base it is the displacement and as much of the base's height as normals turn.
#[test]
fn flatness_holds_on_a_level_base() {
    parallel::for_each(Projection::ALL, |&projection| {
        let mut rng = Rng::with_seed(8);
        for ellipsoid in [Ellipsoid::WGS84, Ellipsoid::MOON] {
            let patches = map(ellipsoid, Shift::Authalic, projection);
            for level in [0, 1, 2, 4, 8, 12, 16] {
                let Flatness { displacement, turning } = patches.flatness(level);
                for tile in suspects(&mut rng, level, 30) {
                    let height = HEIGHTS[rng.usize(0..2)];
                    let base = Base::from(Heights::new(height, height).unwrap());
                    let [o, _] = lifted(&patches, tile, base, 9);
                    for k in 0..81 {
                        let found = length(at(&o, k).map(f64::from));
                        let bound = displacement + height.abs() * turning;
                        assert!(found <= bound, "{projection} {tile:?} {height}: {found} {bound}");
                    }
                }
            }
        }
    });
}

#[test]
fn what_is_no_base_is_refused() {
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        for k in 0..4 {
            let mut corners = [100.0; 4];
            corners[k] = bad;
            let InvalidBase(found) = Base::new(corners).unwrap_err();
            assert_eq!(found.to_bits(), bad.to_bits());
        }
    }
    assert_eq!(InvalidBase(f64::INFINITY).to_string(), "height inf is not finite");
    let widest = Heights::new(f64::MIN, f64::MAX).unwrap();
    assert_eq!(Base::from(widest), Base::default());
}

#[test]
fn plain_tiles_are_within_their_tolerance() {
    let heights = Heights::new(-500.0, 8000.0).unwrap();
    parallel::for_each(Projection::ALL, |&projection| {
        let patches = map(Ellipsoid::WGS84, Shift::Authalic, projection);
        let mut rng = Rng::with_seed(7);
        for tolerance in [0.01, 1.0, 100.0] {
            let level = patches.plain_level(tolerance, heights).unwrap();
            for _ in 0..300 {
                let tile = sample::tile_of(&mut rng, level);
                let base = if rng.bool() { 0.0 } else { 7000.0 };
                let patch = patches.of(tile, Base::from(Heights::new(base, base).unwrap()));
                let node = [rng.u32(0..=16), rng.u32(0..=16)];
                let height = if rng.bool() { -500.0 } else { 8000.0 };
                let expected = truth(&patches, tile, node, 16, height);
                let eye = Ecef::new(expected[0], expected[1], expected[2]).unwrap();
                let place = node.map(|index| index as f32 / 16.0);
                let found = patch
                    .seen_from(eye)
                    .plain(place, patch.normals(), (height - base) as f32);
                // The height itself is rounded.
                let error = length(found.map(f64::from));
                assert!(error <= tolerance + 0.002, "{projection} {level} {error}");
            }
        }
    });
}

#[test]
#[ignore = "a table to look at: cargo test --release --test terrain -- --ignored --nocapture plain_levels"]
fn plain_levels() {
    let sea = Heights::default();
    let land = Heights::new(-11_000.0, 9_000.0).unwrap();
    println!(
        "{:18} | level from which no displacement is longer than 1 m, 1 cm, 1 mm | with heights",
        ""
    );
    for &projection in Projection::ALL {
        let patches = map(Ellipsoid::WGS84, Shift::Authalic, projection);
        let row = |heights| {
            [1.0, 0.01, 0.001].map(|tolerance| {
                patches
                    .plain_level(tolerance, heights)
                    .map_or("none".into(), |level| level.to_string())
            })
        };
        println!("{:18} | {:?} | {:?}", projection.name(), row(sea), row(land));
    }
}

#[test]
fn what_is_no_patch_is_refused() {
    let patches = map(Ellipsoid::WGS84, Shift::Authalic, Projection::Balanced);
    let tile = Tile::root(Face::Top);
    let (mut o, mut n) = (columns(3), columns(3));
    for samples in [0, 1, 4098, u32::MAX] {
        let refused = patches.fill(tile, Base::default(), samples, mutable(&mut o), mutable(&mut n));
        assert_eq!(refused, Err(InvalidPatch::Samples(samples)));
    }
    n[2].pop();
    let wrong = InvalidPatch::Length { expected: 9, length: 8 };
    assert_eq!(
        patches.fill(tile, Base::default(), 3, mutable(&mut o), mutable(&mut n)),
        Err(wrong)
    );
    assert!(o.iter().flatten().all(|&v| v == 0.0));
    assert_eq!(wrong.to_string(), "expected slices of 9 elements, got a slice of 8");
    assert_eq!(
        InvalidPatch::Samples(1).to_string(),
        "expected 2 to 4097 samples along an edge, got 1"
    );
    let seen = patches
        .of(tile, Base::default())
        .seen_from(Ecef::new(0.0, 0.0, 0.0).unwrap());
    let (long, short) = ([0.0; 9], [0.0; 8]);
    let mut out = columns(3);
    let refused = seen.fill(3, [&long; 3], [&long; 3], &short, mutable(&mut out));
    assert_eq!(refused, Err(wrong));
    let (_, symmetry) = tile.representative();
    assert_eq!(symmetry.fill(3, [&long, &short, &long], mutable(&mut out)), Err(wrong));
}
